import { expect, test } from "vitest";
import { hatch } from "./hatch";
import { testPen } from "./test_pen";
import { gapsIn, windowOf, zoomed } from "./window";

const kept = { from: 0, to: 1200 };

test("without a length the whole is shown, at any moment", () => {
  for (const at of [0, 600, 1200])
    expect(windowOf(undefined, undefined, { kept, at, atNow: false }).span).toEqual(kept);
});

test("at now the newest part is shown", () => {
  expect(windowOf(undefined, 30, { kept, at: 1200, atNow: true }).span).toEqual({ from: 1170, to: 1200 });
});

test("a part stays while it contains the moment, and follows it where it does not", () => {
  const first = windowOf(undefined, 30, { kept, at: 600, atNow: false });
  expect(first.span).toEqual({ from: 585, to: 615 });
  expect(windowOf(first, 30, { kept, at: 614, atNow: false })).toBe(first);
  expect(windowOf(first, 30, { kept, at: 700, atNow: false }).span).toEqual({ from: 685, to: 715 });
  expect(windowOf(first, 60, { kept, at: 600, atNow: false }).span).toEqual({ from: 570, to: 630 });
});

test("a part does not leave the available time if that is longer", () => {
  const spanAt = (at: number, length: number) => windowOf(undefined, length, { kept, at, atNow: false }).span;
  expect(spanAt(3, 30)).toEqual({ from: 0, to: 30 });
  expect(spanAt(1199, 30)).toEqual({ from: 1170, to: 1200 });
  expect(spanAt(600, 1800)).toEqual({ from: -600, to: 1200 });
});

test("the time under the pointer stays there when zoomed, and the part stays away from the moment", () => {
  const place = { kept, at: 100, atNow: false };
  const { held, length } = zoomed(windowOf(undefined, undefined, place), place, 900, 4);
  expect(length).toBe(300);
  expect(held.span).toEqual({ from: 675, to: 975 });
  expect(windowOf(held, length, place)).toBe(held); // although it does not contain the moment 100
  expect(zoomed(held, place, 900, 0.01).length).toBeUndefined();
  expect(zoomed(held, place, 900, 1e9).length).toBeGreaterThan(0);
});

test("the parts that are not loaded lie around the loaded one", () => {
  expect(gapsIn(kept, undefined)).toEqual([kept]);
  expect(gapsIn(kept, { from: 100, to: 200 })).toEqual([
    { from: 0, to: 100 },
    { from: 200, to: 1200 },
  ]);
  expect(gapsIn(kept, { from: -5, to: 1300 })).toEqual([]);
  expect(gapsIn(kept, { from: 1300, to: 1400 })).toEqual([kept]);
});

test("hatching covers its rectangle and does not leave it", () => {
  const pen = testPen();
  hatch(pen, 50, 10, 200, 80, "soft");
  expect(pen.points.length).toBeGreaterThan(40);
  for (const { x, y } of pen.points) {
    expect(x).toBeGreaterThanOrEqual(50);
    expect(x).toBeLessThanOrEqual(250);
    expect(y).toBeGreaterThanOrEqual(10);
    expect(y).toBeLessThanOrEqual(90);
  }
  const none = testPen();
  hatch(none, 50, 10, 0, 80, "soft");
  expect(none.points).toEqual([]);
});
