import { expect, test } from "vitest";
import { compile } from "./compile";
import { orMistake, type Mistake } from "./expression";
import { gameVocabulary } from "./test_vocabulary";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
/** The team attacks towards -x. Robot 2 stands at (-1, -2) of `field` and looks along -y; the ball lies 1 m before it. */
const kNow: Record<string, Fields> = {
  "/14/2/ball": fields({ x: 1, y: 0, visible: true, seen_ns: 7n }),
  "/14/2/pose": fields({ x: 1, y: 2, heading: Math.PI / 2, particles: [fields({ x: 1, y: 2 })] }),
  "/14/2/game": fields({ state: new EnumValue(5, "STATE_PLAYING"), attacks_positive_x: false }),
  "/14/2/decision": fields({ role: "chaser", skill: "kick" }),
  "/14/2/joints": fields({ position: Array.from({ length: 25 }, (_, i) => i / 10) }),
  "/14/2/spot": fields({ x: 3, y: 4 }),
  "/14/3/ball": fields({ x: 2.5, y: 0 }),
  "/14/3/pose": fields({ x: 0, y: 0, heading: 0 }),
  "/10/1/ball": fields({ x: -9, y: 0 }),
  "/truth/world": fields({
    ball: fields({ x: -1, y: -3 }),
    robots: [
      fields({ team: 14, player: 3, x: 5, y: 5, heading: 0 }),
      fields({ team: 14, player: 2, x: -1, y: -2, heading: -Math.PI / 2 + 0.1 }),
    ],
  }),
};
const look = (topic: string) => kNow[topic];
const valueOf = (text: string, robot?: string) => compile(text, gameVocabulary(robot)).value(look);

test("numbers are computed, and what is absent stays absent", () => {
  const cases: [string, number | undefined][] = [
    ["ball.x + 2 * pose.y - 1", 4],
    ["-ball.x / 4", -0.25],
    ["abs(-pose.y)", 2],
    ["min(ball.x, 3, -1)", -1],
    ["max(ball.x, 3)", 3],
    ["ball.seen_ns - 2", 5],
    ["ball.visible + 1", 2],
    ["ball.x / 0", undefined],
    ["truth.robots[7].x + 1", undefined],
    ["abs(truth.robots[7].x)", undefined],
    ["joints.position[head_pitch] + joints.position[R_Hand]", 2.5],
    ["angle(3, -3)", 6 - 2 * Math.PI],
  ];
  for (const [text, expected] of cases)
    expect(valueOf(text), text).toEqual(expected === undefined ? undefined : expect.closeTo(expected, 9));
});

test("a believed place is put on the field by the robot's own pose and direction of play", () => {
  expect(valueOf("field(ball).x")).toBeCloseTo(-1, 9);
  expect(valueOf("field(ball).y")).toBeCloseTo(-3, 9);
  expect(valueOf("field(pose).y")).toBeCloseTo(-2, 9);
  expect(valueOf("field(/14/3/ball).x")).toBeCloseTo(2.5, 9); // this robot has no object game
  expect(valueOf("field(field(ball)).x")).toBe(valueOf("field(ball).x"));
});

test("belief is compared with truth in one frame", () => {
  expect(valueOf("distance(ball, truth.ball)")).toBeCloseTo(0, 9);
  expect(valueOf("distance(truth.ball, ball)")).toBeCloseTo(0, 9);
  expect(valueOf("distance(pose, truth.pose)")).toBeCloseTo(0, 9);
  expect(valueOf("distance(pose, truth.robots[team=14,player=3])")).toBeCloseTo(Math.hypot(6, 7), 9);
  expect(valueOf("distance(/14/3/ball, truth.ball)")).toBeCloseTo(Math.hypot(3.5, 3), 9);
  expect(valueOf("distance(ball, /14/3/ball)")).toBeCloseTo(Math.hypot(3.5, 3), 9);
  expect(valueOf("angle(pose, truth.pose)")).toBeCloseTo(-0.1, 9);
  expect(valueOf("distance(spot, spot)")).toBe(0);
  expect(compile("distance(ball, truth.ball)", gameVocabulary()).topics).toEqual([
    "/14/2/ball",
    "/truth/world",
    "/14/2/pose",
    "/14/2/game",
  ]);
});

test("“any” asks all robots that have the objects", () => {
  expect(valueOf("any ball.x > 2")).toBe(true);
  expect(valueOf("any ball.x > 3")).toBe(false);
  expect(valueOf("any ball.x < -8")).toBe(true);
  expect(valueOf("any (ball.x < -8 && pose.x < 9)")).toBe(false); // 10/1 reports no pose
  expect(valueOf("any decision.role == chaser", "10/1")).toBe(true);
  expect(compile("any ball.x > 2", gameVocabulary()).topics).toEqual(["/14/2/ball", "/14/3/ball", "/10/1/ball"]);
});

test("enum values and texts are called by their names", () => {
  for (const name of ["playing", "STATE_PLAYING", "'Playing'"])
    expect(valueOf(`game.state == ${name}`), name).toBe(true);
  expect(valueOf("game.state != ready")).toBe(true);
  expect(valueOf("decision.role == chaser and decision.skill != dribble")).toBe(true);
  expect(compile("game.state", gameVocabulary()).words?.get(5)).toBe("playing");
});

test("a mistake that the schemas reveal is told with its place", () => {
  const cases: [string, string, string][] = [
    ["ball.z > 1", "z", "“ball” has no field “z”, only x, y, visible, seen_ns."],
    ["ball.x.y > 1", ".y", "“ball.x” is one value and has no fields."],
    ["ball.x[0] > 1", "[0]", "“ball.x” is no list."],
    ["truth.robots.x > 1", ".x", "“truth.robots” is a list: name one entry before the field, such as truth.robots[0]."],
    [
      "joints.position > 1",
      "joints.position",
      "“joints.position” is a list: name one entry, such as joints.position[0].",
    ],
    ["joints.position[nose] > 1", "nose", "No joint is called “nose”."],
    ["truth.robots[nose].x > 1", "nose", "Only lists by joint take a name here."],
    ["truth.ball > 1", "truth.ball", "“truth.ball” has fields of its own: name one of them, such as truth.ball.x."],
    ["game.state == plaing", "plaing", "“plaing” is none of its values: unspecified, ready, set, playing."],
    ["game.state < playing", "playing", "“playing” has no order: compare it with == or !=."],
    ["ball.x == playing", "playing", "“playing” is no number, but the other side is one."],
    ["ball.x > pose", "pose", "“pose” is a whole object: name a field of it, such as pose.x."],
    ["ball.visible == yes", "yes", "The other side is true or false, never “yes”."],
    ["decision.role + 1", "decision.role", "A text is no number: name a path such as ball.x."],
    ["sin(ball.x)", "sin", "There is no function “sin”, only abs, min, max, angle, distance, field."],
    ["min(ball.x)", ")", "A value is missing: min(a, b, …)."],
    ["abs(ball.x, ball.y)", "ball.y", "This is one value too many: abs(a)."],
    ["distance(ball, 3)", "3", "distance() needs a place here, such as ball or truth.ball."],
    ["distance(ball, pose.x)", "pose.x", "distance() needs a place here, not a value."],
    ["distance(ball, game)", "game", "This has no x and y, so it is no place."],
    ["distance(ball, spot)", "spot", "Nothing tells in which frame this place is, so it cannot be put on the field."],
    ["angle(ball, pose)", "ball", "This place has no heading."],
    ["field(/10/1/ball).x", "/10/1/ball", "Robot 10/1 reports no pose, so this place is not known on the field."],
    ["field(ball)", "field(ball)", "A place is not one value: write .x, .y or .heading behind it."],
    ["field(ball).z", ".z", "A place on the field has x, y and heading."],
    ["abs(ball.x).y", ".y", "A number has no fields."],
    ["any nothing.x > 2", "nothing", "Robot 14/2 has no object “nothing”."],
  ];
  for (const [text, part, error] of cases) {
    const found = orMistake(() => compile(text, gameVocabulary())) as Mistake;
    expect([found.error, text.slice(found.at, found.end)], text).toEqual([error, part]);
  }
  const vocabulary = { ...gameVocabulary(), topics: new Set(["/14/2/ball"]) };
  expect(orMistake(() => compile("truth.ball.x", vocabulary))).toMatchObject({
    error: "Nobody tells the truth here: there is no object /truth/world.",
  });
});
