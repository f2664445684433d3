// Drawings over a camera image: the vision's detections, the horizon, and the field lines as seen from the believed
// pose.

import type { Detection, Pixel, Vision, VisualBall } from "../memory/schema";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "../memory/value";
import type { Pose } from "./beliefs";
import type { Field, Pen, Point } from "./field";
import { horizonOf, lineToPixels, outlineOf, resized, type Optics, type Place } from "./optics";

export const kOverlays = {
  found: "what the vision found in this picture",
  horizon: "where the ground ends, by the camera matrix",
  lines: "where the field's lines are, if the robot is where it believes to be",
};
export type Overlay = keyof typeof kOverlays;

/** All at the image's own capture time. Undefined if nothing of that time is known. */
export interface Seen {
  vision: Fields<Vision> | undefined;
  /** 1 top, 2 bottom, as in Detection.Camera. */
  camera: number;
  optics: Optics | undefined;
  pose: Pose | undefined;
  field: Field;
}

/** How an image of `width` x `height` [px] lies on the canvas: whole, in the middle. */
export interface Fit {
  width: number;
  height: number;
  scale: number; // [px of the page / px of the image]
  left: number;
  top: number;
}

export function fitOf(image: { width: number; height: number }, width: number, height: number): Fit {
  const scale = Math.min(width / image.width, height / image.height);
  return { ...image, scale, left: (width - scale * image.width) / 2, top: (height - scale * image.height) / 2 };
}

export const toCanvas = ({ scale, left, top }: Fit, { x, y }: Point): Point => ({
  x: left + scale * x,
  y: top + scale * y,
});
export const toImage = ({ scale, left, top }: Fit, { x, y }: Point): Point => ({
  x: (x - left) / scale,
  y: (y - top) / scale,
});

// shapes and words differ too
export const kOverlayColours = {
  ball: "#ffb057",
  own: "#6bb1f5",
  robot: "#ffffff",
  post: "#f0e442",
  corner: "#cc79a7",
  line: "#f0e442",
  horizon: "#ffffff",
  field: "#56b4e9",
};
const kInk = "#0b0e11";
const kStep = 0.25; // [m] a long line is drawn in pieces, because its ends may be outside the image

export function drawOverlay(
  pen: Pen,
  fit: Fit,
  overlays: ReadonlySet<Overlay>,
  { vision, camera, optics, pose, field }: Seen,
): void {
  const sized = optics && resized(optics, fit.width, fit.height);
  if (overlays.has("lines") && sized && pose)
    drawFieldLines(pen, fit, sized, field, (point) => ({ ...inRobot(pose, point), z: 0 }));
  if (overlays.has("horizon") && sized) drawHorizon(pen, fit, sized);
  if (overlays.has("found") && vision) drawFound(pen, fit, vision, camera);
  pen.globalAlpha = 1;
}

/** Draws twice, dark and wide below, for contrast on any image. */
export function stroke(pen: Pen, colour: string, width: number, points: Point[], closed = false): void {
  strokeAll(pen, colour, width, [points], closed);
}

/** Draws a diagonal cross whose arms reach `arm` [px] along each axis. */
export function cross(pen: Pen, { x, y }: Point, arm: number, colour: string): void {
  for (const side of [1, -1])
    stroke(pen, colour, 2, [
      { x: x - arm, y: y - side * arm },
      { x: x + arm, y: y + side * arm },
    ]);
}

/** Draws four lines around a place, from `inner` to `outer` [px] away, so that its middle stays visible. */
export function ticks(pen: Pen, { x, y }: Point, inner: number, outer: number, colour: string, width: number): void {
  for (const [dx, dy] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const)
    stroke(pen, colour, width, [
      { x: x + inner * dx, y: y + inner * dy },
      { x: x + outer * dx, y: y + outer * dy },
    ]);
}

/** Draws several lines at once, which is much quicker than one after the other. */
function strokeAll(pen: Pen, colour: string, width: number, lines: Point[][], closed = false): void {
  for (const [style, wide, alpha] of [
    [kInk, width + 2, 0.55],
    [colour, width, 1],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = wide;
    pen.globalAlpha = alpha;
    pen.beginPath();
    for (const points of lines) {
      points.forEach(({ x, y }, i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
      if (closed) pen.closePath();
    }
    pen.stroke();
  }
}

/** Draws text from `at`. Without room to the right, the text ends at `end` [px]. */
export function label(pen: Pen, fit: Fit, text: string, at: Point, colour: string, end = Infinity): void {
  pen.font = "600 12px system-ui, sans-serif";
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  const width = 7.4 * text.length + 8;
  const most = fit.left + fit.scale * fit.width - width;
  const x = Math.max(fit.left, at.x <= most ? at.x : Math.min(most, end - width));
  const y = Math.max(fit.top + 9, at.y);
  pen.globalAlpha = 0.7;
  pen.fillStyle = kInk;
  pen.fillRect(x, y - 9, width, 18);
  pen.globalAlpha = 1;
  pen.fillStyle = colour;
  pen.fillText(text, x + 4, y);
}

function drawHorizon(pen: Pen, fit: Fit, optics: Optics): void {
  const ends = horizonOf(optics)?.map((end) => toCanvas(fit, end));
  const [top, bottom] = [fit.top, fit.top + fit.scale * fit.height];
  if (!ends || ends.every(({ y }) => y < top) || ends.every(({ y }) => y > bottom)) return;
  pen.setLineDash([8, 6]);
  stroke(pen, kOverlayColours.horizon, 1.5, ends);
  pen.setLineDash([]);
}

/** Returns the field's lines in its own frame [m]; circles as many short lines. */
export function linesOf(field: Field): [Point, Point][] {
  const { length, width, centreCircleRadius: radius } = field;
  const lines: [Point, Point][] = [
    [
      { x: 0, y: -width / 2 },
      { x: 0, y: width / 2 },
    ],
  ];
  const box = (left: number, right: number, wide: number) => {
    const corners = [
      { x: left, y: wide / 2 },
      { x: right, y: wide / 2 },
      { x: right, y: -wide / 2 },
      { x: left, y: -wide / 2 },
    ];
    corners.forEach((corner, i) => lines.push([corner, corners[(i + 1) % 4]!]));
  };
  box(-length / 2, length / 2, width);
  for (const side of [-1, 1])
    for (const [deep, wide] of [
      [field.goalAreaLength, field.goalAreaWidth],
      [field.penaltyAreaLength, field.penaltyAreaWidth],
    ] as const)
      if (deep > 0) box((side * length) / 2, side * (length / 2 - deep), wide);
  const on = (i: number): Point => ({
    x: radius * Math.cos((i * Math.PI) / 24),
    y: radius * Math.sin((i * Math.PI) / 24),
  });
  for (let i = 0; i < 48; ++i) lines.push([on(i), on(i + 1)]);
  return lines;
}

/** Converts a point of the field to the robot's frame. */
function inRobot({ x, y, heading }: Pose, point: Point): Point {
  const [dx, dy] = [point.x - x, point.y - y];
  return { x: Math.cos(heading) * dx + Math.sin(heading) * dy, y: Math.cos(heading) * dy - Math.sin(heading) * dx };
}

/** Converts a point of the robot's frame to the field. */
export const onField = ({ x, y, heading }: Pose, point: Point): Point => ({
  x: x + Math.cos(heading) * point.x - Math.sin(heading) * point.y,
  y: y + Math.sin(heading) * point.x + Math.cos(heading) * point.y,
});

/** Draws the field's lines. `inFrame` converts a point of the field to the frame of the optics. */
export function drawFieldLines(
  pen: Pen,
  fit: Fit,
  optics: Optics,
  field: Field,
  inFrame: (point: Point) => Place,
): void {
  const near = ({ x, y }: Point) =>
    x > -optics.width && x < 2 * optics.width && y > -optics.height && y < 2 * optics.height;
  const seen: Point[][] = [];
  for (const [from, to] of linesOf(field)) {
    const pieces = Math.max(1, Math.round(Math.hypot(to.x - from.x, to.y - from.y) / kStep));
    for (let i = 0; i < pieces; ++i) {
      const [one, other] = [i, i + 1].map((at) =>
        inFrame({ x: from.x + (at / pieces) * (to.x - from.x), y: from.y + (at / pieces) * (to.y - from.y) }),
      );
      const ends = lineToPixels(optics, one!, other!);
      if (ends?.some(near)) seen.push(ends.map((end) => toCanvas(fit, end)));
    }
  }
  strokeAll(pen, kOverlayColours.field, 1.5, seen);
}

/** A percept, or a part of one, that names its camera. */
type Seeing = Pick<Detection, "camera">;

function drawFound(pen: Pen, page: Fit, vision: Fields<Vision>, camera: number): void {
  const [width, height] = [numberOf(vision, "image_width"), numberOf(vision, "image_height")];
  if (!(width > 0 && height > 0)) return;
  // pixels of the vision's own image, whose size may differ
  const fit: Fit = { ...page, width, height, scale: (page.scale * page.width) / width };
  const isHere = (fields: Fields<Seeing>) => cameraOf(fields) === camera || cameraOf(fields) === 0;
  const found = <M extends { detection?: Detection }>(entries: Fields<M>[]) =>
    entries.filter((entry: Fields<{ detection?: Detection }>) => isHere(fieldsOf(entry, "detection")));

  for (const line of listOf(vision, "lines").filter(isHere)) {
    const ends = (["image_start", "image_end"] as const).map((name) => toCanvas(fit, pixelOf(fieldsOf(line, name))));
    stroke(pen, kOverlayColours.line, 2.5, ends);
  }
  for (const corner of found(listOf(vision, "corners")))
    drawSpot(pen, fit, corner, wordOf(corner, "shape").replaceAll("_", " ").toUpperCase() || "mark");
  for (const cross of found(listOf(vision, "crosses"))) drawSpot(pen, fit, cross, "mark");
  for (const post of found(listOf(vision, "goal_posts")))
    drawBox(pen, fit, post, `${textOf(post, "colour")} post`.trim(), kOverlayColours.post);
  for (const robot of found(listOf(vision, "robots"))) {
    const side = wordOf(robot, "side");
    const known = side && side !== "unspecified" ? `${side} robot` : "robot";
    drawBox(
      pen,
      fit,
      robot,
      known,
      side === "own" ? kOverlayColours.own : side === "opponent" ? kOverlayColours.ball : kOverlayColours.robot,
    );
  }
  const ball = fieldsOf(vision, "ball");
  if (ball.size > 0 && isHere(fieldsOf(ball, "detection"))) drawBall(pen, fit, ball);
}

const cameraOf = (fields: Fields<Seeing>): number => {
  const camera = fields.get("camera");
  return typeof camera === "object" && camera !== null && "number" in camera ? (camera.number as number) : 0;
};
const pixelOf = (pixel: Fields<Pixel>): Point => ({ x: numberOf(pixel, "x"), y: numberOf(pixel, "y") });
const centreOf = (detection: Fields<Detection>): Point => ({
  x: numberOf(detection, "image_x"),
  y: numberOf(detection, "image_y"),
});
const away = (detection: Fields<Detection>): string => {
  const distance = numberOf(detection, "distance");
  return Number.isFinite(distance) ? ` ${distance.toFixed(1)} m` : "";
};

function drawSpot(pen: Pen, fit: Fit, entry: Fields<{ detection?: Detection }>, word: string): void {
  const { x, y } = toCanvas(fit, centreOf(fieldsOf(entry, "detection")));
  cross(pen, { x, y }, 6, kOverlayColours.corner);
  label(pen, fit, word, { x: x + 9, y }, kOverlayColours.corner, x - 9);
}

function drawBox(pen: Pen, fit: Fit, entry: Fields<{ detection?: Detection }>, word: string, colour: string): void {
  const detection = fieldsOf(entry, "detection");
  const outline = outlineOf(detection).map((corner) => toCanvas(fit, corner));
  const { x, y } = toCanvas(fit, centreOf(detection));
  if (outline.length === 0) return drawSpot(pen, fit, entry, word);
  stroke(pen, colour, 2, outline, true);
  label(
    pen,
    fit,
    word + away(detection),
    { x: Math.min(x, ...outline.map((corner) => corner.x)), y: Math.min(y, ...outline.map((corner) => corner.y)) - 10 },
    colour,
  );
}

function drawBall(pen: Pen, fit: Fit, ball: Fields<VisualBall>): void {
  const detection = fieldsOf(ball, "detection");
  const { x, y } = toCanvas(fit, centreOf(detection));
  const radius = Math.max(3, fit.scale * (numberOf(ball, "radius") || 0));
  for (const [style, width, alpha] of [
    [kInk, 4.5, 0.55],
    [kOverlayColours.ball, 2.5, 1],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = width;
    pen.globalAlpha = alpha;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.stroke();
  }
  label(pen, fit, `ball${away(detection)}`, { x: x + radius + 5, y }, kOverlayColours.ball, x - radius - 5);
}

/** Luma and colour of a pixel, 0 .. 255. */
export interface Yuv {
  y: number;
  u: number;
  v: number;
}

/** Returns a pixel of a YUYV image; a pair of pixels shares `u` and `v`. */
export function yuvAt(yuyv: Uint8Array, width: number, { x, y }: Point): Yuv {
  const [column, row] = [Math.floor(x), Math.floor(y)];
  const pair = 2 * (row * width + (column & ~1));
  return { y: yuyv[2 * (row * width + column)]!, u: yuyv[pair + 1]!, v: yuyv[pair + 3]! };
}

/** Of red, green and blue, 0 .. 255, by BT.601 with full range. */
export const yuvOf = (red: number, green: number, blue: number): Yuv => {
  const y = 0.299 * red + 0.587 * green + 0.114 * blue;
  return { y: Math.round(y), u: Math.round(128 + (blue - y) / 1.772), v: Math.round(128 + (red - y) / 1.402) };
};
