// Does foresight answer in time, foretell what comes, leave the robot alone, and win games?
import { spawn } from "node:child_process";
import { join } from "node:path";
import { Live } from "../e2e/live.mjs";
import { compare as run } from "./comparisons.mjs";
import { atEnd, scratch, sleep, start, startRobot } from "./programs.mjs";
import { median, pretty, Report } from "./report.mjs";
import { rightChoice } from "./right_choice.mjs";

const kBudgets = [50, 200, 1000]; // [ms]
const kLate = 20; // [ms]

/** Programs that compute as much as they can. */
function occupy(cores) {
  const hogs = Array.from({ length: cores }, () => spawn(process.execPath, ["-e", "for (;;);"]));
  const free = () => hogs.forEach((hog) => hog.kill("SIGKILL"));
  atEnd(free);
  return free;
}

const situation = async (...args) => {
  const began = performance.now();
  const told = JSON.parse(await start("foresight-sim", ["situation", "near_pressed", "--json", ...args]).output);
  return { told, seconds: (performance.now() - began) / 1000 };
};

/**
 * What a question takes on one core with so many rollouts of each strategy: the time of many less that of few, so that
 * the program's start does not count. Returns how many rollouts a second has.
 */
async function speed(report) {
  const three = ["--strategies", "baseline", "passing", "kick_now", "--rules", "spl2025:5"];
  const cost = async (seconds, rollouts, ...more) => {
    const ask = (count) => situation(...three, "--seconds", seconds, "--rollouts", count, ...more);
    const few = await ask(24);
    const many = await ask(24 + rollouts);
    return many.seconds - few.seconds;
  };
  const seconds = median([await cost(30, 200), await cost(30, 200), await cost(30, 200)]);
  report.figure("3 x 200 rollouts of 30 s, 5 a side, match", 1000 * seconds, "ms", { atMost: 100 });
  report.figure("3 x 100 rollouts to the end of the half", await cost(600, 100, "--until", "half"), "s", { atMost: 2.5 });
  return 600 / seconds; // rollouts per second
}

/** A robot in a simulated game, asked again and again while both cores compute something else. */
async function deadline(report, questions) {
  const robot = start("foresight-robot", ["--body", "sim", "--port", 0, "--no-foresight", "--loop", "--state-dir", join(scratch, "state"), "--log-dir", join(scratch, "logs")]);
  const port = /:(\d+)/.exec(await robot.address)[1];
  const live = await Live.open({ after: atEnd }, { port });
  await live.call("/sim/step", { ticks: 1800 });
  const free = occupy(2);
  for (const budget of kBudgets) {
    const late = [];
    let without = 0;
    for (let i = 0; i < Math.ceil(questions / kBudgets.length); ++i) {
      const answer = await live.call("/foresight/what_if", { budget_ms: budget, horizon: 20 });
      if (!answer.ok || answer.forecast.refusal) continue; // the game is over or the ball was lost: nothing to tell
      late.push(answer.forecast.answered_ms - budget);
      without += answer.forecast.advice === "none" ? 1 : 0;
    }
    late.sort((a, b) => a - b);
    report.figure(`${budget} ms asked, both cores taken: questions answered`, late.length);
    report.figure(`${budget} ms asked: later than the budget, p99`, late[Math.floor(0.99 * (late.length - 1))], "ms", { atMost: kLate });
    report.figure(`${budget} ms asked: without advice, too few futures`, without);
  }
  free();
  robot.stop();
}

/** A loop of 30 Hz that uses 70 % of a core, with and without rollouts beside it that never end, at idle priority. */
async function harm(report, seconds) {
  const loop = async () => (await (await startRobot(["--seconds", seconds, "--warm-up", 1, "--work", 0.7])).report).period_p99_ms;
  const free = occupy(1);
  const [alone, beside] = [[], []];
  for (let round = 0; round < 3; ++round) {
    alone.push(await loop());
    const asker = start("foresight-sim", ["bench", "--games", 100_000], ["chrt", "--idle", "0"]);
    await sleep(0.2);
    beside.push(await loop());
    asker.stop();
    await asker.output.catch(() => {});
  }
  free();
  report.figure("period p99 of a 30 Hz loop, the other core busy", median(alone), "ms");
  report.figure("period p99, rollouts at idle priority beside it", median(beside), "ms");
  report.figure("period p99, change", median(beside) - median(alone), "ms", { atMost: 1 });
}

async function calibration(report, situations) {
  const told = JSON.parse(await start("foresight-sim", ["calibration", "--json", "--situations", situations]).output);
  for (const kind of ["score", "concede"]) {
    const { brier, base_rate_brier, deciles } = told[kind];
    const worst = Math.max(...deciles.filter(({ cases }) => cases >= 50).map(({ foretold, came }) => Math.abs(foretold - came)));
    report.figure(`${kind}: worst decile of 50 cases and more, foretold less came`, worst, "", { atMost: 0.05 });
    report.figure(`${kind}: Brier score less that of the base rate`, brier - base_rate_brier, "", { below: 0 });
  }
}

async function wins(report, pairs) {
  const { seconds, report: found } = await run(["baseline", "foresight", "--pairs", pairs, "--jobs", 2]);
  const { mean, low, high } = found.gain;
  report.figure(`goals a game that foresight gains, ${pairs} pairs`, mean, "goals", { above: 0 });
  report.figure("half its 95 % interval", (high - low) / 2, "goals");
  report.figure("processor time", (2 * seconds) / 3600, "h");
  console.log(`   ${pretty(mean)} goals (${pretty(low)} .. ${pretty(high)})`);
}

export async function foresight({ probes = 500, seconds = 20, games = 1000, rollouts = 1000, choices = 200, jobs = 2 }) {
  const report = new Report("foresight", "in time, true, harmless, and worth it?");
  const perSecond = await speed(report);
  if (choices > 0) await rightChoice(report, choices, Math.round((0.2 * perSecond) / 2), jobs);
  if (probes > 0) await deadline(report, probes);
  if (seconds > 0) await harm(report, seconds);
  if (rollouts > 0) await calibration(report, rollouts);
  if (games > 0) await wins(report, games);
  return report.finish();
}
