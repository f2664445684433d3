import { expect, test } from "vitest";
import { clickAt, drawClicks, drawErrors, drawLandmarks, gradeOf, landmarkAt, type Marks } from "./draw_calibration";
import { toScreen, type Camera } from "./field";
import { fitOf, toCanvas } from "./overlay";
import { kUncalibrated, opticsIn } from "./sensor_optics";
import { testPen } from "./test_pen";

const kCamera: Camera = { scale: 60, centreX: 300, centreY: 200, turns: 1 };
const kLandmarks = [
  { name: "corner", x: 4.5, y: 3, z: 0 },
  { name: "mark", x: 0, y: 1, z: 0 },
];
const kMarks: Marks = {
  landmarks: kLandmarks,
  clicks: [{ landmark: "mark", x: 100, y: 120 }],
  residuals: new Map([["mark", { landmark: "mark", pixels: 0.5, outlier: false }]]),
  chosen: "",
  pending: undefined,
};
const kFit = fitOf({ width: 640, height: 480 }, 640, 480);

test("the nearest landmark is picked, and none beyond the reach", () => {
  const { x, y } = toScreen(kCamera, kLandmarks[1]!);
  expect(landmarkAt(kCamera, kLandmarks, { x: x + 5, y: y - 5 }, 10)?.name).toBe("mark");
  expect(landmarkAt(kCamera, kLandmarks, { x: x + 15, y }, 10)).toBeUndefined();
  const { x: left, y: top } = toCanvas(kFit, kMarks.clicks[0]!);
  expect(clickAt(kFit, kMarks.clicks, { x: left + 3, y: top }, 10)?.landmark).toBe("mark");
});

test("a residual is good, fair or poor, and an outlier is poor", () => {
  const grade = (pixels: number, outlier = false) => gradeOf({ landmark: "", pixels, outlier });
  expect([grade(0.5), grade(3), grade(9), grade(0.5, true), grade(NaN)]).toEqual([
    "good",
    "fair",
    "poor",
    "poor",
    "poor",
  ]);
});

test("only the chosen landmark is named on the field, and all are drawn", () => {
  const pen = testPen();
  drawLandmarks(pen, kCamera, { ...kMarks, chosen: "corner" });
  expect(new Set(pen.texts.map(({ text }) => text))).toEqual(new Set(["corner"]));
  expect(pen.circles.filter(({ filled }) => filled)).toHaveLength(2);
});

test("a click has a line to the place where the fit puts its landmark", () => {
  const optics = opticsIn(
    { width: 640, height: 480, focal: { x: 500, y: 500 }, centre: { x: 320, y: 240 } },
    kUncalibrated,
  );
  const pen = testPen();
  drawClicks(pen, kFit, kMarks, optics);
  // the mark is 4 m ahead and 1 m below the sensor
  expect(pen.points).toContainEqual({ x: 320, y: 365 });
  expect(pen.points).toContainEqual({ x: 100, y: 120 });
});

test("the cells of the errors touch each other, whatever their spacing", () => {
  const pen = testPen();
  const grid = [0, 0.25, 0.5].flatMap((x) => [0, 0.5].map((y) => ({ x, y, metres: 0.01 })));
  drawErrors(pen, { ...kCamera, turns: 0 }, grid);
  expect(pen.polygons).toHaveLength(6);
  const widths = pen.polygons.map(({ corners }) => corners[1]!.x - corners[0]!.x);
  expect(widths).toEqual(widths.map(() => expect.closeTo(15)));
});
