import { expect, test } from "vitest";
import type { Memory } from "../memory/memory";
import { memoryWith } from "../memory/test_memory";
import { EnumValue, type Value } from "../memory/value";
import { ellipseOf } from "./beliefs";
import { kUnknownLivery, liveriesOf } from "./robot_sign";
import { liveriesFor, oneWorld, sceneOf, topicsOf } from "./scene";
const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));

/** A memory of decoded values, by topic; all of one capture time unless `log_ns` has another. */
function memoryOf(values: Record<string, Record<string, Value>>, log_ns: Record<string, bigint> = {}): Memory {
  const object = (topic: string) =>
    values[topic] && {
      shown: { log_ns: log_ns[topic] ?? 10_000_000_000n },
      decoded: () => ({ fields: fields(values[topic]!) }),
    };
  const age = ({ shown }: { shown: { log_ns: bigint } }) => Number(10_000_000_000n - shown.log_ns) / 1e9;
  return memoryWith({ get: object, age });
}

const told = (memory: Memory, robots: string[], suffix = "") => ({
  memory,
  robots,
  keyOf: (robot: string) => robot + suffix,
});
const kPose = { x: 1, y: 0.5, heading: Math.PI / 2, deviation_x: 0.1, deviation_y: 0.3 };
const kBall = { x: 2, y: 0, deviation: 0.2, seen_ns: 9_500_000_000n };
const kTruth = {
  ball: fields({ x: 0.5, y: -1 }),
  robots: [fields({ team: 14, player: 2, x: 1.1, y: 0.4, heading: 1.5, fallen: true })],
};
const only = (memory: Memory, robots = ["14/2"]) =>
  sceneOf([told(memory, robots)], 0).robots.find(({ name }) => name === "14/2")!;

test("a belief is at the robot's believed place, and the ball relative to it", () => {
  const robot = only(
    memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: true } }),
  );
  expect(robot.pose).toMatchObject({
    x: 1,
    y: 0.5,
    heading: Math.PI / 2,
    deviation: 0.3,
    age: 0,
    uncertainty: { a: 0.1, b: 0.3 },
  });
  expect(robot.ball!.x).toBeCloseTo(1);
  expect(robot.ball!.y).toBeCloseTo(2.5);
  expect(robot.ball!.deviation).toBe(0.2);
  expect(robot.ball!.age).toBeCloseTo(0.5);
  expect(robot.truth).toBeUndefined();
});

test("a robot that attacks towards -x is turned by half a turn, with its ball", () => {
  const one = only(memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: true } }));
  const other = only(
    memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: false } }),
  );
  expect([other.pose!.x, other.pose!.y]).toEqual([-one.pose!.x, -one.pose!.y]);
  expect(other.ball!.x).toBeCloseTo(-one.ball!.x);
  expect(other.ball!.y).toBeCloseTo(-one.ball!.y);
});

test("the truth does not depend on the robots' beliefs", () => {
  const scene = sceneOf([told(memoryOf({ "/truth/world": kTruth }), [])], 0);
  expect(scene.ball).toMatchObject({ x: 0.5, y: -1 });
  expect(scene.robots.map(({ name }) => name)).toEqual(["14/2"]);
  expect(scene.robots[0]).toMatchObject({ truth: { x: 1.1, y: 0.4, heading: 1.5 }, fallen: true, pose: undefined });
});

test("in a truth without other objects the first team is at home, so that the sides differ", () => {
  const robots = [3, 1, 3].map((team, i) => fields({ team, player: i + 1, x: i, y: 0 }));
  const scene = sceneOf([told(memoryOf({ "/truth/world": { robots } }), [])], 0);
  expect(scene.robots.map(({ name, home }) => [name, home])).toEqual([
    ["1/2", true],
    ["3/1", false],
    ["3/3", false],
  ]);
});

test("robots without a jersey are all shown, by the numbers of their tracks", () => {
  const robots = [fields({ x: 0, y: 0, track: 5 }), fields({ x: 1, y: 0, track: 6 }), fields({ x: 2, y: 0 })];
  const scene = sceneOf([told(memoryOf({ "/truth/world": { robots } }), [])], 0);
  expect(scene.robots.map(({ name, livery }) => [name, livery])).toEqual([
    ["#5", kUnknownLivery],
    ["#6", kUnknownLivery],
    ["robot 3 without a number", kUnknownLivery],
  ]);
});

test("a team wears the jersey that the GameController reports, whichever robot passes it on", () => {
  const team = (number: number, field_colour: string) =>
    fields({ number, field_colour: new EnumValue(0, `COLOUR_${field_colour}`) });
  const game = (own: Value, opponent: Value) => ({ own, opponent }) as Record<string, Value>;
  const [red, yellow] = [team(14, "RED"), team(5, "YELLOW")];
  for (const [robot, its] of [
    ["14/2", game(red, yellow)],
    ["5/1", game(yellow, red)],
  ] as const) {
    const robots = [14, 5].map((number) => fields({ team: number, player: 2, x: 0, y: 0 }));
    const memory = memoryOf({
      [`/${robot}/game`]: its,
      "/truth/world": { robots },
      "/sim/state": { home: fields({ number: 14 }) },
    });
    const colours = Object.fromEntries(
      sceneOf([told(memory, [robot])], 0).robots.map(({ name, livery, rivals }) => [
        name.split("/")[0],
        [livery.colour, rivals.colour],
      ]),
    );
    const { home, away } = liveriesOf("red", "yellow");
    expect(colours).toEqual({ "14": [home.colour, away.colour], "5": [away.colour, home.colour] });
    expect(liveriesFor([told(memory, [robot])], robot).own.colour).toBe(
      robot.startsWith("14") ? home.colour : away.colour,
    );
  }
});

test("a belief ages and is dropped after ten seconds", () => {
  const values = { "/14/2/pose": kPose, "/truth/world": kTruth };
  expect(only(memoryOf(values, { "/14/2/pose": 8_500_000_000n })).pose!.age).toBe(1.5);
  expect(only(memoryOf(values, { "/14/2/pose": -100_000_000n })).pose).toBeUndefined();
});

test("intentions and view are relative to the believed pose", () => {
  const command = {
    walk_to: fields({ x: 1, y: 0, heading: 0.5 }),
    kick: fields({ ball_x: 0.2, ball_y: 0, direction: -Math.PI / 2, distance: 2 }),
    look_to: fields({ x: 0, y: 1 }),
  };
  const values = { "/14/2/pose": kPose, "/14/2/motion_command": command };
  const { target, kick, view } = only(memoryOf(values));
  expect([target!.x, target!.y, target!.heading]).toEqual([
    expect.closeTo(1),
    expect.closeTo(1.5),
    expect.closeTo(Math.PI / 2 + 0.5),
  ]);
  expect([kick!.from.x, kick!.from.y, kick!.to.x, kick!.to.y]).toEqual([
    expect.closeTo(1),
    expect.closeTo(0.7),
    expect.closeTo(3),
    expect.closeTo(0.7),
  ]);
  expect(view!.angle).toBeCloseTo(Math.PI);
  // the camera's own matrix knows better: this one looks to the right
  const camera = { rotation: [0, 0, 0, 0, 0, -1, 0, 0, 0], width: 640, focal_x: 320 };
  const seen = only(memoryOf({ ...values, "/14/2/camera_top_matrix": camera })).view!;
  expect([seen.angle, seen.half]).toEqual([expect.closeTo(0), expect.closeTo(Math.PI / 4)]);
  // an old command is no intent
  expect(only(memoryOf(values, { "/14/2/motion_command": 8_000_000_000n })).target).toBeUndefined();
});

test("teammates are at their reported places and as old as the report", () => {
  const mate = fields({ player: 3, pose: fields({ x: 2, y: 1, heading: 0 }), received_ns: 8_000_000_000n });
  const silent = fields({ player: 4, received_ns: 8_000_000_000n });
  const values = { "/14/2/team": { teammates: [mate, silent] }, "/14/2/game": { attacks_positive_x: false } };
  expect(only(memoryOf(values)).teammates).toEqual([
    { x: -2, y: -1, heading: Math.PI, player: 3, fallen: false, age: 2 },
  ]);
});

test("a covariance is an ellipse whose axes are its own", () => {
  const turned = (angle: number, a: number, b: number) => {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    return fields({
      covariance_xx: a * a * cos * cos + b * b * sin * sin,
      covariance_yy: a * a * sin * sin + b * b * cos * cos,
      covariance_xy: (a * a - b * b) * cos * sin,
    });
  };
  for (const angle of [-1.2, 0, 0.3, 1.5]) {
    const ellipse = ellipseOf(turned(angle, 0.5, 0.2), 9, 1);
    expect([ellipse.a, ellipse.b]).toEqual([expect.closeTo(0.5), expect.closeTo(0.2)]);
    expect(Math.abs(Math.sin(ellipse.angle - 1 - angle))).toBeLessThan(1e-6);
  }
  expect(ellipseOf(fields({}), 0.4, 1)).toEqual({ a: 0.4, b: 0.4, angle: 0 });
});

test("several servers are one scene with the first one's truth, and equal names stay separate", () => {
  const [near, far] = [
    memoryOf({ "/14/2/pose": kPose }),
    memoryOf({ "/14/2/pose": { ...kPose, x: -1 }, "/truth/world": kTruth }),
  ];
  const scene = sceneOf([told(near, ["14/2"]), told(far, ["14/2"], "@far")], 0);
  expect(scene.robots.map(({ key, pose, truth }) => [key, pose!.x, truth !== undefined])).toEqual([
    ["14/2", 1, false],
    ["14/2@far", -1, true],
  ]);
  expect(scene.ball).toMatchObject({ x: 0.5 });
});

test("two truths are two games, and only the first one's is shown, with robots that have none", () => {
  const [game, other, live] = [
    memoryOf({ "/truth/world": kTruth }),
    memoryOf({ "/truth/world": kTruth }),
    memoryOf({ "/14/2/pose": kPose }),
  ].map((memory) => told(memory, []));
  expect(oneWorld([game!, other!, live!])).toEqual([game, live]);
  expect(oneWorld([live!, game!])).toEqual([live]);
});

test("the simulation says who plays at home", () => {
  const simulation = { home: fields({ number: 14 }) };
  const scene = sceneOf([told(memoryOf({ "/sim/state": simulation }), ["5/1", "14/2"])], 0);
  expect(scene.robots.map(({ name, home }) => [name, home])).toEqual([
    ["5/1", false],
    ["14/2", true],
  ]);
});

test("without valid data nothing is drawn", () => {
  expect(sceneOf([told(memoryOf({}), ["14/2"])], 0)).toMatchObject({
    ball: undefined,
    robots: [{ truth: undefined, pose: undefined, ball: undefined }],
  });
  const nonsense = memoryOf({
    "/truth/world": { ball: "round", robots: 7 },
    "/14/2/pose": { x: NaN, y: 1 },
    "/14/2/ball": {},
  });
  expect(sceneOf([told(nonsense, ["14/2"])], 0)).toMatchObject({
    ball: undefined,
    robots: [{ pose: undefined, ball: undefined }],
  });
});

test("only offered topics are requested", () => {
  expect(topicsOf(memoryOf({ "/14/2/pose": {}, "/truth/world": {} }), ["14/2", "5/1"])).toEqual([
    "/truth/world",
    "/14/2/pose",
  ]);
});
