import { expect, test } from "vitest";
import { fieldsOfJson } from "./forecast";
import { forecastScoresOf, strategyOf } from "./forecast_score";

const bins = (at: number, forecasts: number, came: number, foretold: number) =>
  Array.from({ length: 10 }, (_, i) =>
    i === at ? { forecasts, came, foretold } : { forecasts: 0, came: 0, foretold: 0 },
  );
const event = (came: number, brier: number, at: number, forecasts: number, foretold: number) => ({
  came,
  brier,
  log_loss: 2 * brier,
  bins: bins(at, forecasts, came, foretold),
});

test("the scores of all strategies and horizons come first, then one per strategy and horizon", () => {
  const scores = forecastScoresOf(
    fieldsOfJson({
      entries: [
        {
          strategy: "baseline",
          horizon: 30,
          forecasts: 30,
          score: event(9, 0.2, 3, 30, 0.3),
          concede: event(0, 0.01, 0, 30, 0.05),
        },
        {
          strategy: "passing",
          horizon: 30,
          forecasts: 10,
          score: event(5, 0.4, 3, 10, 0.34),
          concede: event(2, 0.09, 0, 10, 0.05),
        },
      ],
    }),
  );
  expect(scores.map(({ name, score }) => [name, score.forecasts])).toEqual([
    ["all", 40],
    ["baseline, 30 s", 30],
    ["passing, 30 s", 10],
  ]);
  expect(scores[2]!.score.score.brier).toBeCloseTo(0.4);
  const { score } = scores[0]!;
  expect(score.forecasts).toBe(40);
  expect(score.score.came).toBe(14);
  expect(score.score.brier).toBeCloseTo(0.25);
  expect(score.score.brierOfRate).toBeCloseTo(0.35 * 0.65);
  expect(score.score.bins).toHaveLength(1);
  expect(score.score.bins[0]).toMatchObject({ forecasts: 40, came: 0.35 });
  expect(score.score.bins[0]!.foretold).toBeCloseTo(0.31);
  expect(score.score.bins[0]!.error).toBeCloseTo(Math.sqrt((0.35 * 0.65) / 40));
  expect(score.concede.brier).toBeCloseTo(0.03);
  expect(score.concede.logLoss).toBeCloseTo(0.06);
});

test("with a single strategy and horizon there is only the common score", () => {
  const entries = [
    {
      strategy: "baseline",
      horizon: 30,
      forecasts: 1,
      score: event(1, 0.2, 3, 1, 0.3),
      concede: event(0, 0.01, 0, 1, 0.05),
    },
  ];
  expect(forecastScoresOf(fieldsOfJson({ entries })).map(({ name }) => name)).toEqual(["all"]);
});

test("before the first scored forecast there is no score, and without the object no strategy", () => {
  expect(forecastScoresOf(new Map())).toEqual([]);
  expect(forecastScoresOf(fieldsOfJson({ entries: [], open: 3 }))).toEqual([]);
  expect(strategyOf(new Map())).toBeUndefined();
  expect(strategyOf(fieldsOfJson({ name: "passing", chosen: true, captain: 2 }))).toEqual({
    name: "passing",
    chosen: true,
    captain: 2,
  });
});
