// Does foresight answer in time, predict well, not disturb the robot, and win games?
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Live } from "../e2e/live.mjs";
import { root } from "../e2e/support.mjs";
import { kAtomInstructions, startCounted } from "./atom.mjs";
import { compare as run } from "./comparisons.mjs";
import { shareOfCore } from "./control_group.mjs";
import { lost } from "./half.mjs";
import { atEnd, scratch, sleep, start, startRobot } from "./programs.mjs";
import { median, pretty, Report } from "./report.mjs";
import { rightChoice } from "./right_choice.mjs";

const kBudgets = [50, 200, 1000]; // [ms]
const kLate = 20; // [ms]
const kThree = ["--strategies", "baseline", "passing", "kick_now"];
const kChoice = ["high_line", "baseline", "kick_now"]; // of the playbook `foresight`: the best one by compare is first
const kShares = [0.05, 0.1, 0.25, 0.5]; // of a core
const kRobot = { share: 0.25, seconds: 0.5 }; // foresight's share of a robot's core, and the time for a question [s]
const kFutures = 200; // rollouts per forecast; with fewer, forecasts far from the mean come from chance
const kLikely = 0.8; // confidence of a captain that changes often enough to distinguish its gains from chance
const kMostRollouts = 64; // rollouts of a question in a game, and their length:
const kGameHorizon = 20; // [s]
// models of opponents that are twice as fast, for a team that is wrong about them
const kFast = "match,walk.forward=0.5,walk.backward=0.4,walk.sideward=0.36,walk.turn_rate=2.444,walk.acceleration=1.2";

/** Programs that use all of a core. */
function occupy(cores) {
  const hogs = Array.from({ length: cores }, () => spawn(process.execPath, ["-e", "for (;;);"]));
  const free = () => hogs.forEach((hog) => hog.kill("SIGKILL"));
  atEnd(free);
  return free;
}

/** [s] that a question about a moment takes. */
const situation = async (preset, ...args) => {
  const began = performance.now();
  await start("foresight-sim", ["situation", "near_pressed", "--json", ...args], [], preset).output;
  return (performance.now() - began) / 1000;
};

/**
 * Measures a question on one core. Subtracts the time of few rollouts from that of many, so that the program's start does
 * not count. Returns the number of rollouts a second.
 */
async function speed(report) {
  const cost = async (preset, seconds, rollouts, ...more) => {
    const ask = (count) =>
      situation(preset, ...kThree, "--rules", "spl2025:5", "--seconds", seconds, "--rollouts", count, ...more);
    const few = await ask(24);
    return (await ask(24 + rollouts)) - few;
  };
  const thrice = async (...asked) => median([await cost(...asked), await cost(...asked), await cost(...asked)]);
  const seconds = await thrice("release", 30, 200);
  report.figure("3 x 200 rollouts of 30 s, 5 a side, match", 1000 * seconds, "ms", { atMost: 100 });
  report.figure(
    "the same by the program for the Nao V6, on this machine",
    1000 * (await thrice("nao-v6", 30, 200)),
    "ms",
  );
  const half = [600, 100, "--until", "half"];
  report.figure("3 x 100 rollouts to the end of the half", await cost("release", ...half), "s", { atMost: 2.5 });
  report.figure("the same by the program for the Nao V6 to the end of the half", await cost("nao-v6", ...half), "s");
  return 600 / seconds; // rollouts per second
}

/** A robot in a simulated game, a minute after its start. */
async function askable(before, preset) {
  const robot = start(
    "foresight-robot",
    [
      "--body",
      "sim",
      "--port",
      0,
      "--no-foresight",
      "--loop",
      "--state-dir",
      join(scratch, "state"),
      "--log-dir",
      join(scratch, "logs"),
    ],
    before,
    preset,
  );
  const port = /:(\d+)/.exec(await robot.address)[1];
  const live = await Live.open({ after: atEnd }, { port });
  await live.call("/sim/step", { ticks: 1800 });
  /** The forecast and its waiting time, or nothing if the game is over or the ball was lost. */
  const ask = async (budget, horizon) => {
    const began = performance.now();
    const { ok, forecast } = await live.call("/foresight/what_if", { budget_ms: budget, horizon });
    return ok && !forecast.refusal ? { ...forecast, waited_ms: performance.now() - began } : undefined;
  };
  return { ask, stop: robot.stop };
}

/** Asks repeatedly while both cores are busy. */
async function deadline(report, questions) {
  const robot = await askable();
  const free = occupy(2);
  for (const budget of kBudgets) {
    const late = [];
    const waited = [];
    let without = 0;
    for (let i = 0; i < Math.ceil(questions / kBudgets.length); ++i) {
      const forecast = await robot.ask(budget, 20);
      if (!forecast) continue;
      late.push(forecast.answered_ms - budget);
      waited.push(forecast.waited_ms - budget);
      without += forecast.advice === "none" ? 1 : 0;
    }
    const p99 = (values) => values.sort((a, b) => a - b)[Math.floor(0.99 * (values.length - 1))];
    report.figure(`${budget} ms asked, both cores taken: questions answered`, late.length);
    report.figure(`${budget} ms asked: later than the budget, p99`, p99(late), "ms", { atMost: kLate });
    report.figure(
      `${budget} ms asked: likewise as the asker saw it, who competes for the cores too`,
      p99(waited),
      "ms",
    );
    report.figure(`${budget} ms asked: without advice, too few futures`, without);
  }
  free();
  robot.stop();
}

/** Rollouts a second of the program for the Nao V6, by its share of this machine's core. */
async function byShare(report) {
  for (const share of kShares) {
    const robot = await askable(shareOfCore(share), "nao-v6");
    const rates = [];
    for (let i = 0; i < 5; ++i) {
      const forecast = await robot.ask(2000, 30);
      if (!forecast) continue;
      const rollouts = forecast.strategies.reduce((sum, strategy) => sum + strategy.rollouts, 0);
      rates.push((1000 * rollouts) / forecast.answered_ms);
    }
    robot.stop();
    report.figure(
      `${100 * share} % of a core: futures of 30 s, 4 a side, program for the Nao V6`,
      median(rates),
      "1/s",
    );
  }
}

/** Number of rollouts, 4 a side, that an Atom core plays for a question, computed from their instructions. */
async function onAtom(report) {
  const [few, many] = [24, 72]; // of each strategy
  const instructions = async (rollouts, seconds) => {
    const counted = startCounted(
      "foresight-sim",
      ["situation", "near_pressed", ...kThree, "--seconds", seconds, "--rollouts", rollouts],
      "nao-v6",
    );
    await counted.output;
    return counted.count();
  };
  const rollouts = {};
  for (const seconds of [kGameHorizon, 30]) {
    const each = ((await instructions(many, seconds)) - (await instructions(few, seconds))) / (3 * (many - few));
    report.figure(`a future of ${seconds} s, 4 a side, program for the Nao V6`, each / 1e6, "million instructions");
    rollouts[seconds] = Math.floor((kAtomInstructions * kRobot.share * kRobot.seconds) / each);
    report.figure(
      `futures of ${seconds} s in ${1000 * kRobot.seconds} ms on ${100 * kRobot.share} % of an Atom's core, estimated`,
      rollouts[seconds],
    );
  }
  return rollouts;
}

/** A loop of 30 Hz that uses 70 % of a core and is recorded whole, with and without questions beside it all the time. */
async function harm(report, seconds) {
  const loop = async (...words) =>
    (await startRobot(["--seconds", seconds, "--warm-up", 1, "--work", 0.7, "--profile", "full", ...words])).report;
  const free = occupy(1);
  const [alone, beside] = [[], []];
  for (let round = 0; round < 3; ++round) {
    alone.push(await loop());
    beside.push(await loop("--foresight"));
  }
  free();
  const p99 = (runs) => median(runs.map((run) => run.period_p99_ms));
  report.figure("period p99 of a 30 Hz loop that is recorded, the other core busy", p99(alone), "ms");
  report.figure("period p99, asking all the time", p99(beside), "ms");
  report.figure("period p99, change", p99(beside) - p99(alone), "ms", { atMost: 1 });
  report.figure("futures meanwhile", median(beside.map(({ futures }) => futures / seconds)), "1/s", { above: 0 });
  report.figure(
    "messages of the recording that were lost",
    beside.reduce((sum, run) => sum + lost(run, 1), 0),
    "",
    { exactly: 0 },
  );
}

async function calibration(report, situations) {
  const told = JSON.parse(
    await start("foresight-sim", ["calibration", "--json", "--situations", situations, "--rollouts", kFutures]).output,
  );
  for (const kind of ["score", "concede"]) {
    const { brier, base_rate_brier, deciles } = told[kind];
    const off = ({ foretold, came }) => Math.abs(foretold - came);
    const worst = deciles
      .filter(({ cases }) => cases >= 50)
      .reduce((worst, decile) => (off(decile) > off(worst) ? decile : worst));
    report.figure(`${kind}: worst decile of 50 cases and more, foretold less came`, off(worst), "", { atMost: 0.05 });
    report.figure(
      `${kind}: what chance alone does to that decile, one standard error`,
      Math.sqrt((worst.foretold * (1 - worst.foretold)) / worst.cases),
    );
    report.figure(`${kind}: Brier score less that of the base rate`, brier - base_rate_brier, "", { below: 0 });
  }
}

const choose = async (moments, rollouts, strategies, ...words) =>
  JSON.parse(
    await start("foresight-sim", [
      "choosing",
      "--json",
      "--moments",
      moments,
      "--rollouts",
      rollouts,
      "--horizon",
      kGameHorizon,
      "--strategies",
      strategies.join(","),
      ...words,
    ]).output,
  );

/** The gain of choosing with full knowledge, and the captain's gain with its few rollouts. */
async function choosing(report, moments, rollouts) {
  const { knowing, captains } = await choose(moments, rollouts, kChoice);
  const [{ gain: captain, changes }] = captains;
  report.figure("moments of games in which each strategy was tried", moments);
  report.figure("the best strategy every 10 s, by who knows all", knowing.mean, "goals a game");
  report.figure("the same, its standard error", knowing.standard_error, "goals a game");
  report.figure(
    `the captain's choice every 10 s, by ${rollouts} futures of what it believes`,
    captain.mean,
    "goals a game",
    { above: 0 },
  );
  report.figure("the same, its standard error", captain.standard_error, "goals a game");
  report.figure("moments in which the captain changes", 100 * changes, "%");
}

/** The reason for the captain's smaller gain: missing knowledge of the game, or too few rollouts. */
async function whatKeeps(report, moments, rollouts) {
  for (const many of [rollouts, 8 * rollouts]) {
    const { captains } = await choose(moments, many, ["baseline", "kick_now"], "--insights", "--sure", kLikely);
    for (const { knows, gain } of captains) {
      const name = `kick_now instead of baseline for 10 s where it likely gains, by ${many} futures of ${captains[0].knows}${knows === captains[0].knows ? "" : ` ${knows}`}`;
      report.figure(name, gain.mean, "goals a game");
      report.figure(`${name}, standard error`, gain.standard_error, "goals a game");
    }
  }
}

/** Compares two teams. The played games are kept, and the next bench of the same program continues them. */
async function play(name, ...words) {
  const program = createHash("sha256")
    .update(readFileSync(join(root, "build/release/bin/foresight-sim")))
    .digest("hex")
    .slice(0, 8);
  const kept = join(root, "build/bench", `${name}-${program}`);
  const { seconds, report } = await run([
    ...words,
    "--jobs",
    2,
    "--out",
    kept,
    ...(existsSync(kept) ? ["--resume"] : []),
  ]);
  const { mean, low, high } = report.gain;
  console.log(
    `   ${name}: ${report.pairs} pairs, ${pretty(mean)} goals a game (95 %: ${pretty(low)} .. ${pretty(high)}), LLR ${pretty(report.llr)}: ${report.verdict}`,
  );
  return { ...report, hours: (2 * seconds) / 3600 };
}

async function wins(report, pairs, rollouts) {
  mkdirSync(join(root, "build/bench"), { recursive: true });
  report.figure("rollouts of a question in a game", rollouts, "", { atMost: kMostRollouts });
  const [best] = kChoice;
  for (const [name, rival, told] of [
    ["same", best, `the same team without, which plays ${best}`],
    ["plain", "baseline", "a team that plays baseline, and did not compare either"],
  ]) {
    const foreseeing = `foresight,opponent=${rival},rollouts=${rollouts},horizon=${kGameHorizon}`;
    const played = await play(`${name}-${rollouts}`, rival, foreseeing, "--sprt", "0,0.2", "--most-pairs", pairs);
    report.figure(
      `against ${told}: pairs of games until the sequential test of 0 against 0.2 goals knew, or enough`,
      played.pairs,
    );
    report.figure(`against ${told}: goals a game that foresight gains`, played.gain.mean, "goals", { above: 0 });
    report.figure(`against ${told}: the same, lower end of 95 %`, played.gain.low, "goals", { above: 0 });
    report.figure(`against ${told}: the same, upper end of 95 %`, played.gain.high, "goals");
    report.figure(`against ${told}: log-likelihood ratio of the test; known beyond 2.94`, played.llr);
    report.figure(`against ${told}: processor time of this run`, played.hours, "h");
  }

  const fast = join(root, "build/bench/fast.json");
  writeFileSync(
    fast,
    JSON.stringify({
      name: "fast",
      about: "takes the others to be twice as fast",
      choose: kChoice,
      opponent: best,
      opponent_models: kFast,
      rollouts,
    }),
  );
  const wrong = await play(`wrong-${rollouts}`, best, fast, "--pairs", Math.max(2, Math.round(0.4 * pairs)));
  const error = (wrong.gain.high - wrong.gain.low) / 2 / 1.96;
  report.figure("goals a game gained by who takes the others to be twice as fast", wrong.gain.mean, "goals");
  report.figure("the same, lower bound of 95 %, one-sided", wrong.gain.mean - 1.645 * error, "goals", { above: -0.2 });
}

export async function foresight({
  probes = 500,
  seconds = 20,
  games = 1000,
  rollouts = 4000,
  choices = 200,
  moments = 1000,
  jobs = 2,
}) {
  const report = new Report("foresight", "in time, true, harmless, and worth it?");
  const perSecond = await speed(report);
  const onRobot = await onAtom(report);
  if (choices > 0)
    await rightChoice(report, choices, jobs, [
      { where: "200 ms", rollouts: Math.round((0.2 * perSecond) / 2) },
      {
        where: `${1000 * kRobot.seconds} ms of ${100 * kRobot.share} % of an Atom's core`,
        rollouts: Math.floor(onRobot[30] / 2),
      },
    ]);
  if (probes > 0) {
    await byShare(report).catch((error) => console.log(`   not by share of a core: ${error.message}`));
    await deadline(report, probes);
  }
  if (seconds > 0) await harm(report, seconds);
  if (rollouts > 0) await calibration(report, rollouts);
  const inGame = Math.min(kMostRollouts, onRobot[kGameHorizon]);
  if (moments > 0) {
    await choosing(report, moments, inGame);
    await whatKeeps(report, 2 * moments, inGame);
  }
  if (games > 0) await wins(report, games, inGame);
  return report.finish();
}
