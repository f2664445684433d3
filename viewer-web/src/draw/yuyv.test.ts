import { expect, test } from "vitest";
import { rgbaFromYuyv } from "./yuyv";

const pixel = (y: number, u: number, v: number) => [...rgbaFromYuyv(Uint8Array.of(y, u, y, v), 2, 1).slice(0, 3)];

test("without colour, brightness is kept: the range is full", () => {
  for (const y of [0, 1, 16, 128, 235, 254, 255]) expect(pixel(y, 128, 128)).toEqual([y, y, y]);
});

test("the JPEG colours of pure red, green, blue and of the field come back", () => {
  expect(pixel(76, 85, 255)).toEqual([254, 0, 0]);
  expect(pixel(150, 44, 21)).toEqual([0, 255, 1]);
  expect(pixel(29, 255, 107)).toEqual([0, 0, 254]);
  expect(pixel(90, 110, 105)).toEqual([58, 113, 58]);
});

test("the forward transform of JPEG, undone, is the colour again up to rounding", () => {
  for (let i = 0; i < 1000; ++i) {
    const [r, g, b] = [(i * 37) % 256, (i * 101) % 256, (i * 197) % 256] as const;
    const y = 0.299 * r + 0.587 * g + 0.114 * b;
    const u = (b - y) / 1.772 + 128;
    const v = (r - y) / 1.402 + 128;
    const back = pixel(Math.round(y), Math.min(255, Math.round(u)), Math.min(255, Math.round(v)));
    [r, g, b].forEach((colour, channel) =>
      expect(Math.abs(back[channel]! - colour), `case ${i}`).toBeLessThanOrEqual(2),
    );
  }
});

test("two pixels share their colour, each has its brightness, in reading order", () => {
  const rgba = rgbaFromYuyv(Uint8Array.of(10, 128, 20, 128, 30, 128, 40, 128), 2, 2);
  expect([0, 4, 8, 12].map((at) => rgba[at])).toEqual([10, 20, 30, 40]);
  expect([3, 7, 11, 15].map((at) => rgba[at])).toEqual([255, 255, 255, 255]);
});
