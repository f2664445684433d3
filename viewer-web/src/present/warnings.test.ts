import { expect, test } from "vitest";
import { memoryWith } from "../memory/test_memory";
import { Memory } from "../memory/memory";
import { kPerceptChannel, percept } from "../memory/test_schema";
import type { Value } from "../memory/value";
import { warningOf } from "./warnings";

const kTopic = kPerceptChannel.topic;
const kStart_ns = 1_700_000_000_000_000_000n;
const at_ns = (seconds: number) => kStart_ns + BigInt(Math.round(seconds * 1e9));

/** Ten seconds of an object at 10 Hz that takes `delay` [s] to arrive. */
function flowing(delay: number) {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  memory.subscribed(kTopic, true);
  for (let i = 0; i <= 100; ++i) {
    memory.clock.heard(at_ns(i / 10), i / 10);
    memory.arrived(kTopic, at_ns(i / 10 - delay), percept(), i / 10);
  }
  return memory;
}
const warning = (memory: Memory, now: number, dropped = { inside: 0, recording: 0, viewers: 0 }) =>
  warningOf(memory.get(kTopic)!, { rate_hz: 10, sequence: 1, dropped }, memory, now);

test("an even, timely flow gives no warning, and neither do messages that a viewer skipped", () => {
  expect(warning(flowing(0.1), 10)).toBeUndefined();
  expect(warning(flowing(0.1), 10, { inside: 0, recording: 0, viewers: 99 })).toBeUndefined();
});

test("silence, loss and lateness each have their sentence", () => {
  expect(warning(flowing(0), 14)).toBe("percept has been silent for 4.00 s; before, it came at 10.0 Hz.");
  expect(warning(flowing(0), 10, { inside: 1, recording: 0, viewers: 0 })).toMatch("missed 1 message of percept");
  expect(warning(flowing(0), 10, { inside: 1, recording: 7, viewers: 0 })).toMatch("The recording lost 7 messages");
  expect(warning(flowing(1.5), 10)).toMatch("percept arrives 1.50 s late");
});

test("one old value is no late flow", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  memory.clock.heard(at_ns(100), 0);
  memory.arrived(kTopic, at_ns(3), percept(), 0);
  expect(warning(memory, 0.1)).toBeUndefined();
});

test("the silence of a penalised robot or of a paused game is no fault", () => {
  const memory = flowing(0);
  expect(warning(memory, 14)).toMatch("silent");
  const [, team, player] = /^\/(\d+)\/(\d+)\//.exec(kTopic)!;
  const told = (penalised: boolean) => {
    const players = [...Array(Number(player)).keys()].map(
      (i) => new Map<string, Value>([["penalised", penalised && i === Number(player) - 1]]),
    );
    const game = new Map<string, Value>([
      ["own_player", Number(player)],
      ["own", new Map<string, Value>([["players", players]])],
    ]);
    const get = (topic: string) =>
      topic === `/${team}/${player}/game` ? { decoded: () => ({ fields: game }) } : undefined;
    return memoryWith({ get, age: () => undefined });
  };
  const object = memory.get(kTopic)!;
  expect(warningOf(object, undefined, told(true), 14)).toBeUndefined();
  expect(warningOf(object, undefined, told(false), 14)).toMatch("silent");
  object.moment.still = true; // as Memory.reached() sets it
  expect(warning(memory, 14)).toBeUndefined();
});
