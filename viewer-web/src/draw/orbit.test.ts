import { expect, test } from "vitest";
import { matrixOf, nearer, onCanvas, orbitOver, shifted, turned } from "./orbit";

const [kWidth, kHeight] = [800, 500];
const kOutline = [
  { x: -2, y: -1 },
  { x: 2, y: -1 },
  { x: 3, y: 2 },
  { x: -3, y: 2 },
];
const kOrbit = orbitOver(kOutline, kWidth / kHeight);
const seen = (orbit: typeof kOrbit, x: number, y: number, z = 0) =>
  onCanvas(matrixOf(orbit, kWidth / kHeight), { x, y, z }, kWidth, kHeight)!;

test("the first look shows the whole outline, on wide and on narrow canvases", () => {
  for (const [width, height] of [
    [800, 500],
    [390, 600],
    [1400, 300],
  ] as const)
    for (const { x, y } of kOutline) {
      const clip = matrixOf(orbitOver(kOutline, width / height), width / height);
      const at = onCanvas(clip, { x, y, z: 0 }, width, height)!;
      expect(at.x).toBeGreaterThan(0);
      expect(at.x).toBeLessThan(width);
      expect(at.y).toBeGreaterThan(0);
      expect(at.y).toBeLessThan(height);
    }
});

test("it is oriented as the field's drawing: +x right, +y up, and high things above", () => {
  const middle = seen(kOrbit, 0, 0);
  expect(seen(kOrbit, 1, 0).x).toBeGreaterThan(middle.x);
  expect(seen(kOrbit, 0, 1).y).toBeLessThan(middle.y);
  expect(seen(kOrbit, 0, 0, 0.5).y).toBeLessThan(middle.y);
});

test("the target stays in the middle while turning and zooming", () => {
  const { x, y, z } = kOrbit.target;
  for (const orbit of [kOrbit, turned(kOrbit, { x: 333, y: -44 }), nearer(kOrbit, 2)]) {
    const at = seen(orbit, x, y, z);
    expect([at.x, at.y]).toEqual([expect.closeTo(kWidth / 2, 2), expect.closeTo(kHeight / 2, 2)]);
  }
});

test("a move to the right moves things to the right, at any turn", () => {
  for (const orbit of [kOrbit, turned(kOrbit, { x: 500, y: 0 })]) {
    const { x, y, z } = orbit.target;
    const at = seen(shifted(orbit, { x: 40, y: 0 }, kHeight), x, y, z);
    expect([at.x, at.y]).toEqual([expect.closeTo(kWidth / 2 + 40, 0), expect.closeTo(kHeight / 2, 0)]);
  }
});

test("nothing behind the viewpoint is on the canvas", () => {
  const clip = matrixOf(kOrbit, 1.6);
  expect(onCanvas(clip, { x: 0, y: -30, z: 0 }, kWidth, kHeight)).toBeUndefined();
});
