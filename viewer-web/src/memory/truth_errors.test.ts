import { expect, test } from "vitest";
import { truthOf, type Truth } from "./truth";
import { pairsOf, TruthErrors } from "./truth_errors";

const at = (x: number, y: number) => new Map(Object.entries({ x, y }));
const truth = (robots: [number, number][], ball?: [number, number]): Truth =>
  truthOf(new Map(Object.entries({ robots: robots.map(([x, y]) => at(x, y)), ball: ball && at(...ball) })));

test("each thing belongs to at most one pair, the nearest first, and none is far away", () => {
  const found = truth([
    [0, 0],
    [0.2, 0],
    [3, 0],
  ]).robots;
  const pairs = pairsOf(found, truth([[0.15, 0]]).robots);
  expect(pairs.map(({ found: one, away }) => [one.x, away])).toEqual([[0.2, expect.closeTo(0.05)]]);
});

test("pairs do not depend on the order of the things", () => {
  const [found, real] = [
    truth([
      [0, 0],
      [0.3, 0],
      [2, 1],
    ]).robots,
    truth([
      [0.25, 0.1],
      [2, 1.1],
      [0.05, 0],
    ]).robots,
  ];
  const total = (some: typeof found) => pairsOf(some, real).reduce((sum, { away }) => sum + away, 0);
  expect(total([...found].reverse())).toBeCloseTo(total(found));
});

test("the means are those of the last three seconds, of each time once", () => {
  const errors = new TruthErrors();
  expect(errors.means).toEqual({ robots: NaN, ball: NaN });
  errors.add(1_000_000_000n, truth([[0, 0]], [1, 1]), truth([[0.4, 0]], [1, 1.1]));
  errors.add(4_500_000_000n, truth([[0, 0]]), truth([[0.02, 0]]));
  errors.add(4_500_000_000n, truth([[0, 0]]), truth([[0.2, 0]]));
  expect(errors.means.robots).toBeCloseTo(0.02);
  expect(errors.means.ball).toBeNaN();
});

test("a time that goes back begins anew", () => {
  const errors = new TruthErrors();
  errors.add(9_000_000_000n, truth([[0, 0]]), truth([[0.4, 0]]));
  errors.add(8_000_000_000n, truth([[0, 0]]), truth([[0.1, 0]]));
  expect(errors.means.robots).toBeCloseTo(0.1);
});
