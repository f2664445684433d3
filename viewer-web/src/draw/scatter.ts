// Numbers over another number on a canvas: a dot for each moment at which both are known. Plain drawing that needs no browser.

import type { Pen } from "./field";
import {
  areaOf,
  axesOf,
  drawAxes,
  firstIndex,
  rangeBetween,
  tickText,
  valueTicks,
  yOf,
  type Area,
  type Line,
  type Range,
} from "./plot";
import type { Colours, Span } from "./timeline";

/** The values of two lines at the same moments [s, the plot's own time]. Only the first `length` entries count. */
export interface Pairs {
  x: Float64Array;
  y: Float64Array;
  times: Float64Array;
  length: number;
}

const kApart = 0.25; // [s] between two values, so that nothing is known between them
const kDot = 3; // [px]
const kReach = 16; // [px] from the pointer to a dot

/** The index of the last value at `time` or before, or -1. */
function indexAt(line: Line, time: number): number {
  let next = firstIndex(line, time);
  while (next < line.length && line.times[next]! + line.offset <= time) ++next;
  return next - 1;
}

/** As valueAt(), for the index of the last value at `time` or before. */
function valueBeside({ times, values, length, offset, wordOf }: Line, i: number, time: number): number {
  if (i < 0) return NaN;
  const before = times[i]! + offset;
  if (before === time || wordOf) return time - before <= kApart ? values[i]! : NaN;
  if (i + 1 >= length) return NaN;
  const after = times[i + 1]! + offset;
  if (after - before > kApart) return NaN;
  return values[i]! + ((time - before) / (after - before)) * (values[i + 1]! - values[i]!);
}

/**
 * Returns the value of a line at a moment, NaN where it is not known. A number is interpolated between its neighbours; a
 * word is the last one.
 */
export const valueAt = (line: Line, time: number): number => valueBeside(line, indexAt(line, time), time);

/** Returns the pairs of a line and the one below it, at the moments of the line within the span. */
export function pairsOf(line: Line, over: Line, { from, to }: Span): Pairs {
  const begin = firstIndex(line, from);
  const end = indexAt(line, to) + 1;
  const room = Math.max(0, end - begin);
  const pairs = { x: new Float64Array(room), y: new Float64Array(room), times: new Float64Array(room), length: 0 };
  let beside = room > 0 ? indexAt(over, line.times[begin]! + line.offset) : -1;
  for (let i = begin; i < end; ++i) {
    const time = line.times[i]! + line.offset;
    while (beside + 1 < over.length && over.times[beside + 1]! + over.offset <= time) ++beside;
    const [x, y] = [valueBeside(over, beside, time), line.values[i]!];
    if (Number.isNaN(x) || Number.isNaN(y)) continue;
    pairs.x[pairs.length] = x;
    pairs.y[pairs.length] = y;
    pairs.times[pairs.length++] = time;
  }
  return pairs;
}

export interface Scatter {
  /** The line of the horizontal axis. */
  over: Line;
  lines: Line[];
  span: Span;
  /** The shown moment, and the one under the pointer. */
  at: number;
  hover: number | undefined;
}

/** A scatter as drawn. */
export interface DrawnScatter {
  /** The number of dots. */
  pairs: number;
  /** The range of each axis by its name, that of the horizontal one included. */
  ranges: Map<string, Range>;
  /** Returns the moment of the dot near a place [px], or undefined without one. */
  nearest(left: number, top: number): number | undefined;
}

function rangeOfValues(parts: { values: Float64Array; length: number }[]): Range {
  let [least, most] = [Infinity, -Infinity];
  for (const { values, length } of parts)
    for (let i = 0; i < length; ++i) {
      const value = values[i]!;
      if (value < least) least = value;
      if (value > most) most = value;
    }
  return rangeBetween(least, most);
}

function drawBelow(pen: Pen, area: Area, { axis, colour, wordOf }: Line, range: Range, colours: Colours): void {
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const tick of valueTicks(range, area.width / 80)) {
    const text = (wordOf ?? tickText)(tick);
    if (text === undefined) continue;
    const x = xOfValue(area, range, tick);
    pen.fillStyle = colours.line;
    pen.fillRect(Math.round(x), area.top, 1, area.height);
    pen.fillStyle = colour;
    pen.fillText(text, x, area.top + area.height + 12);
  }
  pen.fillStyle = colour;
  pen.font = "600 11px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.fillText(axis, area.left + area.width, area.top + area.height - 8);
}

const xOfValue = (area: Area, { least, most }: Range, value: number): number =>
  area.left + area.width * ((value - least) / (most - least));

/** Draws a line on which both numbers are equal. */
function drawEqual(pen: Pen, area: Area, over: Range, range: Range, colours: Colours): void {
  const [from, to] = [Math.max(over.least, range.least), Math.min(over.most, range.most)];
  if (to <= from) return;
  pen.strokeStyle = colours.soft;
  pen.lineWidth = 1;
  pen.setLineDash([5, 4]);
  pen.beginPath();
  pen.moveTo(xOfValue(area, over, from), yOf(area, range, from));
  pen.lineTo(xOfValue(area, over, to), yOf(area, range, to));
  pen.stroke();
  pen.setLineDash([]);
}

function ring(pen: Pen, x: number, y: number, colour: string, width: number): void {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  pen.arc(x, y, 6, 0, 2 * Math.PI);
  pen.stroke();
}

/** Draws the dots of all lines. Lines of the unit of the horizontal axis get the line of equal values. */
export function drawScatter(
  pen: Pen,
  width: number,
  height: number,
  { over, lines, span, at, hover }: Scatter,
  colours: Colours,
): DrawnScatter {
  const axes = axesOf(lines);
  const area = areaOf(width, height, axes.length);
  const clouds = lines.map((line) => ({ line, pairs: pairsOf(line, over, span) }));
  const below = rangeOfValues(clouds.map(({ pairs: { x, length } }) => ({ values: x, length })));
  const ranges = new Map(
    axes.map((axis) => {
      const parts = clouds.filter(({ line }) => line.axis === axis);
      return [axis, rangeOfValues(parts.map(({ pairs: { y, length } }) => ({ values: y, length })))] as const;
    }),
  );

  drawBelow(pen, area, over, below, colours);
  drawAxes(pen, area, lines, ranges, colours);
  if (axes.includes(over.axis)) drawEqual(pen, area, below, ranges.get(over.axis)!, colours);

  const leftOf = (x: number) => xOfValue(area, below, x);
  const topOf = ({ axis }: Line, y: number) => yOf(area, ranges.get(axis)!, y);
  // dots of one colour at one pixel are one: an hour of data costs no more than the screen has room for
  const columns = Math.ceil(width) + 1;
  const drawn = new Uint8Array(columns * (Math.ceil(height) + 1));
  pen.globalAlpha = 0.55;
  for (const { line, pairs } of clouds) {
    drawn.fill(0);
    pen.fillStyle = line.colour;
    for (let i = 0; i < pairs.length; ++i) {
      const [left, top] = [leftOf(pairs.x[i]!), topOf(line, pairs.y[i]!)];
      const pixel = Math.round(top) * columns + Math.round(left);
      if (drawn[pixel]) continue;
      drawn[pixel] = 1;
      pen.fillRect(left - kDot / 2, top - kDot / 2, kDot, kDot);
    }
  }
  pen.globalAlpha = 1;
  for (const [moment, colour, wide] of [
    [hover, colours.soft, 1.5],
    [at, colours.accent, 2],
  ] as const)
    for (const { line } of clouds) {
      if (moment === undefined) continue;
      const [x, y] = [valueAt(over, moment), valueAt(line, moment)];
      if (Number.isNaN(x) || Number.isNaN(y)) continue;
      ring(pen, leftOf(x), topOf(line, y), colour, wide);
    }

  return {
    pairs: clouds.reduce((sum, { pairs }) => sum + pairs.length, 0),
    ranges: new Map([[over.axis, below], ...ranges]),
    nearest(left, top) {
      let [least, time]: [number, number | undefined] = [kReach, undefined];
      for (const { line, pairs } of clouds)
        for (let i = 0; i < pairs.length; ++i) {
          const far = Math.hypot(leftOf(pairs.x[i]!) - left, topOf(line, pairs.y[i]!) - top);
          if (far < least) [least, time] = [far, pairs.times[i]!];
        }
      return time;
    },
  };
}
