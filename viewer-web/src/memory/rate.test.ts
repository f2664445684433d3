import { expect, test } from "vitest";
import { Rate } from "./rate";

const evenly = (hz: number, seconds: number) => {
  const rate = new Rate();
  for (let i = 0; i <= hz * seconds; ++i) rate.arrived(i / hz);
  return rate;
};

test("an even stream has exactly its rate, slow or fast, also between two arrivals", () => {
  for (const hz of [0.5, 1, 30, 100]) {
    const rate = evenly(hz, 20);
    for (const later of [0, 0.3, 0.99]) expect(rate.hz(20 + later / hz), `${hz} Hz`).toBeCloseTo(hz, 6);
  }
});

test("the rate of a stopped stream only falls, and is 0 once it is overdue", () => {
  const rate = evenly(30, 5);
  let before = rate.hz(5);
  for (let now = 5; now < 16; now += 0.1) {
    expect(rate.hz(now)).toBeLessThanOrEqual(before);
    before = rate.hz(now);
    expect(before === 0).toBe(rate.overdue(now));
    expect(rate.overdue(now)).toBe(now > 7);
  }
  expect(rate.interval()).toBeCloseTo(1 / 30, 6); // the earlier interval is still known
  expect(rate.silence(16)).toBeCloseTo(11, 6);
});

test("nothing is known before the first arrival", () => {
  const rate = new Rate();
  expect(rate.hz(1)).toBe(0);
  expect(rate.interval()).toBeUndefined();
  expect(rate.silence(1)).toBeUndefined();
});

test("a burst in one instant has no infinite rate", () => {
  const rate = new Rate();
  for (let i = 0; i < 5; ++i) rate.arrived(1);
  expect(rate.hz(1)).toBe(0);
  expect(rate.hz(2)).toBeCloseTo(4, 6);
});
