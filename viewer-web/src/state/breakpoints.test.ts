import { expect, test } from "vitest";
import { breakpointsOf, kMostBreakpoints, textOfBreakpoints } from "./breakpoints";

test("breakpoints are the same after writing and reading", () => {
  const kept = [
    { condition: "ball.x > 2", on: true },
    { condition: "distance(ball, truth.ball) > 0.5", on: false },
  ];
  expect(textOfBreakpoints(kept)).toBe("ball.x > 2;off:distance(ball, truth.ball) > 0.5");
  expect(breakpointsOf(textOfBreakpoints(kept))).toEqual(kept);
  expect(textOfBreakpoints([])).toBe("");
});

test("an address of any kind gives few and different breakpoints", () => {
  expect(breakpointsOf("")).toEqual([]);
  expect(breakpointsOf(";;off:; ")).toEqual([]);
  expect(breakpointsOf("a > 1; a > 1 ;off:a > 1")).toEqual([{ condition: "a > 1", on: true }]);
  expect(breakpointsOf("x".repeat(301))).toEqual([]);
  const many = Array.from({ length: 50 }, (_, i) => `ball.x > ${i}`).join(";");
  expect(breakpointsOf(many)).toHaveLength(kMostBreakpoints);
});
