// Can a verdict of compare be believed? Intervals of real games cover the truth, a behaviour gains nothing over its equal, and a
// gain as large as the usual question is found.
//
// Coverage is of real games. Rates of verdicts are of tests on pairs drawn with replacement from these games.
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { compare as run } from "./comparisons.mjs";
import { pretty, Report } from "./report.mjs";

const program = fileURLToPath(new URL("../../build/release/bin/bench_verdicts", import.meta.url));

const kBetween = { between: [92, 98] };
const kTests = 4000; // on resampled pairs
const kApart = 1_000_000; // between the seeds of two runs

const kChances = ["align_first", "kick_now", "--from", "close_free", "--fuzz"];
// name, behaviours and metric, pairs of a run
const kGoals = ["goals of whole games", ["baseline", "kick_now"], 25];
const kMetrics = [
  ["score_within:30s", [...kChances, "--metric", "score_within:30s"], 100],
  ["ball_advance:30s", [...kChances, "--metric", "ball_advance:30s"], 100],
];

const percent = (part, whole) => (100 * part) / whole;

/** Returns the reports of `runs` runs with their own seeds, two at once. */
async function reportsOf(words, runs) {
  const reports = [];
  let next = 0;
  const work = async () => {
    while (next < runs) {
      const number = next++;
      reports[number] = (await run([...words, "--seed", 1 + number * kApart, "--jobs", 1])).report;
    }
  };
  await Promise.all([work(), work()]);
  return reports;
}

/** Returns how many intervals hold `truth`, in percent. */
const coverage = (intervals, truth) =>
  percent(intervals.filter(({ low, high }) => low <= truth && truth <= high).length, intervals.length);

/** Returns the pool of the runs' pairs: [gain in columns of the histogram, number]. */
const poolOf = (reports) =>
  reports[0].histogram.pairs.map((_, i) => [
    i - (reports[0].histogram.pairs.length - 1) / 2,
    reports.reduce((sum, { histogram }) => sum + histogram.pairs[i], 0),
  ]);

/** Coverage of the intervals of runs of a fixed length. The truth is the mean of all of them. */
async function fixed(report, [name, words, pairs], runs) {
  const reports = await reportsOf([...words, "--pairs", pairs], runs);
  const truth = reports.reduce((sum, { gain }) => sum + gain.mean, 0) / runs;
  report.figure(`${name}: mean of ${runs} runs of ${pairs} pairs`, truth);
  report.figure(
    `${name}: intervals that hold it`,
    coverage(
      reports.map(({ gain }) => gain),
      truth,
    ),
    "%",
    kBetween,
  );
  return { pool: poolOf(reports), truth };
}

/** Rates of sequential tests on resampled pairs, without a gain and with the gain of the usual question. */
function resampled(report, name, pool) {
  const input = pool.map((line) => line.join(" ")).join("\n");
  const { none, planted } = JSON.parse(execFileSync(program, [kTests], { input, encoding: "utf8" }));
  const of = (text) => `${name}, ${kTests} tests on resampled pairs: ${text}`;
  report.figure(of('verdicts "better" without a gain'), 100 * none.better, "%", { atMost: 5 });
  report.figure(of('verdicts "better" with the gain asked for'), 100 * planted.better, "%", { between: [90, 98] });
  report.figure(of("corrected intervals that hold 0, without a gain"), 100 * none.covered, "%", kBetween);
  report.figure(of("corrected intervals that hold the planted gain"), 100 * planted.covered, "%", kBetween);
  report.figure(of("pairs until the answer, without a gain"), none.pairs);
}

/** The usual question to moments, in real games until the answer: it found a true gain in 15 of 50 runs when it asked for 0.1. */
async function real(report, truth, runs) {
  const reports = await reportsOf([...kChances, "--metric", "score_within:30s"], runs);
  const better = reports.filter(({ verdict }) => verdict === "better").length;
  report.figure(`score_within:30s, ${runs} real tests of the usual question: "better"`, percent(better, runs), "%", {
    atLeast: 90,
  });
  report.figure(
    "score_within:30s, real tests: corrected intervals that hold the truth",
    coverage(
      reports.map(({ unbiased_gain, gain }) => unbiased_gain ?? gain),
      truth,
    ),
    "%",
    kBetween,
  );
  report.figure(
    "score_within:30s, real tests: pairs until the answer",
    reports.reduce((sum, { pairs }) => sum + pairs, 0) / runs,
  );
}

/** A behaviour against itself from a lopsided moment: neither side has an advantage. */
async function itself(report, runs) {
  const found = await reportsOf(
    ["--aa", "baseline", "--from", "close_free", "--metric", "score_within:30s", "--pairs", 100],
    runs,
  );
  report.figure(
    `a lopsided moment, ${runs} runs of --aa: intervals that hold 0`,
    coverage(
      found.map(({ unpaired }) => unpaired.home_advantage),
      0,
    ),
    "%",
    kBetween,
  );
}

/** Fixed runs, and tests on their pairs. Returns the truth. */
async function believe(report, metric, runs) {
  const { pool, truth } = await fixed(report, metric, runs);
  resampled(report, metric[0], pool);
  return truth;
}

export async function verdicts({ choices: runs = 200, games = 10_000 }) {
  const report = new Report("verdicts", "can a verdict of compare be believed?");
  const whole = Math.floor(games / (2 * kGoals[2]));
  console.log(`   spl2012, models match, ${pretty(runs)} runs of each kind, ${pretty(whole)} of whole games.`);
  const [truth] = [await believe(report, kMetrics[0], runs), await believe(report, kMetrics[1], runs)];
  await real(report, truth, Math.ceil(runs / 4));
  await itself(report, runs);
  if (whole > 1) await believe(report, kGoals, whole);
  return report.finish();
}
