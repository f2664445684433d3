// The field from above, and what is on it. Metres of the frame `field`; plain drawing, no browser needed.

/** As /sim/state has it. [m] between the middles of lines. */
export interface Field {
  length: number;
  width: number;
  border: number;
  lineWidth: number;
  centreCircleRadius: number;
  goalAreaLength: number;
  goalAreaWidth: number;
  /** 0: the field has none. */
  penaltyAreaLength: number;
  penaltyAreaWidth: number;
  penaltyMark: number;
  goalWidth: number;
  goalDepth: number;
}

/** Where nobody tells: the field of 2012 to 2014. */
export const kUsualField: Field = {
  length: 6, width: 4, border: 0.7, lineWidth: 0.05, centreCircleRadius: 0.6, goalAreaLength: 0.6, goalAreaWidth: 2.2,
  penaltyAreaLength: 0, penaltyAreaWidth: 0, penaltyMark: 1.8, goalWidth: 1.4, goalDepth: 0.4,
};

/** The part of a canvas' context that is used, so that tests can be the canvas. */
export type Pen = Pick<
  CanvasRenderingContext2D,
  | "fillStyle" | "strokeStyle" | "lineWidth" | "globalAlpha" | "font" | "textAlign" | "textBaseline"
  | "beginPath" | "moveTo" | "lineTo" | "arc" | "fill" | "stroke" | "fillRect" | "strokeRect" | "fillText" | "setLineDash"
>;

/** How metres become pixels: x to the right, y up. */
export interface Camera {
  scale: number; // [px/m]
  centreX: number; // [px] of the field's centre
  centreY: number;
}

export interface Point {
  x: number;
  y: number;
}

/** The whole carpet fits into `width` x `height` pixels, in its middle. */
export function cameraFor(field: Field, width: number, height: number): Camera {
  const scale = Math.min(width / (field.length + 2 * field.border), height / (field.width + 2 * field.border));
  return { scale, centreX: width / 2, centreY: height / 2 };
}

export const toScreen = (camera: Camera, { x, y }: Point): Point => ({
  x: camera.centreX + camera.scale * x,
  y: camera.centreY - camera.scale * y,
});

export const toField = (camera: Camera, { x, y }: Point): Point => ({
  x: (x - camera.centreX) / camera.scale,
  y: (camera.centreY - y) / camera.scale,
});

const kCarpet = "#23523a";
const kLine = "#e8efe9";

export function drawField(pen: Pen, camera: Camera, field: Field): void {
  const { length, width, border } = field;
  const corner = toScreen(camera, { x: -length / 2 - border, y: width / 2 + border });
  pen.fillStyle = kCarpet;
  pen.fillRect(corner.x, corner.y, camera.scale * (length + 2 * border), camera.scale * (width + 2 * border));

  pen.strokeStyle = kLine;
  pen.lineWidth = Math.max(1, camera.scale * field.lineWidth);
  strokeBox(pen, camera, { x: -length / 2, y: width / 2 }, length, width);
  strokeLine(pen, camera, { x: 0, y: -width / 2 }, { x: 0, y: width / 2 });
  strokeCircle(pen, camera, { x: 0, y: 0 }, field.centreCircleRadius);
  for (const side of [-1, 1]) {
    for (const [deep, wide] of [
      [field.goalAreaLength, field.goalAreaWidth],
      [field.penaltyAreaLength, field.penaltyAreaWidth],
    ] as const)
      if (deep > 0) strokeBox(pen, camera, { x: side > 0 ? length / 2 - deep : -length / 2, y: wide / 2 }, deep, wide);
    const mark = { x: side * (length / 2 - field.penaltyMark), y: 0 };
    fillCircle(pen, camera, mark, 1.2 * field.lineWidth, kLine);
  }
  drawGoals(pen, camera, field);
}

function drawGoals(pen: Pen, camera: Camera, { length, goalWidth, goalDepth }: Field): void {
  pen.strokeStyle = "#ffffff";
  pen.lineWidth = Math.max(2, camera.scale * 0.07);
  for (const side of [-1, 1]) {
    const posts = [goalWidth / 2, -goalWidth / 2].map((y) => ({ x: (side * length) / 2, y }));
    const net = posts.map(({ x, y }) => ({ x: x + side * goalDepth, y }));
    strokePath(pen, camera, [posts[0]!, net[0]!, net[1]!, posts[1]!]);
  }
}

export function strokePath(pen: Pen, camera: Camera, points: Point[]): void {
  pen.beginPath();
  points.forEach((point, i) => {
    const { x, y } = toScreen(camera, point);
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
  pen.stroke();
}

export const strokeLine = (pen: Pen, camera: Camera, from: Point, to: Point): void => strokePath(pen, camera, [from, to]);

/** `corner` is the one with the smallest x and the greatest y. */
function strokeBox(pen: Pen, camera: Camera, corner: Point, length: number, width: number): void {
  const { x, y } = toScreen(camera, corner);
  pen.strokeRect(x, y, camera.scale * length, camera.scale * width);
}

export function strokeCircle(pen: Pen, camera: Camera, centre: Point, radius: number): void {
  circle(pen, camera, centre, radius);
  pen.stroke();
}

export function fillCircle(pen: Pen, camera: Camera, centre: Point, radius: number, style: string): void {
  pen.fillStyle = style;
  circle(pen, camera, centre, radius);
  pen.fill();
}

function circle(pen: Pen, camera: Camera, centre: Point, radius: number): void {
  const { x, y } = toScreen(camera, centre);
  pen.beginPath();
  pen.arc(x, y, Math.max(1, camera.scale * radius), 0, 2 * Math.PI);
}
