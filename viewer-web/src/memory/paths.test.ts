import { expect, test } from "vitest";
import { numberAt, numbersIn, pathOf, textOf } from "./paths";
import { EnumValue, type Value } from "./value";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const kTopics = ["/14/2/ball", "/14/2/ball.filtered", "/truth/world"];
const kWorld = fields({
  robots: [fields({ team: 14, player: 1, x: 1 }), fields({ team: 14, player: 2, x: 2.5 })],
  ball: fields({ x: 0.5, visible: true, kind: new EnumValue(3, "KIND_THREE"), count: 7n, name: "round" }),
  seen_ns: 5n,
  weights: [0.25, 0.75],
});

test("a path leads to its number", () => {
  const cases: [string, number][] = [
    ["/truth/world.ball.x", 0.5],
    ["/truth/world.ball.visible", 1],
    ["/truth/world.ball.kind", 3],
    ["/truth/world.ball.count", 7],
    ["/truth/world.weights[1]", 0.75],
    ["/truth/world.robots[1].x", 2.5],
    ["/truth/world.robots[team=14, player=2].x", 2.5],
    ["/truth/world.robots[team=5,player=2].x", NaN],
    ["/truth/world.ball.name", NaN],
    ["/truth/world.nothing.x[3]", NaN],
    ["/truth/world", NaN],
  ];
  for (const [text, value] of cases) expect(numberAt(kWorld, pathOf(text, kTopics)!.steps), text).toBe(value);
});

test("a path that was written leads to the same place", () => {
  for (const text of ["/truth/world.ball.x", "/truth/world.weights[1]", "/truth/world.robots[team=14,player=2].x"])
    expect(textOf(pathOf(text, kTopics)!)).toBe(text);
  const joint = pathOf("/14/2/joints.position[head_yaw]", ["/14/2/joints"])!;
  expect(pathOf(textOf(joint), ["/14/2/joints"])).toEqual(joint);
});

test("topics may contain dots, and an invalid path is refused", () => {
  expect(pathOf("/14/2/ball.filtered.x", kTopics)).toEqual({ topic: "/14/2/ball.filtered", steps: ["x"] });
  expect(pathOf("/14/2/ball.x", kTopics)).toEqual({ topic: "/14/2/ball", steps: ["x"] });
  for (const text of [
    "",
    "/14/2",
    "/14/2/balls.x",
    "/14/2/ball..x",
    "/14/2/ball[x",
    "/14/2/ball[]",
    "/14/2/ball[a=]",
    "/14/2/ball[a=b]",
  ])
    expect(pathOf(text, kTopics), text).toBeUndefined();
});

test("search finds numbers, but no times since the epoch", () => {
  expect(numbersIn(kWorld, "w")).toEqual([
    ...[0, 1].flatMap((i) => ["team", "player", "x"].map((name) => `w.robots[${i}].${name}`)),
    "w.ball.x",
    "w.ball.visible",
    "w.ball.kind",
    "w.ball.count",
    "w.weights[0]",
    "w.weights[1]",
  ]);
});
