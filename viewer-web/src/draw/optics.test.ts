import { expect, test } from "vitest";
import type { Fields } from "../memory/value";
import { horizonOf, lineToPixels, opticsOf, outlineOf, resized, toGround, toPixel, type Optics } from "./optics";

/** Looks ahead and `down` [rad], from half a metre above the ground. */
function looking(down: number): Optics {
  const [c, s] = [Math.cos(down), Math.sin(down)];
  // columns: right is -y, down is down, forward is ahead
  const rotation = [0, -s, c, -1, 0, 0, 0, -c, -s];
  return {
    rotation,
    at: { x: 0.05, y: 0.01, z: 0.5 },
    width: 640,
    height: 480,
    focal: { x: 544, y: 544 },
    centre: { x: 320, y: 240 },
  };
}

test("a ground point projects to the pixel that leads back to it", () => {
  const optics = looking(0.4);
  for (const place of [
    { x: 1, y: 0 },
    { x: 2.5, y: -0.8 },
    { x: 0.6, y: 0.3 },
  ]) {
    const pixel = toPixel(optics, { ...place, z: 0 })!;
    const back = toGround(optics, pixel)!;
    expect([back.x, back.y]).toEqual([expect.closeTo(place.x, 6), expect.closeTo(place.y, 6)]);
  }
  // left of the robot is left in the image, far is high
  expect(toPixel(optics, { x: 1, y: 0.5, z: 0 })!.x).toBeLessThan(320);
  expect(toPixel(optics, { x: 4, y: 0, z: 0 })!.y).toBeLessThan(toPixel(optics, { x: 1, y: 0, z: 0 })!.y);
});

test("nothing behind the camera is projected, and a line from there is cut", () => {
  const optics = looking(0.2);
  expect(toPixel(optics, { x: -1, y: 0, z: 0 })).toBeUndefined();
  expect(lineToPixels(optics, { x: -2, y: 0, z: 0 }, { x: -1, y: 0, z: 0 })).toBeUndefined();
  const [near, far] = lineToPixels(optics, { x: -2, y: 0, z: 0 }, { x: 3, y: 0, z: 0 })!;
  expect(near.y).toBeGreaterThan(480);
  expect(far).toEqual(toPixel(optics, { x: 3, y: 0, z: 0 }));
});

test("above the horizon there is no ground, below there is", () => {
  const optics = looking(0.3);
  const [left, right] = horizonOf(optics)!;
  expect([left.x, right.x, left.y]).toEqual([0, 640, expect.closeTo(right.y, 6)]);
  expect(left.y).toBeCloseTo(240 - 544 * Math.tan(0.3), 3);
  expect(toGround(optics, { x: 100, y: left.y - 1 })).toBeUndefined();
  expect(toGround(optics, { x: 100, y: left.y + 1 })!.x).toBeGreaterThan(100);
  expect(horizonOf({ ...optics, rotation: [0, 0, 1, -1, 0, 0, 0, 0, 0] })).toBeUndefined();
});

test("an image of half the size shows the same at half the pixels", () => {
  const [whole, half] = [looking(0.4), resized(looking(0.4), 320, 240)];
  const place = { x: 1.3, y: 0.2, z: 0.1 };
  const [one, other] = [toPixel(whole, place)!, toPixel(half, place)!];
  expect([other.x, other.y]).toEqual([expect.closeTo(one.x / 2), expect.closeTo(one.y / 2)]);
});

test("an incomplete matrix gives no optics", () => {
  const fields: Fields = new Map(
    Object.entries({
      rotation: [0, 0, 1, -1, 0, 0, 0, -1, 0],
      x: 0,
      y: 0,
      z: 0.5,
      width: 640,
      height: 480,
      focal_x: 544,
      focal_y: 544,
      centre_x: 320,
      centre_y: 240,
    }),
  );
  expect(opticsOf(fields)).toMatchObject({ width: 640, at: { z: 0.5 } });
  for (const name of fields.keys())
    expect(opticsOf(new Map([...fields].filter(([other]) => other !== name))), name).toBeUndefined();
  expect(opticsOf(new Map([...fields, ["focal_x", 0]]))).toBeUndefined();
});

test("a detection has an outline, else a box, else neither", () => {
  const box: Fields = new Map(Object.entries({ box_left: 10, box_top: 20, box_width: 30, box_height: 40 }));
  expect(outlineOf(box)).toEqual([
    { x: 10, y: 20 },
    { x: 40, y: 20 },
    { x: 40, y: 60 },
    { x: 10, y: 60 },
  ]);
  const corner = (x: number) => new Map(Object.entries({ x, y: 1 }));
  expect(outlineOf(new Map([...box, ["outline", [corner(1), corner(2), corner(3)]]]))).toHaveLength(3);
  expect(outlineOf(new Map())).toEqual([]);
});
