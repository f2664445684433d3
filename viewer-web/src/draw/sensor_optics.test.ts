import { expect, test } from "vitest";
import { toPixel } from "./optics";
import { footprintOf, isSeen, kUncalibrated, opticsIn, placeAt } from "./sensor_optics";

const kPinhole = { width: 640, height: 480, focal: { x: 575, y: 576 }, centre: { x: 322, y: 238 } };
/** Behind the field at -y, 2 m high, and 30 degrees down. */
const [cos, sin] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
const kOptics = opticsIn(kPinhole, {
  rotation: [1, 0, 0, 0, -sin, cos, 0, -cos, -sin],
  at: { x: 0.5, y: -4, z: 2 },
  depthScale: 1,
});

test("a pixel at a depth is the place that projects to it", () => {
  for (const pixel of [
    { x: 12, y: 34 },
    { x: 322, y: 238 },
    { x: 600, y: 450 },
  ]) {
    const back = toPixel(kOptics, placeAt(kOptics, pixel, 3.3))!;
    expect([back.x, back.y]).toEqual([expect.closeTo(pixel.x), expect.closeTo(pixel.y)]);
  }
});

test("the axis meets a depth straight ahead, which for a level sensor is along +y", () => {
  expect(placeAt(opticsIn(kPinhole, kUncalibrated), kPinhole.centre, 2)).toEqual({ x: 0, y: -1, z: 1 });
});

test("the footprint is in front of the sensor, within its reach, and what is inside is seen", () => {
  const outline = footprintOf(kOptics);
  for (const { x, y } of outline) {
    expect(y).toBeGreaterThan(-4);
    expect(Math.hypot(x - 0.5, y + 4)).toBeLessThanOrEqual(6 + 1e-9);
  }
  const middle = outline.reduce((sum, { x, y }) => ({ x: sum.x + x / outline.length, y: sum.y + y / outline.length }), {
    x: 0,
    y: 0,
  });
  expect(isSeen(kOptics, { ...middle, z: 0 })).toBe(true);
  expect(isSeen(kOptics, { x: 0, y: -8, z: 0 })).toBe(false);
});
