// The strip of time: what is kept, what happened, where we are. Seconds relative to any origin; plain drawing.

import type { EventKind } from "../memory/game_events";
import type { Pen } from "./field";

/** The part of time that is on screen [s]. */
export interface Span {
  from: number;
  to: number;
}

export interface Mark {
  at: number;
  kind: EventKind;
  text: string;
}

export interface Strip {
  /** What is kept. */
  kept: Span;
  shown: Span;
  at: number;
  live: boolean;
  marks: Mark[];
  hover: number | undefined;
}

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

/** The last `length` [s] up to `last`, or all that is kept where that is less; a strip is never shorter than a few seconds. */
export function spanOf(kept: Span, length: number): Span {
  const whole = Math.max(kLeast, kept.to - kept.from);
  return { from: kept.to - Math.min(whole, Math.max(kLeast, length)), to: kept.to };
}

/** Nearer by `factor` about `at`, within what is kept. */
export function zoomedSpan(shown: Span, kept: Span, at: number, factor: number): Span {
  const whole = Math.max(kLeast, kept.to - kept.from);
  const length = Math.min(whole, Math.max(kLeast, (shown.to - shown.from) / factor));
  const share = Math.min(1, Math.max(0, (at - shown.from) / (shown.to - shown.from)));
  return within({ from: at - share * length, to: at - share * length + length }, kept);
}

/** Moved so that nothing beyond what is kept is shown. */
export function within({ from, to }: Span, kept: Span): Span {
  const first = Math.min(kept.from, kept.to - kLeast);
  const by = from < first ? first - from : to > kept.to ? kept.to - to : 0;
  return { from: Math.max(first, from + by), to: to + by };
}

const kSteps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];

/** Where ticks stand: not nearer than `least` [px]. */
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

const kShape: Record<EventKind, { letter: string; important: boolean }> = {
  goal: { letter: "G", important: true },
  penalty: { letter: "P", important: false },
  state: { letter: "", important: false },
  error: { letter: "!", important: true },
};

export function drawStrip(pen: Pen, width: number, height: number, strip: Strip, colours: Colours): void {
  const { shown, kept, at, live, marks } = strip;
  const bar = { top: height - 12, height: 6 };
  const x = (time: number) => xOf(shown, width, time);

  // what is kept, and of that what lies before the moment shown
  pen.fillStyle = colours.line;
  pen.fillRect(0, bar.top, width, bar.height);
  pen.fillStyle = colours.fill;
  pen.fillRect(Math.max(0, x(kept.from)), bar.top, Math.max(0, Math.min(width, x(at)) - Math.max(0, x(kept.from))), bar.height);

  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  pen.textAlign = "center";
  const { step, at: ticks } = ticksOf({ from: shown.from - kept.to, to: shown.to - kept.to }, width, 76);
  for (const tick of ticks) {
    const place = x(tick + kept.to);
    pen.fillStyle = colours.line;
    pen.fillRect(place, bar.top - 4, 1, 4);
    pen.fillStyle = colours.soft;
    if (place > 20 && place < width - 20) pen.fillText(agoWords(tick, step), place, 8);
  }
  for (const mark of marks) drawMark(pen, x(mark.at), bar.top, mark.kind, colours);

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

/** Goals and errors are signs with letters, the rest lines: told apart without colour. */
function drawMark(pen: Pen, x: number, bottom: number, kind: EventKind, colours: Colours): void {
  const { letter, important } = kShape[kind];
  pen.fillStyle = kind === "error" ? colours.warn : important ? colours.accent : colours.soft;
  pen.fillRect(x - 0.5, bottom - (important ? 6 : 4), 1.5, important ? 12 : 10);
  if (!letter) return;
  pen.font = `${important ? 700 : 400} 10px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(letter, x, bottom - 9);
}
