// For tests: a canvas that remembers what was drawn on it.

import type { Pen, Point } from "./field";

export interface TestPen extends Pen {
  /** Corners of boxes, ends of lines, middles of circles [px]. */
  points: Point[];
  circles: (Point & { radius: number; filled: boolean; style: string; alpha: number })[];
  polygons: { corners: Point[]; filled: boolean; style: string; alpha: number }[];
  texts: (Point & { text: string })[];
  /** Filled. */
  boxes: (Point & { width: number; height: number; style: string })[];
}

export function testPen(): TestPen {
  let circle: (Point & { radius: number }) | undefined;
  let path: Point[] = [];
  let closed = false;
  const points: Point[] = [];
  const box = (x: number, y: number, width: number, height: number) => {
    for (const [dx, dy] of [
      [0, 0],
      [width, 0],
      [0, height],
      [width, height],
    ] as const)
      points.push({ x: x + dx, y: y + dy });
  };
  const pen: TestPen = {
    points,
    circles: [],
    polygons: [],
    texts: [],
    boxes: [],
    fillStyle: "",
    strokeStyle: "",
    lineWidth: 1,
    globalAlpha: 1,
    font: "",
    textAlign: "start",
    textBaseline: "alphabetic",
    beginPath() {
      circle = undefined;
      path = [];
      closed = false;
    },
    moveTo(x, y) {
      points.push({ x, y });
      path.push({ x, y });
    },
    lineTo(x, y) {
      points.push({ x, y });
      path.push({ x, y });
    },
    arc(x, y, radius) {
      points.push({ x, y });
      circle = { x, y, radius };
    },
    closePath: () => (closed = true),
    ellipse(x, y, radius) {
      points.push({ x, y });
      circle = { x, y, radius };
    },
    fill() {
      const look = { filled: true, style: String(pen.fillStyle), alpha: pen.globalAlpha };
      if (circle) pen.circles.push({ ...circle, ...look });
      else if (closed) pen.polygons.push({ corners: path, ...look });
    },
    stroke: () =>
      circle && pen.circles.push({ ...circle, filled: false, style: String(pen.strokeStyle), alpha: pen.globalAlpha }),
    fillRect(x, y, width, height) {
      box(x, y, width, height);
      pen.boxes.push({ x, y, width, height, style: String(pen.fillStyle) });
    },
    strokeRect: box,
    fillText: (text, x, y) => void pen.texts.push({ text, x, y }),
    setLineDash: () => {},
  };
  return pen;
}

/** Returns the bounding box of the drawing, without the width of pens. */
export function boxOf({ points }: TestPen) {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
}
