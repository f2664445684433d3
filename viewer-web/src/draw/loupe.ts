// A magnifier over an image, which shows single pixels for a precise click.

import type { Pen, Point } from "./field";
import { ticks, type Fit } from "./overlay";

const kSize = 136; // [px of the page]
export const kLoupeScale = 8; // [px of the page / px of the image]
const kMargin = 10;

/** The pen of a real canvas. */
export type ImagePen = Pen &
  Pick<CanvasRenderingContext2D, "save" | "restore" | "clip" | "rect" | "drawImage" | "imageSmoothingEnabled">;

/** Returns how the image lies in a loupe with `middle` [px of the image] in its middle. It avoids the pointer. */
export function loupeAt(
  shape: { width: number; height: number },
  image: { width: number; height: number },
  middle: Point,
  pointer: Point | undefined,
): { left: number; top: number; fit: Fit } {
  const isLeft = pointer !== undefined && pointer.x < kSize + 3 * kMargin && pointer.y < kSize + 3 * kMargin;
  const left = isLeft ? shape.width - kSize - kMargin : kMargin;
  const fit = {
    width: image.width,
    height: image.height,
    scale: kLoupeScale,
    left: left + kSize / 2 - kLoupeScale * middle.x,
    top: kMargin + kSize / 2 - kLoupeScale * middle.y,
  };
  return { left, top: kMargin, fit };
}

/** Draws the loupe. `over` draws what lies over the image. */
export function drawLoupe(
  pen: ImagePen,
  shape: { width: number; height: number },
  image: HTMLCanvasElement,
  middle: Point,
  pointer: Point | undefined,
  over: (fit: Fit) => void,
): void {
  const { left, top, fit } = loupeAt(shape, image, middle, pointer);
  pen.save();
  pen.beginPath();
  pen.rect(left, top, kSize, kSize);
  pen.clip();
  pen.fillStyle = "#0b0e11";
  pen.fillRect(left, top, kSize, kSize);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(image, fit.left, fit.top, kLoupeScale * image.width, kLoupeScale * image.height);
  over(fit);
  ticks(pen, { x: left + kSize / 2, y: top + kSize / 2 }, 5, 30, "#ffffff", 1);
  pen.restore();
  pen.strokeStyle = "#ffffff";
  pen.lineWidth = 1.5;
  pen.globalAlpha = 0.9;
  pen.strokeRect(left, top, kSize, kSize);
  pen.globalAlpha = 1;
}
