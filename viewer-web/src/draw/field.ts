// The field from above. In metres of the frame `field`; plain drawing that needs no browser.

/** The dimensions in /sim/state. [m] between the middles of lines. */
export interface Field {
  length: number;
  width: number;
  border: number;
  lineWidth: number;
  centreCircleRadius: number;
  goalAreaLength: number;
  goalAreaWidth: number;
  /** 0 if the field has none. */
  penaltyAreaLength: number;
  penaltyAreaWidth: number;
  penaltyMark: number;
  goalWidth: number;
  goalDepth: number;
}

/** Equal to sim/data/rules; a test compares them. */
export const kFields: Record<string, Field> = {
  spl2012: {
    length: 6,
    width: 4,
    border: 0.71,
    lineWidth: 0.05,
    centreCircleRadius: 0.6,
    goalAreaLength: 0.6,
    goalAreaWidth: 2.2,
    penaltyAreaLength: 0,
    penaltyAreaWidth: 0,
    penaltyMark: 1.3,
    goalWidth: 1.4,
    goalDepth: 0.4,
  },
  spl2025: {
    length: 9,
    width: 6,
    border: 0.7,
    lineWidth: 0.05,
    centreCircleRadius: 0.75,
    goalAreaLength: 0.6,
    goalAreaWidth: 2.2,
    penaltyAreaLength: 1.65,
    penaltyAreaWidth: 4,
    penaltyMark: 1.3,
    goalWidth: 1.6,
    goalDepth: 0.5,
  },
  hsl2026: {
    length: 8.95,
    width: 5.95,
    border: 1.025,
    lineWidth: 0.05,
    centreCircleRadius: 0.725,
    goalAreaLength: 0.95,
    goalAreaWidth: 2.95,
    penaltyAreaLength: 1.95,
    penaltyAreaWidth: 3.95,
    penaltyMark: 1.475,
    goalWidth: 1.9,
    goalDepth: 0.48,
  },
};

/** The part of a canvas' context that the drawing uses, so that tests can replace it. */
export type Pen = Pick<
  CanvasRenderingContext2D,
  | "fillStyle"
  | "strokeStyle"
  | "lineWidth"
  | "globalAlpha"
  | "font"
  | "textAlign"
  | "textBaseline"
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "closePath"
  | "arc"
  | "ellipse"
  | "fill"
  | "stroke"
  | "fillRect"
  | "strokeRect"
  | "fillText"
  | "setLineDash"
>;

/** The conversion from metres to pixels: x to the right, y up, then turned. */
export interface Camera {
  scale: number; // [px/m]
  centreX: number; // [px] of the field's centre
  centreY: number;
  /** Quarter turns, counter-clockwise: 1 turns +x up, 2 is the view from the other side. */
  turns?: number;
}

export interface Point {
  x: number;
  y: number;
}

/** Returns the camera that shows the whole carpet in the middle of `width` x `height` pixels. */
export function cameraFor(field: Field, width: number, height: number): Camera {
  const scale = Math.min(width / (field.length + 2 * field.border), height / (field.width + 2 * field.border));
  return { scale, centreX: width / 2, centreY: height / 2 };
}

const kCos = [1, 0, -1, 0];
const kSin = [0, 1, 0, -1];

export function toScreen({ scale, centreX, centreY, turns = 0 }: Camera, { x, y }: Point): Point {
  const [cos, sin] = [kCos[turns]!, kSin[turns]!];
  return { x: centreX + scale * (cos * x - sin * y), y: centreY - scale * (sin * x + cos * y) };
}

export function toField({ scale, centreX, centreY, turns = 0 }: Camera, { x, y }: Point): Point {
  const [cos, sin] = [kCos[turns]!, kSin[turns]!];
  const [right, up] = [(x - centreX) / scale, (centreY - y) / scale];
  return { x: cos * right + sin * up, y: cos * up - sin * right };
}

/** Converts a direction of the field to a canvas angle: clockwise from the right. */
export const toCanvasAngle = ({ turns = 0 }: Camera, angle: number): number => -(angle + (turns * Math.PI) / 2);

const kCarpet = "#23523a";
const kLine = "#e8efe9";

export function drawField(pen: Pen, camera: Camera, field: Field): void {
  const { length, width, border } = field;
  const [one, other] = [-1, 1].map((side) =>
    toScreen(camera, { x: side * (length / 2 + border), y: side * (width / 2 + border) }),
  );
  pen.fillStyle = kCarpet;
  pen.fillRect(
    Math.min(one!.x, other!.x),
    Math.min(one!.y, other!.y),
    Math.abs(other!.x - one!.x),
    Math.abs(other!.y - one!.y),
  );

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
    // a cross, as on the carpet, which differs from a ball
    const [at, arm] = [side * (length / 2 - field.penaltyMark), 0.05];
    strokeLine(pen, camera, { x: at - arm, y: 0 }, { x: at + arm, y: 0 });
    strokeLine(pen, camera, { x: at, y: -arm }, { x: at, y: arm });
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

/** Sets the style of lines. */
export function style(pen: Pen, colour: string, width: number, alpha = 1): void {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.globalAlpha = alpha;
}

function polygon(pen: Pen, camera: Camera, corners: Point[]): void {
  trace(pen, camera, corners);
  pen.closePath();
}

export function strokePath(pen: Pen, camera: Camera, points: Point[]): void {
  trace(pen, camera, points);
  pen.stroke();
}

function trace(pen: Pen, camera: Camera, points: Point[]): void {
  pen.beginPath();
  points.forEach((point, i) => {
    const { x, y } = toScreen(camera, point);
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
}

export const strokeLine = (pen: Pen, camera: Camera, from: Point, to: Point): void =>
  strokePath(pen, camera, [from, to]);

/** Draws a diagonal cross whose arms reach `arm` [m] along each axis. */
export function strokeCross(pen: Pen, camera: Camera, { x, y }: Point, arm: number): void {
  for (const side of [-1, 1])
    strokeLine(pen, camera, { x: x - arm, y: y - side * arm }, { x: x + arm, y: y + side * arm });
}

/** Draws a box. `corner` has the smallest x and the greatest y. */
function strokeBox(pen: Pen, camera: Camera, corner: Point, length: number, width: number): void {
  const [one, other] = [toScreen(camera, corner), toScreen(camera, { x: corner.x + length, y: corner.y - width })];
  pen.strokeRect(
    Math.min(one.x, other.x),
    Math.min(one.y, other.y),
    Math.abs(other.x - one.x),
    Math.abs(other.y - one.y),
  );
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

export function fillPolygon(pen: Pen, camera: Camera, corners: Point[], style: string): void {
  pen.fillStyle = style;
  polygon(pen, camera, corners);
  pen.fill();
}

export function strokePolygon(pen: Pen, camera: Camera, corners: Point[]): void {
  polygon(pen, camera, corners);
  pen.stroke();
}

/** Half axes [m] and the direction of the first one [rad]. */
export interface Ellipse {
  a: number;
  b: number;
  angle: number;
}

export function strokeEllipse(pen: Pen, camera: Camera, centre: Point, { a, b, angle }: Ellipse, least = 0): void {
  ellipse(pen, camera, centre, { a: Math.max(a, least), b: Math.max(b, least), angle });
  pen.stroke();
}

export function fillEllipse(pen: Pen, camera: Camera, centre: Point, size: Ellipse, style: string): void {
  pen.fillStyle = style;
  ellipse(pen, camera, centre, size);
  pen.fill();
}

function ellipse(pen: Pen, camera: Camera, centre: Point, { a, b, angle }: Ellipse): void {
  const { x, y } = toScreen(camera, centre);
  pen.beginPath();
  pen.ellipse(
    x,
    y,
    Math.max(1, camera.scale * a),
    Math.max(1, camera.scale * b),
    toCanvasAngle(camera, angle),
    0,
    2 * Math.PI,
  );
}

/** Fills the sector within `half` [rad] of a direction, up to `radius` [m]. */
export function fillSector(
  pen: Pen,
  camera: Camera,
  from: Point,
  angle: number,
  half: number,
  radius: number,
  style: string,
): void {
  const { x, y } = toScreen(camera, from);
  const middle = toCanvasAngle(camera, angle);
  pen.fillStyle = style;
  pen.beginPath();
  pen.moveTo(x, y);
  pen.arc(x, y, camera.scale * radius, middle - half, middle + half);
  pen.closePath();
  pen.fill();
}

/** Draws a line with an arrow head of `head` [m] at its end. */
export function strokeArrow(pen: Pen, camera: Camera, from: Point, to: Point, head = 0.08): void {
  const [length, angle] = [Math.hypot(to.x - from.x, to.y - from.y), Math.atan2(to.y - from.y, to.x - from.x)];
  if (!(length > 0)) return;
  const barb = (side: number): Point => ({
    x: to.x - head * Math.cos(angle + side * 0.5),
    y: to.y - head * Math.sin(angle + side * 0.5),
  });
  strokeLine(pen, camera, from, to);
  strokePath(pen, camera, [barb(-1), to, barb(1)]);
}

function circle(pen: Pen, camera: Camera, centre: Point, radius: number): void {
  const { x, y } = toScreen(camera, centre);
  pen.beginPath();
  pen.arc(x, y, Math.max(1, camera.scale * radius), 0, 2 * Math.PI);
}
