import { expect, test } from "vitest";
import { MemoryObject } from "./memory_object";
import { kPerceptChannel, percept } from "./test_schema";
import { Trail } from "./trail";
import { numberOf } from "./value";

test("a trail has the last seconds up to the shown moment, and decodes each message once", () => {
  const moment: { ns: bigint | undefined } = { ns: undefined };
  const object = new MemoryObject(kPerceptChannel, moment);
  let read = 0;
  const trail = new Trail(object, (fields) => (++read, numberOf(fields, "x")));
  expect(trail.points(2)).toEqual([]);
  const add = (i: number) => {
    const log_ns = (BigInt(i) * 1_000_000_000n) / 10n;
    object.arrived(log_ns, percept({ x: i }), i / 10);
    object.history.add(object.newest!);
  };
  for (let i = 0; i < 100; ++i) add(i);
  expect(trail.points(2)).toEqual(Array.from({ length: 20 }, (_, i) => 80 + i));
  const before = read;
  add(100);
  trail.points(2);
  expect(read).toBe(before + 1);
  moment.ns = 5_000_000_000n;
  expect(trail.points(1)).toEqual([41, 42, 43, 44, 45, 46, 47, 48, 49, 50]);
  object.history.clear();
  expect(trail.points(1)).toEqual([]);
});
