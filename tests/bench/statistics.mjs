// Quantiles, confidence of means, equivalence, powers of growth; and random numbers that are the same every time.

const kNormal = { 90: 1.6449, 95: 1.96 }; // two-sided, for samples of dozens and more

/** Mean and its standard error; of a single value the error is infinite. */
export function meanOf(values) {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return { mean, error: values.length < 2 ? Infinity : Math.sqrt(squares / (values.length - 1) / values.length) };
}

/** The value below which `part` of all lie, 0 .. 1. */
export const quantile = (values, part) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];

/** Returns mean and standard error of a - b, game by game. Both games of a pair have one seed, which cancels common luck. */
export const differenceOf = (a, b) => meanOf(a.map((value, i) => value - b[i]));

/** Returns the confidence interval [from, to] of the mean. */
export const interval = ({ mean, error }, percent) => [
  mean - kNormal[percent] * error,
  mean + kNormal[percent] * error,
];

/**
 * Equivalent: two one-sided tests at 5 %. The 90 % interval lies within ± margin; `farthest` is its end that is farther
 * from 0.
 */
export function equivalence(difference, margin) {
  const [from, to] = interval(difference, 90);
  const farthest = Math.max(Math.abs(from), Math.abs(to));
  return { from, to, farthest, equivalent: farthest <= margin };
}

/** k of y ≈ c·x^k, by least squares of the logarithms. */
export function exponentOf(points) {
  const logs = points.map((point) => point.map(Math.log));
  const x = meanOf(logs.map(([each]) => each)).mean;
  const y = meanOf(logs.map(([, each]) => each)).mean;
  const covariance = logs.reduce((sum, [logX, logY]) => sum + (logX - x) * (logY - y), 0);
  return covariance / logs.reduce((sum, [logX]) => sum + (logX - x) ** 2, 0);
}

/** Numbers in [0, 1) that look random and are the same every time. */
export function* numbers(seed) {
  for (let state = seed >>> 0; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}

/** Returns the root of a falling function between `from` and `to`. */
function rootOfFalling(f, from, to) {
  for (let i = 0; i < 200; ++i) {
    const middle = (from + to) / 2;
    if (f(middle) > 0) from = middle;
    else to = middle;
  }
  return (from + to) / 2;
}

/** P(X <= count) of a Poisson distribution. */
function poissonAtMost(count, mean) {
  let term = Math.exp(-mean);
  let sum = term;
  for (let k = 1; k <= count; ++k) sum += term *= mean / k;
  return sum;
}

/** P(X <= count) of a binomial distribution. */
function binomialAtMost(count, trials, share) {
  if (share <= 0) return 1;
  if (share >= 1) return count >= trials ? 1 : 0;
  let log = trials * Math.log1p(-share);
  let sum = Math.exp(log);
  for (let k = 1; k <= count; ++k) {
    log += Math.log(((trials - k + 1) / k) * (share / (1 - share)));
    sum += Math.exp(log);
  }
  return sum;
}

/** Returns the exact 95 % interval [from, to] of the mean of a Poisson distribution that gave `count`. */
export function poissonInterval(count) {
  const far = count + 10 * Math.sqrt(count + 1) + 20;
  const to = rootOfFalling((mean) => poissonAtMost(count, mean) - 0.025, 0, far);
  const from = count === 0 ? 0 : rootOfFalling((mean) => poissonAtMost(count - 1, mean) - 0.975, 0, far);
  return [from, to];
}

/** Returns the exact 95 % interval [from, to] of a share of which `count` of `trials` were seen (Clopper and Pearson). */
export function binomialInterval(count, trials) {
  const to = count === trials ? 1 : rootOfFalling((share) => binomialAtMost(count, trials, share) - 0.025, 0, 1);
  const from = count === 0 ? 0 : rootOfFalling((share) => binomialAtMost(count - 1, trials, share) - 0.975, 0, 1);
  return [from, to];
}
