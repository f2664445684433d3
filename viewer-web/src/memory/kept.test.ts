import { expect, test } from "vitest";
import { isKept, nearestKept, nearestOf, placesOf } from "./kept";
import { Memory } from "./memory";

const kChannel = { id: 1, topic: "", encoding: "json", schemaName: "", schema: "", schemaEncoding: "", metadata: {} };
const second = (count: number) => BigInt(Math.round(count * 1000)) * 1_000_000n;

/** A robot whose pose came in the seconds 10 to 12 and 40 to 42, and its game state all the time. */
function gappy(): Memory {
  const memory = new Memory();
  for (const [id, object] of ["pose", "game"].entries()) memory.offer({ ...kChannel, id, topic: `/14/2/${object}` });
  for (let i = 10; i <= 42; i += 0.5) {
    memory.arrived("/14/2/game", second(i), new Uint8Array(), i);
    if (i <= 12 || i >= 40) memory.arrived("/14/2/pose", second(i), new Uint8Array(), i);
  }
  return memory;
}

test("a moment has data if a place was captured at most two seconds before it", () => {
  const memory = gappy();
  const topics = placesOf(memory, ["14/2"]);
  expect(topics).toEqual(["/14/2/pose"]);
  const kept = (at: number) => (memory.show(second(at)), isKept(memory, topics, second(at)));
  expect([9, 10, 12, 14, 14.001, 30, 39.9, 40, 42].map(kept)).toEqual([
    false,
    true,
    true,
    true,
    false,
    false,
    false,
    true,
    true,
  ]);
});

test("the nearest moment with data is before or after, whichever is nearer", () => {
  const memory = gappy();
  const nearest = (at: number) => nearestKept(memory, ["/14/2/pose"], second(at));
  expect([5, 20, 27, 99].map(nearest)).toEqual([second(10), second(12), second(40), second(42)]);
  expect(nearestKept(memory, [], second(20))).toBeUndefined();
  expect(nearestKept(memory, ["/14/2/ball"], second(20)), "no such topic").toBeUndefined();
});

test("of two equally near times the earlier one is the nearest", () => {
  expect(nearestOf([30n, undefined, 10n], 20n)).toBe(10n);
  expect(nearestOf([10n, 30n], 20n)).toBe(10n);
  expect(nearestOf([undefined], 20n)).toBeUndefined();
});
