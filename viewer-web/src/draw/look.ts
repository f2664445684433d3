// The look at the field: zoom, place and turn, and how wheel, fingers and keys change them.

import { cameraFor, toField, type Camera, type Field, type Point } from "./field";

export interface Look {
  /** 1: the whole carpet fits. */
  zoom: number;
  /** [m] Place in the middle of the canvas. */
  x: number;
  y: number;
  /** The other side's view. */
  mirrored: boolean;
}

export const kWhole: Look = { zoom: 1, x: 0, y: 0, mirrored: false };
const kMostZoom = 30;

/**
 * Returns the camera. A canvas that is higher than wide shows the field upright, with the home team's goal at the
 * bottom.
 */
export function cameraOf(field: Field, look: Look, width: number, height: number): Camera {
  const upright = height > 1.15 * width;
  const fitted = upright ? cameraFor(field, height, width) : cameraFor(field, width, height);
  const turns = (upright ? 1 : 0) + (look.mirrored ? 2 : 0);
  const camera = { scale: fitted.scale * look.zoom, centreX: 0, centreY: 0, turns };
  // shifts the centre so that the chosen place is in the middle
  const [cos, sin] = [[1, 0, -1, 0][turns]!, [0, 1, 0, -1][turns]!];
  camera.centreX = width / 2 - camera.scale * (cos * look.x - sin * look.y);
  camera.centreY = height / 2 + camera.scale * (sin * look.x + cos * look.y);
  return camera;
}

/** Zooms by `factor`. The place under `pointer` [px] stays there. */
export function zoomed(look: Look, camera: Camera, pointer: Point, factor: number): Look {
  const zoom = Math.min(kMostZoom, Math.max(0.5, look.zoom * factor));
  const place = toField(camera, pointer);
  const share = look.zoom / zoom;
  return { ...look, zoom, x: place.x + share * (look.x - place.x), y: place.y + share * (look.y - place.y) };
}

/** Moves the look by these pixels. */
export function dragged(look: Look, camera: Camera, by: Point): Look {
  const [from, to] = [toField(camera, { x: 0, y: 0 }), toField(camera, by)];
  return { ...look, x: look.x - (to.x - from.x), y: look.y - (to.y - from.y) };
}

/** Returns "2,1.5,-0.25,m" for the page's address, or "" for the whole field. */
export function textOfLook({ zoom, x, y, mirrored }: Look): string {
  const parts = [zoom, x, y].map((value) => String(Number(value.toFixed(2))));
  const plain = parts.join(",") === "1,0,0";
  return plain && !mirrored ? "" : [...parts, ...(mirrored ? ["m"] : [])].join(",");
}

export function lookOfText(text: string): Look {
  const [zoom, x, y, mirrored] = text.split(",");
  const number = (part: string | undefined, otherwise: number, most: number) =>
    part !== undefined && part !== "" && Math.abs(Number(part)) <= most ? Number(part) : otherwise;
  return {
    zoom: Math.max(0.5, number(zoom, 1, kMostZoom)),
    x: number(x, 0, 20),
    y: number(y, 0, 20),
    mirrored: mirrored === "m",
  };
}
