// Does foresight choose the truly better strategy? Planted situations before the goal, each asked with as many futures as there
// is time for, and with many, which tell the truth.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { scratch, start } from "./programs.mjs";
import { pretty } from "./report.mjs";
import { numbers } from "./statistics.mjs";

const kIncumbent = "baseline";
const kChallengers = ["kick_now", "align_first", "passing", "idle"];
const kTruth = 10_000; // rollouts of each strategy
const kSeconds = 30;
const kSure = 3; // standard errors of a short answer by which the truth must differ
const kTie = 0.5; // standard errors within which the truth counts as a tie

/** A striker behind a ball in the opponents' half, one of them near it, a teammate somewhere in front. */
function plant(number) {
  const chance = numbers(7919 * (number + 1));
  const between = (least, most) => least + (most - least) * chance.next().value;
  const ball = { x: between(0.3, 2.4), y: between(-1.3, 1.3) };
  const around = (distance, angle) => ({
    x: ball.x + distance * Math.cos(angle),
    y: ball.y + distance * Math.sin(angle),
  });
  const behind = between(-0.8, 0.8);
  const facing = Math.PI - behind;
  return {
    about: `Planted situation ${number}.`,
    clock: 300,
    ball,
    robots: [
      { side: "home", player: 1, x: -2.7, y: 0, heading: 0 },
      { side: "home", player: 2, ...around(between(0.22, 0.6), facing), heading: -behind },
      {
        side: "home",
        player: 3,
        x: between(0.8, 2.2),
        y: ball.y > 0 ? between(-1.6, -0.7) : between(0.7, 1.6),
        heading: 0,
      },
      { side: "away", player: 1, x: 2.75, y: 0.3 * ball.y, heading: 3.14 },
      { side: "away", player: 2, ...around(between(0.4, 1.2), between(-1.2, 1.2)), heading: 3.14 },
    ],
  };
}

/** The challenger's gain: {gain, error, advice}, goals in the next 30 s. */
async function ask(situation, challenger, rollouts, seed) {
  const file = join(scratch, `planted-${seed}.json`);
  writeFileSync(file, JSON.stringify({ ...situation, seed }));
  const args = [
    "situation",
    file,
    "--json",
    "--seconds",
    kSeconds,
    "--rollouts",
    rollouts,
    "--strategies",
    kIncumbent,
    challenger,
  ];
  const { strategies, advice } = JSON.parse(await start("foresight-sim", args).output);
  const { gain, gain_low, gain_high } = strategies[1];
  return { gain, error: (gain_high - gain_low) / 2 / 1.96, advice };
}

async function answer(number, budgets) {
  const situation = plant(number);
  const challenger = kChallengers[number % kChallengers.length];
  const short = [];
  for (const { rollouts } of budgets) short.push(await ask(situation, challenger, rollouts, 2 * number + 1));
  const truth = await ask(situation, challenger, kTruth, 2 * number + 1_000_000);
  return { short, truth };
}

/**
 * A short answer's standard error is that of the many futures for as few: its own is far too small where by chance nobody
 * scored in it.
 */
function tell(report, where, rollouts, answers) {
  const errorOf = ({ truth }) => truth.error * Math.sqrt(kTruth / rollouts);
  const apart = answers.filter((answer) => Math.abs(answer.truth.gain) > kSure * errorOf(answer));
  const right = apart.filter(({ short, truth }) => Math.sign(short.gain) === Math.sign(truth.gain));
  const ties = answers.filter((answer) => Math.abs(answer.truth.gain) < kTie * errorOf(answer));
  const kept = ties.filter(({ short }) => short.advice === "keep");
  report.figure(`${where}: situations in which one strategy is better by ${kSure} standard errors`, apart.length);
  report.figure(`${where}: of these, the better one chosen`, (100 * right.length) / apart.length, "%", { atLeast: 95 });
  report.figure(`${where}: situations in which both are as good, to ${kTie} standard errors`, ties.length);
  report.figure(`${where}: of these, kept what was played`, (100 * kept.length) / ties.length, "%", { atLeast: 85 });
}

/** `budgets`: {where, rollouts of each of two strategies}. */
export async function rightChoice(report, count, jobs, budgets) {
  const answers = [];
  let next = 0;
  const work = async () => {
    while (next < count) answers.push(await answer(next++, budgets));
  };
  await Promise.all(Array.from({ length: jobs }, work));

  report.figure("planted situations", count);
  for (const [i, { where, rollouts }] of budgets.entries()) {
    report.figure(`${where}: futures of each strategy`, rollouts);
    tell(
      report,
      where,
      rollouts,
      answers.map(({ short, truth }) => ({ short: short[i], truth })),
    );
  }
  const gains = answers.map(({ truth }) => truth.gain);
  console.log(
    `   largest true gain ${pretty(Math.max(...gains))}, loss ${pretty(-Math.min(...gains))} goals in ${kSeconds} s`,
  );
}
