import { expect, test } from "vitest";
import { EnumValue, type Fields, type Value } from "../memory/value";
import { kFields } from "./field";
import {
  drawOverlay,
  fitOf,
  linesOf,
  onField,
  toCanvas,
  toImage,
  yuvAt,
  yuvOf,
  type Overlay,
  type Seen,
} from "./overlay";
import { testPen } from "./test_pen";
import { rgbaFromYuyv } from "./yuyv";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const kTop = new EnumValue(1, "CAMERA_TOP");
const field = kFields["spl2012"]!;
const optics = {
  rotation: [0, -0.3, 0.954, -1, 0, 0, 0, -0.954, -0.3],
  at: { x: 0, y: 0, z: 0.5 },
  width: 640,
  height: 480,
  focal: { x: 544, y: 544 },
  centre: { x: 320, y: 240 },
};
const vision = fields({
  image_width: 640,
  image_height: 480,
  ball: fields({ detection: fields({ camera: kTop, image_x: 100, image_y: 200, distance: 1.234 }), radius: 10 }),
  robots: [
    fields({
      side: new EnumValue(2, "SIDE_OPPONENT"),
      detection: fields({
        camera: kTop,
        image_x: 320,
        image_y: 100,
        box_left: 300,
        box_top: 50,
        box_width: 40,
        box_height: 100,
        distance: 2,
      }),
    }),
  ],
});
const seen: Seen = { vision, camera: 1, optics, pose: { x: 0, y: 0, heading: 0 }, field };
const drawn = (overlays: Overlay[], more: Partial<Seen> = {}) => {
  const pen = testPen();
  drawOverlay(pen, fitOf({ width: 320, height: 240 }, 640, 480), new Set(overlays), { ...seen, ...more });
  return pen;
};

test("a detection is drawn at its pixels with word and distance, at any size of the image", () => {
  const pen = drawn(["found"]);
  expect(pen.circles).toContainEqual(expect.objectContaining({ x: 100, y: 200, radius: 10 }));
  expect(pen.texts.map(({ text }) => text)).toEqual(["opponent robot 2.0 m", "ball 1.2 m"]);
});

test("a word never covers its detection", () => {
  const pen = drawn(["found"], {
    vision: fields({
      image_width: 640,
      image_height: 480,
      ball: fields({ detection: fields({ camera: kTop, image_x: 620, image_y: 200 }), radius: 10 }),
    }),
  });
  expect(pen.boxes[0]!.x + pen.boxes[0]!.width).toBeLessThan(610);
});

test("the other camera's detections are not drawn", () => {
  expect(drawn(["found"], { camera: 2 }).points).toEqual([]);
});

test("nothing is drawn if nothing of the image's time is known", () => {
  expect(drawn(["found", "horizon", "lines"], { vision: undefined, optics: undefined }).points).toEqual([]);
  expect(drawn(["lines"], { pose: undefined }).points).toEqual([]);
  expect(drawn(["lines"]).points.length).toBeGreaterThan(50);
  expect(drawn(["horizon"]).points[0]!.x).toBe(0);
});

test("a place of the page and back is the pixel", () => {
  const fit = fitOf({ width: 640, height: 480 }, 900, 480);
  expect(fit).toMatchObject({ scale: 1, left: 130, top: 0 });
  expect(toImage(fit, toCanvas(fit, { x: 17, y: 33 }))).toEqual({ x: 17, y: 33 });
});

test("the lines are those of the field, and the robot's places are turned onto it", () => {
  const ends = linesOf(field).flat();
  expect(Math.max(...ends.map(({ x }) => x))).toBe(field.length / 2);
  expect(Math.max(...ends.map(({ y }) => y))).toBe(field.width / 2);
  const place = onField({ x: 1, y: 2, heading: Math.PI / 2 }, { x: 1, y: 0 });
  expect([place.x, place.y]).toEqual([expect.closeTo(1), expect.closeTo(3)]);
});

test("a pixel has the Y, U and V of the camera, also when they are read off the screen", () => {
  const yuyv = Uint8Array.of(10, 120, 30, 140, 50, 100, 70, 160);
  expect(yuvAt(yuyv, 4, { x: 1.7, y: 0.2 })).toEqual({ y: 30, u: 120, v: 140 });
  expect(yuvAt(yuyv, 2, { x: 0.5, y: 1.5 })).toEqual({ y: 50, u: 100, v: 160 });
  const [red, green, blue] = rgbaFromYuyv(Uint8Array.of(100, 120, 100, 140), 2, 1);
  const { y, u, v } = yuvOf(red!, green!, blue!);
  expect([Math.abs(y - 100), Math.abs(u - 120), Math.abs(v - 140)].every((difference) => difference <= 1)).toBe(true);
});
