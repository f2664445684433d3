import { expect, test } from "vitest";
import { drawScatter, pairsOf, valueAt, type Pairs } from "./scatter";
import { line } from "./test_line";
import { testPen } from "./test_pen";

const kColours = { line: "line", soft: "soft", ink: "ink", accent: "accent" } as unknown as Parameters<
  typeof drawScatter
>[4];

test("a value between two messages is interpolated; beside a gap nothing is known", () => {
  const truth = line([0, 1, 2, 3], 10);
  expect(valueAt(truth, 0.15)).toBeCloseTo(1.5, 9);
  expect(valueAt(truth, 0.2)).toBeCloseTo(2, 9);
  expect(valueAt(truth, 0.31)).toBeNaN(); // after the last
  expect(valueAt(truth, -0.01)).toBeNaN();
  expect(valueAt(line([0, 1], 1), 0.5)).toBeNaN(); // a second apart
  const words = line([4, 7], 10, { wordOf: String });
  expect(valueAt(words, 0.05)).toBe(4);
  expect(valueAt(words, 9)).toBeNaN();
});

test("each message of a line has its pair, where the other number is known", () => {
  const truth = line(
    Array.from({ length: 31 }, (_, i) => i / 10),
    10,
  ); // x = t
  const belief = line(
    Array.from({ length: 91 }, (_, i) => 2 * (i / 30)),
    30,
  ); // y = 2 t
  const list = ({ x, y, times, length }: Pairs) =>
    Array.from({ length }, (_, i) => ({ x: x[i]!, y: y[i]!, time: times[i]! }));
  const pairs = list(pairsOf(belief, truth, { from: 1, to: 2 }));
  expect(pairs.length).toBe(31);
  for (const { x, y, time } of pairs) {
    expect(x).toBeCloseTo(time, 9);
    expect(y).toBeCloseTo(2 * x, 9);
  }
  const shifted = list(pairsOf({ ...belief, offset: 1 }, truth, { from: 1, to: 3 }));
  expect(shifted.length).toBe(61);
  for (const { x, y } of shifted) expect(y).toBeCloseTo(2 * (x - 1), 6); // another clock
  belief.values[40] = NaN;
  expect(pairsOf(belief, truth, { from: 1, to: 2 }).length).toBe(30);
});

test("dots lie where their numbers say, and a place finds its moment again", () => {
  const over = line([0, 1, 2, 3, 4], 10, { axis: "m" });
  const belief = line([0, 2, 4, 6, 8], 10, { axis: "cm" });
  const pen = testPen();
  const drawn = drawScatter(
    pen,
    400,
    300,
    { over, lines: [belief], span: { from: 0, to: 1 }, at: 0.1, hover: undefined },
    kColours,
  );
  expect(drawn.pairs).toBe(5);
  const dots = pen.boxes.filter(({ style }) => style === "#000");
  expect(dots.length).toBe(5);
  const [first, last] = [dots[0]!, dots.at(-1)!];
  expect(last.x).toBeGreaterThan(first.x);
  expect(last.y).toBeLessThan(first.y);
  expect((dots[2]!.x - first.x) / (last.x - first.x)).toBeCloseTo(0.5, 6);
  for (const [i, { x, y }] of dots.entries()) expect(drawn.nearest(x + 1.5, y + 1.5)).toBeCloseTo(i / 10, 9);
  expect(drawn.nearest(0, 0)).toBeUndefined();
  expect(drawn.ranges.get("cm")!.most).toBeCloseTo(8.48, 9);
});

test("a million pairs cost no more dots than the screen has pixels", () => {
  const values = Array.from({ length: 200_000 }, (_, i) => Math.sin(i / 1000));
  const pen = testPen();
  drawScatter(
    pen,
    200,
    150,
    { over: line(values), lines: [line(values)], span: { from: 0, to: 1e9 }, at: 0, hover: undefined },
    kColours,
  );
  expect(pen.boxes.filter(({ style }) => style === "#000").length).toBeLessThan(200 * 150);
});

test("numbers without a common moment are drawn as an empty plot", () => {
  const pen = testPen();
  const early = line([1, 2, 3]);
  const late = line([1, 2, 3], 30, { offset: 100 });
  const drawn = drawScatter(
    pen,
    400,
    300,
    { over: early, lines: [late], span: { from: 0, to: 200 }, at: 0, hover: 1 },
    kColours,
  );
  expect(drawn.pairs).toBe(0);
  expect(drawn.nearest(200, 150)).toBeUndefined();
});
