// How readable one colour is on another.

/** The contrast of two colours "#rrggbb", 1 .. 21 (WCAG 2.1). Text needs 4.5, a line 3. */
export function contrast(one: string, other: string): number {
  const [a, b] = [brightness(one), brightness(other)];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}

const brightness = (colour: string): number => {
  const [red, green, blue] = [1, 3, 5]
    .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
    .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
};

/** The dark or the bright colour of words on `ground`, whichever is more readable. */
export const wordsOn = (ground: string): string =>
  contrast(kDarkWords, ground) >= contrast(kBrightWords, ground) ? kDarkWords : kBrightWords;

const kDarkWords = "#10161c";
const kBrightWords = "#ffffff";
