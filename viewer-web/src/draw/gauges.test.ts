import { expect, test } from "vitest";
import { fieldsOfJson, forecastOf } from "../memory/forecast";
import { amount, axesOf, axisOf, percent, shareOf, size } from "./gauges";

test("an axis holds zero and all values, and is never of no length", () => {
  for (const values of [[], [0], [1, 2], [-3, -1], [-0.001, 0.002], [5, -5]]) {
    const axis = axisOf(values, 0.1);
    expect(axis.high - axis.low).toBeGreaterThanOrEqual(0.1);
    for (const value of [0, ...values]) {
      expect(shareOf(axis, value)).toBeGreaterThan(0);
      expect(shareOf(axis, value)).toBeLessThan(100);
    }
  }
  expect(shareOf({ low: 0, high: 1 }, 7)).toBe(100);
  expect(shareOf({ low: 0, high: 1 }, -7)).toBe(0);
});

test("strategies of which no future was played say nothing about the axes", () => {
  const strategies = [{ strategy: "a", rollouts: 10, mean: 0.2, error: 0.1 }, { strategy: "b", rollouts: 0, mean: 99, gain_high: 99 }];
  const { mean, gain } = axesOf(forecastOf(fieldsOfJson({ strategies })));
  expect(mean.high).toBeLessThan(0.5);
  expect(gain.high).toBeLessThan(0.5);
});

test("gains are goals or chances, zero has no sign", () => {
  expect([0.125, -0.05, 0, -0.0001].map((value) => amount("goal_difference", value))).toEqual(["+0.125", "−0.050", "0.000", "0.000"]);
  expect([0.125, -0.05].map((value) => amount("score_next", value))).toEqual(["+12.5 %", "−5.0 %"]);
  expect([size("goal_difference", 0.05), size("concede", 0.012)]).toEqual(["0.050", "1.2 %"]);
  expect([0, 0.001, 0.62, 1].map(percent)).toEqual(["0 %", "< 1 %", "62 %", "100 %"]);
});
