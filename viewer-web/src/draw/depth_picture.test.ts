import { expect, test } from "vitest";
import type { Value } from "../memory/value";
import { paintColour, paintDepth, rangeOf, sensorPictureOf, steadyRange, type DepthPicture } from "./depth_picture";
import { orderedColour } from "./ordered_colours";

const message = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const depthOf = (width: number, height: number, of: (i: number) => number): DepthPicture => ({
  kind: "depth",
  width,
  height,
  depth: Uint16Array.from({ length: width * height }, (_, i) => of(i)),
});

test("depths are read little endian, also from an odd address", () => {
  const data = new Uint8Array([9, 1, 2, 3, 4]).subarray(1);
  const picture = sensorPictureOf(message({ encoding: "16UC1", width: 2, height: 1, data }));
  expect(picture).toMatchObject({ kind: "depth", depth: new Uint16Array([0x0201, 0x0403]) });
});

test("colours are read and get an opaque pixel each", () => {
  const data = new Uint8Array([1, 2, 3, 4, 5, 6]);
  const picture = sensorPictureOf(message({ encoding: "rgb8", width: 2, height: 1, data }));
  if (picture.kind !== "colour") throw new Error("no colours");
  const rgba = new Uint8ClampedArray(8);
  paintColour(picture, rgba);
  expect([...rgba]).toEqual([1, 2, 3, 255, 4, 5, 6, 255]);
});

test("what is no image of a sensor is refused with one sentence", () => {
  const whole = { encoding: "16UC1", width: 2, height: 2, data: new Uint8Array(8) };
  for (const [wrong, why] of [
    [{ encoding: "bayer" }, /encoding 'bayer'/],
    [{ encoding: "constructor" }, /encoding 'constructor'/],
    [{ data: new Uint8Array(7) }, /takes 8 bytes, got 7/],
    [{ data: undefined }, /takes 8 bytes, got 0/],
    [{ width: 0 }, /0 x 2 pixels/],
    [{ width: 1e9 }, /1000000000 x 2 pixels/],
  ] as const) {
    const read = sensorPictureOf(message({ ...whole, ...wrong }));
    expect(read.kind === "none" && read.why).toMatch(why);
  }
});

test("the range holds almost all depths, and nothing that was not measured", () => {
  const { near, far } = rangeOf(depthOf(200, 200, (i) => (i % 3 === 0 ? 0 : 1100 + (i % 2000))));
  expect(near).toBe(1);
  expect(far).toBe(3.25);
  expect(rangeOf(depthOf(200, 200, () => 0))).toEqual({ near: 0.5, far: 5 });
});

test("a range stays while it fits, so that colours do not flicker", () => {
  const before = { near: 1, far: 4 };
  expect(steadyRange(before, { near: 1.25, far: 4.25 })).toBe(before);
  expect(steadyRange(before, { near: 1, far: 6 })).toEqual({ near: 1, far: 6 });
  expect(steadyRange(before, { near: 1, far: 2 })).toEqual({ near: 1, far: 2 });
  expect(steadyRange(undefined, before)).toBe(before);
});

test("near depths are bright, far ones dark, and places without a depth have no colour of the scale", () => {
  const rgba = new Uint8ClampedArray(16);
  paintDepth(
    depthOf(4, 1, (i) => [1000, 3000, 9000, 0][i]!),
    { near: 1, far: 3 },
    rgba,
  );
  const pixel = (i: number) => [...rgba.slice(4 * i, 4 * i + 3)];
  expect(pixel(0)).toEqual(orderedColour(1));
  expect(pixel(1)).toEqual(orderedColour(0));
  expect(pixel(2)).toEqual(orderedColour(0));
  expect(Math.max(...pixel(3)) - Math.min(...pixel(3))).toBeLessThan(20);
  expect(rgba[15]).toBe(255);
});
