// The newest image of a sensor on a canvas of its own size, which is on no page; views draw it enlarged.

import {
  paintColour,
  paintDepth,
  rangeOf,
  sensorPictureOf,
  steadyRange,
  type Range,
  type SensorPicture,
} from "../draw/depth_picture";
import type { Point } from "../draw/field";
import type { Decoded } from "../memory/decoder";
import type { Entry } from "../memory/history";
import type { MemoryObject } from "../memory/memory_object";
import type { foxglove_RawImage } from "../memory/schema";

export interface ReadPicture {
  /** Undefined without an image that can be drawn. */
  picture: SensorPicture | undefined;
  /** The reason why the image cannot be drawn, or "". */
  problem: string;
}

const pictures = new WeakMap<Entry, ReadPicture>();

/** Reads the shown image of `object`, once for all views. */
export function readPicture(object: MemoryObject<foxglove_RawImage> | undefined): ReadPicture {
  const entry = object?.shown;
  if (!object || !entry) return { picture: undefined, problem: "" };
  const known = pictures.get(entry) ?? pictureIn(object.decoded()!);
  pictures.set(entry, known);
  return known;
}

function pictureIn({ fields, error }: Decoded<foxglove_RawImage>): ReadPicture {
  const picture = fields ? sensorPictureOf(fields) : { kind: "none" as const, why: error };
  return picture.kind === "none" ? { picture: undefined, problem: picture.why } : { picture, problem: "" };
}

export class SensorImage {
  readonly canvas = document.createElement("canvas");
  /** The reason why the image cannot be drawn, or "". */
  problem = $state("");
  /** The depths of the colours; undefined before the first depth image. */
  range = $state.raw<Range>();
  /** Whether there is an image. */
  shown = $state(false);
  picture: SensorPicture | undefined;
  #pen = this.canvas.getContext("2d", { alpha: false })!;
  #pixels: ImageData | undefined;
  #taken: Entry | undefined;

  /** Takes over the shown image of `object`, if that is another one. */
  take(object: MemoryObject<foxglove_RawImage> | undefined): void {
    const entry = object?.shown;
    if (entry === this.#taken) return;
    this.#taken = entry;
    ({ picture: this.picture, problem: this.problem } = readPicture(object));
    this.shown = this.picture !== undefined;
    if (this.picture) this.#paint(this.picture);
  }

  #paint(picture: SensorPicture): void {
    const { width, height } = picture;
    if (this.#pixels?.width !== width || this.#pixels.height !== height) {
      [this.canvas.width, this.canvas.height] = [width, height];
      this.#pixels = this.#pen.createImageData(width, height);
    }
    if (picture.kind === "colour") paintColour(picture, this.#pixels.data);
    else {
      const range = steadyRange(this.range, rangeOf(picture));
      if (range !== this.range) this.range = range;
      paintDepth(picture, range, this.#pixels.data);
    }
    this.#pen.putImageData(this.#pixels, 0, 0);
  }

  /** [mm] The depth at a place of the image; 0: not measured. Undefined in a colour image. */
  depthAt({ x, y }: Point): number | undefined {
    const { picture } = this;
    return picture?.kind === "depth" ? picture.depth[Math.floor(y) * picture.width + Math.floor(x)] : undefined;
  }
}
