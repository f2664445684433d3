import { expect, test } from "vitest";
import { ago, bytes, clockLength, clockTime, count, duration, hertz, hex, number, numberWithin } from "./format";

test("durations keep three digits or so, and never show a unit's overflow", () => {
  const cases: [number | undefined, string][] = [
    [undefined, "–"],
    [NaN, "–"],
    [0, "0 ms"],
    [0.0333, "33 ms"],
    [0.9994, "999 ms"],
    [0.9996, "1.00 s"],
    [9.994, "9.99 s"],
    [9.996, "10.0 s"],
    [99.94, "99.9 s"],
    [99.96, "2 min"],
    [7200, "2 h"],
    [864000, "10 days"],
  ];
  for (const [seconds, text] of cases) expect(duration(seconds)).toBe(text);
});

test("lengths of recordings read like a clock", () => {
  expect([0, 7, 59.6, 600, 3723, -1, NaN].map(clockLength)).toEqual([
    "0:00",
    "0:07",
    "1:00",
    "10:00",
    "1:02:03",
    "–",
    "–",
  ]);
});

test("sizes are decimal and change unit before they show four digits", () => {
  expect([0, 999, 999.6, 1234, 614400, 999499, 999500, 5e15].map(bytes)).toEqual([
    "0 B",
    "999 B",
    "1.0 kB",
    "1.2 kB",
    "614 kB",
    "999 kB",
    "1.0 MB",
    "5000 TB",
  ]);
});

test("rates and counts", () => {
  expect([NaN, 0, 0.5, 30, 99.96].map(hertz)).toEqual(["–", "0", "0.5", "30.0", "100"]);
  expect([0, 999, 1000, 1234567].map(count)).toEqual(["0", "999", "1\u2009000", "1\u2009234\u2009567"]);
});

test("a float shows the digits it has, not those of its double", () => {
  expect([Math.fround(1.1), Math.fround(-0.3), 16777216, -0, 1e-9, Infinity, NaN].map(number)).toEqual([
    "1.1",
    "-0.3",
    "16777216",
    "0",
    "1e-9",
    "∞",
    "not a number",
  ]);
});

test("a value on an axis shows steps of at most a five-hundredth of the axis, always as many digits", () => {
  const cases: [value: number, span: number, text: string][] = [
    [1.2345678, 9, "1.23"],
    [-0.3333333, 1, "-0.333"],
    [36.641237, 120, "36.6"],
    [0.0123456, 0.02, "0.01235"],
    [4321.987, 5000, "4322"],
    [-0.0001, 9, "0.00"],
    [1.5, 9, "1.50"],
    [12, 9, "12"],
    [0.1, 0, "0.1"],
    [NaN, 9, "not a number"],
  ];
  for (const [value, span, text] of cases) expect(numberWithin(value, span)).toBe(text);
  for (let span = 1e-6; span < 1e6; span *= 3) {
    const decimals = numberWithin(span / 7, span).split(".")[1]?.length ?? 0;
    expect(10 ** -decimals).toBeLessThanOrEqual(Math.max(1, span / 500) * 1.001);
  }
});

test("bytes show their beginning", () => {
  expect(hex(Uint8Array.of(0, 255, 16), 2)).toBe("00 ff …");
  expect(hex(Uint8Array.of(0, 255), 2)).toBe("00 ff");
});

test("a longer age is shown coarsely", () => {
  expect([-1, 0.4, 1.7, 59.9, 60, 119, 5399, 5400].map(ago)).toEqual([
    "just now",
    "just now",
    "1 s ago",
    "59 s ago",
    "1 min ago",
    "1 min ago",
    "89 min ago",
    "2 h ago",
  ]);
});

test("the time of day has two digits for each part", () => {
  const at = new Date(2026, 10, 21, 2, 5, 48, 999);
  expect(clockTime(BigInt(at.getTime()) * 1_000_000n)).toBe("02:05:48");
});
