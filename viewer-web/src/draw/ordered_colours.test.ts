import { expect, test } from "vitest";
import { kSteps, orderedColour, orderedTable } from "./ordered_colours";

/** Lightness in Oklab of an sRGB colour, by its definition. */
function lightnessOf(rgb: number[]): number {
  const [r, g, b] = rgb
    .map((value) => value / 255)
    .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4)) as [number, number, number];
  return (
    0.2104542553 * Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
    0.793617785 * Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
    0.0040720468 * Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
  );
}

test("equal steps of the value are equal steps of brightness", () => {
  const steps = Array.from({ length: 21 }, (_, i) => lightnessOf(orderedColour(i / 20)));
  const mean = (steps.at(-1)! - steps[0]!) / 20;
  expect(mean).toBeGreaterThan(0.025);
  for (let i = 1; i < steps.length; ++i) expect(steps[i]! - steps[i - 1]!).toBeCloseTo(mean, 2);
});

test("values beyond the ends have the colours of the ends", () => {
  expect(orderedColour(-1)).toEqual(orderedColour(0));
  expect(orderedColour(7)).toEqual(orderedColour(1));
});

test("the table has all colours, opaque", () => {
  expect(orderedTable()).toHaveLength(4 * kSteps);
  expect(orderedTable().filter((_, i) => i % 4 === 3)).toEqual(new Uint8Array(kSteps).fill(255));
});
