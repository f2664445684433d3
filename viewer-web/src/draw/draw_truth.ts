// The field from above with ground truth: fused things, the true positions of a synthetic scene, and the sensors with the
// ground that they see.

import { pairsOf } from "../memory/truth_errors";
import { labelOf, thingsIn, type Truth, type TrueThing } from "../memory/truth";
import { axesOf } from "./beliefs";
import {
  drawField,
  fillCircle,
  fillPolygon,
  strokeArrow,
  strokeCircle,
  strokeCross,
  strokeEllipse,
  strokeLine,
  strokePolygon,
  style,
  toScreen,
  type Camera,
  type Field,
  type Pen,
  type Point,
} from "./field";
import { kBallColour, kRealColour, kTrueBallRadius } from "./draw_sensor";
import { footprintOf } from "./sensor_optics";
import type { Optics } from "./optics";
import {
  ahead,
  drawFallen,
  drawOutlined,
  fillBody,
  kBright,
  kInk,
  kRobotRadius,
  strokeBody,
  strokeHeading,
  type Livery,
} from "./robot_sign";

export interface SeenSensor {
  number: number;
  optics: Optics;
  chosen: boolean;
}

export interface TruthDrawing {
  field: Field;
  truth: Truth | undefined;
  /** True positions of a synthetic scene. */
  real: Truth | undefined;
  sensors: SeenSensor[];
  liveryOf(robot: TrueThing): Livery;
}

const kDeviations = 3; // drawn of a position's error: the thing is inside in 99 of 100 cases
const kAhead = 0.5; // [s] of a velocity's arrow
const kSlowest = 0.05; // [m/s] slower things have no arrow
const kSensorSize = 0.3; // [m]
const kArm = 0.05; // [m] of a cross
const kEdge = 0.45; // [m] of room around a sensor
const kWidest = 2.5; // [m] beyond the lines

/** A field as large as this one with the sensors beside it, for the camera: all of them are on the canvas. */
export function withSensors(field: Field, sensors: SeenSensor[]): Field {
  const reach = (size: number, places: number[]) => {
    const outermost = Math.max(...places.map((place) => Math.abs(place) + kEdge), size / 2 + field.border);
    return 2 * Math.min(outermost, size / 2 + kWidest);
  };
  const at = sensors.map(({ optics }) => optics.at);
  return {
    ...field,
    length: reach(
      field.length,
      at.map(({ x }) => x),
    ),
    width: reach(
      field.width,
      at.map(({ y }) => y),
    ),
    border: 0,
  };
}

export function drawTruth(pen: Pen, camera: Camera, { field, truth, real, sensors, liveryOf }: TruthDrawing): void {
  drawField(pen, camera, field);
  for (const sensor of sensors) drawFootprint(pen, camera, sensor);
  for (const robot of truth?.robots ?? []) drawRobot(pen, camera, robot, liveryOf(robot));
  if (truth?.ball) drawBall(pen, camera, truth.ball);
  for (const thing of thingsIn(truth)) drawMotion(pen, camera, thing);
  drawReal(pen, camera, truth, real);
  for (const sensor of sensors) drawSensor(pen, camera, sensor);
  pen.globalAlpha = 1;
}

function drawRobot(pen: Pen, camera: Camera, robot: TrueThing, livery: Livery): void {
  pen.globalAlpha = 1;
  fillBody(pen, camera, robot, livery);
  style(pen, kInk, 1.5);
  strokeBody(pen, camera, robot, livery);
  style(pen, livery.colour, 3);
  strokeHeading(pen, camera, robot);
  const above = -(kRobotRadius * camera.scale + 10);
  drawOutlined(pen, toScreen(camera, robot), above, labelOf(robot), { colour: kBright, weight: 650 });
  if (robot.fallen) drawFallen(pen, camera, robot);
  drawError(pen, camera, robot);
}

function drawBall(pen: Pen, camera: Camera, ball: TrueThing): void {
  pen.globalAlpha = 1;
  fillCircle(pen, camera, ball, kTrueBallRadius * 1.2, kBallColour);
  style(pen, kInk, 1.5);
  strokeCircle(pen, camera, ball, kTrueBallRadius * 1.2);
  drawError(pen, camera, ball);
}

function drawError(pen: Pen, camera: Camera, thing: TrueThing): void {
  if (!thing.covariance) return;
  const { a, b, angle } = axesOf(thing.covariance);
  const size = { a: kDeviations * a, b: kDeviations * b, angle };
  style(pen, kInk, 3, 0.4);
  strokeEllipse(pen, camera, thing, size);
  style(pen, kBright, 1.5, 0.95);
  strokeEllipse(pen, camera, thing, size);
}

function drawMotion(pen: Pen, camera: Camera, { x, y, velocity }: TrueThing): void {
  if (!velocity || Math.hypot(velocity.x, velocity.y) < kSlowest) return;
  style(pen, kBright, 2);
  strokeArrow(pen, camera, { x, y }, { x: x + kAhead * velocity.x, y: y + kAhead * velocity.y });
}

/** Draws crosses at true positions, each with a line to the thing that was found there. */
function drawReal(pen: Pen, camera: Camera, truth: Truth | undefined, real: Truth | undefined): void {
  if (!real) return;
  const pairs = [
    ...pairsOf(truth?.robots ?? [], real.robots),
    ...pairsOf(truth?.ball ? [truth.ball] : [], real.ball ? [real.ball] : []),
  ];
  style(pen, kRealColour, 1.5, 0.9);
  for (const pair of pairs) strokeLine(pen, camera, pair.found, pair.real);
  for (const thing of thingsIn(real)) {
    style(pen, kInk, 4, 0.6);
    strokeCross(pen, camera, thing, kArm);
    style(pen, kRealColour, 2);
    strokeCross(pen, camera, thing, kArm);
  }
}

function drawFootprint(pen: Pen, camera: Camera, { optics, chosen }: SeenSensor): void {
  const outline = footprintOf(optics);
  pen.globalAlpha = chosen ? 0.12 : 0.05;
  fillPolygon(pen, camera, outline, kBright);
  style(pen, kBright, 1, chosen ? 0.6 : 0.3);
  strokePolygon(pen, camera, outline);
}

/** Draws a wedge that opens in the direction of the view, with the sensor's number behind it. */
function drawSensor(pen: Pen, camera: Camera, { number, optics, chosen }: SeenSensor): void {
  const { at, rotation } = optics;
  const heading = Math.atan2(rotation[5]!, rotation[2]!);
  const corner = (side: number): Point => ahead({ ...at, heading: heading + side * 0.5 }, kSensorSize);
  pen.globalAlpha = 1;
  fillPolygon(pen, camera, [at, corner(-1), corner(1)], chosen ? kBright : "#aab7be");
  style(pen, kInk, 1);
  strokePolygon(pen, camera, [at, corner(-1), corner(1)]);
  const { x, y } = toScreen(camera, ahead({ ...at, heading }, -0.2));
  drawOutlined(pen, { x, y }, 0, String(number), { colour: kBright, weight: 700 });
}
