// The differences between two decisions of one robot, as sentences.

import { comparison, type Decision, type Visit } from "../memory/decisions";
import { words } from "./format";

const conditionOf = (visit: Visit): string => visit.condition || visit.name;

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
