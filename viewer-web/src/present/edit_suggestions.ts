// The edits that a moment offers, as lines of the debugger.

import type { ChangeableMoment } from "../memory/change";
import type { Reasons } from "../memory/reasons";
import { words } from "./format";

export interface Suggestion {
  text: string;
  about: string;
}

/** Returns the thresholds on the path of the decision, the arguments of its leaf, other trees, beliefs and the luck. */
export function suggestionsOf(reasons: Reasons, { robot, leaves, strategies }: ChangeableMoment): Suggestion[] {
  const thresholds = reasons.path.flatMap(({ comparison: { node, condition, threshold } }): Suggestion[] =>
    threshold === undefined ? [] : [{ text: `set threshold ${node} ${threshold}`, about: condition }],
  );
  const taken = reasons.parts.findLast((part) => part.taken && part.skill !== undefined);
  const leaf = taken && leaves.find(({ path }) => path === taken.path || path.startsWith(`${taken.path}/`));
  const given = (leaf?.arguments ?? []).map(({ name, value }): Suggestion => ({
    text: `set argument ${name} ${value} of ${leaf!.path}`,
    about: `${words(name)} of ${words(taken!.skill!)}`,
  }));
  return [
    ...thresholds,
    ...given,
    ...strategies.map((name): Suggestion => ({ text: `strategy ${name}`, about: "another tree" })),
    { text: `set ${robot} believes ball 1 0`, about: "it has just seen the ball there [m, robot]" },
    { text: `set ${robot} believes at 0 0`, about: "its own place [m, team_field]" },
    { text: "set luck 1", about: "other dice from here on" },
  ];
}
