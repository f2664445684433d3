// Numbers over time on a canvas: any number of lines, one axis per unit. Plain drawing that needs no browser.

import type { Pen } from "./field";
import { ticksOf, xOf, type Colours, type Count, type Span } from "./timeline";

/** A line of the plot; only the part within the span is read. Times [s] in the plot's own time. */
export interface Line {
  times: Float64Array;
  values: Float64Array;
  length: number;
  /** [s] to add to `times`. */
  offset: number;
  colour: string;
  dash: number[];
  /** Lines of one axis share its scale. The axis' name is the unit. */
  axis: string;
  /** The name of a value, where values are no numbers. Only whole values have names. */
  wordOf?: ((value: number) => string | undefined) | undefined;
}

export interface Range {
  least: number;
  most: number;
}

/** A line's values in one column of pixels: first, least, greatest and last. */
export interface Column {
  x: number;
  first: number;
  least: number;
  most: number;
  last: number;
  /** The line is broken before this column, because no value came for long. */
  broken: boolean;
}

/** Distinguished by brightness and dashes as well as by colour (after Okabe and Ito, 2008). */
export const kLineStyles: { colour: string; dash: number[] }[] = [
  { colour: "#56b4e9", dash: [] },
  { colour: "#e69f00", dash: [] },
  { colour: "#009e73", dash: [] },
  { colour: "#cc79a7", dash: [] },
  { colour: "#d55e00", dash: [6, 3] },
  { colour: "#8f7fe0", dash: [6, 3] },
  { colour: "#b3a100", dash: [2, 3] },
  { colour: "#7f8c99", dash: [2, 3] },
];

const kGap = 1.5; // [s] without a value breaks a line

function firstIndex({ times, length, offset }: Line, time: number): number {
  let [low, high] = [0, length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (times[middle]! + offset < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * Converts a line to columns of pixels. No extreme is lost, and the work grows with the visible part, not with the
 * redraws.
 */
export function columnsOf(line: Line, span: Span, width: number): Column[] {
  const columns: Column[] = [];
  const from = Math.max(0, firstIndex(line, span.from) - 1);
  const to = Math.min(line.length, firstIndex(line, span.to) + 1);
  let column: Column | undefined;
  let before = NaN;
  for (let i = from; i < to; ++i) {
    const value = line.values[i]!;
    if (Number.isNaN(value)) continue;
    const time = line.times[i]! + line.offset;
    const x = Math.floor(xOf(span, width, time));
    if (column?.x === x) {
      if (value < column.least) column.least = value;
      if (value > column.most) column.most = value;
      column.last = value;
    } else {
      column = { x, first: value, least: value, most: value, last: value, broken: !(time - before <= kGap) };
      columns.push(column);
    }
    before = time;
  }
  return columns;
}

/** Returns the axis' range with a margin, never of zero height. */
export function rangeOf(columns: Column[][]): Range {
  let [least, most] = [Infinity, -Infinity];
  for (const list of columns)
    for (const column of list) {
      if (column.least < least) least = column.least;
      if (column.most > most) most = column.most;
    }
  if (!(most >= least)) return { least: 0, most: 1 };
  const air = most > least ? 0.06 * (most - least) : Math.max(0.5 * Math.abs(most), 0.5);
  return { least: least - air, most: most + air };
}

/** Round values from `least` to `most`, at most `count`. */
export function valueTicks({ least, most }: Range, count: number): number[] {
  const rough = (most - least) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough)!;
  const ticks: number[] = [];
  for (let i = Math.ceil(least / step); i * step <= most && ticks.length < 50; ++i)
    ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

export const kAxisWidth = 54; // [px]
const kHead = 24; // [px] above the lines: units
const kFoot = 22; // [px] below them: the time

/** The area of the lines: axes left of it, the time below. */
export const areaOf = (width: number, height: number, axes: number) => {
  const left = kAxisWidth * Math.max(1, axes);
  return { left, top: kHead, width: Math.max(1, width - left - 8), height: Math.max(1, height - kFoot - kHead) };
};

export interface Plot {
  lines: Line[];
  span: Span;
  /** The shown moment, and the one under the pointer. */
  at: number;
  hover: number | undefined;
  count: Count;
}

export const axesOf = (lines: Line[]): string[] => [...new Set(lines.map(({ axis }) => axis))];

export function drawPlot(
  pen: Pen,
  width: number,
  height: number,
  { lines, span, at, hover, count }: Plot,
  colours: Colours,
): void {
  const axes = axesOf(lines);
  const area = areaOf(width, height, axes.length);
  const x = (time: number) => area.left + xOf(span, area.width, time);
  const drawn = lines.map((line) => ({ line, columns: columnsOf(line, span, area.width) }));
  const ranges = new Map(
    axes.map((axis) => [axis, rangeOf(drawn.filter(({ line }) => line.axis === axis).map(({ columns }) => columns))]),
  );

  drawTimes(pen, area, span, count, x, colours);
  axes.forEach((axis, i) => {
    const single = lines.filter((line) => line.axis === axis);
    drawAxis(
      pen,
      area,
      axis,
      ranges.get(axis)!,
      kAxisWidth * (axes.length - i),
      i === 0,
      single.length === 1 ? single[0]!.colour : colours.soft,
      single.find(({ wordOf }) => wordOf)?.wordOf ?? tickText,
      colours,
    );
  });
  for (const { line, columns } of drawn) drawLine(pen, area, line, columns, ranges.get(line.axis)!);

  pen.setLineDash([]);
  if (hover !== undefined) drawCursor(pen, area, x(hover), colours.soft, 1);
  drawCursor(pen, area, x(at), colours.accent, 2);
}

type Area = ReturnType<typeof areaOf>;

function drawTimes(
  pen: Pen,
  area: Area,
  span: Span,
  { zero, wordsOf }: Count,
  x: (time: number) => number,
  colours: Colours,
): void {
  const { step, at } = ticksOf({ from: span.from - zero, to: span.to - zero }, area.width, 90);
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const tick of at) {
    pen.fillStyle = colours.line;
    pen.fillRect(Math.round(x(tick + zero)), area.top, 1, area.height);
    pen.fillStyle = colours.soft;
    pen.fillText(
      wordsOf(tick, step),
      Math.min(area.left + area.width - 14, x(tick + zero)),
      area.top + area.height + 12,
    );
  }
}

function drawAxis(
  pen: Pen,
  area: Area,
  name: string,
  range: Range,
  right: number,
  grid: boolean,
  colour: string,
  textOf: (value: number) => string | undefined,
  colours: Colours,
): void {
  const edge = right; // [px] of its labels
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const tick of valueTicks(range, area.height / 44)) {
    const y = yOf(area, range, tick);
    const text = textOf(tick);
    if (text === undefined) continue;
    if (grid) {
      pen.fillStyle = colours.line;
      pen.fillRect(area.left, Math.round(y), area.width, 1);
    }
    pen.fillStyle = colour;
    pen.fillText(text, edge - 6, y, kAxisWidth - 8);
  }
  pen.fillStyle = colour;
  pen.font = "600 11px system-ui, sans-serif";
  pen.fillText(name.length > 9 ? `${name.slice(0, 8)}…` : name, edge - 6, area.top - 14);
}

const tickText = (value: number): string =>
  Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-4)
    ? value.toExponential(1)
    : String(Number(value.toPrecision(5)));

const yOf = (area: Area, { least, most }: Range, value: number): number =>
  area.top + area.height * (1 - (value - least) / (most - least));

function drawLine(pen: Pen, area: Area, line: Line, columns: Column[], range: Range): void {
  pen.strokeStyle = line.colour;
  pen.lineWidth = 1.6;
  pen.setLineDash(line.dash);
  pen.beginPath();
  for (const { x, first, least, most, last, broken } of columns) {
    const place = Math.min(area.left + area.width, Math.max(area.left, area.left + x + 0.5));
    if (broken) pen.moveTo(place, yOf(area, range, first));
    else pen.lineTo(place, yOf(area, range, first));
    if (most > least) {
      pen.lineTo(place, yOf(area, range, least));
      pen.lineTo(place, yOf(area, range, most));
      pen.lineTo(place, yOf(area, range, last));
    } else if (broken) pen.lineTo(place + 1, yOf(area, range, first)); // a single value is a dot
  }
  pen.stroke();
}

function drawCursor(pen: Pen, area: Area, x: number, colour: string, width: number): void {
  if (x < area.left || x > area.left + area.width + 1) return;
  pen.fillStyle = colour;
  pen.fillRect(x - width / 2, area.top, width, area.height);
}
