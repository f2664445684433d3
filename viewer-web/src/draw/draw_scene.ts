// Draws a game, layer by layer: the truth in full, the chosen robot's beliefs over it, the others' beliefs faintly. A
// filled disc is a robot's true place, an outline its believed one.

import type { Path } from "../memory/forecast";
import type { BallBelief, Beliefs, Pose, PoseBelief } from "./beliefs";
import {
  drawField,
  fillCircle,
  fillEllipse,
  fillSector,
  strokeArrow,
  strokeCircle,
  strokeEllipse,
  strokeCross,
  strokeLine,
  strokePath,
  style,
  toScreen,
} from "./field";
import type { Camera, Field, Pen, Point } from "./field";
import { drawPaths } from "./futures";
import {
  ahead,
  drawFallen,
  drawNumber,
  drawOutlined,
  drawWord,
  fillBody,
  kBright,
  kInk,
  kRobotRadius,
  strokeBody,
  strokeHeading,
} from "./robot_sign";
import type { Robot, Scene } from "./scene";

export const kLayers = {
  truth: "what is so, where somebody tells it",
  belief: "where robots believe to be, and the ball",
  error: "lines from belief to truth",
  uncertainty: "one standard deviation",
  view: "where the camera looks",
  intent: "walk target and kick",
  team: "teammates, as the chosen robot believes them",
  opponents: "opponents, as the chosen robot believes them",
  trail: "the last seconds of ball and robot",
  forecast: "the futures of the newest forecast's choice",
  names: "what robots are doing, in words",
  everyone: "all this for every robot, not only the chosen one",
};
export type Layer = keyof typeof kLayers;
export const kUsualLayers: Layer[] = [
  "truth",
  "belief",
  "error",
  "uncertainty",
  "view",
  "intent",
  "opponents",
  "trail",
];

/** In the frame `field`. */
export interface Foreseen {
  paths: Path[];
  /** The colour of the team that foresees. */
  colour: string;
}

export interface TrailPoint extends Point {
  /** No way leads here from the point before. */
  leaps?: boolean;
}

/** Everything that a scene is drawn from. Trails go from old to new. */
export interface Drawing {
  field: Field;
  chosen: string;
  layers: ReadonlySet<Layer>;
  trails: { key: string; points: TrailPoint[]; kind: "ball" | "truth" | "belief" }[];
  /** The newest forecast's rollouts, and its team's colour. */
  foreseen?: Foreseen | undefined;
}

const kBallRadius = 0.05; // [m] larger than the real ball, to be visible
const kViewRange = 1.6; // [m] of the drawn cone

/** 1 for a thing seen just now, falling to 0.15 after five seconds. */
export const freshness = (age: number): number => Math.min(1, Math.max(0.15, 1 - age / 5));

/** The chosen robot's beliefs are white, to contrast with the bodies. */
const inkOf = ({ livery }: Robot, front: boolean): string => (front ? kBright : livery.colour);

export function drawScene(
  pen: Pen,
  camera: Camera,
  scene: Scene,
  { field, chosen, layers, trails, foreseen }: Drawing,
): void {
  const isFront = ({ key }: Robot) => key === chosen;
  const inOrder = [...scene.robots].sort((a, b) => Number(isFront(a)) - Number(isFront(b)));
  const detailed = inOrder.filter((robot) => isFront(robot) || layers.has("everyone"));
  const when = (layer: Layer, draw: () => void) => layers.has(layer) && draw();

  drawField(pen, camera, field);
  when(
    "forecast",
    () => foreseen && drawPaths(pen, camera, foreseen.paths, { strength: 0.45, colour: foreseen.colour }),
  );
  when("view", () => detailed.forEach((robot) => drawView(pen, camera, robot)));
  when("trail", () => drawTrails(pen, camera, scene, trails));
  when("belief", () =>
    inOrder.filter((robot) => !detailed.includes(robot)).forEach((robot) => drawFaintBeliefs(pen, camera, robot)),
  );
  when("team", () => detailed.forEach((robot) => drawTeammates(pen, camera, robot)));
  when("opponents", () => detailed.forEach((robot) => drawOpponents(pen, camera, robot)));
  when("truth", () =>
    scene.robots.forEach((robot) => robot.truth && drawRobot(pen, camera, robot, robot.truth, isFront(robot))),
  );
  when("truth", () => scene.ball && drawBall(pen, camera, scene.ball));
  when("error", () =>
    detailed.forEach((robot) => drawErrors(pen, camera, robot, scene, layers.has("belief") && layers.has("truth"))),
  );
  when("uncertainty", () => detailed.forEach((robot) => drawUncertainty(pen, camera, robot, isFront(robot))));
  when("belief", () => detailed.forEach((robot) => drawBeliefs(pen, camera, robot, isFront(robot))));
  when("intent", () => detailed.forEach((robot) => drawIntent(pen, camera, robot, isFront(robot))));
  when("names", () => inOrder.forEach((robot) => drawName(pen, camera, robot, isFront(robot))));
  pen.globalAlpha = 1;
}

function dashed(pen: Pen, draw: () => void): void {
  pen.setLineDash([4, 4]);
  draw();
  pen.setLineDash([]);
}

function drawRobot(pen: Pen, camera: Camera, robot: Robot, pose: Pose, front: boolean): void {
  pen.globalAlpha = 1;
  fillBody(pen, camera, pose, robot.livery);
  style(pen, front ? kBright : kInk, front ? 3 : 1.5);
  strokeBody(pen, camera, pose, robot.livery);
  style(pen, front ? kBright : robot.livery.colour, 3);
  strokeHeading(pen, camera, pose);
  drawNumber(pen, camera, numberOf(robot), pose, robot.livery);
  if (robot.fallen) drawFallen(pen, camera, pose);
}

/** Short: a body has room for three characters. */
const numberOf = ({ name }: Robot): string => /(?:\/|^)(#?\d+)$/.exec(name)?.[1] ?? "";

function drawBall(pen: Pen, camera: Camera, ball: NonNullable<Scene["ball"]>): void {
  pen.globalAlpha = 1;
  fillCircle(pen, camera, ball, kBallRadius, kBright);
  style(pen, kInk, 1.5);
  strokeCircle(pen, camera, ball, kBallRadius);
}

function drawFaintBeliefs(pen: Pen, camera: Camera, robot: Robot): void {
  const { pose, ball } = robot;
  if (!pose) return;
  if (!robot.truth) drawBelievedBody(pen, camera, robot, pose, 0.6);
  style(pen, robot.livery.colour, 1, 0.45 * freshness(pose.age));
  strokeBody(pen, camera, pose, robot.livery);
  strokeHeading(pen, camera, pose);
  if (ball) drawBelievedBall(pen, camera, robot, ball, 0.45);
}

function drawBeliefs(pen: Pen, camera: Camera, robot: Robot, front: boolean): void {
  const { pose, ball } = robot;
  if (!pose) return;
  if (!robot.truth) drawBelievedBody(pen, camera, robot, pose, 1);
  style(pen, inkOf(robot, front), front ? 2 : 1.5, freshness(pose.age));
  strokeBody(pen, camera, pose, robot.livery);
  strokeHeading(pen, camera, pose);
  if (ball) drawBelievedBall(pen, camera, robot, ball, 1);
}

/** Draws a robot at its believed place. Without the truth, the belief gets the body. */
function drawBelievedBody(pen: Pen, camera: Camera, robot: Robot, pose: PoseBelief, strength: number): void {
  pen.globalAlpha = 0.8 * strength * freshness(pose.age);
  fillBody(pen, camera, pose, robot.livery);
  drawNumber(pen, camera, numberOf(robot), pose, robot.livery);
}

function drawBelievedBall(pen: Pen, camera: Camera, robot: Robot, ball: BallBelief, strength: number): void {
  pen.globalAlpha = strength * freshness(ball.age);
  fillCircle(pen, camera, ball, 0.8 * kBallRadius, robot.livery.colour);
  if (strength < 1) return;
  style(pen, kInk, 1, pen.globalAlpha);
  strokeCircle(pen, camera, ball, 0.8 * kBallRadius);
  // its place in one second
  style(pen, robot.livery.colour, 2, pen.globalAlpha);
  if (Math.hypot(ball.velocity.x, ball.velocity.y) > 0.05)
    strokeArrow(pen, camera, ball, { x: ball.x + ball.velocity.x, y: ball.y + ball.velocity.y });
}

function drawErrors(pen: Pen, camera: Camera, { truth, pose, ball }: Robot, scene: Scene, shown: boolean): void {
  if (!shown || !pose) return;
  style(pen, "#ffe14d", 1.5, 0.9);
  const between = (a: Point, b: Point) => dashed(pen, () => strokeLine(pen, camera, a, b));
  if (truth) between(truth, pose);
  pen.globalAlpha = ball ? 0.9 * freshness(ball.age) : 0;
  if (scene.ball && ball) between(scene.ball, ball);
}

function drawUncertainty(pen: Pen, camera: Camera, robot: Robot, front: boolean): void {
  const { pose, ball } = robot;
  if (!pose) return;
  const draw = (at: Point, size: PoseBelief["uncertainty"], age: number) => {
    pen.globalAlpha = 0.14 * freshness(age);
    fillEllipse(pen, camera, at, size, inkOf(robot, front));
    style(pen, inkOf(robot, front), 1, 0.8 * freshness(age));
    strokeEllipse(pen, camera, at, size);
  };
  draw(pose, pose.uncertainty, pose.age);
  if (ball && ball.deviation > 0) draw(ball, ball.uncertainty, ball.age);
}

function drawView(pen: Pen, camera: Camera, robot: Robot): void {
  const { pose, view, truth } = robot;
  if (!pose || !view) return;
  // the head turns with the true body, not with the believed one
  const body = truth && Number.isFinite(truth.heading) ? truth : pose;
  const angle = view.angle - pose.heading + body.heading;
  pen.globalAlpha = 0.13 * freshness(pose.age);
  fillSector(pen, camera, body, angle, view.half, kViewRange, kBright);
  style(pen, kBright, 1, 0.35 * freshness(pose.age));
  strokeLine(pen, camera, body, ahead({ ...body, heading: angle }, kViewRange));
}

function drawIntent(pen: Pen, camera: Camera, robot: Robot, front: boolean): void {
  const { pose, target, kick } = robot;
  if (pose && target) {
    style(pen, inkOf(robot, front), 1.5, 0.8);
    dashed(pen, () => strokeLine(pen, camera, pose, target));
    strokeCross(pen, camera, target, 0.07);
    strokeLine(pen, camera, target, ahead(target, 0.2));
  }
  if (kick) {
    style(pen, inkOf(robot, front), 3, 1);
    strokeArrow(pen, camera, kick.from, kick.to, 0.14);
  }
}

function drawTeammates(pen: Pen, camera: Camera, { teammates, livery }: Robot): void {
  for (const mate of teammates) {
    style(pen, livery.colour, 1.5, 0.9 * freshness(mate.age / 3));
    dashed(pen, () => strokeBody(pen, camera, mate, livery));
    strokeHeading(pen, camera, mate, 0);
    drawWord(pen, camera, String(mate.player), beside(mate), livery.colour);
    if (mate.fallen) drawFallen(pen, camera, mate);
  }
}

const beside = ({ x, y }: Point): Point => ({ x, y: y + 1.9 * kRobotRadius });

/** Draws crosses in the other team's colour, which differ clearly from true places. */
function drawOpponents(pen: Pen, camera: Camera, { opponents, rivals }: Robot): void {
  for (const opponent of opponents) {
    style(pen, rivals.colour, 2, 0.9 * freshness(opponent.age / 3));
    strokeCross(pen, camera, opponent, 0.6 * kRobotRadius);
    style(pen, rivals.colour, 1.5, pen.globalAlpha);
    dashed(pen, () => strokeCircle(pen, camera, opponent, Math.max(kRobotRadius, opponent.deviation)));
    if (opponent.player !== undefined) drawWord(pen, camera, String(opponent.player), beside(opponent), rivals.colour);
  }
}

function drawTrails(pen: Pen, camera: Camera, { robots }: Scene, trails: Drawing["trails"]): void {
  const kParts = 4; // number of parts; older ones are fainter
  for (const { key, points, kind } of trails) {
    const robot = robots.find((robot) => robot.key === key);
    const colour = kind === "truth" && robot ? robot.livery.colour : kBright;
    for (let part = 0; part < kParts; ++part) {
      const piece = points.slice(
        Math.floor((part * (points.length - 1)) / kParts),
        Math.floor(((part + 1) * (points.length - 1)) / kParts) + 1,
      );
      style(pen, colour, kind === "ball" ? 2 : 1.5, (kind === "belief" ? 0.5 : 0.75) * ((part + 1) / kParts));
      for (const way of waysOf(piece))
        if (kind === "belief") dashed(pen, () => strokePath(pen, camera, way));
        else strokePath(pen, camera, way);
    }
  }
}

/** The parts of a trail without a leap, of two points or more. */
function waysOf(points: TrailPoint[]): TrailPoint[][] {
  const ways: TrailPoint[][] = [];
  for (const point of points)
    if (point.leaps || ways.length === 0) ways.push([point]);
    else ways.at(-1)!.push(point);
  return ways.filter((way) => way.length > 1);
}

function drawName(pen: Pen, camera: Camera, robot: Robot, front: boolean): void {
  const at = robot.truth ?? robot.pose;
  const words = wordsOf(robot);
  if (!at || !words) return;
  pen.globalAlpha = front ? 1 : 0.85;
  drawOutlined(pen, toScreen(camera, at), camera.scale * kRobotRadius * 1.8 + 8, words, {
    colour: front ? kBright : "#dfe9e2",
    weight: front ? 600 : 400,
  });
}

const wordsOf = ({ role, skill }: Beliefs): string => [role, skill.replaceAll("_", " ")].filter(Boolean).join(" · ");
