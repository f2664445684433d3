// Detections over a point cloud: a post at each, and a cross at each true position.

import { labelOf, type Truth, type TrueThing } from "../memory/truth";
import { kBallColour, kRealColour } from "./draw_sensor";
import type { Pen, Point } from "./field";
import { onCanvas } from "./orbit";
import type { Place } from "./optics";
import { drawOutlined, kBright, kInk } from "./robot_sign";

const kRobotPost = 0.85; // [m]
const kBallPost = 0.35;
const kArm = 0.07; // [m] of a cross

interface View {
  clip: Float32Array;
  width: number; // [px] of the canvas
  height: number;
}

export function drawPosts(pen: Pen, view: View, truth: Truth | undefined, real: Truth | undefined): void {
  for (const thing of [...(real?.robots ?? []), ...(real?.ball ? [real.ball] : [])]) drawCross(pen, view, thing);
  for (const robot of truth?.robots ?? []) drawPost(pen, view, robot, kRobotPost, kBright, labelOf(robot) || "robot");
  if (truth?.ball) drawPost(pen, view, truth.ball, kBallPost, kBallColour, "ball");
}

function line(pen: Pen, { clip, width, height }: View, places: Place[], colour: string, thick: number): void {
  const points = places.map((place) => onCanvas(clip, place, width, height));
  if (!points.every((point): point is Point => point !== undefined)) return;
  for (const [style, wide] of [
    [kInk, thick + 2],
    [colour, thick],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = wide;
    pen.beginPath();
    points.forEach(({ x, y }, i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
    pen.stroke();
  }
}

function drawPost(pen: Pen, view: View, { x, y }: TrueThing, top: number, colour: string, words: string): void {
  pen.globalAlpha = 1;
  const [foot, head] = [
    { x, y, z: 0 },
    { x, y, z: top },
  ];
  line(pen, view, [foot, head], colour, 2);
  const at = onCanvas(view.clip, head, view.width, view.height);
  if (at) drawOutlined(pen, at, -8, words, { colour, weight: 650 });
}

function drawCross(pen: Pen, view: View, { x, y }: TrueThing): void {
  pen.globalAlpha = 1;
  for (const side of [-1, 1])
    line(
      pen,
      view,
      [
        { x: x - kArm, y: y - side * kArm, z: 0.01 },
        { x: x + kArm, y: y + side * kArm, z: 0.01 },
      ],
      kRealColour,
      2,
    );
}
