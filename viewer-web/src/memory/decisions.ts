// The agent's decision tree, rebuilt from its traces because the tree itself is not sent. A branch that no decision has
// reached is unknown here.

import type { Entry } from "./history";
import type { MemoryObject } from "./memory_object";
import type { DecisionTrace } from "./schema";
import { listOf, numberOf, textOf, wordOf, type Fields } from "./value";

/** One node on the path of one decision. */
export interface Visit {
  path: string;
  name: string;
  kind: string;
  condition: string;
  feature: string;
  /** In the feature's own unit. NaN if nothing was compared or the value was unknown. */
  value: number;
  /** The number in the condition, or the value of the second feature if the condition compares two. NaN as `value`. */
  threshold: number;
  result: boolean;
}

export interface Decision {
  strategy: string;
  role: string;
  skill: string;
  arguments: { name: string; value: number }[];
  visited: Visit[];
  /** Path of the chosen leaf, or "" if there is none. */
  leaf: string;
}

export function decisionOf(fields: Fields<DecisionTrace>): Decision {
  const visited = listOf(fields, "visited").map((node) => ({
    path: textOf(node, "path"),
    name: textOf(node, "name"),
    kind: wordOf(node, "kind"),
    condition: textOf(node, "condition"),
    feature: textOf(node, "feature"),
    value: numberOf(node, "value"),
    threshold: numberOf(node, "threshold"),
    result: node.get("result") === true,
  }));
  return {
    strategy: textOf(fields, "strategy"),
    role: textOf(fields, "role"),
    skill: textOf(fields, "skill"),
    arguments: listOf(fields, "arguments").map((argument) => ({
      name: textOf(argument, "name"),
      value: numberOf(argument, "value"),
    })),
    visited,
    leaf: visited.findLast(({ kind, result }) => kind === "skill" && result)?.path ?? visited.at(-1)?.path ?? "",
  };
}

/** A node of the tree, as far as the traces show it. */
export interface Node {
  path: string;
  name: string;
  kind: string;
  condition: string;
  parent: Node | undefined;
  children: Node[];
  /** [s] during which the node was on the path to the chosen leaf. */
  seconds: number;
  /** The path of the newest decision that ended below this node: the conditions that must hold for it. */
  way: Visit[];
}

/** The chosen leaf from `from_ns` until the next phase, for the timeline. */
export interface Phase {
  from_ns: bigint;
  leaf: string;
  skill: string;
  role: string;
}

const kMostPhases = 20000;
const kLongest = 1; // [s] the longest time of one decision; a longer gap means that the robot was away
const kMostNodes = 2000;

export class Decisions {
  roots: Node[] = [];
  phases: Phase[] = [];
  strategy = "";
  #nodes = new Map<string, Node>();
  #next = 0;
  #generation = -1;
  #last_ns: bigint | undefined;

  constructor(readonly object: MemoryObject<DecisionTrace>) {}

  /** Reads new decisions for at most `milliseconds`. Returns true when all are read. */
  update(milliseconds: number, clock: () => number = () => performance.now()): boolean {
    const { history } = this.object;
    if (history.generation !== this.#generation) this.#restart();
    this.#next = Math.max(this.#next, history.begin);
    const end = clock() + milliseconds;
    for (let read = 0; this.#next < history.end; ++this.#next) {
      if (++read % 8 === 0 && clock() > end) return false;
      this.#read(history.get(this.#next)!);
    }
    return true;
  }

  node(path: string): Node | undefined {
    return this.#nodes.get(path);
  }

  #restart(): void {
    this.#generation = this.object.history.generation;
    this.#next = this.object.history.begin;
    this.#last_ns = undefined;
    this.phases = [];
  }

  #read(entry: Entry): void {
    const fields = this.object.decode(entry.data).fields;
    if (!fields) return;
    const decision = decisionOf(fields);
    // another strategy is another tree
    if (decision.strategy !== this.strategy) {
      this.roots = [];
      this.#nodes.clear();
      this.strategy = decision.strategy;
    }
    decision.visited.forEach((visit, i) => this.#grow(visit, decision.visited.slice(0, i)));
    this.#credit(decision, entry.log_ns);
    const before = this.phases.at(-1);
    if (before?.leaf !== decision.leaf || before.role !== decision.role)
      this.phases.push({ from_ns: entry.log_ns, leaf: decision.leaf, skill: decision.skill, role: decision.role });
    if (this.phases.length > kMostPhases) this.phases.splice(0, kMostPhases / 10);
  }

  /** Adds a new node after those siblings that were tested `before` it. A path has the tree's order. */
  #grow(visit: Visit, before: Visit[]): void {
    const known = this.#nodes.get(visit.path);
    if (known) {
      if (visit.condition) known.condition = visit.condition;
      return;
    }
    if (visit.path === "" || this.#nodes.size >= kMostNodes) return;
    const parent = this.#parentOf(visit.path);
    const node: Node = {
      path: visit.path,
      name: visit.name,
      kind: visit.kind,
      condition: visit.condition,
      parent,
      children: [],
      seconds: 0,
      way: [],
    };
    this.#nodes.set(visit.path, node);
    const siblings = parent?.children ?? this.roots;
    const asked = new Set(before.map(({ path }) => path));
    siblings.splice(siblings.findLastIndex(({ path }) => asked.has(path)) + 1, 0, node);
  }

  /** Returns the nearest known node above. Parts of a path that only name a subtree are no nodes. */
  #parentOf(path: string): Node | undefined {
    for (let end = path.lastIndexOf("/"); end > 0; end = path.lastIndexOf("/", end - 1)) {
      const node = this.#nodes.get(path.slice(0, end));
      if (node) return node;
    }
    return undefined;
  }

  #credit({ leaf, visited }: Decision, log_ns: bigint): void {
    const passed = this.#last_ns === undefined ? 0 : Number(log_ns - this.#last_ns) / 1e9;
    this.#last_ns = log_ns;
    for (let node = this.#nodes.get(leaf); node; node = node.parent) {
      if (passed > 0 && passed <= kLongest) node.seconds += passed;
      node.way = visited;
    }
  }
}

const shown = (value: number): string => (Number.isFinite(value) ? String(Number(value.toPrecision(3))) : "not known");

/** Describes the comparison of a visit by both values: "ball_distance 0.52, compared with 0.35". */
export const comparison = (visit: Visit): string =>
  visit.feature
    ? `${visit.feature} ${valueWord(visit, visit.value)}, compared with ${valueWord(visit, visit.threshold)}`
    : "";

/** The words for the values of features that are no numbers (sim/agent/features.cpp). */
const kWords: Record<string, string[]> = {
  role: ["keeper", "chaser", "supporter", "defender"],
  set_play: ["none", "kick_off", "kick_in", "goal_kick", "corner_kick"],
};

/** The word for a value. A number if the words are not those of this agent: then its condition names another word. */
function valueWord({ feature, condition, threshold }: Visit, value: number): string {
  const words = Object.hasOwn(kWords, feature) ? kWords[feature]! : [];
  const compared = words[threshold];
  const known = compared !== undefined && condition.split(/\s+/).includes(compared);
  return (known ? words[value] : undefined) ?? shown(value);
}

/**
 * Explains why `now` did not end in `node`: the first condition that differs from the newest decision that did.
 * Undefined if the node is on the path of this decision or was never reached.
 */
export function whyNot(node: Node, now: Decision): string | undefined {
  if (now.visited.some(({ path, result }) => path === node.path && result)) return undefined;
  const visits = new Map(now.visited.map((visit) => [visit.path, visit]));
  for (const then of node.way) {
    const visit = visits.get(then.path);
    if (!visit || visit.result === then.result) continue;
    const condition = visit.condition || visit.name;
    const compared = comparison(visit);
    return `“${condition}” ${visit.result ? "holds" : "does not hold"}${compared ? `: ${compared}` : ""}. ${then.result ? "It must hold to reach this node." : "While it holds, an earlier node is chosen."}`;
  }
  const last = now.visited.at(-1);
  return last ? `The decision reached “${last.name}” before this node.` : "Nothing was decided.";
}
