// The look at a point cloud: a viewpoint on a sphere around a place of the field.

import type { Place } from "./optics";
import type { Point } from "./field";

export interface Orbit {
  /** [rad] 0 looks along +y, with +x to the right as in the field's drawing; counter-clockwise from above. */
  azimuth: number;
  /** [rad] above the ground. */
  elevation: number;
  /** [m] */
  distance: number;
  target: Place; // [m, field]
}

const kHalfView = 0.4; // [rad] half of the vertical angle of view
const kFocal = 1 / Math.tan(kHalfView);
const kNear = 0.05; // [m]
const kFar = 60; // [m]

/** Looks at the ground within an outline, oriented as the field's drawing. `aspect`: width / height. */
export function orbitOver(outline: Point[], aspect: number): Orbit {
  const [x, y] = [middleOf(outline.map((point) => point.x)), middleOf(outline.map((point) => point.y))];
  const distance = Math.max((kFocal / aspect) * x.half + 0.7 * y.half, 0.9 * kFocal * y.half) + 0.5;
  return { azimuth: 0, elevation: 0.7, distance, target: { x: x.middle, y: y.middle, z: 0.2 } };
}

function middleOf(values: number[]): { middle: number; half: number } {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return { middle: (least + most) / 2, half: (most - least) / 2 };
}

/** Turns by pixels of a canvas. */
export const turned = (orbit: Orbit, { x, y }: Point): Orbit => ({
  ...orbit,
  azimuth: orbit.azimuth - 0.006 * x,
  elevation: Math.min(1.55, Math.max(-0.2, orbit.elevation + 0.006 * y)),
});

export const nearer = (orbit: Orbit, factor: number): Orbit => ({
  ...orbit,
  distance: Math.min(30, Math.max(0.3, orbit.distance / factor)),
});

/** Moves the target over the ground, so that it follows the pointer. `height`: of the canvas [px]. */
export function shifted(orbit: Orbit, { x, y }: Point, height: number): Orbit {
  const perPixel = (2 * orbit.distance) / (kFocal * height);
  const [right, ahead] = [-x * perPixel, (y * perPixel) / Math.max(0.3, Math.sin(orbit.elevation))];
  const [cos, sin] = [Math.cos(orbit.azimuth), Math.sin(orbit.azimuth)];
  const limited = (value: number) => Math.min(10, Math.max(-10, value));
  return {
    ...orbit,
    target: {
      ...orbit.target,
      x: limited(orbit.target.x + cos * right - sin * ahead),
      y: limited(orbit.target.y + sin * right + cos * ahead),
    },
  };
}

/** The viewpoint's axes in the field: right, up, and back towards the viewer. */
function axesOf({ azimuth, elevation }: Orbit): { right: Place; up: Place; back: Place } {
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  return {
    right: { x: ca, y: sa, z: 0 },
    up: { x: -sa * se, y: ca * se, z: ce },
    back: { x: sa * ce, y: -ca * ce, z: se },
  };
}

/** Returns clip_from_field, column by column as WebGL takes it. */
export function matrixOf(orbit: Orbit, aspect: number): Float32Array {
  const { right, up, back } = axesOf(orbit);
  const { x, y, z } = orbit.target;
  const along = (axis: Place) => axis.x * x + axis.y * y + axis.z * z;
  const rows = [
    [right.x, right.y, right.z, -along(right)],
    [up.x, up.y, up.z, -along(up)],
    [back.x, back.y, back.z, -along(back) - orbit.distance],
  ] as const;
  const [a, b] = [(kFar + kNear) / (kNear - kFar), (2 * kFar * kNear) / (kNear - kFar)];
  const clip = [
    rows[0].map((value) => (kFocal / aspect) * value),
    rows[1].map((value) => kFocal * value),
    rows[2].map((value, column) => a * value + (column === 3 ? b : 0)),
    rows[2].map((value) => -value),
  ];
  return Float32Array.from({ length: 16 }, (_, i) => clip[i % 4]![Math.floor(i / 4)]!);
}

/** [px] of a length of 1 m at a distance of 1 m, on a canvas of this height. */
export const pixelsPerMetre = (height: number): number => (kFocal * height) / 2;

/** Returns the place on a canvas [px], or undefined behind the viewpoint. */
export function onCanvas(clip: Float32Array, { x, y, z }: Place, width: number, height: number): Point | undefined {
  const row = (i: number) => clip[i]! * x + clip[4 + i]! * y + clip[8 + i]! * z + clip[12 + i]!;
  const w = row(3);
  if (w < kNear) return undefined;
  return { x: (width / 2) * (1 + row(0) / w), y: (height / 2) * (1 - row(1) / w) };
}
