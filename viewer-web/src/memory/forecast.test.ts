import { expect, test } from "vitest";
import { chosenOf, fieldsOfJson, forecastOf } from "./forecast";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));

const kAnswer = {
  question: { opponent: "baseline", measure: "concede", until: "half", horizon: 20 },
  advice: "change",
  choice: "passing",
  reason: "changes to passing",
  strategies: [
    {
      strategy: "baseline",
      rollouts: 40,
      mean: -0.3,
      error: 0.05,
      raced_on: true,
      heat: [0, 1, 2, 3, 4, 5],
      heat_columns: 3,
      paths: [],
    },
    {
      strategy: "passing",
      rollouts: 40,
      mean: -0.1,
      gain: 0.2,
      gain_low: 0.1,
      gain_high: 0.3,
      best: 0.9,
      raced_on: true,
      paths: [{ spacing: 0.5, ball: [0, 0, 1, 2], robots: [{ player: 3, points: [1, 1] }] }],
    },
  ],
  answered_ms: 206,
  computed_ms: 90,
  simulated: 3600,
  models: "match",
  situation: {
    ball: { x: 1, y: 2, deviation: 0.3, elsewhere: 0.25 },
    own_score: 2,
    opponent_score: 1,
    seconds_remaining: 95,
    robots: [{ side: "opponent", player: 4, x: 3, y: -1, heading: 0.1, deviation: 0.2 }],
  },
};

test("the service's answer is read", () => {
  const forecast = forecastOf(fieldsOfJson(kAnswer));
  expect(forecast).toMatchObject({
    measure: "concede",
    until: "half",
    advice: "change",
    choice: "passing",
    horizon: 20,
    answeredMs: 206,
    models: "match",
  });
  expect(forecast.strategies[0]!.heat).toEqual({ columns: 3, counts: [0, 1, 2, 3, 4, 5] });
  expect(forecast.strategies[1]).toMatchObject({ gain: 0.2, gainLow: 0.1, gainHigh: 0.3, best: 0.9, racedOn: true });
  expect(forecast.strategies[1]!.paths).toEqual([
    {
      spacing: 0.5,
      ball: [
        { x: 0, y: 0 },
        { x: 1, y: 2 },
      ],
      robots: [{ player: 3, points: [{ x: 1, y: 1 }] }],
    },
  ]);
  expect(forecast).toMatchObject({ ballElsewhere: 0.25, standing: { score: [2, 1], remaining: 95 } });
  expect(forecast.situation).toEqual({
    ball: { x: 1, y: 2, deviation: 0.3 },
    bodies: [{ side: "opponent", player: 4, x: 3, y: -1, heading: 0.1, deviation: 0.2 }],
  });
});

test("the memory object gives the same forecast from its own field names", () => {
  const told = forecastOf(
    fields({
      question: fields({
        measure: new EnumValue(2, "MEASURE_CONCEDE"),
        until: new EnumValue(1, "UNTIL_NEXT_GOAL"),
        asked_by: "captain: the ball is lost",
      }),
      refusal: "nobody has seen the ball yet",
      advice: new EnumValue(1, "ADVICE_KEEP"),
      situation: fields({
        ball_x: 1,
        ball_y: 2,
        ball_deviation: 0.3,
        ball_elsewhere: 0.25,
        own_score: 2,
        opponent_score: 1,
        seconds_remaining: 95,
        bodies: [fields({ opponent: true, player: 4, x: 3, y: -1, heading: 0.1, deviation: 0.2 })],
      }),
    }),
  );
  expect(told).toMatchObject({
    measure: "concede",
    until: "next_goal",
    advice: "keep",
    askedBy: "captain: the ball is lost",
    reason: "nobody has seen the ball yet",
  });
  expect(forecastOf(fields({ question: fields({}) })).askedBy).toBe("the team's code");
  const { situation, ballElsewhere, standing } = forecastOf(fieldsOfJson(kAnswer));
  expect(told).toMatchObject({ situation, ballElsewhere, standing });
});

test("the named strategy is chosen, else the advised one, else the first", () => {
  const forecast = forecastOf(fieldsOfJson(kAnswer));
  expect(["baseline", "gone", ""].map((name) => chosenOf(forecast, name)?.name)).toEqual([
    "baseline",
    "passing",
    "passing",
  ]);
  expect(chosenOf({ ...forecast, choice: "" }, "")?.name).toBe("baseline");
  expect(chosenOf({ ...forecast, strategies: [] }, "")).toBeUndefined();
});

test("an invalid answer becomes an empty forecast and never throws", () => {
  for (const nonsense of [
    undefined,
    null,
    3,
    "x",
    [],
    [1],
    {},
    { question: [], strategies: [1, null, {}], situation: { robots: "no" }, advice: "constructor" },
    { strategies: [{ heat: [1, 2, 3], heat_columns: 2, paths: [{ ball: [1, "x", 2] }] }] },
  ]) {
    const forecast = forecastOf(fieldsOfJson(nonsense));
    expect(forecast.advice).toBe("none");
    expect(forecast.situation).toEqual({ ball: undefined, bodies: [] });
    expect([forecast.ballElsewhere, forecast.standing]).toEqual([0, undefined]);
    for (const { heat, paths } of forecast.strategies)
      expect([heat, paths.flatMap(({ ball }) => ball)]).toEqual([undefined, []]);
  }
});
