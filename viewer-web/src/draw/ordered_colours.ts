// Colours in an order that the eye sees: from dark violet over red and orange to light yellow. Equal steps of the value are
// equal steps of brightness, also for people who do not distinguish hues.
//
// The path is straight in the lightness of Oklab (B. Ottosson, 2020), so no table of another program is needed.

const kDarkest = 0.3; // [0..1] lightness in Oklab; black belongs to things without a value
const kLightest = 0.93;
const kFirstHue = (290 * Math.PI) / 180;
const kLastHue = (465 * Math.PI) / 180; // 105°, once around
const kMostChroma = 0.17;

type Colour = [red: number, green: number, blue: number]; // 0 .. 1

/** Returns the lightness of the colour of a share. */
const lightnessAt = (share: number): number => kDarkest + (kLightest - kDarkest) * clamped(share);

const clamped = (value: number): number => Math.min(1, Math.max(0, value));

/** Returns red, green and blue, 0 .. 255, of a share from 0 to 1. */
export function orderedColour(share: number): Colour {
  const lightness = lightnessAt(share);
  const hue = kFirstHue + (kLastHue - kFirstHue) * clamped(share);
  // less chroma where the screen has no such colour
  for (let chroma = kMostChroma; ; chroma -= 0.005) {
    const colour = rgbOf(lightness, chroma * Math.cos(hue), chroma * Math.sin(hue));
    if (chroma <= 0 || colour.every((value) => value >= 0 && value <= 1))
      return colour.map((value) => Math.round(255 * clamped(value))) as Colour;
  }
}

/** Converts from Oklab to sRGB, without limits. */
function rgbOf(lightness: number, a: number, b: number): Colour {
  const [l, m, s] = [
    lightness + 0.3963377774 * a + 0.2158037573 * b,
    lightness - 0.1055613458 * a - 0.0638541728 * b,
    lightness - 0.0894841775 * a - 1.291485548 * b,
  ].map((value) => value ** 3) as Colour;
  const linear: Colour = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((value) => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055)) as Colour;
}

export const kSteps = 256;
let table: Uint8Array | undefined;

/** Returns `kSteps` colours as RGBA. */
export function orderedTable(): Uint8Array {
  table ??= Uint8Array.from(Array.from({ length: kSteps }, (_, i) => [...orderedColour(i / (kSteps - 1)), 255]).flat());
  return table;
}

/** "rgb(…)" of a share from 0 to 1. */
export const orderedStyle = (share: number): string => `rgb(${orderedColour(share).join(" ")})`;

const kStops = 9;

/** The colours of a legend between two shares, as a CSS gradient from left to right. */
export const gradientFrom = (first: number, last: number): string => {
  const stops = Array.from({ length: kStops }, (_, i) => orderedStyle(first + (i / (kStops - 1)) * (last - first)));
  return `linear-gradient(to right, ${stops.join(", ")})`;
};
