// The part of time that a plot or a strip shows.

import { within, type Span } from "./timeline";

/** A shown part that stays, and the shown moment when it was chosen. */
export interface Held {
  span: Span;
  at: number;
}

/** The available time, the shown moment, and whether that is now: new data arrive at its end. All in [s]. */
export interface Place {
  kept: Span;
  at: number;
  atNow: boolean;
}

/**
 * Returns the part of `length` to show: the newest at now, otherwise one around the shown moment. A held part stays as
 * long as it contains the moment or the moment stands still, because a click must not move its own target. It stays
 * within the available time if that is longer. Without a length it is the whole.
 */
export function windowOf(held: Held | undefined, length: number | undefined, { kept, at, atNow }: Place): Held {
  if (length === undefined) return { span: kept, at };
  if (atNow) return { span: { from: kept.to - length, to: kept.to }, at };
  const fits = held && Math.abs(held.span.to - held.span.from - length) < 1e-6 * length;
  if (fits && (at === held.at || (at >= held.span.from && at <= held.span.to))) return held;
  const span = { from: at - length / 2, to: at + length / 2 };
  const whole = kept.to - kept.from;
  return { span: length <= whole ? within(span, kept) : { from: kept.to - length, to: kept.to }, at };
}

const kLeast = 0.2; // [s] on screen

/** Zooms by `factor` about the time `about`, at most to the whole. Returns no length where it is the whole. */
export function zoomed(
  { span }: Held,
  { kept, at, atNow }: Place,
  about: number,
  factor: number,
): { held: Held; length: number | undefined } {
  const whole = kept.to - kept.from;
  const length = Number(Math.max(kLeast, (span.to - span.from) / factor).toPrecision(4));
  if (length >= whole) return { held: { span: kept, at }, length: undefined };
  const share = atNow ? 1 : Math.min(1, Math.max(0, (about - span.from) / (span.to - span.from)));
  const from = about - share * length;
  return { held: { span: within({ from, to: from + length }, kept), at }, length };
}

/** Returns the parts of `span` that `loaded` does not cover. */
export function gapsIn(span: Span, loaded: Span | undefined): Span[] {
  if (!loaded || loaded.to <= span.from || loaded.from >= span.to) return [span];
  return [
    { from: span.from, to: loaded.from },
    { from: loaded.to, to: span.to },
  ].filter(({ from, to }) => to > from);
}
