import { expect, test } from "vitest";
import { fieldsOfJson, forecastOf } from "../memory/forecast";
import { amount, axesOf, axisOf, headline, isNothing, percent, reach, shareOf, size } from "./gauges";

test("an axis holds zero and all values, and always has a length", () => {
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

test("strategies without rollouts do not change the axes", () => {
  const strategies = [
    { strategy: "a", rollouts: 10, mean: 0.2, error: 0.1 },
    { strategy: "b", rollouts: 0, mean: 99, gain_high: 99 },
  ];
  const { mean, gain } = axesOf(forecastOf(fieldsOfJson({ strategies })));
  expect(mean.high).toBeLessThan(0.5);
  expect(gain.high).toBeLessThan(0.5);
});

test("gains are goals or chances, zero has no sign", () => {
  expect([0.125, -0.05, 0, -0.0001].map((value) => amount("goal_difference", value))).toEqual([
    "+0.125",
    "−0.050",
    "0.000",
    "0.000",
  ]);
  expect([0.125, -0.05].map((value) => amount("score_next", value))).toEqual(["+12.5 %", "−5.0 %"]);
  expect([size("goal_difference", 0.05), size("concede", 0.012)]).toEqual(["0.050", "1.2 %"]);
  expect([0, 0.001, 0.62, 1].map(percent)).toEqual(["0 %", "< 1 %", "62 %", "100 %"]);
});

test("a gain that would be written as zeros is nothing", () => {
  const nothing = { gain: 0, gainLow: -0.0004, gainHigh: 0.0004 };
  expect(isNothing("goal_difference", nothing)).toBe(true);
  expect(isNothing("goal_difference", { ...nothing, gainHigh: 0.001 })).toBe(false);
  expect(isNothing("concede", { ...nothing, gainLow: -0.01 })).toBe(false);
});

test("the horizon is shown in seconds, and a long one in minutes", () => {
  const words = [
    ["horizon", 30],
    ["horizon", 12.5],
    ["horizon", 600],
    ["next_goal", 30],
    ["half", 542],
    ["game", 1142],
    ["half", 42.04],
  ] as const;
  expect(words.map(([until, horizon]) => reach({ until, horizon }))).toEqual([
    "30 s ahead",
    "12.5 s ahead",
    "10:00 ahead",
    "to the next goal, 30 s at most",
    "to the end of the half, 9:02",
    "to the end of the game, 19:02",
    "to the end of the half, 42 s",
  ]);
});

test("only the played strategy is kept or left; otherwise the advice is a comparison", () => {
  const { strategies } = forecastOf(fieldsOfJson({ strategies: [{ strategy: "baseline" }, { strategy: "passing" }] }));
  const words = (advice: "keep" | "change" | "none", choice: string, plays: string) =>
    headline({ advice, choice, strategies }, plays);
  expect([
    words("keep", "baseline", "baseline"),
    words("change", "passing", "baseline"),
    words("keep", "baseline", ""),
  ]).toEqual(["Keep baseline", "Change to passing", "Keep baseline"]);
  expect([words("keep", "baseline", "passing"), words("change", "passing", "kick_now")]).toEqual([
    "Nothing clearly beats baseline",
    "passing beats baseline",
  ]);
  expect(words("none", "baseline", "passing")).toBe("No advice");
});
