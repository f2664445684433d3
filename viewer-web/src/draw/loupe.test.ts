import { expect, test } from "vitest";
import { kLoupeScale, loupeAt } from "./loupe";
import { toCanvas } from "./overlay";

const kShape = { width: 800, height: 600 };
const kImage = { width: 640, height: 480 };

test("the loupe shows the chosen pixel in its middle", () => {
  const { left, top, fit } = loupeAt(kShape, kImage, { x: 100.25, y: 50 }, undefined);
  const middle = toCanvas(fit, { x: 100.25, y: 50 });
  expect([middle.x - left, middle.y - top]).toEqual([68, 68]);
  expect(toCanvas(fit, { x: 101.25, y: 50 }).x - middle.x).toBe(kLoupeScale);
});

test("the loupe is never under the pointer", () => {
  const away = loupeAt(kShape, kImage, { x: 1, y: 1 }, { x: 50, y: 60 });
  expect(away.left).toBeGreaterThan(600);
  expect(loupeAt(kShape, kImage, { x: 1, y: 1 }, { x: 700, y: 60 }).left).toBeLessThan(50);
});
