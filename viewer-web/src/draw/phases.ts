// The agent's skills over time as a strip: one colour and one word per skill.

import type { Phase } from "../memory/decisions";
import type { WholeRun } from "../source/whole";
import { wordsOn } from "./contrast";
import type { Pen } from "./field";
import { hatch } from "./hatch";
import { ticksOf, xOf, type Colours, type Count, type Span } from "./timeline";

/** The colours differ in brightness. The words on the strip name the skills. */
export const kSkillColours = ["#56b4e9", "#e69f00", "#f0e442", "#7486fe", "#4eee73", "#f84360", "#39aea5", "#5658f2"];

/** A skill always has the same colour, and neighbours in the list have different ones. */
export const colourOfSkill = (skills: string[], skill: string): string =>
  kSkillColours[Math.max(0, skills.indexOf(skill)) % kSkillColours.length]!;

export interface Piece {
  from: number;
  to: number;
  skill: string;
  role: string;
}

/**
 * Returns the visible phases as pieces [s] of the plot's own time. Consecutive phases with the same skill are one
 * piece.
 */
export function piecesOf(phases: Phase[], span: Span, secondsOf: (ns: bigint) => number): Piece[] {
  const pieces: Piece[] = [];
  phases.forEach(({ from_ns, skill, role }, i) => {
    const next = phases[i + 1];
    const [from, to] = [secondsOf(from_ns), next ? secondsOf(next.from_ns) : span.to];
    if (to < span.from || from > span.to) return;
    const before = pieces.at(-1);
    if (before && before.skill === skill && before.role === role) before.to = to;
    else pieces.push({ from: Math.max(span.from, from), to: Math.min(span.to, to), skill, role });
  });
  return pieces;
}

/** As before, of runs with the words skill and role. Runs that leave a gap were interrupted: the robot was away. */
export function piecesOfRuns(runs: WholeRun[], span: Span, secondsOf: (ns: bigint) => number): Piece[] {
  const pieces: Piece[] = [];
  for (const { from_ns, to_ns, words } of runs) {
    const [from, to] = [secondsOf(from_ns), secondsOf(to_ns)];
    if (to < span.from || from > span.to) continue;
    const [skill, role] = [words[0] ?? "", words[1] ?? ""];
    pieces.push({ from: Math.max(span.from, from), to: Math.min(span.to, to), skill, role });
  }
  return pieces;
}

/** Returns the spans in which both decided, for other skills. */
export function differencesOf(one: Piece[], other: Piece[]): Span[] {
  const spans: Span[] = [];
  let next = 0; // pieces of `other` before it end before the piece of `one`
  for (const { from, to, skill } of one) {
    while (next < other.length && other[next]!.to <= from) ++next;
    for (let i = next; i < other.length && other[i]!.from < to; ++i) {
      const piece = other[i]!;
      if (piece.skill === skill) continue;
      const span = { from: Math.max(from, piece.from), to: Math.min(to, piece.to) };
      if (span.to <= span.from) continue;
      const before = spans.at(-1);
      if (before?.to === span.from) before.to = span.to;
      else spans.push(span);
    }
  }
  return spans;
}

/**
 * Draws the pieces as a band. `others` are a second band below, and a line between the two marks where they differ.
 */
export function drawPhases(
  pen: Pen,
  width: number,
  height: number,
  pieces: Piece[],
  others: Piece[] | undefined,
  skills: string[],
  { span, at, count: { zero, wordsOf }, unloaded = [] }: { span: Span; at: number; count: Count; unloaded?: Span[] },
  colours: Colours,
): void {
  const bar = { top: 4, height: height - 24 };
  const between = others ? 8 : 0; // [px]
  const high = others ? (bar.height - between) / 2 : bar.height;
  pen.textBaseline = "middle";
  pen.font = "11px system-ui, sans-serif";
  const band = (pieces: Piece[], top: number) => {
    pen.fillStyle = colours.line;
    pen.fillRect(0, top, width, high);
    for (const { from, to } of unloaded) {
      const [left, right] = [from, to].map((time) => Math.min(width, Math.max(0, xOf(span, width, time))));
      hatch(pen, left!, top, right! - left!, high, colours.soft);
    }
    for (const { from, to, skill } of pieces) {
      const [left, right] = [xOf(span, width, from), xOf(span, width, Math.min(to, span.to))];
      const colour = colourOfSkill(skills, skill);
      pen.fillStyle = colour;
      pen.fillRect(left, top, Math.max(1, right - left), high);
      const word = skill.replaceAll("_", " ");
      if (right - left > 6.2 * word.length + 8) {
        pen.fillStyle = wordsOn(colour);
        pen.textAlign = "left";
        pen.fillText(word, left + 4, top + high / 2);
      }
    }
  };
  band(pieces, bar.top);
  if (others) {
    band(others, bar.top + high + between);
    pen.fillStyle = colours.warn;
    for (const { from, to } of differencesOf(pieces, others)) {
      const left = xOf(span, width, from);
      pen.fillRect(left, bar.top + high + 2, Math.max(1, xOf(span, width, to) - left), between - 4);
    }
  }
  pen.textAlign = "center";
  const { step, at: ticks } = ticksOf({ from: span.from - zero, to: span.to - zero }, width, 90);
  pen.fillStyle = colours.soft;
  for (const tick of ticks)
    pen.fillText(wordsOf(tick, step), Math.min(width - 18, Math.max(18, xOf(span, width, tick + zero))), height - 8);
  pen.fillStyle = colours.accent;
  pen.fillRect(Math.min(width - 2, xOf(span, width, at)) - 1, 0, 2.5, bar.top + bar.height + 4);
}
