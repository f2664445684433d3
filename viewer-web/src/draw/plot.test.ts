import { expect, test } from "vitest";
import {
  areaOf,
  axesOf,
  columnsOf,
  columnsOfSummary,
  drawPlot,
  rangeOf,
  summaryAt,
  valueTicks,
  type Intervals,
} from "./plot";
import { countOf } from "./timeline";
import { line } from "./test_line";
import { testPen } from "./test_pen";

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
  const ranges = drawPlot(
    pen,
    600,
    300,
    { lines, span: { from: 0, to: 1 }, at: 0.5, hover: 0.2, count: countOf({ from: 0, to: 1 }, false) },
    colours,
  );
  expect([...ranges].map(([axis, { least, most }]) => [axis, least.toFixed(2), most.toFixed(2)])).toEqual([
    ["m", "0.82", "4.18"],
    ["s", "94.00", "206.00"],
  ]);
  expect(pen.texts.map(({ text }) => text)).toEqual(expect.arrayContaining(["m", "s", "now", "160", "3"]));
});

/** A summary of a value that rises by one in each interval and deviates by a half in it. */
function intervals(count: number, from: number, step: number): Intervals {
  const mean = Float64Array.from({ length: count }, (_, i) => i);
  return { from, step, mean, least: mean.map((value) => value - 0.5), most: mean.map((value) => value + 0.5) };
}

test("a summary keeps all extremes in the columns on screen", () => {
  const whole = intervals(2048, 0, 1200 / 2048);
  whole.most[777] = 9000;
  whole.least[1234] = -9000;
  const columns = columnsOfSummary([whole], { from: 0, to: 1200 }, 800);
  expect(columns.length).toBeLessThanOrEqual(801);
  expect(Math.max(...columns.map(({ most }) => most))).toBe(9000);
  expect(Math.min(...columns.map(({ least }) => least))).toBe(-9000);
  expect(columns.every(({ least, mean, most }) => least <= mean! && mean! <= most)).toBe(true);
});

test("the finest summary of the visible part is shown, else the whole", () => {
  const [whole, part] = [intervals(10, 0, 100), intervals(100, 400, 1)];
  const shown = (from: number, to: number) => columnsOfSummary([whole, part], { from, to }, 1000).length;
  expect(shown(420, 440)).toBeGreaterThan(15);
  expect(shown(0, 1000)).toBe(10);
  expect(shown(480, 530)).toBeLessThan(5);
  expect(summaryAt([whole, part], 450.5)).toBe(50);
  expect(summaryAt([whole, part], 150)).toBe(1);
});

test("intervals without values break the line after a while, and have no value", () => {
  const some = intervals(10, 0, 1);
  for (const i of [2, 5, 6, 7]) for (const list of [some.mean, some.least, some.most]) list[i] = NaN;
  const columns = columnsOfSummary([some], { from: 0, to: 10 }, 100);
  expect(columns.map(({ mean, broken }) => [mean, broken])).toEqual([
    [0, true],
    [1, false],
    [3, false],
    [4, false],
    [8, true],
    [9, false],
  ]);
  expect([2.5, 5.5, 7.5].map((time) => summaryAt([some], time))).toEqual([1, 4, NaN]);
  expect([-3, 99].map((time) => summaryAt([some], time))).toEqual([NaN, NaN]);
});

test("parts that are not loaded are hatched, and a summary is drawn from the beginning to the end", () => {
  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#000" };
  const span = { from: 0, to: 1200 };
  const plot = { span, at: 0, hover: undefined, count: countOf(span, true) };
  const area = areaOf(860, 400, 1);
  const inside = ({ x, y }: { x: number; y: number }) =>
    x >= area.left - 1 && x <= area.left + area.width + 1 && y >= area.top - 1 && y <= area.top + area.height + 1;
  drawPlot(pen, 860, 400, { ...plot, lines: [], unloaded: [{ from: 600, to: 9999 }] }, colours);
  const middle = area.left + area.width / 2;
  const hatched = pen.points.filter((point) => inside(point) && point.x > middle + 20);
  expect(hatched.length).toBeGreaterThan(100);
  const drawn = testPen();
  const summary = intervals(2048, 0, 1200 / 2048);
  drawPlot(drawn, 860, 400, { ...plot, lines: [line([], 30, { summaries: [summary], colour: "#123" })] }, colours);
  const band = drawn.boxes.filter(({ style, ...corner }) => style === "#123" && inside(corner));
  expect(band.length).toBeGreaterThan(1500); // the band, and the line of the means
  expect(Math.min(...band.map(({ x }) => x))).toBeLessThan(area.left + 3);
  expect(Math.max(...band.map(({ x, width }) => x + width))).toBeGreaterThan(area.left + area.width - 3);
  // few intervals are a line and a band with corners
  const few = testPen();
  drawPlot(
    few,
    860,
    400,
    { ...plot, lines: [line([], 30, { summaries: [intervals(9, 0, 130)], colour: "#123" })] },
    colours,
  );
  expect(few.polygons.length).toBe(1);
  expect(few.polygons[0]!.corners.every(inside)).toBe(true);
});
