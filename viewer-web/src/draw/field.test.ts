import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { cameraFor, drawField, kFields, toField, toScreen } from "./field";
import { boxOf, testPen } from "./test_pen";

const kField = kFields["spl2012"]!;
test("a point converted to the screen and back is the same point", () => {
  const camera = cameraFor(kField, 900, 600);
  for (const [x, y] of [
    [0, 0],
    [3, -2],
    [-3.7, 2.7],
    [0.1, 5],
  ] as const) {
    const back = toField(camera, toScreen(camera, { x, y }));
    expect(back.x).toBeCloseTo(x, 9);
    expect(back.y).toBeCloseTo(y, 9);
  }
});

test("y is up, x to the right, and a metre has one length in both directions", () => {
  const camera = cameraFor(kField, 900, 600);
  const origin = toScreen(camera, { x: 0, y: 0 });
  expect(origin).toEqual({ x: 450, y: 300 });
  expect(toScreen(camera, { x: 1, y: 0 }).x - origin.x).toBeCloseTo(camera.scale);
  expect(origin.y - toScreen(camera, { x: 0, y: 1 }).y).toBeCloseTo(camera.scale);
});

test("the whole carpet is on the canvas, whatever its shape, and touches two of its sides", () => {
  for (const [width, height] of [
    [900, 600],
    [300, 1200],
    [2000, 200],
  ] as const) {
    const pen = testPen();
    drawField(pen, cameraFor(kField, width, height), kField);
    const box = boxOf(pen);
    expect(Math.min(box.left, box.top, width - box.right, height - box.bottom)).toBeCloseTo(0);
    expect([box.left, box.top, width - box.right, height - box.bottom].every((gap) => gap > -1e-6)).toBe(true);
  }
});

test("the field is drawn symmetrically", () => {
  const pen = testPen();
  drawField(pen, { scale: 100, centreX: 0, centreY: 0 }, { ...kField, penaltyAreaLength: 1.65, penaltyAreaWidth: 4 });
  const points = pen.points.map(({ x, y }) =>
    [x, y].map((value) => value.toFixed(6).replace("-0.000000", "0.000000")).join(),
  );
  for (const [flipX, flipY] of [
    [-1, 1],
    [1, -1],
    [-1, -1],
  ] as const) {
    const flipped = pen.points.map(({ x, y }) =>
      [flipX * x, flipY * y].map((value) => value.toFixed(6).replace("-0.000000", "0.000000")).join(),
    );
    expect(new Set(flipped)).toEqual(new Set(points));
  }
});

test("the fields to choose from are those of the simulator's rules", () => {
  for (const [name, field] of Object.entries(kFields)) {
    const rules = JSON.parse(readFileSync(new URL(`../../../sim/data/rules/${name}.json`, import.meta.url), "utf8"));
    for (const [key, value] of Object.entries(field))
      expect(rules.field[key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`)].value, `${name} ${key}`).toBe(
        value,
      );
  }
});
