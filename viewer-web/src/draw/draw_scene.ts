// Draws a game: what is true in full, what the chosen robot believes over it, what the others believe faintly.

import { drawField, fillCircle, strokeCircle, strokeLine, toScreen, type Camera, type Pen, type Point } from "./field";
import type { BallBelief, Pose, Robot, Scene } from "./scene";

const kRobotRadius = 0.15; // [m] of a Nao from above, arms included
const kBallRadius = 0.05; // [m] a little larger than it is, to be seen
const kColours = { home: "#5aa9f8", away: "#ff9f40" };
const kInk = "#0d1712";

/** 1 for a ball seen just now, falling to 0.15 after five seconds unseen. */
export const freshness = (age: number): number => Math.min(1, Math.max(0.15, 1 - age / 5));

export function drawScene(pen: Pen, camera: Camera, scene: Scene, chosen: string): void {
  drawField(pen, camera, scene.field);
  for (const robot of scene.robots) if (robot.name !== chosen) drawBeliefs(pen, camera, robot, 0.35);
  for (const robot of scene.robots) if (robot.truth) drawRobot(pen, camera, robot, robot.truth, robot.name === chosen);
  if (scene.ball) drawBall(pen, camera, scene.ball);
  const own = scene.robots.find(({ name }) => name === chosen);
  if (own) drawBeliefs(pen, camera, own, 1);
}

/** The robot nearest to `point`, if it is near enough to be meant. */
export function robotAt(scene: Scene, point: Point): Robot | undefined {
  const distance = ({ truth, pose }: Robot) => {
    const place = truth ?? pose;
    return place ? Math.hypot(place.x - point.x, place.y - point.y) : Infinity;
  };
  const [nearest] = [...scene.robots].sort((a, b) => distance(a) - distance(b));
  return nearest && distance(nearest) < 2 * kRobotRadius ? nearest : undefined;
}

const colourOf = ({ home }: Robot): string => (home ? kColours.home : kColours.away);

function drawRobot(pen: Pen, camera: Camera, robot: Robot, pose: Pose, chosen: boolean): void {
  pen.globalAlpha = robot.fallen ? 0.55 : 1;
  fillCircle(pen, camera, pose, kRobotRadius, colourOf(robot));
  pen.strokeStyle = chosen ? "#ffffff" : kInk;
  pen.lineWidth = chosen ? 3 : 1.5;
  strokeCircle(pen, camera, pose, kRobotRadius);
  pen.strokeStyle = chosen ? "#ffffff" : colourOf(robot);
  pen.lineWidth = 3;
  if (Number.isFinite(pose.heading)) strokeLine(pen, camera, ahead(pose, kRobotRadius), ahead(pose, 1.7 * kRobotRadius));

  const { x, y } = toScreen(camera, pose);
  pen.fillStyle = kInk;
  pen.font = `600 ${Math.max(10, Math.round(0.17 * camera.scale))}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(robot.name.split("/").at(-1)!, x, y);
  pen.globalAlpha = 1;
}

function drawBall(pen: Pen, camera: Camera, ball: Point): void {
  fillCircle(pen, camera, ball, kBallRadius, "#ffffff");
  pen.strokeStyle = kInk;
  pen.lineWidth = 1.5;
  strokeCircle(pen, camera, ball, kBallRadius);
}

/** An outline where the robot believes to stand, a dot in its colour where it believes the ball, the errors dashed. */
function drawBeliefs(pen: Pen, camera: Camera, robot: Robot, strength: number): void {
  if (!robot.pose) return;
  const { pose, ball } = robot;
  pen.strokeStyle = strength === 1 ? "#ffffff" : colourOf(robot);
  pen.lineWidth = strength === 1 ? 2 : 1;
  pen.globalAlpha = strength;
  strokeCircle(pen, camera, pose, kRobotRadius);
  strokeLine(pen, camera, pose, ahead(pose, 1.7 * kRobotRadius));
  if (strength === 1) {
    pen.setLineDash([4, 4]);
    strokeCircle(pen, camera, pose, Math.max(pose.deviation, kRobotRadius));
    pen.setLineDash([]);
  }
  if (ball) drawBelievedBall(pen, camera, robot, ball, strength);
  pen.globalAlpha = 1;
}

function drawBelievedBall(pen: Pen, camera: Camera, robot: Robot, ball: BallBelief, strength: number): void {
  pen.globalAlpha = strength * freshness(ball.age);
  if (strength === 1) {
    pen.setLineDash([4, 4]);
    strokeCircle(pen, camera, ball, Math.max(ball.deviation, kBallRadius));
    strokeLine(pen, camera, robot.pose!, ball);
    pen.setLineDash([]);
  }
  fillCircle(pen, camera, ball, 0.8 * kBallRadius, colourOf(robot));
}

const ahead = ({ x, y, heading }: Pose, distance: number): Point => ({
  x: x + distance * Math.cos(heading),
  y: y + distance * Math.sin(heading),
});
