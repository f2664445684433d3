// The camera's projection as in proto/foresight/camera.proto: between pixels and places in the frame `robot`. A sensor of
// ground truth has the same one in the frame `field`.

import type { CameraMatrix, Detection } from "../memory/schema";
import { listOf, numberOf, type Fields, type NumberIn } from "../memory/value";
import type { Point } from "./field";

/** A place in the frame `robot` [m]. */
export interface Place extends Point {
  z: number;
}

export interface Optics {
  /** robot_from_camera, 9 numbers row by row. */
  rotation: number[];
  /** [m] of the optical centre. */
  at: Place;
  /** [px] Size of the images that the other values belong to. */
  width: number;
  height: number;
  focal: Point; // [px]
  centre: Point; // [px]
}

const kNear = 0.05; // [m] in front of the camera: nearer points are not drawn

/** Returns undefined if the message has no complete projection. */
export function opticsOf(matrix: Fields<CameraMatrix>): Optics | undefined {
  const rotation = (matrix.get("rotation") as unknown[] | undefined)?.map(Number) ?? [];
  const of = (name: NumberIn<CameraMatrix>) => numberOf(matrix, name);
  const optics: Optics = {
    rotation,
    at: { x: of("x"), y: of("y"), z: of("z") },
    width: of("width"),
    height: of("height"),
    focal: { x: of("focal_x"), y: of("focal_y") },
    centre: { x: of("centre_x"), y: of("centre_y") },
  };
  const numbers = [...rotation, ...Object.values(optics.at), ...Object.values(optics.centre)];
  const positive = [optics.width, optics.height, optics.focal.x, optics.focal.y];
  return rotation.length === 9 && numbers.every(Number.isFinite) && positive.every((value) => value > 0)
    ? optics
    : undefined;
}

/** The same camera for images of another size. */
export function resized(optics: Optics, width: number, height: number): Optics {
  const [x, y] = [width / optics.width, height / optics.height];
  return {
    ...optics,
    width,
    height,
    focal: { x: optics.focal.x * x, y: optics.focal.y * y },
    centre: { x: optics.centre.x * x, y: optics.centre.y * y },
  };
}

/** In the camera's own axes: +x right, +y down, +z forward [m]. */
function inCamera({ rotation: r, at }: Optics, { x, y, z }: Place): Place {
  const [dx, dy, dz] = [x - at.x, y - at.y, z - at.z];
  return {
    x: r[0]! * dx + r[3]! * dy + r[6]! * dz,
    y: r[1]! * dx + r[4]! * dy + r[7]! * dz,
    z: r[2]! * dx + r[5]! * dy + r[8]! * dz,
  };
}

const pixelOf = ({ focal, centre }: Optics, { x, y, z }: Place): Point => ({
  x: centre.x + (focal.x * x) / z,
  y: centre.y + (focal.y * y) / z,
});

/** Returns the pixel of a place, or undefined if it is not in front of the camera. */
export function toPixel(optics: Optics, place: Place): Point | undefined {
  const seen = inCamera(optics, place);
  return seen.z > kNear ? pixelOf(optics, seen) : undefined;
}

/** Returns both ends of the visible part of a straight line. */
export function lineToPixels(optics: Optics, from: Place, to: Place): [Point, Point] | undefined {
  let [a, b] = [inCamera(optics, from), inCamera(optics, to)];
  if (a.z <= kNear && b.z <= kNear) return undefined;
  const cut = (inside: Place, outside: Place): Place => {
    const share = (inside.z - kNear) / (inside.z - outside.z);
    return { x: inside.x + share * (outside.x - inside.x), y: inside.y + share * (outside.y - inside.y), z: kNear };
  };
  if (a.z <= kNear) a = cut(b, a);
  else if (b.z <= kNear) b = cut(a, b);
  return [pixelOf(optics, a), pixelOf(optics, b)];
}

/** Returns the direction of a pixel in the frame `robot`, 1 long along the optical axis. */
export function direction({ rotation: r, focal, centre }: Optics, pixel: Point): Place {
  const [x, y] = [(pixel.x - centre.x) / focal.x, (pixel.y - centre.y) / focal.y];
  return { x: r[0]! * x + r[1]! * y + r[2]!, y: r[3]! * x + r[4]! * y + r[5]!, z: r[6]! * x + r[7]! * y + r[8]! };
}

/** Returns the ground point of a pixel [m, robot], or undefined above the horizon. */
export function toGround(optics: Optics, pixel: Point): Point | undefined {
  const ray = direction(optics, pixel);
  if (ray.z >= -1e-6) return undefined;
  const length = -optics.at.z / ray.z;
  return { x: optics.at.x + length * ray.x, y: optics.at.y + length * ray.y };
}

/** Returns two points of the horizon, at the left and right edge of the image. Undefined if it is vertical. */
export function horizonOf({ rotation: r, width, focal, centre }: Optics): [Point, Point] | undefined {
  if (Math.abs(r[7]!) < 1e-6) return undefined;
  const at = (x: number): Point => ({
    x,
    y: centre.y - (focal.y * (r[8]! + (r[6]! * (x - centre.x)) / focal.x)) / r[7]!,
  });
  return [at(0), at(width)];
}

/** Returns the corners of a detection's outline or box [px]. Empty if only its centre is known. */
export function outlineOf(detection: Fields<Detection>): Point[] {
  const outline = listOf(detection, "outline").map((pixel) => ({ x: numberOf(pixel, "x"), y: numberOf(pixel, "y") }));
  if (outline.length > 1) return outline;
  const [left, top, width, height] = (["box_left", "box_top", "box_width", "box_height"] as const).map((name) =>
    numberOf(detection, name),
  ) as [number, number, number, number];
  if (![left, top, width, height].every(Number.isFinite)) return [];
  return [
    { x: left, y: top },
    { x: left + width, y: top },
    { x: left + width, y: top + height },
    { x: left, y: top + height },
  ];
}
