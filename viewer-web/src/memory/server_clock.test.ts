import { expect, test } from "vitest";
import { ServerClock } from "./server_clock";

const kStart_ns = 1_700_000_000_000_000_000n;
const serverTime = (seconds: number) => kStart_ns + BigInt(Math.round(seconds * 1e9));

test("age is known to the fastest frame's travelling time, however late the others were", () => {
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

test("age grows as time goes by and is never negative", () => {
  const clock = new ServerClock();
  clock.heard(serverTime(0), 0);
  expect(clock.age(serverTime(0), 1.5)).toBeCloseTo(1.5, 6);
  expect(clock.age(serverTime(9), 1.5)).toBe(0);
});

test("it follows a drift once the old frames leave the window", () => {
  const clock = new ServerClock();
  for (let i = 0; i <= 100; ++i) clock.heard(serverTime(i), i * 1.001);
  expect(clock.age(serverTime(100), 100.1)).toBeLessThan(0.04);
});

test("a server time that goes back is a seek: what was learnt is void", () => {
  const clock = new ServerClock();
  clock.heard(serverTime(500), 0);
  clock.heard(serverTime(3), 1);
  expect(clock.age(serverTime(3), 1)).toBe(0);
  expect(clock.age(serverTime(3), 2)).toBeCloseTo(1, 6);
});

test("without Time frames no age is claimed", () => {
  expect(new ServerClock().age(kStart_ns, 5)).toBeUndefined();
});
