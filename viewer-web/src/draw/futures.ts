// Draws rollouts of a forecast: the ball's path thick, the robots' thin, a mark every five seconds.

import type { Path, Place } from "../memory/forecast";
import { fillCircle, strokeCross, strokePath, type Camera, type Pen, type Point } from "./field";
import { kBright, kInk } from "./robot_sign";

const kTick = 5; // [s] between marks on a path
const kPlain = 30; // [s] of a path that is drawn in full; a longer one cannot be followed by eye
const kFaint = 0.25; // relative strength of the rest of the path

/** Returns the place after `at` [s], interpolated, or the last point after the end. Undefined without points. */
export function placeAt(points: Place[], spacing: number, at: number): Point | undefined {
  if (points.length === 0) return undefined;
  const step = spacing > 0 ? Math.min(points.length - 1, Math.max(0, at / spacing)) : 0;
  const [one, other, share] = [points[Math.floor(step)]!, points[Math.ceil(step)]!, step % 1];
  return { x: one.x + share * (other.x - one.x), y: one.y + share * (other.y - one.y) };
}

/** [s] of the longest path. */
export const lengthOf = (paths: Path[]): number =>
  Math.max(0, ...paths.map(({ spacing, ball }) => spacing * (ball.length - 1)));

/**
 * [s] The part that is drawn in full: the time before `at`, or the beginning if `at` is 0. It is limited, so that many
 * paths do not become a tangle.
 */
const plainPart = (at: number): [number, number] => (at > 0 ? [Math.max(0, at - kPlain), at] : [0, kPlain]);

/**
 * Draws the part before `at` [s] in full and the rest faintly; with `at` 0, the beginning in full. Robots in `colour`, the
 * ball in `ball`.
 */
export function drawPaths(
  pen: Pen,
  camera: Camera,
  paths: Path[],
  { strength, colour, ball = kBright, at = 0 }: { strength: number; colour: string; ball?: string; at?: number },
): void {
  for (const path of paths) {
    for (const { points } of path.robots)
      drawTrack(pen, camera, points, path.spacing, at, { colour, width: 1.5, alpha: 0.75 * strength });
    drawTrack(pen, camera, path.ball, path.spacing, at, { colour: kInk, width: 5, alpha: 0.55 * strength });
    drawTrack(pen, camera, path.ball, path.spacing, at, { colour: ball, width: 3, alpha: 0.95 * strength });
    drawTicks(pen, camera, path, at, { colour: ball, strength });
  }
  pen.globalAlpha = 1;
}

function drawTrack(
  pen: Pen,
  camera: Camera,
  points: Place[],
  spacing: number,
  at: number,
  { colour, width, alpha }: { colour: string; width: number; alpha: number },
): void {
  if (points.length < 2) return;
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  const [from, to] = plainPart(at);
  const part = (begin: number, end: number, strength: number) => {
    const [first, last] = [Math.floor(begin / spacing) + 1, Math.ceil(end / spacing)];
    if (!(last >= first) || first >= points.length) return;
    pen.globalAlpha = strength;
    strokePath(pen, camera, [
      placeAt(points, spacing, begin)!,
      ...points.slice(first, last),
      placeAt(points, spacing, end)!,
    ]);
  };
  part(0, from, kFaint * alpha);
  part(from, to, alpha);
  part(to, spacing * points.length, kFaint * alpha);
}

function drawTicks(
  pen: Pen,
  camera: Camera,
  { ball, spacing }: Path,
  at: number,
  { colour, strength }: { colour: string; strength: number },
): void {
  const length = spacing * (ball.length - 1);
  const [from, to] = plainPart(at);
  const strengthAt = (time: number) => (time >= from && time <= to ? 1 : kFaint) * strength;
  for (let time = kTick; time < length; time += kTick) {
    const place = placeAt(ball, spacing, time)!;
    pen.globalAlpha = strengthAt(time);
    fillCircle(pen, camera, place, 4.5 / camera.scale, kInk);
    fillCircle(pen, camera, place, 3 / camera.scale, colour);
  }
  const end = ball.at(-1);
  if (!end || length <= 0) return;
  // the end's mark differs from a tick by its shape
  pen.globalAlpha = strengthAt(length);
  pen.strokeStyle = colour;
  pen.lineWidth = 2;
  strokeCross(pen, camera, end, 5 / camera.scale);
}
