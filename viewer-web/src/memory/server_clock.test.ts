import { expect, test } from "vitest";
import { ServerClock } from "./server_clock";

const kStart_ns = 1_700_000_000_000_000_000n;
const serverTime = (seconds: number) => kStart_ns + BigInt(Math.round(seconds * 1e9));

test("the error of an age is the travel time of the fastest frame, however late the others are", () => {
  const clock = new ServerClock();
  const delays = [0.3, 0.02, 0.5, 0.004, 0.2, 0.09]; // [s]
  delays.forEach((delay, i) => clock.heard(serverTime(i), 100 + i + delay)); // our clock is 100 s ahead
  // captured at server time 4, asked for at server time 6
  expect(clock.age(serverTime(4), 106)).toBeCloseTo(2 - 0.004, 6);
});

test("a slow frame never makes data look younger or older than before", () => {
  const clock = new ServerClock();
  clock.heard(serverTime(0), 0);
  clock.heard(serverTime(1), 1.8);
  expect(clock.age(serverTime(1), 2)).toBeCloseTo(1, 6);
});

test("age grows with time and is never negative", () => {
  const clock = new ServerClock();
  clock.heard(serverTime(0), 0);
  expect(clock.age(serverTime(0), 1.5)).toBeCloseTo(1.5, 6);
  expect(clock.age(serverTime(9), 1.5)).toBe(0);
});

test("the clock follows a drift once the old frames leave the window", () => {
  const clock = new ServerClock();
  for (let i = 0; i <= 100; ++i) clock.heard(serverTime(i), i * 1.001);
  expect(clock.age(serverTime(100), 100.1)).toBeLessThan(0.04);
});

test("a server time that goes back is a seek and resets the clock", () => {
  const clock = new ServerClock();
  clock.heard(serverTime(500), 0);
  clock.heard(serverTime(3), 1);
  expect(clock.age(serverTime(3), 1)).toBe(0);
  expect(clock.age(serverTime(3), 2)).toBeCloseTo(1, 6);
});

test("without Time frames there is no age", () => {
  expect(new ServerClock().age(kStart_ns, 5)).toBeUndefined();
});
