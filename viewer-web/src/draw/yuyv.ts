// YUYV (Y0 U Y1 V per pair of pixels) to RGB: the coefficients, and the reference conversion.
//
// BT.601 with full range, as in JPEG (JFIF). The Nao's cameras use the full range of Y: pictures have values from 0 to 255,
// not 16..235. The robot compresses its JPEGs from these same bytes. With another choice the same picture would look
// different in the two encodings.

export const kRedFromV = 1.402;
export const kGreenFromU = -0.344136;
export const kGreenFromV = -0.714136;
export const kBlueFromU = 1.772;

/** The pixels as RGBA, each pair sharing its U and V. `yuyv` holds exactly 2 * width * height bytes, width is even. */
export function rgbaFromYuyv(yuyv: Uint8Array, width: number, height: number): Uint8ClampedArray<ArrayBuffer> {
  const rgba = new Uint8ClampedArray(4 * width * height); // rounds and clamps what is stored
  for (let from = 0, to = 0; from < 2 * width * height; from += 4) {
    const u = yuyv[from + 1]! - 128;
    const v = yuyv[from + 3]! - 128;
    for (const y of [yuyv[from]!, yuyv[from + 2]!]) {
      rgba[to++] = y + kRedFromV * v;
      rgba[to++] = y + kGreenFromU * u + kGreenFromV * v;
      rgba[to++] = y + kBlueFromU * u;
      rgba[to++] = 255;
    }
  }
  return rgba;
}
