// Numbers over time on a canvas: any number of lines, one axis per unit. Plain drawing that needs no browser.

import type { Pen } from "./field";
import { hatch } from "./hatch";
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
  /** Summaries of the values, a coarse one of all before a finer one of a part. They are drawn instead of the values. */
  summaries?: Intervals[];
  /** The name of a value, where values are no numbers. Only whole values have names. */
  wordOf?: ((value: number) => string | undefined) | undefined;
}

/** Minimum, maximum and mean per interval [s] of the plot's own time; NaN where there is no value. */
export interface Intervals {
  from: number;
  step: number;
  least: Float64Array;
  most: Float64Array;
  mean: Float64Array;
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
  /** The mean of the values; only a summary has it. */
  mean?: number;
}

/** The look of a line in each theme. */
export interface LineStyle {
  dark: string;
  light: string;
  dash: number[];
}

/**
 * Distinguished by brightness and dashes as well as by colour (after Okabe and Ito, 2008). An axis of one line has its
 * colour, so words in it are readable too.
 */
export const kLineStyles: LineStyle[] = [
  { dark: "#56b4e9", light: "#007aad", dash: [] },
  { dark: "#e69f00", light: "#a86200", dash: [] },
  { dark: "#009e73", light: "#007a4d", dash: [] },
  { dark: "#cc79a7", light: "#8b2f6e", dash: [] },
  { dark: "#e0690f", light: "#bf4300", dash: [6, 3] },
  { dark: "#8f7fe0", light: "#6a4fd0", dash: [6, 3] },
  { dark: "#b3a100", light: "#756900", dash: [2, 3] },
  { dark: "#7f8c99", light: "#5d6a76", dash: [2, 3] },
];

const kGap = 1.5; // [s] without a value breaks a line

/** Returns the index of the first value at `time` or later. */
export function firstIndex({ times, length, offset }: Line, time: number): number {
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

const endOf = ({ from, step, mean }: Intervals): number => from + step * mean.length;

/** Returns the finest summary of the visible part. */
function fitting(summaries: Intervals[], { from, to }: Span): Intervals {
  const whole = summaries[0]!;
  // the last interval of the whole may reach beyond the recording
  const covers = (one: Intervals) =>
    one.from <= Math.max(from, whole.from) + one.step &&
    endOf(one) + one.step >= Math.min(to, endOf(whole) - whole.step);
  return summaries.findLast(covers) ?? whole;
}

/** Converts a summary to columns of pixels. An interval is drawn at its middle. */
export function columnsOfSummary(summaries: Intervals[], span: Span, width: number): Column[] {
  const summary = fitting(summaries, span);
  const { from, step, least, most, mean } = summary;
  const columns: Column[] = [];
  const first = Math.max(0, Math.floor((span.from - from) / step) - 1);
  const end = Math.min(mean.length, Math.ceil((span.to - from) / step) + 1);
  let column: Column | undefined;
  let [before, count] = [-Infinity, 0];
  for (let i = first; i < end; ++i) {
    const value = mean[i]!;
    if (Number.isNaN(value)) continue;
    const x = Math.floor(xOf(span, width, from + (i + 0.5) * step));
    if (column?.x === x) {
      column.least = Math.min(column.least, least[i]!);
      column.most = Math.max(column.most, most[i]!);
      column.mean! += (value - column.mean!) / ++count;
    } else {
      const broken = (i - before - 1) * step > kGap;
      column = { x, first: value, least: least[i]!, most: most[i]!, last: value, broken, mean: value };
      columns.push(column);
      count = 1;
    }
    before = i;
  }
  return columns;
}

/** Returns the mean around `time`, of the last interval with a value in the time that breaks no line; else NaN. */
export function summaryAt(summaries: Intervals[], time: number): number {
  const { from, step, mean } = fitting(summaries, { from: time, to: time });
  for (let i = Math.min(mean.length - 1, Math.floor((time - from) / step)); i >= 0; --i) {
    if (time - from - (i + 1) * step > kGap) break;
    if (!Number.isNaN(mean[i])) return mean[i]!;
  }
  return NaN;
}

/** Returns the axis' range with a margin, never of zero height. */
export function rangeOf(columns: Column[][]): Range {
  let [least, most] = [Infinity, -Infinity];
  for (const list of columns)
    for (const column of list) {
      if (column.least < least) least = column.least;
      if (column.most > most) most = column.most;
    }
  return rangeBetween(least, most);
}

/** Returns a range with a margin around all values, never of zero height. */
export function rangeBetween(least: number, most: number): Range {
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
  /** Parts of the time in which values are missing, because they are not loaded. */
  unloaded?: Span[];
}

export const axesOf = (lines: Line[]): string[] => [...new Set(lines.map(({ axis }) => axis))];

/** Draws the lines. Returns the range of each axis. */
export function drawPlot(
  pen: Pen,
  width: number,
  height: number,
  { lines, span, at, hover, count, unloaded = [] }: Plot,
  colours: Colours,
): Map<string, Range> {
  const axes = axesOf(lines);
  const area = areaOf(width, height, axes.length);
  const x = (time: number) => area.left + xOf(span, area.width, time);
  const drawn = lines.map((line) => ({
    line,
    columns: line.summaries?.length
      ? columnsOfSummary(line.summaries, span, area.width)
      : columnsOf(line, span, area.width),
  }));
  const ranges = new Map(
    axes.map((axis) => [axis, rangeOf(drawn.filter(({ line }) => line.axis === axis).map(({ columns }) => columns))]),
  );

  for (const { from, to } of unloaded) {
    const [left, right] = [from, to].map((time) => Math.min(area.left + area.width, Math.max(area.left, x(time))));
    hatch(pen, left!, area.top, right! - left!, area.height, colours.soft);
  }
  drawTimes(pen, area, span, count, x, colours);
  drawAxes(pen, area, lines, ranges, colours);
  for (const { line, columns } of drawn) drawLine(pen, area, line, columns, ranges.get(line.axis)!);

  pen.setLineDash([]);
  if (hover !== undefined) drawCursor(pen, area, x(hover), colours.soft, 1);
  drawCursor(pen, area, x(at), colours.accent, 2);
  return ranges;
}

export type Area = ReturnType<typeof areaOf>;

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

/** Draws a vertical axis for each unit of the lines; the first has the grid. */
export function drawAxes(
  pen: Pen,
  area: Area,
  lines: Line[],
  ranges: ReadonlyMap<string, Range>,
  colours: Colours,
): void {
  const axes = axesOf(lines);
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

export const tickText = (value: number): string =>
  Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-4)
    ? value.toExponential(1)
    : String(Number(value.toPrecision(5)));

export const yOf = (area: Area, { least, most }: Range, value: number): number =>
  area.top + area.height * (1 - (value - least) / (most - least));

const kWide = 1.6; // [px] of a line
const kDense = 2; // [px] between columns that are drawn as boxes

/**
 * Draws the values of a summary: a line of the means, in a band of all values. Dense columns are boxes, which a processor
 * fills thirty times faster than a path of a thousand corners.
 */
function drawSummary(pen: Pen, area: Area, { colour, dash }: Line, columns: Column[], range: Range): void {
  const y = (value: number) => yOf(area, range, value);
  const pairs = columns.map((column, i) => ({ column, before: column.broken ? undefined : columns[i - 1] }));
  const dense = pairs.filter(({ column, before }) => column.x - (before?.x ?? column.x) <= kDense);
  const sparse = pairs.filter(({ column, before }) => before && column.x - before.x > kDense);
  const widthOf = (column: Column, before: Column | undefined) => Math.max(1, column.x - (before?.x ?? column.x));
  const period = dash.reduce((sum, part) => sum + part, 0);

  pen.fillStyle = pen.strokeStyle = colour;
  pen.globalAlpha = 0.3;
  for (const { column, before } of dense) {
    const width = widthOf(column, before);
    pen.fillRect(placeOf(area, column.x) + 0.5 - width, y(column.most), width, y(column.least) - y(column.most));
  }
  pen.beginPath();
  for (const { column, before } of sparse) {
    const [left, right] = [placeOf(area, before!.x), placeOf(area, column.x)];
    pen.moveTo(left, y(before!.most));
    pen.lineTo(right, y(column.most));
    pen.lineTo(right, y(column.least));
    pen.lineTo(left, y(before!.least));
    pen.closePath();
  }
  pen.fill();
  pen.globalAlpha = 1;

  for (const { column, before } of dense) {
    if (period > 0 && column.x % period >= dash[0]!) continue;
    const [now, then] = [y(column.mean!), y((before ?? column).mean!)];
    const width = widthOf(column, before);
    pen.fillRect(
      placeOf(area, column.x) + 0.5 - width,
      Math.min(now, then) - kWide / 2,
      width,
      Math.abs(now - then) + kWide,
    );
  }
  pen.lineWidth = kWide;
  pen.setLineDash(dash);
  pen.beginPath();
  for (const { column, before } of sparse) {
    pen.moveTo(placeOf(area, before!.x), y(before!.mean!));
    pen.lineTo(placeOf(area, column.x), y(column.mean!));
  }
  pen.stroke();
}

const placeOf = (area: Area, x: number): number =>
  Math.min(area.left + area.width, Math.max(area.left, area.left + x + 0.5));

function drawLine(pen: Pen, area: Area, line: Line, columns: Column[], range: Range): void {
  if (line.summaries?.length) return drawSummary(pen, area, line, columns, range);
  pen.strokeStyle = line.colour;
  pen.lineWidth = kWide;
  pen.setLineDash(line.dash);
  pen.beginPath();
  for (const { x, first, least, most, last, broken } of columns) {
    const place = placeOf(area, x);
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
