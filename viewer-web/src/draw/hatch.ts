// Hatched areas: parts of the time that are not loaded. They differ from parts without data, which are empty.

import type { Pen } from "./field";

const kApart = 10; // [px] between two lines

/** Hatches a rectangle [px] with diagonal lines, which do not leave it. */
export function hatch(pen: Pen, left: number, top: number, width: number, height: number, colour: string): void {
  if (width <= 0 || height <= 0) return;
  pen.strokeStyle = colour;
  pen.lineWidth = 1;
  pen.globalAlpha = 0.3;
  pen.setLineDash([]);
  pen.beginPath();
  // lines rise to the right; they are fixed to the canvas, so that a moving edge does not move them
  for (let foot = Math.floor((left - height) / kApart) * kApart; foot < left + width; foot += kApart) {
    const [from, to] = [Math.max(left, foot), Math.min(left + width, foot + height)];
    if (to <= from) continue;
    pen.moveTo(from, top + height - (from - foot));
    pen.lineTo(to, top + height - (to - foot));
  }
  pen.stroke();
  pen.globalAlpha = 1;
}
