// Drawings over the image of a sensor: the field's lines by its calibration, detections, and true positions.

import { labelOf, thingsIn, type Sensor, type Truth, type TrueThing } from "../memory/truth";
import type { Field, Pen, Point } from "./field";
import { toPixel, type Optics, type Place } from "./optics";
import { cross, drawFieldLines, kOverlayColours, label, stroke, toCanvas, type Fit } from "./overlay";
import { kRobotRadius } from "./robot_sign";

const kHeight = 0.58; // [m] of a standing Nao
const kLying = 0.25; // [m] of a fallen one
export const kTrueBallRadius = 0.05; // [m]
export const kRealColour = "#ffe14d"; // true positions, in all drawings of this view
export const kBallColour = kOverlayColours.ball;

export interface Over {
  /** Undefined without a calibration. */
  optics: Optics | undefined;
  field: Field;
  lines: boolean;
  /** The sensor's own detections. Undefined: not drawn. */
  found: Pick<Sensor, "robots" | "ball"> | undefined;
  /** True positions of a synthetic scene. */
  real: Truth | undefined;
}

export function drawOverSensor(pen: Pen, fit: Fit, { optics, field, lines, found, real }: Over): void {
  if (!optics) return;
  if (lines) drawFieldLines(pen, fit, optics, field, onGround);
  if (found) {
    for (const robot of found.robots) drawRobot(pen, fit, optics, robot);
    if (found.ball) drawBall(pen, fit, optics, found.ball);
  }
  for (const thing of thingsIn(real)) {
    const pixel = toPixel(optics, onGround(thing));
    if (pixel) cross(pen, toCanvas(fit, pixel), 5, kRealColour);
  }
  pen.globalAlpha = 1;
}

const onGround = ({ x, y }: Point): Place => ({ x, y, z: 0 });

/** [px of the image] of one metre at a place, or undefined behind the sensor. */
function scaleAt(optics: Optics, place: Place): number | undefined {
  const [low, high] = [toPixel(optics, place), toPixel(optics, { ...place, z: place.z + 0.1 })];
  return low && high && Math.hypot(high.x - low.x, high.y - low.y) * 10;
}

/** Draws a box around a robot, as wide as its arms. */
function drawRobot(pen: Pen, fit: Fit, optics: Optics, robot: TrueThing): void {
  const height = robot.fallen ? kLying : kHeight;
  const [foot, top] = [toPixel(optics, onGround(robot)), toPixel(optics, { ...robot, z: height })];
  const scale = scaleAt(optics, { ...robot, z: height / 2 });
  if (!foot || !top || !scale) return;
  const half = kRobotRadius * scale * 1.1;
  const [left, right] = [Math.min(foot.x, top.x) - half, Math.max(foot.x, top.x) + half];
  const [high, low] = [Math.min(foot.y, top.y), Math.max(foot.y, top.y) + 0.1 * half];
  const corners = [
    { x: left, y: high },
    { x: right, y: high },
    { x: right, y: low },
    { x: left, y: low },
  ].map((corner) => toCanvas(fit, corner));
  stroke(pen, kOverlayColours.robot, 2, corners, true);
  const words = [labelOf(robot), robot.fallen ? "fallen" : ""].filter(Boolean).join(" ");
  if (words) label(pen, fit, words, { x: corners[0]!.x, y: corners[0]!.y - 11 }, kOverlayColours.robot);
}

function drawBall(pen: Pen, fit: Fit, optics: Optics, ball: TrueThing): void {
  const centre = { x: ball.x, y: ball.y, z: kTrueBallRadius };
  const [pixel, scale] = [toPixel(optics, centre), scaleAt(optics, centre)];
  if (!pixel || !scale) return;
  const { x, y } = toCanvas(fit, pixel);
  const radius = Math.max(5, 1.3 * fit.scale * kTrueBallRadius * scale);
  const ring = Array.from({ length: 24 }, (_, i) => ({
    x: x + radius * Math.cos((i * Math.PI) / 12),
    y: y + radius * Math.sin((i * Math.PI) / 12),
  }));
  stroke(pen, kBallColour, 2.5, ring, true);
  label(pen, fit, "ball", { x: x + radius + 5, y }, kBallColour, x - radius - 5);
}
