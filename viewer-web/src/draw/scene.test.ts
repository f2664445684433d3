import { expect, test } from "vitest";
import type { Memory } from "../memory/memory";
import type { Value } from "../memory/value";
import { kUsualField } from "./field";
import { sceneOf, topicsOf } from "./scene";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));

/** A memory of decoded values, by topic; all of one capture time unless `log_ns` has another. */
function memoryOf(values: Record<string, Record<string, Value>>, log_ns: Record<string, bigint> = {}): Memory {
  const object = (topic: string) =>
    values[topic] && { newest: { log_ns: log_ns[topic] ?? 10_000_000_000n }, decoded: () => ({ fields: fields(values[topic]!) }) };
  return { get: object } as unknown as Memory;
}

const kPose = { x: 1, y: 0.5, heading: Math.PI / 2, deviation_x: 0.1, deviation_y: 0.3 };
const kBall = { x: 2, y: 0, deviation: 0.2, seen_ns: 9_500_000_000n };
const kTruth = { ball: fields({ x: 0.5, y: -1 }), robots: [fields({ team: 14, player: 2, x: 1.1, y: 0.4, heading: 1.5, fallen: true })] };
const only = (memory: Memory, robots = ["14/2"]) => sceneOf(memory, robots).robots.find(({ name }) => name === "14/2")!;

test("a belief stands where the robot believes, the ball seen from there", () => {
  const robot = only(memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: true } }));
  expect(robot.pose).toEqual({ x: 1, y: 0.5, heading: Math.PI / 2, deviation: 0.3 });
  expect(robot.ball!.x).toBeCloseTo(1);
  expect(robot.ball!.y).toBeCloseTo(2.5);
  expect(robot.ball!.deviation).toBe(0.2);
  expect(robot.ball!.age).toBeCloseTo(0.5);
  expect(robot.truth).toBeUndefined();
});

test("who attacks towards -x is turned by half a turn, and so is his ball", () => {
  const one = only(memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: true } }));
  const other = only(memoryOf({ "/14/2/pose": kPose, "/14/2/ball": kBall, "/14/2/game": { attacks_positive_x: false } }));
  expect([other.pose!.x, other.pose!.y]).toEqual([-one.pose!.x, -one.pose!.y]);
  expect(other.ball!.x).toBeCloseTo(-one.ball!.x);
  expect(other.ball!.y).toBeCloseTo(-one.ball!.y);
});

test("the truth is what it is, whoever tells his own beliefs", () => {
  const scene = sceneOf(memoryOf({ "/truth/world": kTruth }), []);
  expect(scene.ball).toEqual({ x: 0.5, y: -1 });
  expect(scene.robots.map(({ name }) => name)).toEqual(["14/2"]);
  expect(scene.robots[0]).toMatchObject({ truth: { x: 1.1, y: 0.4, heading: 1.5 }, fallen: true, pose: undefined });
});

test("a belief that is a second older than the truth is none any more", () => {
  const values = { "/14/2/pose": kPose, "/truth/world": kTruth };
  expect(only(memoryOf(values, { "/14/2/pose": 9_500_000_000n })).pose).toBeDefined();
  expect(only(memoryOf(values, { "/14/2/pose": 8_900_000_000n })).pose).toBeUndefined();
});

test("the simulation says who plays at home and on which field", () => {
  const field = { length: 9, width: 6, border: 0.7, line_width: 0.05, penalty_area_length: 1.65, penalty_area_width: 4 };
  const simulation = { home: fields({ number: 14 }), field: fields(field) };
  const scene = sceneOf(memoryOf({ "/sim/state": simulation }), ["5/1", "14/2"]);
  expect(scene.robots.map(({ name, home }) => [name, home])).toEqual([["5/1", false], ["14/2", true]]);
  expect(scene.field).toMatchObject({ length: 9, width: 6, penaltyAreaWidth: 4 });
  expect(sceneOf(memoryOf({}), []).field).toEqual(kUsualField);
});

test("nothing, or nonsense, draws nothing", () => {
  expect(sceneOf(memoryOf({}), ["14/2"])).toMatchObject({ ball: undefined, robots: [{ truth: undefined, pose: undefined, ball: undefined }] });
  const nonsense = memoryOf({ "/truth/world": { ball: "round", robots: 7 }, "/14/2/pose": { x: NaN, y: 1 }, "/14/2/ball": {} });
  expect(sceneOf(nonsense, ["14/2"])).toMatchObject({ ball: undefined, robots: [{ pose: undefined, ball: undefined }] });
});

test("only what is offered is asked for", () => {
  expect(topicsOf(memoryOf({ "/14/2/pose": {}, "/truth/world": {} }), ["14/2", "5/1"])).toEqual(["/truth/world", "/14/2/pose"]);
});
