// Detections over a point cloud: a post at each, and a cross at each true position.

import { labelOf, thingsIn, type Truth, type TrueThing } from "../memory/truth";
import { kBallColour, kRealColour } from "./draw_sensor";
import type { Pen, Point } from "./field";
import { onCanvas } from "./orbit";
import type { Place } from "./optics";
import { stroke } from "./overlay";
import { drawOutlined, kBright } from "./robot_sign";

const kRobotPost = 0.85; // [m]
const kBallPost = 0.35;
const kArm = 0.07; // [m] of a cross

interface View {
  clip: Float32Array;
  width: number; // [px] of the canvas
  height: number;
}

export function drawPosts(pen: Pen, view: View, truth: Truth | undefined, real: Truth | undefined): void {
  for (const thing of thingsIn(real)) drawCross(pen, view, thing);
  for (const robot of truth?.robots ?? []) drawPost(pen, view, robot, kRobotPost, kBright, labelOf(robot) || "robot");
  if (truth?.ball) drawPost(pen, view, truth.ball, kBallPost, kBallColour, "ball");
}

function line(pen: Pen, { clip, width, height }: View, places: Place[], colour: string): void {
  const points = places.map((place) => onCanvas(clip, place, width, height));
  if (!points.every((point): point is Point => point !== undefined)) return;
  stroke(pen, colour, 2, points);
}

function drawPost(pen: Pen, view: View, { x, y }: TrueThing, top: number, colour: string, words: string): void {
  const [foot, head] = [
    { x, y, z: 0 },
    { x, y, z: top },
  ];
  line(pen, view, [foot, head], colour);
  const at = onCanvas(view.clip, head, view.width, view.height);
  if (at) drawOutlined(pen, at, -8, words, { colour, weight: 650 });
}

function drawCross(pen: Pen, view: View, { x, y }: TrueThing): void {
  for (const side of [-1, 1])
    line(
      pen,
      view,
      [
        { x: x - kArm, y: y - side * kArm, z: 0.01 },
        { x: x + kArm, y: y + side * kArm, z: 0.01 },
      ],
      kRealColour,
    );
}
