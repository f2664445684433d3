// The timeline: kept span, events, shown moment. Seconds relative to any origin; plain drawing.

import type { EventKind } from "../memory/game_events";
import type { Pen } from "./field";

/** The visible part of time [s]. */
export interface Span {
  from: number;
  to: number;
}

export interface Mark {
  at: number;
  kind: EventKind | "bookmark" | "breakpoint";
  text: string;
}

export interface Strip {
  /** The whole available span. */
  kept: Span;
  /** The part that is drawn as available; undefined: up to the shown moment. */
  seen?: Span | undefined;
  shown: Span;
  at: number;
  live: boolean;
  marks: Mark[];
  /** Spans in which the searched condition holds. */
  matches?: Span[];
  /** The repeated span. */
  loop?: Span | undefined;
  count: Count;
  hover: number | undefined;
}

/** Origin [s] of the ticks, and their names. */
export interface Count {
  zero: number;
  wordsOf(seconds: number, step: number): string;
}

/** Live data count back from now, a recording counts from its begin. */
export const countOf = (kept: Span, recorded: boolean): Count =>
  recorded ? { zero: kept.from, wordsOf: elapsedWords } : { zero: kept.to, wordsOf: agoWords };

export interface Colours {
  ink: string;
  soft: string;
  line: string;
  fill: string;
  accent: string;
  warn: string;
}

const kLeast = 2; // [s] on screen

export const xOf = ({ from, to }: Span, width: number, at: number): number => ((at - from) / (to - from)) * width;
export const timeAt = ({ from, to }: Span, width: number, x: number): number => from + (x / width) * (to - from);

/** Returns the last `length` [s] up to `last`, limited to the kept span. Never shorter than a few seconds. */
export function spanOf(kept: Span, length: number): Span {
  const whole = Math.max(kLeast, kept.to - kept.from);
  return { from: kept.to - Math.min(whole, Math.max(kLeast, length)), to: kept.to };
}

/** Zooms by `factor` about `at`, within the kept span. */
export function zoomedSpan(shown: Span, kept: Span, at: number, factor: number): Span {
  const whole = Math.max(kLeast, kept.to - kept.from);
  const length = Math.min(whole, Math.max(kLeast, (shown.to - shown.from) / factor));
  const share = Math.min(1, Math.max(0, (at - shown.from) / (shown.to - shown.from)));
  return within({ from: at - share * length, to: at - share * length + length }, kept);
}

/** Returns the span that has the times `at` under two fingers at `x` [px]: it is pinched and panned at once. */
export function pinchedSpan(kept: Span, width: number, at: [number, number], x: [number, number]): Span {
  const apart = Math.max(kLeastApart, Math.abs(x[1] - x[0]));
  const whole = Math.max(kLeast, kept.to - kept.from);
  const length = Math.min(whole, Math.max(kLeast, (Math.abs(at[1] - at[0]) / apart) * width));
  const from = (at[0] + at[1]) / 2 - ((x[0] + x[1]) / 2 / width) * length;
  return within({ from, to: from + length }, kept);
}

/** Moves the span into the kept span. */
export function within({ from, to }: Span, kept: Span): Span {
  const first = Math.min(kept.from, kept.to - kLeast);
  const by = from < first ? first - from : to > kept.to ? kept.to - to : 0;
  return { from: Math.max(first, from + by), to: to + by };
}

const kLeastApart = 12; // [px] of two fingers
const kSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];

/** Returns the ticks, at least `least` [px] apart. */
export function ticksOf(span: Span, width: number, least: number): { step: number; at: number[] } {
  const step = kSteps.find((step) => (step / (span.to - span.from)) * width >= least) ?? kSteps.at(-1)!;
  const at: number[] = [];
  for (let time = Math.ceil(span.from / step) * step; time <= span.to + 1e-9; time += step) at.push(time);
  return { step, at };
}

/** "−1:05" before now; tenths where steps are so fine. */
export function agoWords(seconds: number, step: number): string {
  if (Math.abs(seconds) < step / 2) return "now";
  const amount = Math.abs(seconds);
  const sign = seconds < 0 ? "−" : "+";
  if (step < 1) return `${sign}${amount.toFixed(1)} s`;
  const whole = Math.round(amount);
  return whole < 60 ? `${sign}${whole} s` : `${sign}${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** "1:05" after the beginning; tenths where steps are so fine. */
export function elapsedWords(seconds: number, step: number): string {
  const tenths = Math.round(10 * Math.max(0, seconds));
  const whole = step < 1 ? Math.floor(tenths / 10) : Math.round(tenths / 10);
  const words = `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
  return step < 1 ? `${words}.${tenths % 10}` : words;
}

/** Letters where there is room, the most important first; the tick reaches from `above` to `below` the bar's top [px]. */
const kShape: Record<Mark["kind"], { letter: string; rank: number; above: number; below: number }> = {
  goal: { letter: "G", rank: 0, above: 6, below: 6 },
  error: { letter: "!", rank: 0, above: 6, below: 6 },
  bookmark: { letter: "◆", rank: 0, above: 6, below: 6 },
  breakpoint: { letter: "●", rank: 1, above: 6, below: 6 },
  penalty: { letter: "P", rank: 1, above: 4, below: 6 },
  fall: { letter: "F", rank: 2, above: 4, below: 6 },
  state: { letter: "", rank: 3, above: 4, below: 6 },
  kick: { letter: "", rank: 3, above: 0, below: 4 },
};
const colourOf = (kind: Mark["kind"], { warn, accent, soft }: Colours): string =>
  kind === "error" || kind === "breakpoint" ? warn : kShape[kind].rank === 0 ? accent : soft;
const kLetterRoom = 11; // [px]
const kTextRoom = 22; // [px] on each side of the middle of a time

export function drawStrip(pen: Pen, width: number, height: number, strip: Strip, colours: Colours): void {
  const { shown, kept, seen, at, live, marks, loop } = strip;
  const { zero, wordsOf } = strip.count;
  const bar = { top: height - 12, height: 6 };
  const x = (time: number) => xOf(shown, width, time);
  const fill = (from: number, to: number, top: number, high: number, least = 0) => {
    const left = Math.max(0, x(from));
    pen.fillRect(left, top, Math.max(least, Math.min(width, x(to)) - left), high);
  };

  // the whole span, and the part of it that is loaded
  pen.fillStyle = colours.line;
  pen.fillRect(0, bar.top, width, bar.height);
  pen.fillStyle = colours.fill;
  fill(seen?.from ?? kept.from, seen?.to ?? at, bar.top, bar.height);
  // when the searched condition holds, also for a short time
  pen.fillStyle = colours.warn;
  for (const match of strip.matches ?? [])
    if (match.to >= shown.from && match.from <= shown.to) fill(match.from, match.to, bar.top + bar.height + 1, 4, 2);

  if (loop) {
    pen.fillStyle = colours.accent;
    pen.globalAlpha = 0.18;
    fill(loop.from, loop.to, 0, height);
    pen.globalAlpha = 1;
    for (const edge of [loop.from, loop.to])
      if (edge >= shown.from && edge <= shown.to) pen.fillRect(Math.min(width - 2, x(edge)), 0, 2, height);
  }

  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  pen.textAlign = "center";
  const { step, at: ticks } = ticksOf({ from: shown.from - zero, to: shown.to - zero }, width, 76);
  const placed = marks.map(({ at, kind }) => ({ x: x(at), kind }));
  const leads = placed.filter(({ kind }) => kShape[kind].rank === 0);
  const texts: number[] = []; // the places of times; the letter of a goal displaces one
  for (const tick of ticks) {
    const place = x(tick + zero);
    pen.fillStyle = colours.line;
    pen.fillRect(place, bar.top - 4, 1, 4);
    pen.fillStyle = colours.soft;
    if (place <= 20 || place >= width - 20 || leads.some(({ x }) => Math.abs(x - place) < kTextRoom)) continue;
    pen.fillText(wordsOf(tick, step), place, 8);
    texts.push(place);
  }
  drawMarks(pen, placed, texts, bar.top, colours);

  if (strip.hover !== undefined) {
    pen.fillStyle = colours.soft;
    pen.fillRect(x(strip.hover), 0, 1, height);
  }
  const place = Math.min(width - 1, Math.max(1, x(at)));
  pen.fillStyle = live ? colours.accent : colours.ink;
  pen.fillRect(place - 1, 0, 2, height);
  pen.beginPath();
  pen.arc(place, bar.top + bar.height / 2, 6, 0, 2 * Math.PI);
  pen.fill();
}

export interface Piece extends Span {
  colour: string;
}

/** A whole recording in short [s after its beginning]: the agent's skills as a band, events as marks. */
export function drawSummary(
  pen: Pen,
  width: number,
  height: number,
  length: number,
  pieces: Piece[],
  marks: Mark[],
  colours: Colours,
): void {
  const whole = { from: 0, to: Math.max(length, 1e-3) };
  const bar = { top: height - 8, height: 8 };
  pen.fillStyle = colours.line;
  pen.fillRect(0, bar.top, width, bar.height);
  for (const { from, to, colour } of pieces) {
    pen.fillStyle = colour;
    pen.fillRect(
      xOf(whole, width, from),
      bar.top,
      Math.max(0.5, xOf(whole, width, to) - xOf(whole, width, from)),
      bar.height,
    );
  }
  drawMarks(
    pen,
    marks.map(({ at, kind }) => ({ x: Math.min(width - 4, Math.max(4, xOf(whole, width, at))), kind })),
    [],
    bar.top,
    colours,
  );
}

/**
 * Goals and errors are signs with letters, the rest lines: told apart without colour. A letter covers no other one, and
 * no text at the places `texts`.
 */
function drawMarks(
  pen: Pen,
  marks: { x: number; kind: Mark["kind"] }[],
  texts: number[],
  top: number,
  colours: Colours,
): void {
  const ranked = [...marks].sort((a, b) => kShape[a.kind].rank - kShape[b.kind].rank);
  const taken: number[] = []; // places of letters, in steps of their room
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  // the important ones last, above the others
  for (const { x, kind } of [...ranked].reverse()) {
    const { above, below } = kShape[kind];
    pen.fillStyle = colourOf(kind, colours);
    pen.fillRect(x - 0.5, top - above, 1.5, above + below);
  }
  for (const { x, kind } of ranked) {
    const { letter, rank } = kShape[kind];
    const step = Math.floor(x / kLetterRoom);
    if (!letter || texts.some((text) => Math.abs(text - x) < kTextRoom)) continue;
    if ([step - 1, step, step + 1].some((near) => Math.abs((taken[near] ?? Infinity) - x) < kLetterRoom)) continue;
    taken[step] = x;
    pen.fillStyle = colourOf(kind, colours);
    pen.font = `${rank === 0 ? 700 : 400} 10px system-ui, sans-serif`;
    pen.fillText(letter, x, top - 9);
  }
}
