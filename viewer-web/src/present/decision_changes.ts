// The differences between two decisions of one robot, as sentences.

import { comparison, type Decision, type Visit } from "../memory/decisions";
import { words } from "./format";

const conditionOf = (visit: Visit): string => visit.condition || visit.name;

type Deed = Pick<Decision, "skill" | "arguments">;

/** Returns what another tree decides, for people: "the same", or the skill with the arguments that differ. */
export function otherDeed(deed: Deed, other: Deed): string {
  const known = new Map(deed.arguments.map(({ name, value }) => [name, value]));
  const differing = other.arguments.filter(({ name, value }) => known.get(name) !== value);
  if (deed.skill === other.skill && differing.length === 0 && deed.arguments.length === other.arguments.length)
    return "the same";
  return [
    words(other.skill) || "nothing",
    ...differing.map(({ name, value }) => `${words(name)} ${value.toFixed(2)}`),
  ].join(", ");
}

/** Returns one sentence for each difference that matters, the skill first. Empty if the same path was taken. */
export function changesBetween(before: Decision, now: Decision): string[] {
  const changes: string[] = [];
  if (before.strategy !== now.strategy) changes.push(`the tree: ${before.strategy} → ${now.strategy}`);
  if (before.skill !== now.skill)
    changes.push(`the skill: ${words(before.skill) || "none"} → ${words(now.skill) || "none"}`);
  if (before.role !== now.role) changes.push(`the role: ${before.role || "none"} → ${now.role || "none"}`);
  const then = new Map(before.visited.map((visit) => [visit.path, visit]));
  for (const visit of now.visited) {
    const old = then.get(visit.path);
    if (!old || visit.kind === "skill" || old.result === visit.result) continue;
    const compared = comparison(visit);
    changes.push(
      `“${conditionOf(visit)}” ${visit.result ? "holds now" : "holds no longer"}${compared ? `: ${compared}` : ""}`,
    );
  }
  if (changes.length === 0 && before.leaf !== now.leaf) changes.push("another part of the tree with the same skill");
  return changes;
}
