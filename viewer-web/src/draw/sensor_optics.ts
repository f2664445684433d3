// The projection of a sensor of ground truth, in the frame `field`.

import type { Pinhole, SensorPlace } from "../memory/truth";
import type { Point } from "./field";
import { direction, toGround, toPixel, type Optics, type Place } from "./optics";

/** A sensor without a calibration: upright, level and behind the field, so that its points can be looked at. */
export const kUncalibrated: SensorPlace = {
  rotation: [1, 0, 0, 0, 0, 1, 0, -1, 0],
  at: { x: 0, y: -3, z: 1 },
  depthScale: 1,
};

export const opticsIn = ({ width, height, focal, centre }: Pinhole, { rotation, at }: SensorPlace): Optics => ({
  rotation,
  at,
  width,
  height,
  focal,
  centre,
});

/** Returns the point [m, field] that a pixel shows at a depth [m], which is along the optical axis. */
export function placeAt(optics: Optics, pixel: Point, depth: number): Place {
  const { x, y, z } = direction(optics, pixel);
  const { at } = optics;
  return { x: at.x + depth * x, y: at.y + depth * y, z: at.z + depth * z };
}

/** Reports whether a place is in the image. */
export function isSeen(optics: Optics, place: Place): boolean {
  const pixel = toPixel(optics, place);
  return pixel !== undefined && pixel.x >= 0 && pixel.y >= 0 && pixel.x <= optics.width && pixel.y <= optics.height;
}

const kReach = 6; // [m] beyond it, a depth camera measures nothing useful
const kPerEdge = 12;

/** Returns the outline of the ground that the image shows, up to a reach of 6 m. */
export function footprintOf(optics: Optics): Point[] {
  const { width, height, at } = optics;
  const corners: [number, number][] = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ];
  return corners.flatMap(([x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % 4]!;
    return Array.from({ length: kPerEdge }, (_, step) => {
      const share = step / kPerEdge;
      const pixel = { x: x + share * (nextX - x), y: y + share * (nextY - y) };
      const ground = toGround(optics, pixel);
      if (ground && Math.hypot(ground.x - at.x, ground.y - at.y) < kReach) return ground;
      const ahead = direction(optics, pixel);
      const length = Math.hypot(ahead.x, ahead.y) || 1;
      return { x: at.x + (kReach * ahead.x) / length, y: at.y + (kReach * ahead.y) / length };
    });
  });
}
