import { expect, test } from "vitest";
import { Played } from "./played";

const kSecond = 1_000_000_000n;

test("the playhead advances at the reported speed while playing, and stays while paused", () => {
  const played = new Played(0n, 100n * kSecond);
  expect(played.known).toBe(false);
  played.told({ status: "playing", time_ns: 10n * kSecond, speed: 2 }, 5);
  expect(played.at(5.5)).toBe(11n * kSecond);
  played.heard(12n * kSecond, 6);
  expect(played.at(6)).toBe(12n * kSecond);
  played.told({ status: "paused", time_ns: 13n * kSecond, speed: 2 }, 7);
  expect([played.at(7), played.at(9000)]).toEqual([13n * kSecond, 13n * kSecond]);
  expect(played.known).toBe(true);
});

test("the playhead never leaves the recording", () => {
  const played = new Played(50n * kSecond, 60n * kSecond);
  expect(played.at(0)).toBe(50n * kSecond);
  played.told({ status: "playing", time_ns: 59n * kSecond, speed: 20 }, 0);
  expect(played.at(100)).toBe(60n * kSecond);
  expect([played.within(0n), played.within(55n * kSecond)]).toEqual([50n * kSecond, 55n * kSecond]);
});
