// Reads an image from any message that carries one: foresight.Image, foxglove.RawImage, foxglove.CompressedImage.

import type { foxglove_CompressedImage, foxglove_RawImage, Image } from "../memory/schema";
import { numberOf, wordOf, type Fields } from "../memory/value";

export type Picture =
  { kind: "yuyv"; width: number; height: number; data: Uint8Array } | { kind: "jpeg"; data: Uint8Array };

const kMostPixels = 4096 * 4096; // larger than any of our cameras; a larger claim is an error

type AnyImage = Omit<Image, "encoding"> &
  Pick<foxglove_CompressedImage, "format"> & { encoding?: Image["encoding"] | foxglove_RawImage["encoding"] };

/** Reads by field name: `encoding` (or `format`), `width`, `height`, `data`. Returns the reason if it is no image. */
export function pictureOf(message: Fields<AnyImage>): Picture | { kind: "none"; why: string } {
  const none = (why: string) => ({ kind: "none" as const, why });
  const data = message.get("data");
  if (!(data instanceof Uint8Array)) return none("The message has no field 'data' of bytes.");

  const encoding = wordOf(message, message.has("encoding") ? "encoding" : "format");
  if (encoding === "jpeg" || encoding === "jpg")
    return data.length > 0 ? { kind: "jpeg", data } : none("The JPEG is empty.");
  if (encoding !== "yuyv" && encoding !== "yuv422_yuy2")
    return none(`Cannot draw the encoding '${encoding}', only YUYV and JPEG.`);

  const width = numberOf(message, "width");
  const height = numberOf(message, "height");
  if (!(width > 0 && height > 0 && width % 2 === 0 && width * height <= kMostPixels))
    return none(`Cannot draw YUYV of ${width} x ${height} pixels: the width must be even, at most 16 million pixels.`);
  if (data.length !== 2 * width * height)
    return none(
      `YUYV of ${width} x ${height} pixels takes ${2 * width * height} bytes, the message has ${data.length}.`,
    );
  return { kind: "yuyv", width, height, data };
}
