import { expect, test } from "vitest";
import { Memory } from "../memory/memory";
import { Played } from "../memory/played";
import type { PlaybackWish } from "../source/frames";
import { kSecond } from "./test_time";
import { ask, release, show } from "./time_effects";

/** A server with a recording of 100 s, or a live robot, that keeps its orders. */
function server(recorded: boolean, at = 0n) {
  const orders: (PlaybackWish | { stand: bigint })[] = [];
  return {
    orders,
    memory: new Memory(),
    played: recorded ? new Played(0n, 100n * kSecond) : undefined,
    place: () => at,
    goes: false,
    asked: false,
    stand: (at_ns: bigint) => void orders.push({ stand: at_ns }),
    ask: (wish: PlaybackWish) => void orders.push(wish),
  };
}
const shownBy = (...servers: ReturnType<typeof server>[]) => ({ servers, shiftOf: () => 2n * kSecond });

test("each server shows the moment by its own clock: a robot from the page's memory, a recording at its server", () => {
  const [robot, recording] = [server(false), server(true)];
  show(shownBy(robot, recording), 5n * kSecond);
  expect(robot.memory.moment_ns).toBe(7n * kSecond);
  expect(recording.orders).toEqual([{ stand: 7n * kSecond }]);
  show(shownBy(recording), 500n * kSecond);
  expect(recording.orders.at(-1)).toEqual({ stand: 100n * kSecond });
});

test("a recording that shows the moment, or is paused there, gets no order", () => {
  const [shows, paused] = [server(true), server(true, 7n * kSecond)];
  shows.memory.show(7n * kSecond);
  show(shownBy(shows, paused), 5n * kSecond);
  expect([shows.orders, paused.orders]).toEqual([[], []]);
  const going = { ...server(true, 7n * kSecond), goes: true };
  show(shownBy(going), 5n * kSecond);
  expect(going.orders).toEqual([{ stand: 7n * kSecond }]);
});

test("a wish goes to all recordings, and robots show their newest data", () => {
  const [robot, recording] = [server(false), server(true)];
  robot.memory.show(3n);
  ask(shownBy(robot, recording), { do: "ask", play: true, speed: 2, seek_ns: 5n * kSecond });
  ask(shownBy(robot, recording), { do: "ask", play: false, speed: 1, seek_ns: undefined });
  expect(recording.orders).toEqual([
    { play: true, speed: 2, seek_ns: 7n * kSecond },
    { play: false, speed: 1, seek_ns: undefined },
  ]);
  expect(robot.memory.moment_ns).toBeUndefined();
});

test("released servers show their newest data", () => {
  const robot = server(false);
  robot.memory.show(3n);
  release(shownBy(robot));
  expect(robot.memory.moment_ns).toBeUndefined();
});
