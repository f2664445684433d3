import { expect, test } from "vitest";
import { memoryWith } from "../memory/test_memory";
import type { Memory } from "../memory/memory";
import { fieldsOfJson } from "../memory/forecast";
import { believedBy } from "./believed";

const kNow = 10_000_000_000n;

/** Returns a memory of decoded values with one capture time. Times in ns stay integers. */
function memoryOf(values: Record<string, object>): Memory {
  const whole = (value: unknown): unknown =>
    value instanceof Map
      ? new Map(
          [...value].map(([name, part]) => [name, /_ns$/.test(String(name)) ? BigInt(part as number) : whole(part)]),
        )
      : Array.isArray(value)
        ? value.map(whole)
        : value;
  const get = (topic: string) =>
    values[topic] && { shown: { log_ns: kNow }, decoded: () => ({ fields: whole(fieldsOfJson(values[topic])) }) };
  return memoryWith({ get, age: () => 0 });
}

const kSeen = { seen_ns: 9_500_000_000 };
const kTold = {
  "/14/2/pose": { x: 1, y: 0.5, heading: Math.PI / 2, deviation_x: 0.1, deviation_y: 0.3 },
  "/14/2/ball": { x: 2, y: 0, deviation: 0.2, ...kSeen },
  "/14/2/team": {
    teammates: [{ player: 3, pose: { x: -1, y: 0, heading: 0 }, received_ns: 9_000_000_000 }],
    shared_ball: { x: -2, y: 1 },
  },
  "/14/2/opponents": {
    opponents: [
      { player: 4, x: 2, y: -1, deviation: 0.4, ...kSeen },
      { x: 2, y: 1, ...kSeen },
    ],
  },
};

test("an edit starts from the robot's own beliefs, in team_field for both attacking directions", () => {
  for (const attacks_positive_x of [true, false]) {
    const { ball, bodies } = believedBy(memoryOf({ ...kTold, "/14/2/game": { attacks_positive_x } }), "14/2", 0);
    expect(ball).toEqual({ x: expect.closeTo(1), y: expect.closeTo(2.5), deviation: 0.2 });
    expect(bodies.map(({ side, player, x, y, deviation }) => [side, player, x, y, deviation])).toEqual([
      ["own", 2, 1, 0.5, 0.3],
      ["own", 3, -1, 0, 0],
      ["opponent", 4, 2, -1, 0.4],
    ]);
    // opponents look towards our goal as a default
    expect(bodies.map(({ heading }) => Math.cos(heading))).toEqual([
      expect.closeTo(0),
      expect.closeTo(1),
      expect.closeTo(-1),
    ]);
    expect(Math.sin(bodies[0]!.heading)).toBeCloseTo(1);
  }
});

test("a ball that only the team saw is at the team's place, and without any message nothing is believed", () => {
  const { "/14/2/ball": _, ...others } = kTold;
  expect(believedBy(memoryOf(others), "14/2", 0).ball).toEqual({ x: -2, y: 1, deviation: 0 });
  expect(believedBy(memoryOf({}), "14/2", 0)).toEqual({ ball: undefined, bodies: [] });
});
