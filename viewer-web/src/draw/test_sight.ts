// For tests: colours as people with colour blindness see them, and the distance of two colours.

type Rgb = [number, number, number];
type Matrix = [Rgb, Rgb, Rgb];

/** Matrices for linear RGB, for a sight without one kind of cones (Machado, Oliveira and Fernandes, 2009). */
export const kSights: Record<string, Matrix> = {
  "all colours": [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
};

const linear = (value: number): number => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);

/** "#rrggbb" in linear RGB, 0 .. 1. */
const rgbOf = (colour: string): Rgb =>
  [1, 3, 5].map((at) => linear(parseInt(colour.slice(at, at + 2), 16) / 255)) as Rgb;

const times = (matrix: Matrix, [r, g, b]: Rgb): Rgb =>
  matrix.map((row) => Math.min(1, Math.max(0, row[0] * r + row[1] * g + row[2] * b))) as Rgb;

/** CIE L*a*b* for daylight (D65). */
function labOf([r, g, b]: Rgb): Rgb {
  const f = (value: number) => (value > 216 / 24389 ? Math.cbrt(value) : (24389 / 27) * (value / 116) + 16 / 116);
  const [x, y, z] = [
    f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505),
    f(0.2126 * r + 0.7152 * g + 0.0722 * b),
    f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089),
  ];
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** How different two colours look: 2 is just to be seen side by side, 100 is black and white. */
export function distance(sight: Matrix, one: string, other: string): number {
  const [a, b] = [one, other].map((colour) => labOf(times(sight, rgbOf(colour))));
  return Math.hypot(a![0] - b![0], a![1] - b![1], a![2] - b![2]);
}
