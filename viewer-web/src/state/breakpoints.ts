// Breakpoints, as the page's address and the layout file hold them: "ball.x > 2;off:decision.skill == kick".

export interface Kept {
  condition: string;
  /** false: it is shown, and stops nothing. */
  on: boolean;
}

export const kMostBreakpoints = 10;
export const kLongestCondition = 300; // [letters]
const kOff = "off:";

/** Parses any text. Parts beyond the limits, and repeated conditions, are left out. */
export function breakpointsOf(text: string): Kept[] {
  const kept = new Map<string, Kept>();
  for (const part of text.split(";")) {
    const on = !part.startsWith(kOff);
    const condition = (on ? part : part.slice(kOff.length)).trim();
    if (condition && condition.length <= kLongestCondition && !kept.has(condition))
      kept.set(condition, { condition, on });
  }
  return [...kept.values()].slice(0, kMostBreakpoints);
}

export const textOfBreakpoints = (breakpoints: Kept[]): string =>
  breakpoints.map(({ condition, on }) => `${on ? "" : kOff}${condition}`).join(";");
