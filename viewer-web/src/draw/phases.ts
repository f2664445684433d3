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

export function drawPhases(
  pen: Pen,
  width: number,
  height: number,
  pieces: Piece[],
  skills: string[],
  { span, at, count: { zero, wordsOf }, unloaded = [] }: { span: Span; at: number; count: Count; unloaded?: Span[] },
  colours: Colours,
): void {
  const bar = { top: 4, height: height - 24 };
  pen.fillStyle = colours.line;
  pen.fillRect(0, bar.top, width, bar.height);
  for (const { from, to } of unloaded) {
    const [left, right] = [from, to].map((time) => Math.min(width, Math.max(0, xOf(span, width, time))));
    hatch(pen, left!, bar.top, right! - left!, bar.height, colours.soft);
  }
  pen.textBaseline = "middle";
  pen.font = "11px system-ui, sans-serif";
  for (const { from, to, skill } of pieces) {
    const [left, right] = [xOf(span, width, from), xOf(span, width, Math.min(to, span.to))];
    const colour = colourOfSkill(skills, skill);
    pen.fillStyle = colour;
    pen.fillRect(left, bar.top, Math.max(1, right - left), bar.height);
    const word = skill.replaceAll("_", " ");
    if (right - left > 6.2 * word.length + 8) {
      pen.fillStyle = wordsOn(colour);
      pen.textAlign = "left";
      pen.fillText(word, left + 4, bar.top + bar.height / 2);
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
