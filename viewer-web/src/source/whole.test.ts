import { expect, test } from "vitest";
import { eventsIn, numbersIn, runsIn } from "./whole";

test("events of a whole recording are read, and those without a time are left out", () => {
  const event = { at: "1700000000000000007", kind: "goal", text: "goal of team 14", robot: "14/2" };
  expect(eventsIn({ events: [event, { ...event, at: 7 }, { ...event, at: "-1" }, null, "x", { at: "9" }] })).toEqual([
    { log_ns: 1700000000000000007n, kind: "goal", text: "goal of team 14", robot: "14/2" },
    { log_ns: 9n, kind: "", text: "", robot: "" },
  ]);
  expect(eventsIn({})).toEqual([]);
});

test("summaries of numbers are read; null is an interval without a value", () => {
  const fields = [
    { field: "/14/2/ball.x", least: [1, null], most: [3, null], mean: [2, null] },
    { field: "/14/2/y.z", problem: "topic '/14/2/y' is not played" },
    { field: "/14/2/odd", least: [1, 2, 3], most: [1], mean: ["a", 2] },
  ];
  const [ball, y, odd] = numbersIn({ from: "5", step_ns: 10, fields });
  expect(ball).toEqual({
    field: "/14/2/ball.x",
    from_ns: 5n,
    step_ns: 10,
    least: Float64Array.of(1, NaN),
    most: Float64Array.of(3, NaN),
    mean: Float64Array.of(2, NaN),
    problem: "",
  });
  expect([y!.problem, y!.least.length]).toEqual(["topic '/14/2/y' is not played", 0]);
  expect(odd!.mean).toEqual(Float64Array.of(NaN)); // lists of different lengths are cut
  for (const bad of [
    {},
    { from: "5" },
    { from: "5", step_ns: 0 },
    { from: 5, step_ns: 1 },
    { from: "5", step_ns: "1" },
  ])
    expect(() => numbersIn({ ...bad, fields })).toThrow("does not say its time");
});

test("runs are read with their words, and wrong ones are left out", () => {
  const answer = {
    from: "1000",
    words: ["stand", "striker"],
    runs: [[0, 5, 0, 1], [5, 2, 1, 9], ["a", 1], [7], null, [-1, 2]],
  };
  expect(runsIn(answer)).toEqual([
    { from_ns: 1000n, to_ns: 1005n, words: ["stand", "striker"] },
    { from_ns: 1005n, to_ns: 1007n, words: ["striker", ""] },
  ]);
  expect(() => runsIn({ runs: [] })).toThrow("do not say their time");
});
