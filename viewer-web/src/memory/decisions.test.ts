import { expect, test } from "vitest";
import { comparison, Decisions, decisionOf, whyNot } from "./decisions";
import { History } from "./history";
import type { MemoryObject } from "./memory_object";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const condition = (path: string, value: number, threshold: number, result: boolean) =>
  fields({
    kind: new EnumValue(1, "KIND_CONDITION"),
    name: path.split("/").at(-1)!,
    path,
    condition: "ball_distance < $near",
    feature: "ball_distance",
    value,
    threshold,
    result,
  });
const skill = (path: string) =>
  fields({ kind: new EnumValue(4, "KIND_SKILL"), name: path.split("/").at(-1)!, path, result: true });
const trace = (name: string, ...visited: Fields[]) =>
  fields({ strategy: "baseline", role: "chaser", skill: name, visited });

const kKick = trace("kick", condition("t/near", 0.2, 0.3, true), skill("t/near/shoot/kick"));
const kWalk = trace("walk", condition("t/near", 0.52, 0.3, false), skill("t/walk"));

/** Returns an object that holds these traces, 10 per second. */
function decided(...traces: Fields[]) {
  const history = new History();
  const add = (i: number, second: number) =>
    history.add({ log_ns: BigInt(Math.round(second * 1e9)), data: Uint8Array.of(i), arrived: second });
  traces.forEach((_, i) => add(i, i / 10));
  const object = { history, decode: (data: Uint8Array) => ({ fields: traces[data[0]!] }) } as unknown as MemoryObject;
  return { decisions: new Decisions(object), add };
}

test("the tree has the nodes of the traces, and names of subtrees are no nodes", () => {
  const { decisions } = decided(kKick, kWalk, kWalk, kKick);
  expect(decisions.update(100)).toBe(true);
  expect(decisions.roots.map(({ path }) => path)).toEqual(["t/near", "t/walk"]);
  expect(decisions.roots[0]!.children.map(({ path }) => path)).toEqual(["t/near/shoot/kick"]);
});

test("a node that is seen late gets its place in the tree's order", () => {
  const [a, b, c] = ["t/a", "t/b", "t/c"].map((path) => condition(path, 0, 1, false));
  const { decisions } = decided(trace("walk", a!, skill("t/walk")), trace("kick", a!, b!, c!, skill("t/c/kick")));
  decisions.update(100);
  expect(decisions.roots.map(({ path }) => path)).toEqual(["t/a", "t/b", "t/c", "t/walk"]);
});

test("time counts for the chosen leaf and all nodes above it, and a long silence counts for none", () => {
  const { decisions, add } = decided(kKick, kWalk, kWalk, kKick);
  add(3, 50);
  decisions.update(100);
  expect(decisions.node("t/walk")!.seconds).toBeCloseTo(0.2);
  expect(decisions.node("t/near/shoot/kick")!.seconds).toBeCloseTo(0.1);
  expect(decisions.node("t/near")!.seconds).toBeCloseTo(0.1);
  expect(decisions.phases.map(({ skill, from_ns }) => [skill, Number(from_ns) / 1e9])).toEqual([
    ["kick", 0],
    ["walk", 0.1],
    ["kick", 0.3],
  ]);
});

test("a leaf that was not chosen names the condition that failed and by how much", () => {
  const { decisions } = decided(kKick, kWalk);
  decisions.update(100);
  const [kick, walk] = ["t/near/shoot/kick", "t/walk"].map((path) => decisions.node(path)!);
  expect(whyNot(kick!, decisionOf(kWalk))).toBe(
    "“ball_distance < $near” does not hold: ball_distance 0.52, compared with 0.3. It must hold to reach this node.",
  );
  expect(whyNot(walk!, decisionOf(kKick))).toBe(
    "“ball_distance < $near” holds: ball_distance 0.2, compared with 0.3. While it holds, an earlier node is chosen.",
  );
  expect(whyNot(kick!, decisionOf(kKick))).toBeUndefined();
  expect(whyNot(kick!, decisionOf(fields({})))).toBe("Nothing was decided.");
});

test("a comparison shows both values, also of two features and when one is unknown", () => {
  const shownOf = (visit: Fields) => comparison(decisionOf(trace("stand", visit)).visited[0]!);
  const two = (entries: Record<string, Value>) =>
    fields({
      kind: new EnumValue(1, "KIND_CONDITION"),
      path: "t/late",
      condition: "mates_time_to_ball < time_to_ball",
      feature: "mates_time_to_ball",
      ...entries,
    });
  expect(shownOf(two({ value: 1.5, threshold: 2.25 }))).toBe("mates_time_to_ball 1.5, compared with 2.25");
  expect(shownOf(two({ value: 1.5 }))).toBe("mates_time_to_ball 1.5, compared with not known");
  expect(shownOf(two({ threshold: 2.25 }))).toBe("mates_time_to_ball not known, compared with 2.25");
  expect(shownOf(skill("t/stand"))).toBe("");
});

test("another strategy starts another tree, and a seek starts another past", () => {
  const other = fields({ strategy: "passing", visited: [skill("p/pass")] });
  const { decisions, add } = decided(kKick, other);
  decisions.update(100);
  expect(decisions.roots.map(({ path }) => path)).toEqual(["p/pass"]);
  add(0, -100);
  decisions.update(100);
  expect(decisions.phases).toHaveLength(1);
});

test("a comparison of a role names it, unless the agent's words are not ours", () => {
  const asked = (condition: string) =>
    fields({ kind: new EnumValue(1, "KIND_CONDITION"), condition, feature: "role", value: 2, threshold: 1 });
  const shownOf = (condition: string) => comparison(decisionOf(trace("stand", asked(condition))).visited[0]!);
  expect(shownOf("role is chaser")).toBe("role supporter, compared with chaser");
  expect(shownOf("role is striker")).toBe("role 2, compared with 1");
});
