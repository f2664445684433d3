// The sign of a robot on the field: its side's colour and shape, its number, its heading, and whether it has fallen.
// All views draw robots with it, so that a side looks the same everywhere.

import {
  fillPolygon,
  fillCircle,
  strokeCircle,
  strokeLine,
  strokePolygon,
  toScreen,
  type Camera,
  type Pen,
  type Point,
} from "./field";

/** How the robots of one side look. Shapes differ between sides, for people who do not see the colours' difference. */
export interface Livery {
  colour: string;
  shape: "disc" | "square";
}

export interface Liveries {
  home: Livery;
  away: Livery;
}

/** Without known jerseys. The brightness of one is twice the other's. */
export const kLiveries: Liveries = {
  home: { colour: "#8ec5ff", shape: "disc" },
  away: { colour: "#e8500a", shape: "square" },
};

/** Robots that nobody has identified look like this. */
export const kUnknownLivery: Livery = { colour: "#dde5ea", shape: "disc" };

/** Jerseys by the words of `TeamState.Colour`, bright enough for the carpet. */
const kJerseys: Record<string, string> = {
  blue: "#6fb1ff",
  red: "#e33b2e",
  yellow: "#ffe04a",
  black: "#20252b",
  white: "#f5f7f5",
  green: "#86e07a",
  orange: "#ff9430",
  purple: "#c58bff",
  brown: "#b07d4c",
  gray: "#aab2ba",
};

/** Returns the liveries of sides that wear `home` and `away`, words of `TeamState.Colour`. Equal or unknown ones do not count. */
export function liveriesOf(home: string, away: string): Liveries {
  const [one, other] = [kJerseys[home], kJerseys[away]];
  if (!one || !other || one === other) return kLiveries;
  return { home: { ...kLiveries.home, colour: one }, away: { ...kLiveries.away, colour: other } };
}

export const kRobotRadius = 0.15; // [m] of a Nao from above, arms included
export const kInk = "#0d1712";
export const kBright = "#ffffff";
const kFallen = "#ffe14d";

export interface Sign extends Point {
  /** [rad] NaN if unknown. */
  heading: number;
}

/** The point `distance` [m] ahead of a robot. */
export const ahead = ({ x, y, heading }: Sign, distance: number): Point => ({
  x: x + distance * Math.cos(heading),
  y: y + distance * Math.sin(heading),
});

/** The corners of a square body of about the disc's area. */
function cornersOf({ x, y, heading }: Sign, radius: number): Point[] {
  const turn = Number.isFinite(heading) ? heading : 0;
  return [1, 3, 5, 7].map((eighth) => {
    const angle = turn + (eighth * Math.PI) / 4;
    return { x: x + 1.25 * radius * Math.cos(angle), y: y + 1.25 * radius * Math.sin(angle) };
  });
}

export function fillBody(pen: Pen, camera: Camera, at: Sign, { colour, shape }: Livery, radius = kRobotRadius): void {
  if (shape === "disc") fillCircle(pen, camera, at, radius, colour);
  else fillPolygon(pen, camera, cornersOf(at, radius), colour);
}

/** Draws the outline with the pen's style. */
export function strokeBody(pen: Pen, camera: Camera, at: Sign, { shape }: Livery, radius = kRobotRadius): void {
  if (shape === "disc") strokeCircle(pen, camera, at, radius);
  else strokePolygon(pen, camera, cornersOf(at, radius));
}

/** Draws the line that shows the heading with the pen's style. */
export function strokeHeading(pen: Pen, camera: Camera, at: Sign, from = kRobotRadius): void {
  if (Number.isFinite(at.heading)) strokeLine(pen, camera, ahead(at, from), ahead(at, 1.7 * kRobotRadius));
}

/** Draws the number in the middle, in an ink that is readable on the livery. */
export function drawNumber(pen: Pen, camera: Camera, text: string, at: Point, { colour }: Livery): void {
  drawWord(pen, camera, text, at, isDark(colour) ? kBright : kInk);
}

/** Draws a short word in the size of a robot's number. */
export function drawWord(pen: Pen, camera: Camera, text: string, at: Point, colour: string): void {
  const { x, y } = toScreen(camera, at);
  pen.fillStyle = colour;
  pen.font = `600 ${Math.max(10, Math.round(0.17 * camera.scale))}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(text, x, y);
}

const isDark = (colour: string): boolean => {
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  return 0.3 * red! + 0.59 * green! + 0.11 * blue! < 80;
};

/** Draws the sign of a fallen robot over its body: a bold ring, a bar through it, and the word. */
export function drawFallen(pen: Pen, camera: Camera, at: Sign): void {
  pen.globalAlpha = 1;
  const bar = 1.5 * kRobotRadius;
  for (const [colour, width] of [
    [kInk, 7],
    [kFallen, 4],
  ] as const) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    strokeCircle(pen, camera, at, bar);
    strokeLine(pen, camera, { x: at.x - 0.7 * bar, y: at.y - 0.7 * bar }, { x: at.x + 0.7 * bar, y: at.y + 0.7 * bar });
  }
  drawOutlined(pen, toScreen(camera, at), -(camera.scale * bar + 11), "fallen", { colour: kFallen, weight: 700 });
}

/** Draws words `below` [px] a place, with a dark edge, so that they are readable over lines too. */
export function drawOutlined(
  pen: Pen,
  { x, y }: Point,
  below: number,
  words: string,
  { colour, weight }: { colour: string; weight: number },
): void {
  pen.font = `${weight} 12px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = kInk;
  for (const [dx, dy] of [
    [-1, 0],
    [1, 0],
    [0, 1],
  ] as const)
    pen.fillText(words, x + dx, y + below + dy);
  pen.fillStyle = colour;
  pen.fillText(words, x, y + below);
}
