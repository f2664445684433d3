// The laws of the benches' statistics.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  binomialInterval,
  differenceOf,
  equivalence,
  exponentOf,
  interval,
  meanOf,
  numbers,
  poissonInterval,
} from "./statistics.mjs";

const take = (count, source) => Array.from({ length: count }, () => source.next().value);
const near = (value, expected, by) =>
  assert.ok(Math.abs(value - expected) <= by, `${value} is not ${expected} ± ${by}`);

test("a mean moves and stretches with its values, its error only stretches", () => {
  const values = take(50, numbers(1));
  const plain = meanOf(values);
  const moved = meanOf(values.map((value) => 3 * value + 7));
  near(moved.mean, 3 * plain.mean + 7, 1e-12);
  near(moved.error, 3 * plain.error, 1e-12);
});

test("four times as many values halve the error", () => {
  const values = take(4000, numbers(2));
  near(meanOf(values.slice(0, 1000)).error / meanOf(values).error, 2, 0.1);
  near(meanOf(values).error, Math.sqrt(1 / 12 / 4000), 1e-4);
});

test("one value has an infinite error", () => {
  assert.equal(meanOf([3]).error, Infinity);
  assert.equal(equivalence(meanOf([0]), 1e9).equivalent, false);
});

test("95 % intervals hold the true mean in 95 of 100 samples, 90 % ones in 90", () => {
  const source = numbers(3);
  const holding = { 90: 0, 95: 0 };
  for (let sample = 0; sample < 1000; ++sample) {
    const found = meanOf(take(100, source));
    for (const percent of [90, 95]) {
      const [from, to] = interval(found, percent);
      if (from <= 0.5 && 0.5 <= to) holding[percent] += 1;
    }
  }
  near(holding[90] / 1000, 0.9, 0.03);
  near(holding[95] / 1000, 0.95, 0.02);
});

test("the same seed for both gives no difference", () => {
  const luck = take(30, numbers(4));
  const found = differenceOf(
    luck.map((value) => value + 0.25),
    luck,
  );
  near(found.mean, 0.25, 1e-12);
  near(found.error, 0, 1e-12);
});

test("two means are equivalent only if the whole interval is within the margin", () => {
  assert.equal(equivalence({ mean: 0.05, error: 0.05 }, 0.15).equivalent, true);
  assert.equal(equivalence({ mean: 0.1, error: 0.05 }, 0.15).equivalent, false);
  assert.equal(equivalence({ mean: 0, error: 0.1 }, 0.15).equivalent, false);
  const [above, below] = [0.06, -0.06].map((mean) => equivalence({ mean, error: 0.02 }, 1).farthest);
  assert.equal(above, below);
});

test("powers are found whatever their factor", () => {
  for (const exponent of [0.5, 1, 2])
    for (const factor of [0.01, 40])
      near(exponentOf([3, 4, 5, 6, 7].map((x) => [x, factor * x ** exponent])), exponent, 1e-12);
});

test("exact intervals of counts are those of the tables", () => {
  const about = (found, wanted) => wanted.forEach((value, i) => near(found[i], value, 5e-4));
  about(poissonInterval(0), [0, 3.6889]);
  about(poissonInterval(2), [0.2422, 7.2247]);
  about(poissonInterval(10), [4.7954, 18.3904]);
  about(binomialInterval(0, 128), [0, 0.0284]);
  about(binomialInterval(5, 10), [0.1871, 0.8129]);
  about(binomialInterval(10, 10), [0.6915, 1]);
});
