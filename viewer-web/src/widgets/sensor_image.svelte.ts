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
import type { Entry } from "../memory/history";
import type { MemoryObject } from "../memory/memory_object";
import type { foxglove_RawImage } from "../memory/schema";

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
    const decoded = object?.decoded();
    const read = decoded?.fields ? sensorPictureOf(decoded.fields) : undefined;
    this.problem = read?.kind === "none" ? read.why : (decoded?.error ?? "");
    this.picture = read && read.kind !== "none" ? read : undefined;
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
