import { expect, test } from "vitest";
import { compile } from "./compile";
import { orMistake, parse, print, type Mistake, type Node } from "./expression";
import { gameVocabulary } from "./test_vocabulary";
import { objectNames } from "./vocabulary";
import type { Fields, Value } from "./value";

const kNames = objectNames(gameVocabulary());
const of = (text: string) => print(parse(text, kNames));

test("arithmetic binds closer than comparison, comparison closer than not, and, or", () => {
  const cases: [string, string][] = [
    ["a.x+2*b.y-1", "a.x + 2 * b.y - 1"],
    ["(a.x+2)*b.y", "(a.x + 2) * b.y"],
    ["a.x-(b.y-1)", "a.x - (b.y - 1)"],
    ["(a.x-b.y)-1", "a.x - b.y - 1"],
    ["-(a.x+1)", "-(a.x + 1)"],
    ["- -2 * a.x", "--2 * a.x"],
    ["not a.x > 2 and b.y or c.z", "!a.x > 2 && b.y || c.z"],
    ["!(a.x > 2 and b.y)", "!(a.x > 2 && b.y)"],
    ["any ball.x > 2 && pose.x < 1", "any(ball.x > 2) && pose.x < 1"],
    ["any (ball.x > 2 && pose.x < 1)", "any(ball.x > 2 && pose.x < 1)"],
    ["max(a.x,2 , abs( b.y ))", "max(a.x, 2, abs(b.y))"],
    ["field(ball).x>2", "field(ball).x > 2"],
    ["joints.position[ head_yaw ]", "joints.position[head_yaw]"],
    ["truth.robots[ team = 14, player=2 ].x", "truth.robots[team=14,player=2].x"],
    [`decision.role == 'a "b"'`, `decision.role == 'a "b"'`],
    ["organ.x + android.y + nothing.z + anything.w", "organ.x + android.y + nothing.z + anything.w"],
  ];
  for (const [text, expected] of cases) expect(of(text), text).toBe(expected);
});

test("a slash belongs to the longest known topic, every other one divides", () => {
  expect(parse("/14/2/ball.x/2", kNames)).toMatchObject({ kind: "compute", how: "/", left: { object: "/14/2/ball" } });
  expect(parse("ball.x/14/2", kNames)).toMatchObject({ kind: "compute", left: { kind: "compute" } });
  expect(parse("truth/world.ball.x", [...kNames, "truth/world"])).toMatchObject({ object: "truth/world" });
});

test("every part of the tree knows its place in the text", () => {
  const text = " abs(ball.x) > 2 && pose.y == 1";
  const node = parse(text, kNames) as Node & { kind: "join" };
  expect(text.slice(node.left.at, node.left.end)).toBe("abs(ball.x) > 2");
  expect(text.slice(node.right.at, node.right.end)).toBe("pose.y == 1");
});

/** Draws whole numbers below `most`, the same ones in each run. */
function draws(seed: number) {
  let state = seed;
  return (most: number) => (state = (state * 48271) % 2147483647) % most;
}

const kNumbers = ["ball.x", "pose.heading", "joints.position[1]", "2", "0.5", "1e-3", "field(ball).y", "truth.ball.x"];
/** Returns the text of a random number or, with `truth`, of a random condition. */
function sample(draw: (most: number) => number, depth: number, truth: boolean): string {
  const number = () => sample(draw, depth - 1, false);
  const condition = () => sample(draw, depth - 1, true);
  const one = (...choices: (() => string)[]) => choices[draw(choices.length)]!();
  if (truth)
    return depth <= 0
      ? "ball.visible"
      : one(
          () => `${number()} ${["<", ">", "<=", ">=", "==", "!="][draw(6)]} ball.y`,
          () => `${condition()} && ${condition()}`,
          () => `(${condition()} || ${condition()})`,
          () => `!${condition()}`,
          () => `any (${condition()})`,
          () => "game.state == playing",
          () => 'decision.role == "chaser"',
        );
  return depth <= 0
    ? kNumbers[draw(kNumbers.length)]!
    : one(
        () => `(${number()} ${"+-*/"[draw(4)]} ${number()})`,
        () => `${number()} ${"+-*/"[draw(4)]} ${number()}`,
        () => `-${number()}`,
        () => `max(${number()}, ${number()})`,
        () => `abs(${number()})`,
        () => "distance(ball, truth.ball)",
      );
}

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const kNow: Record<string, Fields> = {
  "/14/2/ball": fields({ x: 1.25, y: -0.5, visible: true }),
  "/14/2/pose": fields({ x: 1, y: 2, heading: 0.3 }),
  "/14/2/game": fields({ attacks_positive_x: false }),
  "/14/2/decision": fields({ role: "chaser" }),
  "/14/2/joints": fields({ position: [0.1, -0.2] }),
  "/14/3/ball": fields({ x: -1, y: 2, visible: false }),
  "/truth/world": fields({ ball: fields({ x: 0.5, y: 0.25 }), robots: [] }),
};

test("a printed expression has the same tree and the same value, also without spaces", () => {
  const draw = draws(7);
  const vocabulary = gameVocabulary();
  const look = (topic: string) => kNow[topic];
  for (let i = 0; i < 2000; ++i) {
    const text = sample(draw, 4, i % 2 === 0);
    const { node, value } = compile(text, vocabulary);
    for (const gap of ["", " "] as const) {
      const printed = print(node, gap);
      expect(print(parse(printed, kNames), gap), text).toBe(printed);
      expect(compile(printed, vocabulary).value(look), `${text} as ${printed}`).toEqual(value(look));
    }
    expect(print(node, "").replace('"chaser"', "")).not.toContain(" ");
  }
});

test("no text makes it throw, and every mistake has a place in the text or just behind it", () => {
  const pieces = `ball.x|&&| and |!|not |(|)|<|==|=|2|1.5.|'a|"b"|[|]|.| |,|/14/2/|\\|é|-|+|*|/|any |distance(|field(|
    max(|truth.|ball|playing|game.state|head_yaw|joints.position|__proto__.x|constructor(|[team=14|e5|🤖`.split("|");
  const draw = draws(1);
  let mistakes = 0;
  for (let i = 0; i < 20_000; ++i) {
    const text = Array.from({ length: 1 + draw(7) }, () => pieces[draw(pieces.length)]).join("");
    const found = orMistake(() => compile(text, gameVocabulary())) as Partial<Mistake> & {
      value?: (look: object) => Value;
    };
    if (found.error === undefined) {
      found.value!((topic: string) => kNow[topic]);
      continue;
    }
    ++mistakes;
    expect(found.error, text).toMatch(/[.]$/);
    expect(
      found.at! >= 0 && found.at! <= text.length && found.end! > found.at! && found.end! <= text.length + 1,
      text,
    ).toBe(true);
  }
  expect(mistakes).toBeGreaterThan(10_000);
});
