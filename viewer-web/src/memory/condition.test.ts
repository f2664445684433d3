import { expect, test } from "vitest";
import { conditionOf, type Condition } from "./condition";
import type { Mistake } from "./expression";
import { topicsOnly } from "./test_vocabulary";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const kNow: Record<string, Fields> = {
  "/14/2/ball": fields({ x: 2.5, seen: true, count: 7n, list: [fields({ y: -1 })] }),
  "/14/2/pose": fields({ deviation_x: 0.2, absent: undefined }),
  "/14/2/game": fields({ state: new EnumValue(3, "STATE_PLAYING"), note: "it's" }),
  "/14/3/ball": fields({ x: -1 }),
  "/truth/world": fields({ tick: 5 }),
};
const of = (text: string) => conditionOf(text, topicsOnly("14/2", Object.keys(kNow)));
const holds = (text: string) => {
  const condition = of(text);
  if ("error" in condition) throw new Error(`${text}: ${condition.error}`);
  return condition.holds((topic) => kNow[topic]);
};

test("comparisons, and, or, not and brackets have their usual meaning", () => {
  const cases: [string, boolean][] = [
    ["ball.x > 2", true],
    ["ball.x > 2 && pose.deviation_x < 0.1", false],
    ["ball.x < 2 || pose.deviation_x <= 0.2", true],
    ["!(ball.x < 2) && !(ball.x > 3)", true],
    ["ball.x > 9 && ball.x > 9 || ball.seen", true],
    ["ball.x > 9 && (ball.x > 9 || ball.seen)", false],
    ["2 < ball.x", true],
    ["ball.x>=-1e3&&ball.count==7", true],
    ["ball.seen == true", true],
    ["ball.seen != false", true],
    ["ball.list[0].y == -1", true],
    ["/14/3/ball.x < 0", true],
    ["/14/3/ball.x < ball.x", true],
    ["truth/world.tick == 5", true],
  ];
  for (const [text, expected] of cases) expect(holds(text), text).toBe(expected);
});

test("an enum value matches its name with or without prefix, and a text matches its words", () => {
  for (const name of ["playing", "PLAYING", "STATE_PLAYING", '"playing"', "3"])
    expect(holds(`game.state == ${name}`), name).toBe(true);
  expect(holds("game.state == ing")).toBe(false);
  expect(holds("game.state != ready")).toBe(true);
  expect(holds(`game.note == "it's"`)).toBe(true);
  expect(holds("game.state > 2")).toBe(true);
});

test("an absent value is neither true, nor equal, nor different", () => {
  for (const text of ["pose.absent", "pose.absent == 0", "pose.absent != 0", "pose.nowhere < 1", "ball.list[9].y < 1"])
    expect(holds(text), text).toBe(false);
  const condition = of("ball.x > 2") as Condition;
  expect(condition.holds(() => undefined)).toBe(false);
});

test("a condition lists each topic that it reads once", () => {
  expect(of("ball.x > 1 && ball.x < 2 && /14/3/ball.x > pose.deviation_x")).toMatchObject({
    topics: ["/14/2/ball", "/14/3/ball", "/14/2/pose"],
  });
});

test("an invalid condition gives one sentence and the place of the mistake", () => {
  const cases: [string, string, string][] = [
    ["", "", "The text ends where a value is expected."],
    ["ball.x >", "", "The text ends where a value is expected."],
    ["ball.x > > 2", ">", "Expected a value before “>”."],
    ["(ball.x > 2", "(", "A bracket is not closed."],
    ["ball.x > 2)", ")", "This bracket was never opened."],
    ["ball.x > 2 pose.x", "pose.x", "Expected a sign such as && or > before “pose.x”."],
    ["ball.x = 2", "=", "“=” compares nothing: write == for “equals”."],
    ["1 < ball.x < 2", "<", "Comparisons make no chain: join two of them with &&."],
    ["ball.x # 2", "#", "Expected a sign such as && or > before “#”."],
    ["# 2", "#", "I cannot read “# 2”."],
    ["bal.x > 2", "bal", "Robot 14/2 has no object “bal”."],
    ["/9/9/ball.x > 2", "/9/9/ball", "Nobody tells “/9/9/ball”."],
    ["/14/2/ball > 2", "/14/2/ball", "“/14/2/ball” is a whole object: name a field of it, such as /14/2/ball.x."],
    ["ball > 2", "ball", "“ball” is a whole object: name a field of it, such as ball.x."],
    ["1 < 2", "1 < 2", "Both sides never change: one must be a path such as ball.x."],
    ["playing", "playing", "“playing” must be compared with something."],
    ["true", "true", "The condition never changes: name a path such as ball.x."],
    ["ball.x + 1", "ball.x + 1", "This is a number: compare it with something, such as > 0."],
    ["(".repeat(500), "(", "There are too many brackets within each other."],
    ["a".repeat(5000), "a".repeat(3000), "At most 2000 characters are read."],
  ];
  for (const [text, part, error] of cases) {
    const found = of(text) as Mistake;
    expect([found.error, text.slice(found.at, found.end)], text.slice(0, 40)).toEqual([error, part]);
  }
});
