import { expect, test } from "vitest";
import { axesOf, columnsOf, drawPlot, rangeOf, valueTicks, type Line } from "./plot";
import { countOf } from "./timeline";
import { testPen } from "./test_pen";

function line(values: number[], hz = 30, more: Partial<Line> = {}): Line {
  return {
    times: Float64Array.from(values, (_, i) => i / hz),
    values: Float64Array.from(values),
    length: values.length,
    offset: 0,
    colour: "#000",
    dash: [],
    axis: "m",
    ...more,
  };
}
const sine = (count: number) => Array.from({ length: count }, (_, i) => Math.sin(i / 50));

test("a whole half is reduced to the columns on screen, and keeps all extremes", () => {
  const values = sine(18000);
  values[7777] = 9;
  values[12345] = -9;
  const columns = columnsOf(line(values), { from: 0, to: 600 }, 800);
  expect(columns.length).toBeLessThanOrEqual(801);
  expect(Math.max(...columns.map(({ most }) => most))).toBe(9);
  expect(Math.min(...columns.map(({ least }) => least))).toBe(-9);
  expect(
    columns.every(({ least, first, last, most }) => least <= first && least <= last && first <= most && last <= most),
  ).toBe(true);
});

test("eight lines of a half are drawn in a small part of a frame", () => {
  const lines = Array.from({ length: 8 }, () => line(sine(18000)));
  columnsOf(lines[0]!, { from: 0, to: 600 }, 800); // warm
  const run_ms = () => {
    const begin = performance.now();
    for (const one of lines) columnsOf(one, { from: 0, to: 600 }, 800);
    return performance.now() - begin;
  };
  // the least of several runs, because other programs run, too
  const deadline = performance.now() + 30_000;
  let least_ms = Infinity;
  while (least_ms >= 16 && performance.now() < deadline) least_ms = Math.min(least_ms, run_ms());
  expect(least_ms).toBeLessThan(16);
});

test("a part of the time shows its values and their neighbours, so that the line reaches the edges", () => {
  const columns = columnsOf(line([0, 1, 2, 3, 4, 5], 1), { from: 1.5, to: 3.5 }, 100);
  expect(columns.map(({ first }) => first)).toEqual([1, 2, 3, 4]);
});

test("a pause breaks the line, and values that are no number are left out", () => {
  const some = line([1, NaN, 3, 4], 1);
  some.times.set([0, 0.5, 1, 9]);
  expect(columnsOf(some, { from: 0, to: 10 }, 100).map(({ first, broken }) => [first, broken])).toEqual([
    [1, true],
    [3, false],
    [4, true],
  ]);
});

test("an axis has a margin, also for constant values and without values", () => {
  expect(rangeOf([columnsOf(line([2, 4]), { from: 0, to: 1 }, 10)])).toEqual({ least: 1.88, most: 4.12 });
  expect(rangeOf([columnsOf(line([2, 2]), { from: 0, to: 1 }, 10)])).toEqual({ least: 1, most: 3 });
  expect(rangeOf([])).toEqual({ least: 0, most: 1 });
  for (const [least, most] of [
    [0, 1],
    [-3.3, 7.1],
    [1e-6, 2e-6],
    [1e9, 1e9 + 5],
  ] as const) {
    const ticks = valueTicks({ least, most }, 8);
    expect(ticks.length).toBeGreaterThan(1);
    expect(ticks.length).toBeLessThanOrEqual(9);
    expect(ticks.every((tick) => tick >= least && tick <= most)).toBe(true);
  }
});

test("lines of one unit share an axis", () => {
  const lines = [line([1, 2]), line([3, 4]), line([100, 200], 30, { axis: "s" })];
  expect(axesOf(lines)).toEqual(["m", "s"]);
  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#000" };
  drawPlot(
    pen,
    600,
    300,
    { lines, span: { from: 0, to: 1 }, at: 0.5, hover: 0.2, count: countOf({ from: 0, to: 1 }, false) },
    colours,
  );
  expect(pen.texts.map(({ text }) => text)).toEqual(expect.arrayContaining(["m", "s", "now", "160", "3"]));
});
