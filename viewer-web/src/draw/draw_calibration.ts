// Drawings of a calibration: landmarks and their errors on the field and in the image, and the expected error over the
// field.

import type { Click, ErrorCell, Landmark, Residual } from "../memory/calibration";
import { fillCircle, fillPolygon, strokeCircle, toScreen, type Camera, type Pen, type Point } from "./field";
import { toPixel, type Optics } from "./optics";
import { orderedStyle } from "./ordered_colours";
import { label, stroke, ticks, toCanvas, type Fit } from "./overlay";
import { drawOutlined, kBright, kInk } from "./robot_sign";
import { isSeen } from "./sensor_optics";

/** [m] The error that has the brightest colour. */
export const kWorstError = 0.05;
const kGood = 1.5; // [px] as a careful click
const kPoor = 4; // [px]

/** How good a residual is. Words and signs say it too, never the colour alone. */
export const gradeOf = ({ pixels, outlier }: Residual): "good" | "fair" | "poor" =>
  outlier || !(pixels <= kPoor) ? "poor" : pixels <= kGood ? "good" : "fair";

const kGradeColours = { good: "#7cc4ff", fair: "#ffd36b", poor: "#ff8a4c" };
const kUnrated = "#ffffff";

/** The marks of a calibration: clicks of a person, and what the server knows of them. */
export interface Marks {
  landmarks: Landmark[];
  clicks: readonly Click[];
  residuals: ReadonlyMap<string, Residual>;
  /** The landmark that keys and the next click are for, or "". */
  chosen: string;
  /** A pixel that has no landmark yet. */
  pending: Point | undefined;
}

const colourOf = (marks: Marks, name: string): string => {
  const residual = marks.residuals.get(name);
  return residual ? kGradeColours[gradeOf(residual)] : kUnrated;
};

/** Returns the landmark nearest to a place on the canvas [px], within `reach`. */
export function landmarkAt(camera: Camera, landmarks: Landmark[], pointer: Point, reach: number): Landmark | undefined {
  return nearest(landmarks, (landmark) => toScreen(camera, landmark), pointer, reach);
}

/** Returns the click nearest to a place on the image's canvas [px], within `reach`. */
export const clickAt = (fit: Fit, clicks: readonly Click[], pointer: Point, reach: number): Click | undefined =>
  nearest(clicks, (click) => toCanvas(fit, click), pointer, reach);

function nearest<T>(things: readonly T[], placeOf: (thing: T) => Point, pointer: Point, reach: number): T | undefined {
  let [found, least]: [T | undefined, number] = [undefined, reach];
  for (const thing of things) {
    const { x, y } = placeOf(thing);
    const away = Math.hypot(x - pointer.x, y - pointer.y);
    if (away <= least) [found, least] = [thing, away];
  }
  return found;
}

/** Draws the expected error over the field as coloured cells. */
export function drawErrors(pen: Pen, camera: Camera, grid: ErrorCell[]): void {
  const [across, up] = [spacingOf(grid.map(({ x }) => x)), spacingOf(grid.map(({ y }) => y))];
  pen.globalAlpha = 0.62;
  for (const { x, y, metres } of grid)
    fillPolygon(
      pen,
      camera,
      [
        { x: x - across / 2, y: y - up / 2 },
        { x: x + across / 2, y: y - up / 2 },
        { x: x + across / 2, y: y + up / 2 },
        { x: x - across / 2, y: y + up / 2 },
      ],
      orderedStyle(metres / kWorstError),
    );
  pen.globalAlpha = 1;
}

/** Returns the least distance between different values, which is a grid's spacing. */
function spacingOf(values: number[]): number {
  const sorted = [...new Set(values)].sort((a, b) => a - b);
  const steps = sorted.slice(1).map((value, i) => value - sorted[i]!);
  return Math.min(...steps.filter((step) => step > 1e-6), 0.5);
}

/** Draws the landmarks on the field: rings, filled once they were clicked in the image. */
export function drawLandmarks(pen: Pen, camera: Camera, marks: Marks): void {
  const clicked = new Set(marks.clicks.map(({ landmark }) => landmark));
  for (const landmark of marks.landmarks) {
    const isChosen = landmark.name === marks.chosen;
    const radius = (isChosen ? 7 : 5) / camera.scale;
    pen.globalAlpha = 1;
    fillCircle(
      pen,
      camera,
      landmark,
      radius,
      clicked.has(landmark.name) ? colourOf(marks, landmark.name) : "#0d1712aa",
    );
    pen.strokeStyle = kInk;
    pen.lineWidth = 4;
    strokeCircle(pen, camera, landmark, radius);
    pen.strokeStyle = isChosen || !clicked.has(landmark.name) ? kBright : colourOf(marks, landmark.name);
    pen.lineWidth = isChosen ? 2.5 : 1.5;
    strokeCircle(pen, camera, landmark, radius);
  }
  const chosen = marks.landmarks.find(({ name }) => name === marks.chosen);
  if (chosen) drawOutlined(pen, toScreen(camera, chosen), -17, chosen.name, { colour: kBright, weight: 650 });
}

/** Draws clicks in the image, each with a line to the place where the fit puts its landmark. */
export function drawClicks(pen: Pen, fit: Fit, marks: Marks, optics: Optics | undefined): void {
  for (const click of marks.clicks) {
    const landmark = marks.landmarks.find(({ name }) => name === click.landmark);
    const isChosen = click.landmark === marks.chosen;
    const projected = optics && landmark && toPixel(optics, landmark);
    const colour = colourOf(marks, click.landmark);
    const at = toCanvas(fit, click);
    if (projected) stroke(pen, colour, 1.5, [at, toCanvas(fit, projected)]);
    drawTarget(pen, at, colour, isChosen);
    if (isChosen) label(pen, fit, click.landmark, { x: at.x + 16, y: at.y - 14 }, colour, at.x - 16);
  }
  if (optics) for (const landmark of marks.landmarks) drawExpected(pen, fit, marks, optics, landmark);
  if (marks.pending) drawTarget(pen, toCanvas(fit, marks.pending), kUnrated, true);
  pen.globalAlpha = 1;
}

/** Draws an open target, so that the pixel in its middle stays visible. */
function drawTarget(pen: Pen, at: Point, colour: string, bold: boolean): void {
  ticks(pen, at, 3, bold ? 13 : 8, colour, bold ? 2 : 1.5);
}

/** Draws a diamond where a landmark without a click should be. */
function drawExpected(pen: Pen, fit: Fit, { clicks, chosen }: Marks, optics: Optics, landmark: Landmark): void {
  if (clicks.some((click) => click.landmark === landmark.name)) return;
  const pixel = toPixel(optics, landmark);
  if (!pixel || !isSeen(optics, landmark)) return;
  const { x, y } = toCanvas(fit, pixel);
  const size = landmark.name === chosen ? 9 : 5;
  const corners = [
    { x, y: y - size },
    { x: x + size, y },
    { x, y: y + size },
    { x: x - size, y },
  ];
  stroke(pen, kUnrated, landmark.name === chosen ? 2 : 1, corners, true);
}
