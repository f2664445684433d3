import { expect, test, vi } from "vitest";
import { MemoryObject } from "./memory_object";
import { kPerceptChannel } from "./test_schema";

/** An object with messages `{ at }` of these capture times. */
function objectAt(...times_ns: bigint[]) {
  const object = new MemoryObject({ ...kPerceptChannel, encoding: "json" });
  for (const log_ns of times_ns) add(object, log_ns, { at: Number(log_ns) });
  return object;
}
const add = (object: MemoryObject, log_ns: bigint, value: object, arrived = 1) =>
  object.history.add({ log_ns, data: new TextEncoder().encode(JSON.stringify(value)), arrived });

test("the message nearest to a time is found, at most so far away", () => {
  const object = objectAt(100n, 200n);
  const near = object.near(160n, 50n)!;
  expect([near.log_ns, near.fields?.get("at")]).toEqual([200n, 200]);
  expect(object.near(140n, 50n)!.log_ns).toBe(100n);
  expect(object.near(160n, 30n)).toBeUndefined();
  expect(objectAt().near(160n, 30n)).toBeUndefined();
});

test("it stays decoded until another message is the nearest", () => {
  const object = objectAt(100n, 200n);
  const decode = vi.spyOn(object, "decode");
  const near = object.near(100n, 50n);
  expect(object.near(120n, 50n)).toBe(near);
  expect(decode).toHaveBeenCalledTimes(1);
  expect(object.near(200n, 50n)).not.toBe(near);
  expect(decode).toHaveBeenCalledTimes(2);
});

test("another message of the same time is decoded anew", () => {
  const object = objectAt(100n);
  object.near(100n, 50n);
  object.history.clear();
  add(object, 100n, { at: 7 }, 2);
  expect(object.near(100n, 50n)!.fields?.get("at")).toBe(7);
});

test("a message that cannot be decoded has a sentence", () => {
  const object = new MemoryObject(kPerceptChannel);
  object.history.add({ log_ns: 1n, data: new Uint8Array([255]), arrived: 0 });
  expect(object.near(1n, 0n)).toMatchObject({ log_ns: 1n, error: expect.any(String) });
});
