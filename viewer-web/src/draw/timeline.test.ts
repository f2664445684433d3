import { expect, test } from "vitest";
import { testPen } from "./test_pen";
import {
  agoWords,
  countOf,
  drawStrip,
  drawSummary,
  elapsedWords,
  pinchedSpan,
  spanOf,
  ticksOf,
  timeAt,
  within,
  xOf,
  zoomedSpan,
} from "./timeline";

const kept = { from: 100, to: 400 };

test("a place on the strip and back is the time", () => {
  for (const time of [100, 123.4, 400]) expect(timeAt(kept, 800, xOf(kept, 800, time))).toBeCloseTo(time);
});

test("the strip shows the last seconds, never more than the kept span", () => {
  expect(spanOf(kept, 60)).toEqual({ from: 340, to: 400 });
  expect(spanOf(kept, 1e9)).toEqual(kept);
  expect(spanOf({ from: 400, to: 400 }, 60)).toEqual({ from: 398, to: 400 });
});

test("the time under the pointer stays there when zoomed, except at the ends", () => {
  const nearer = zoomedSpan(kept, kept, 200, 2);
  expect(nearer.to - nearer.from).toBeCloseTo(150);
  expect(xOf(nearer, 800, 200)).toBeCloseTo(xOf(kept, 800, 200));
  expect(zoomedSpan(nearer, kept, 200, 0.01)).toEqual(kept);
  expect(within({ from: 50, to: 80 }, kept)).toEqual({ from: 100, to: 130 });
});

test("ticks are round and far enough apart", () => {
  for (const length of [2, 17, 130, 900, 5000]) {
    const { step, at } = ticksOf({ from: -length, to: 0 }, 900, 76);
    expect((step / length) * 900).toBeGreaterThanOrEqual(Math.min(76, (3600 / length) * 900));
    for (const time of at) expect(Math.abs(time / step - Math.round(time / step))).toBeLessThan(1e-6);
  }
  expect([agoWords(0, 10), agoWords(-70, 10), agoWords(-0.5, 0.1), agoWords(-30, 10)]).toEqual([
    "now",
    "−1:10",
    "−0.5 s",
    "−30 s",
  ]);
});

test("a recording counts from its beginning", () => {
  expect([
    elapsedWords(0, 10),
    elapsedWords(65, 10),
    elapsedWords(65.26, 0.1),
    elapsedWords(59.96, 0.1),
    elapsedWords(1199.6, 1),
  ]).toEqual(["0:00", "1:05", "1:05.3", "1:00.0", "20:00"]);
});

test("a loop and matches are drawn at their places, also short ones", () => {
  const pen = testPen();
  const colours = { ink: "ink", soft: "soft", line: "line", fill: "fill", accent: "accent", warn: "warn" };
  const strip = {
    kept,
    shown: kept,
    seen: { from: 200, to: 250 },
    at: 300,
    live: false,
    marks: [],
    matches: [{ from: 150, to: 150 }],
    loop: { from: 300, to: 350 },
    count: countOf(kept, true),
    hover: undefined,
  };
  drawStrip(pen, 600, 40, strip, colours);
  const boxes = (colour: string) =>
    pen.boxes.filter(({ style }) => style === colour).map(({ x, width }) => [Math.round(x), Math.round(width)]);
  expect(boxes("fill")).toEqual([[200, 100]]);
  expect(boxes("warn")).toEqual([[100, 2]]);
  expect(boxes("accent")).toEqual([
    [400, 100],
    [400, 2],
    [500, 2],
  ]);
});

test("a recording's summary has every mark at its place", () => {
  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#000" };
  drawSummary(
    pen,
    400,
    24,
    100,
    [{ from: 0, to: 50, colour: "red" }],
    [
      { at: 0, kind: "goal", text: "" },
      { at: 50, kind: "fall", text: "" },
    ],
    colours,
  );
  expect(pen.texts.map(({ text, x }) => [text, x])).toEqual([
    ["G", 4],
    ["F", 200],
  ]);
  expect(pen.boxes.find(({ style }) => style === "red")).toMatchObject({ x: 0, width: 200 });
});

test("goals and errors are distinguished by letters", () => {
  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#000" };
  const marks = (["goal", "error", "state"] as const).map((kind, i) => ({ at: 150 + 50 * i, kind, text: "" }));
  drawStrip(
    pen,
    800,
    40,
    { kept, shown: kept, at: 300, live: false, marks, count: countOf(kept, false), hover: undefined },
    colours,
  );
  expect(pen.texts.filter(({ text }) => ["G", "!"].includes(text)).map(({ x }) => Math.round(x))).toEqual([133, 267]);
});

test("letters of crowded events cover no other letter, and a goal keeps its own", () => {
  const pen = testPen();
  const colours = { ink: "ink", soft: "soft", line: "line", fill: "fill", accent: "accent", warn: "warn" };
  const marks = Array.from({ length: 300 }, (_, i) => ({
    at: 100 + i,
    kind: i === 150 ? ("goal" as const) : i % 2 ? ("fall" as const) : ("kick" as const),
    text: "",
  }));
  const strip = { kept, shown: kept, at: 100, live: false, marks, count: countOf(kept, true), hover: undefined };
  drawStrip(pen, 800, 36, strip, colours);
  const letters = pen.texts.filter(({ text }) => /^[GFP]$/.test(text)).sort((a, b) => a.x - b.x);
  expect(letters.filter(({ text }) => text === "G").map(({ x }) => x)).toEqual([400]);
  expect(letters.length).toBeGreaterThan(30);
  expect(letters.slice(1).every(({ x }, i) => x - letters[i]!.x >= 11)).toBe(true);
  const times = pen.texts.filter(({ text }) => /\d/.test(text));
  expect(times.length).toBeGreaterThan(3);
  for (const { x } of times) expect(letters.every((letter) => Math.abs(letter.x - x) >= 15)).toBe(true);
  // each event has a tick, also without a letter
  expect(pen.boxes.filter(({ width }) => width === 1.5).length).toBe(300);
});

test("two fingers keep the times under them, within the kept span", () => {
  const shown = { from: 100, to: 200 };
  const whole = { from: 0, to: 300 };
  const under = (x: number) => timeAt(shown, 400, x);
  const zoomedIn = pinchedSpan(whole, 400, [under(100), under(200)], [50, 250]);
  expect(zoomedIn.to - zoomedIn.from).toBeCloseTo(50);
  expect(timeAt(zoomedIn, 400, 50)).toBeCloseTo(under(100));
  expect(timeAt(zoomedIn, 400, 250)).toBeCloseTo(under(200));
  const panned = pinchedSpan(whole, 400, [under(100), under(200)], [180, 280]);
  expect([panned.from, panned.to].map(Math.round)).toEqual([80, 180]);
  const wide = pinchedSpan(whole, 400, [under(0), under(400)], [199, 201]);
  expect([wide.from, wide.to]).toEqual([0, 300]);
  for (const x of [
    [0, 0],
    [-1e6, 1e6],
    [390, 10],
  ] as [number, number][]) {
    const { from, to } = pinchedSpan(whole, 400, [150, 150], x);
    expect(from >= 0 && to <= 300 && from < to).toBe(true);
  }
});
