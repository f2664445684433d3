// Draws the situation at the start of the rollouts, and the rollouts: heat of the ball, some paths, and the places of
// all at a chosen time.

import type { Body, Heat, Path, Situation } from "../memory/forecast";
import { bodyOf, edited, movedIn, thingOf, type Edit, type Standing, type Thing } from "../memory/question";
import { drawPaths, placeAt } from "./futures";
import {
  drawField,
  fillCircle,
  strokeCircle,
  strokeLine,
  toField,
  toScreen,
  type Camera,
  type Field,
  type Pen,
  type Point,
} from "./field";
import {
  ahead,
  drawNumber,
  fillBody,
  kBright,
  kInk,
  kRobotRadius,
  strokeBody,
  strokeHeading,
  type Livery,
} from "./robot_sign";

const kBallRadius = 0.06; // [m] larger than the real ball, to be visible
const kHandle = 0.42; // [m] from a robot's middle to the handle that turns it
const kReach = 0.22; // [m] radius of a hit
export const kHeatColour = "#ffe9a3";
export const kEditColour = "#ff66aa";

/** By the side of the robot that foresees. */
export type Sides = Record<"own" | "opponent", Livery>;

export interface Foreseen {
  field: Field;
  liveries: Sides;
  /** The beliefs without the edit. */
  believed: Situation;
  edit: Edit;
  /** Of one strategy. */
  heat: Heat | undefined;
  paths: Path[];
  /** Futures with a change, beside `paths` without it. */
  changed?: Path[];
  /** [s] after the start of the rollouts. */
  at: number;
  /** The thing that is dragged or under the pointer. */
  held: Thing | undefined;
  /** True if the rollouts belong to another situation than this one. */
  stale: boolean;
}

export function drawForeseen(
  pen: Pen,
  camera: Camera,
  { field, liveries, believed, edit, heat, paths, changed = [], at, held, stale }: Foreseen,
): void {
  const strength = stale ? 0.3 : 1;
  const now = edited(believed, edit);
  drawField(pen, camera, field);
  if (heat) drawHeat(pen, camera, field, heat, strength);
  drawPaths(pen, camera, paths, { strength, colour: liveries.own.colour, at });
  drawPaths(pen, camera, changed, { strength, colour: kEditColour, ball: kEditColour, at });
  // a moving thing leaves a shadow at its start
  drawSituation(pen, camera, { believed, now, edit, liveries }, at > 0 ? 0.35 : 1);
  if (held) drawHandle(pen, camera, now, held);
  if (at > 0) for (const path of paths) drawThen(pen, camera, path, liveries.own, at, strength);
  pen.globalAlpha = 1;
}

// heat of the ball

const kFine = 4; // each cell is drawn this many times finer, along x and y

/** [0..1] How often the ball was there, relative to the most frequent cell, on a scale for the eye. */
export function warmth({ columns, counts }: Heat): { columns: number; rows: number; values: number[] } {
  const rows = counts.length / columns;
  const most = Math.max(1, ...counts);
  const at = (column: number, row: number) =>
    counts[Math.min(rows - 1, Math.max(0, row)) * columns + Math.min(columns - 1, Math.max(0, column))]! / most;
  const values: number[] = [];
  for (let row = 0; row < kFine * rows; ++row)
    for (let column = 0; column < kFine * columns; ++column) {
      const [x, y] = [(column + 0.5) / kFine - 0.5, (row + 0.5) / kFine - 0.5];
      const [left, below] = [Math.floor(x), Math.floor(y)];
      const [right, up] = [x - left, y - below];
      const mixed =
        (1 - up) * ((1 - right) * at(left, below) + right * at(left + 1, below)) +
        up * ((1 - right) * at(left, below + 1) + right * at(left + 1, below + 1));
      values.push(mixed ** 0.7);
    }
  return { columns: kFine * columns, rows: kFine * rows, values };
}

const warm = new WeakMap<Heat, ReturnType<typeof warmth>>();

function drawHeat(pen: Pen, camera: Camera, { length, width }: Field, heat: Heat, strength: number): void {
  if (!warm.has(heat)) warm.set(heat, warmth(heat));
  const { columns, rows, values } = warm.get(heat)!;
  pen.fillStyle = kHeatColour;
  const edge = (column: number, row: number) =>
    toScreen(camera, { x: (column / columns - 0.5) * length, y: (row / rows - 0.5) * width });
  values.forEach((value, i) => {
    if (value < 0.03) return;
    const [column, row] = [i % columns, Math.floor(i / columns)];
    const [one, other] = [edge(column, row), edge(column + 1, row + 1)].map(({ x, y }) => ({
      x: Math.round(x),
      y: Math.round(y),
    }));
    pen.globalAlpha = 0.72 * strength * value;
    pen.fillRect(
      Math.min(one!.x, other!.x),
      Math.min(one!.y, other!.y),
      Math.abs(other!.x - one!.x),
      Math.abs(other!.y - one!.y),
    );
  });
}

// rollouts

function drawThen(
  pen: Pen,
  camera: Camera,
  { spacing, ball, robots }: Path,
  livery: Livery,
  at: number,
  strength: number,
): void {
  for (const { player, points } of robots) {
    const place = placeAt(points, spacing, at);
    if (!place) continue;
    pen.globalAlpha = 0.9 * strength;
    const then = { ...place, heading: NaN };
    fillBody(pen, camera, then, livery, 0.8 * kRobotRadius);
    pen.strokeStyle = kInk;
    pen.lineWidth = 1;
    strokeBody(pen, camera, then, livery, 0.8 * kRobotRadius);
    drawNumber(pen, camera, String(player), place, livery);
  }
  const place = placeAt(ball, spacing, at);
  if (place) drawBall(pen, camera, place, strength);
}

// situation

function drawSituation(
  pen: Pen,
  camera: Camera,
  { believed, now, edit, liveries }: { believed: Situation; now: Situation; edit: Edit; liveries: Sides },
  alpha: number,
): void {
  for (const thing of movedIn(edit)) drawMove(pen, camera, standingOf(believed, thing), standingOf(now, thing));
  const doubt = (at: Point, deviation: number, colour: string) => {
    if (!(deviation > 0)) return;
    pen.globalAlpha = 0.16 * alpha;
    fillCircle(pen, camera, at, deviation, colour);
    pen.globalAlpha = 0.7 * alpha;
    pen.strokeStyle = colour;
    pen.lineWidth = 1;
    strokeCircle(pen, camera, at, deviation);
  };
  for (const body of now.bodies) doubt(body, body.deviation, liveries[body.side].colour);
  if (now.ball) doubt(now.ball, now.ball.deviation, kBright);
  // moved robots lie on top of the others
  const isMoved = (body: Body) => Number(edit.robots.has(thingOf(body)));
  for (const body of [...now.bodies].sort((a, b) => isMoved(a) - isMoved(b))) {
    const livery = liveries[body.side];
    pen.globalAlpha = alpha;
    fillBody(pen, camera, body, livery);
    pen.strokeStyle = kInk;
    pen.lineWidth = 1.5;
    strokeBody(pen, camera, body, livery);
    pen.strokeStyle = livery.colour;
    pen.lineWidth = 3;
    strokeHeading(pen, camera, body);
    drawNumber(pen, camera, String(body.player), body, livery);
    if (edit.robots.has(thingOf(body))) drawMark(pen, camera, body, kRobotRadius);
  }
  if (now.ball) drawBall(pen, camera, now.ball, alpha);
  if (now.ball && edit.ball) drawMark(pen, camera, now.ball, kBallRadius);
}

/** Draws an arrow from the believed place to the new place. */
function drawMove(pen: Pen, camera: Camera, from: Standing | undefined, to: Standing | undefined): void {
  if (!from || !to) return;
  pen.strokeStyle = kEditColour;
  pen.lineWidth = 1.5;
  pen.globalAlpha = 0.9;
  pen.setLineDash([4, 4]);
  strokeLine(pen, camera, from, to);
  strokeCircle(pen, camera, from, 0.1);
  pen.setLineDash([]);
}

function drawMark(pen: Pen, camera: Camera, at: Point, radius: number): void {
  pen.globalAlpha = 1;
  pen.strokeStyle = kEditColour;
  pen.lineWidth = 2.5;
  strokeCircle(pen, camera, at, radius + 5 / camera.scale);
}

function drawHandle(pen: Pen, camera: Camera, now: Situation, held: Thing): void {
  const standing = standingOf(now, held);
  if (!standing) return;
  pen.globalAlpha = 1;
  pen.strokeStyle = kBright;
  pen.lineWidth = 2;
  strokeCircle(pen, camera, standing, (held === "ball" ? kBallRadius : kRobotRadius) + 2 / camera.scale);
  if (held === "ball") return;
  const handle = handleOf(camera, standing);
  pen.setLineDash([3, 3]);
  strokeLine(pen, camera, standing, handle);
  pen.setLineDash([]);
  // dark, to differ from a ball
  fillCircle(pen, camera, handle, 6 / camera.scale, kInk);
  strokeCircle(pen, camera, handle, 6 / camera.scale);
}

function drawBall(pen: Pen, camera: Camera, at: Point, alpha: number): void {
  pen.globalAlpha = alpha;
  fillCircle(pen, camera, at, kBallRadius, kBright);
  pen.strokeStyle = kInk;
  pen.lineWidth = 2;
  strokeCircle(pen, camera, at, kBallRadius);
}

// pointer

export function standingOf({ ball, bodies }: Situation, thing: Thing): Standing | undefined {
  if (thing === "ball") return ball && { ...ball, heading: 0 };
  const wanted = bodyOf(thing);
  return bodies.find(({ side, player }) => side === wanted?.side && player === wanted.player);
}

/** Returns the handle's place, far enough from the robot for a finger. */
const handleOf = ({ scale }: Camera, standing: Standing): Point => ahead(standing, Math.max(kHandle, 34 / scale));

export interface Grip {
  thing: Thing;
  /** True if gripped by the handle: it turns and does not move. */
  turns: boolean;
}

/** Returns the grip at a place of the canvas [px]: the handle of the held thing, else the nearest thing. */
export function gripAt(camera: Camera, now: Situation, held: Thing | undefined, pointer: Point): Grip | undefined {
  const point = toField(camera, pointer);
  const apart = (at: Point) => Math.hypot(at.x - point.x, at.y - point.y);
  const reach = Math.max(kReach, 22 / camera.scale);
  const standing = held && held !== "ball" ? standingOf(now, held) : undefined;
  if (held && standing && apart(handleOf(camera, standing)) < 0.7 * reach) return { thing: held, turns: true };
  // the ball is small and often at a robot's feet: it has precedence if both are hit
  const things = [
    ...(now.ball ? [{ thing: "ball", away: apart(now.ball) - 0.1 }] : []),
    ...now.bodies.map((body) => ({ thing: thingOf(body), away: apart(body) })),
  ];
  const [nearest] = things.sort((a, b) => a.away - b.away);
  return nearest && nearest.away < reach ? { thing: nearest.thing, turns: false } : undefined;
}

const kFarthest = 2; // [m] beyond the lines

/** Returns the field with a border wide enough for all believed places. */
export function fieldRound(field: Field, { ball, bodies }: Situation): Field {
  const beyond = [...(ball ? [ball] : []), ...bodies].map(
    ({ x, y }) => Math.max(Math.abs(x) - field.length / 2, Math.abs(y) - field.width / 2) + 2 * kRobotRadius,
  );
  return { ...field, border: Math.min(kFarthest, Math.max(field.border, ...beyond)) };
}

/** Clamps a point to the carpet. */
export const onCarpet = ({ length, width, border }: Field, { x, y }: Point): Point => {
  const within = (value: number, most: number) => Math.max(-most, Math.min(most, value));
  return { x: within(x, length / 2 + border), y: within(y, width / 2 + border) };
};
