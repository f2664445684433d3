import { expect, test } from "vitest";
import { truthOf } from "../memory/truth";
import type { Value } from "../memory/value";
import { drawPosts } from "./draw_posts";
import { drawOverSensor, kRealColour } from "./draw_sensor";
import { drawTruth, withSensors } from "./draw_truth";
import { cameraFor, kFields } from "./field";
import { matrixOf, orbitOver } from "./orbit";
import { fitOf } from "./overlay";
import { kLiveries, kUnknownLivery } from "./robot_sign";
import { kUncalibrated, opticsIn } from "./sensor_optics";
import { testPen } from "./test_pen";

const kField = kFields["spl2025"]!;
const kCamera = cameraFor(kField, 1000, 700);
const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const kTruth = truthOf(
  fields({
    robots: [
      fields({ x: 0, y: 0, track: 3, velocity_x: 1, velocity_y: 0 }),
      fields({ x: 1, y: 1, team: 14, player: 2 }),
    ],
    ball: fields({ x: -1, y: 0, covariance: fields({ xx: 0.01, xy: 0, yy: 0.04 }) }),
  }),
);
const kOptics = opticsIn(
  { width: 640, height: 480, focal: { x: 500, y: 500 }, centre: { x: 320, y: 240 } },
  kUncalibrated,
);
const liveryOf = ({ name }: { name: string }) => (name ? kLiveries.away : kUnknownLivery);
const texts = (pen: ReturnType<typeof testPen>) => [...new Set(pen.texts.map(({ text }) => text))].filter(Boolean);

test("robots have their player's number or track, and only moving things have arrows", () => {
  const [pen, still] = [testPen(), testPen()];
  const robots = kTruth.robots.map((robot) => ({ ...robot, velocity: undefined }));
  const rest = { field: kField, real: undefined, sensors: [], liveryOf };
  drawTruth(pen, kCamera, { ...rest, truth: kTruth });
  drawTruth(still, kCamera, { ...rest, truth: { ...kTruth, robots } });
  expect(texts(pen)).toEqual(["#3", "2"]);
  expect(pen.points.length).toBe(still.points.length + 5); // a line and two barbs
});

test("robots have the colours and shapes of their sides, and unknown ones their own", () => {
  const pen = testPen();
  drawTruth(pen, kCamera, { field: kField, truth: kTruth, real: undefined, sensors: [], liveryOf });
  const radius = kCamera.scale * 0.15;
  const discs = pen.circles.filter((circle) => circle.filled && Math.abs(circle.radius - radius) < 1e-9);
  expect(discs.map(({ style }) => style)).toEqual([kUnknownLivery.colour]);
  const squares = pen.polygons.filter(({ filled }) => filled);
  expect(squares.map(({ style, corners }) => [style, corners.length])).toEqual([[kLiveries.away.colour, 4]]);
});

test("without a truth the field is drawn, with its sensors and their numbers", () => {
  const pen = testPen();
  drawTruth(pen, kCamera, {
    field: kField,
    truth: undefined,
    real: undefined,
    sensors: [{ number: 4, optics: kOptics, chosen: true }],
    liveryOf,
  });
  expect(texts(pen)).toEqual(["4"]);
  expect(pen.polygons.filter(({ filled }) => filled)).toHaveLength(2);
});

test("the camera has room for sensors beside the field, and only for those", () => {
  expect(cameraFor(withSensors(kField, []), 1000, 700)).toEqual(kCamera);
  const far = { ...kOptics, at: { x: 0, y: -4.5, z: 2 } };
  const { length, width } = withSensors(kField, [{ number: 1, optics: far, chosen: true }]);
  expect(length).toBeCloseTo(kField.length + 2 * kField.border);
  expect(width / 2).toBeGreaterThan(4.5);
});

test("in the image, detections are labelled and true positions are crosses at their feet", () => {
  const pen = testPen();
  const fit = fitOf({ width: 640, height: 480 }, 640, 480);
  let colours: string[] = [];
  const stroke = pen.stroke;
  pen.stroke = () => ((colours = [...colours, String(pen.strokeStyle)]), stroke());
  drawOverSensor(pen, fit, { optics: kOptics, field: kField, lines: false, found: kTruth, real: kTruth });
  expect(texts(pen)).toEqual(["#3", "2", "ball"]);
  expect(colours.filter((colour) => colour === kRealColour)).toHaveLength(6);
  const none = testPen();
  drawOverSensor(none, fit, { optics: undefined, field: kField, lines: true, found: kTruth, real: kTruth });
  expect(none.points).toEqual([]);
});

test("among the points, each thing has a post", () => {
  const pen = testPen();
  const clip = matrixOf(
    orbitOver(
      [
        { x: -2, y: -2 },
        { x: 2, y: 2 },
      ],
      1.5,
    ),
    1.5,
  );
  drawPosts(pen, { clip, width: 600, height: 400 }, kTruth, undefined);
  expect(texts(pen)).toEqual(["#3", "2", "ball"]);
});
