// Images of depth sensors: read from messages, and drawn in colours by distance.

import type { foxglove_RawImage } from "../memory/schema";
import { numberOf, textOf, type Fields } from "../memory/value";
import { kSteps, orderedTable } from "./ordered_colours";

export interface DepthPicture {
  kind: "depth";
  width: number;
  height: number;
  /** [mm] rows from the top; 0: not measured. */
  depth: Uint16Array;
}
export interface ColourPicture {
  kind: "colour";
  width: number;
  height: number;
  /** 3 bytes per pixel. */
  rgb: Uint8Array;
}
export type SensorPicture = DepthPicture | ColourPicture;

const kMostPixels = 4096 * 4096;
const kBytes: Record<string, number> = { "16UC1": 2, mono16: 2, rgb8: 3 };

/** Reads a foxglove.RawImage of depths or colours without padding. Returns the reason if it is none. */
export function sensorPictureOf(message: Fields<foxglove_RawImage>): SensorPicture | { kind: "none"; why: string } {
  const none = (why: string) => ({ kind: "none" as const, why });
  const [width, height] = [numberOf(message, "width"), numberOf(message, "height")];
  const encoding = textOf(message, "encoding");
  const bytes = Object.hasOwn(kBytes, encoding) ? kBytes[encoding]! : 0;
  if (bytes === 0) return none(`Cannot draw the encoding '${encoding}', only 16UC1 and rgb8.`);
  if (!(width > 0 && height > 0 && width * height <= kMostPixels))
    return none(`Cannot draw ${width} x ${height} pixels: expected 1 to 16 million pixels.`);
  const data = message.get("data");
  const length = data instanceof Uint8Array ? data.length : 0;
  if (!(data instanceof Uint8Array) || length !== bytes * width * height)
    return none(`${encoding} of ${width} x ${height} pixels takes ${bytes * width * height} bytes, got ${length}.`);
  if (bytes === 3) return { kind: "colour", width, height, rgb: data };
  // a copy, because the message may begin at an odd address
  return { kind: "depth", width, height, depth: new Uint16Array(data.slice().buffer) };
}

/** [m] The nearest and farthest depth of the colours. */
export interface Range {
  near: number;
  far: number;
}

const kEvery = 151; // a prime, so that the sample lies in all columns
const kStep = 0.25; // [m] ends of ranges
const kTail = 0.01; // share of the depths beyond each end
const kWholeRange: Range = { near: 0.5, far: 5 };

/** Returns the range that holds almost all measured depths. */
export function rangeOf({ depth }: DepthPicture): Range {
  const sample: number[] = [];
  for (let i = 0; i < depth.length; i += kEvery) if (depth[i]! > 0) sample.push(depth[i]!);
  if (sample.length < 20) return kWholeRange;
  sample.sort((a, b) => a - b);
  const [least, most] = [kTail, 1 - kTail].map((share) => sample[Math.floor(share * (sample.length - 1))]! / 1000);
  const near = kStep * Math.floor(least! / kStep);
  return { near, far: Math.max(near + kStep, kStep * Math.ceil(most! / kStep)) };
}

/** Returns the range for the next image: the one before while it fits, so that colours do not flicker. */
export function steadyRange(before: Range | undefined, fresh: Range): Range {
  if (!before) return fresh;
  const isInside = fresh.near >= before.near - kStep && fresh.far <= before.far + kStep;
  const isFilled = fresh.far - fresh.near > 0.6 * (before.far - before.near);
  return isInside && isFilled ? before : fresh;
}

/** The share of a depth [m] in the colours: 1 is near, so that near things are bright. */
export const shareOf = ({ near, far }: Range, depth: number): number => (far - depth) / (far - near);

const kUnmeasured = [0xff_1f_19_14, 0xff_33_2b_24] as const; // stripes, ABGR
const kStripe = 3; // [px] as a power of two

/** Writes the colours of a depth image as RGBA. */
export function paintDepth({ depth, width }: DepthPicture, range: Range, rgba: Uint8ClampedArray): void {
  const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, depth.length);
  const colours = coloursOf(range);
  for (let at = 0, row = 0; at < depth.length; ++row)
    for (let column = 0; column < width; ++column, ++at) {
      const steps = depth[at]!;
      pixels[at] = steps === 0 ? kUnmeasured[((column + row) >> kStripe) & 1]! : colours[steps]!;
    }
}

let known: { range: Range; colours: Uint32Array } | undefined;

/** The colours of all depths in mm. */
function coloursOf(range: Range): Uint32Array {
  if (known?.range.near === range.near && known.range.far === range.far) return known.colours;
  const table = new Uint32Array(orderedTable().slice().buffer);
  const colours = Uint32Array.from({ length: 65536 }, (_, steps) => {
    const share = Math.min(1, Math.max(0, shareOf(range, steps / 1000)));
    return table[Math.round(share * (kSteps - 1))]!;
  });
  known = { range, colours };
  return colours;
}

/** Writes an RGB image as RGBA. */
export function paintColour({ rgb }: ColourPicture, rgba: Uint8ClampedArray): void {
  for (let from = 0, to = 0; from < rgb.length;) {
    rgba[to++] = rgb[from++]!;
    rgba[to++] = rgb[from++]!;
    rgba[to++] = rgb[from++]!;
    rgba[to++] = 255;
  }
}
