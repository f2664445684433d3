import { expect, test } from "vitest";
import { changesBetween, otherDeed } from "./decision_changes";
import type { Decision, Visit } from "../memory/decisions";

const visit = (path: string, result: boolean, value = 0.4): Visit => ({
  path,
  name: path,
  kind: "condition",
  condition: `ball_distance < ${path}`,
  feature: "ball_distance",
  value,
  threshold: 0.35,
  result,
});
const kDecision: Decision = {
  strategy: "baseline",
  role: "chaser",
  skill: "walk_to_ball",
  arguments: [],
  visited: [visit("a", false), visit("b", true)],
  leaf: "b/walk_to_ball",
};

test("nothing changes between equal decisions, whatever the values are", () => {
  expect(changesBetween(kDecision, kDecision)).toEqual([]);
  const nearer = { ...kDecision, visited: [visit("a", false, 0.39), visit("b", true, 0.39)] };
  expect(changesBetween(kDecision, nearer)).toEqual([]);
});

test("the skill, the role and each answer that turned are told, in this order", () => {
  const now = { ...kDecision, skill: "kick", role: "", visited: [visit("a", true, 0.3)], leaf: "a/kick" };
  expect(changesBetween(kDecision, now)).toEqual([
    "the skill: walk to ball → kick",
    "the role: chaser → none",
    "“ball_distance < a” holds now: ball_distance 0.3, compared with 0.35",
  ]);
  expect(changesBetween(now, kDecision)[2]).toBe(
    "“ball_distance < a” holds no longer: ball_distance 0.4, compared with 0.35",
  );
});

test("another tree, and another leaf of the same skill, are changes", () => {
  expect(changesBetween(kDecision, { ...kDecision, strategy: "mine" })).toEqual(["the tree: baseline → mine"]);
  expect(changesBetween(kDecision, { ...kDecision, leaf: "c/walk_to_ball" })).toEqual([
    "another part of the tree with the same skill",
  ]);
});

test("another deed is named by its skill and the arguments that differ", () => {
  const argument = (name: string, value: number) => ({ name, value });
  const walk = (tolerance: number) => ({
    skill: "walk_to_ball",
    arguments: [argument("tolerance", tolerance), argument("gain", 1)],
  });
  expect(otherDeed(walk(0.5), walk(0.5))).toBe("the same");
  expect(otherDeed(walk(0.5), walk(0.96))).toBe("walk to ball, tolerance 0.96");
  expect(otherDeed(walk(0.5), { skill: "", arguments: [] })).toBe("nothing");
  expect(otherDeed(walk(0.5), { skill: "walk_to_ball", arguments: [] })).toBe("walk to ball");
});
