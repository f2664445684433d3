// Is compare as quick as the games it plays, does it need the same memory for many games as for few, and is its verdict reproducible?
import { mkdtempSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { childrenOf, compare as run } from "./comparisons.mjs";
import { start, scratch } from "./programs.mjs";
import { otherLoad, pretty, Report } from "./report.mjs";

const kPlain = ["baseline", "kick_now"];
const kKillEvery = 3; // [s]

/** Games a second of the simulator alone, on two threads. */
async function promised(games) {
  const args = ["bench", "--json", "--games", games, "--threads", 2, "--home", kPlain[0], "--away", kPlain[1]];
  return JSON.parse(await start("foresight-sim", args).output).games_per_second;
}

async function speed(report, pairs) {
  const few = Math.max(25, Math.ceil(pairs / 10));
  const rate = await promised(2 * few);
  const many = await run([...kPlain, "--pairs", pairs, "--jobs", 2]);
  const again = await promised(2 * few);
  const ratio = (many.seconds * (rate + again)) / 2 / (2 * pairs);
  report.figure(`${pairs} pairs`, many.seconds, "s");
  report.figure("against the simulator's own games", ratio, "x", { atMost: 1.1 });
  const small = await run([...kPlain, "--pairs", few, "--jobs", 2]);
  report.figure(`memory held by ${few} pairs`, small.megabytes, "MB");
  report.figure(`memory held by ${pairs} pairs, against that`, many.megabytes / small.megabytes, "x", { atMost: 1.05 });
  const [one, two] = [
    await run([...kPlain, "--pairs", 2 * few, "--jobs", 1]),
    await run([...kPlain, "--pairs", 4 * few, "--jobs", 2]),
  ];
  report.figure("two processes against one", (2 * one.seconds) / two.seconds, "x", { atLeast: 1.9 });
}

async function honesty(report, pairs) {
  const { paired, unpaired } = (await run(["--aa", "baseline", "--pairs", pairs])).report;
  report.figure("a behaviour against itself: pairs that do not come out even", paired.even ? 0 : 1, "", { exactly: 0 });
  const { mean, low, high } = unpaired.home_advantage;
  report.figure(`home advantage over ${unpaired.games} games`, mean, "goals");
  report.figure("home advantage: half its interval", (high - low) / 2, "goals");
  report.figure("home advantage: how far its interval is from 0", Math.max(0, low, -high), "goals", { exactly: 0 });
  for (const other of ["kick_now", "align_first", "passing", "baseline,tolerance=20 deg"]) {
    const { report: found } = await run(["baseline", other, "--pairs", Math.max(50, Math.ceil(pairs / 10))]);
    const bar = other.includes("=") ? {} : { atLeast: 1.3 };
    report.figure(`pairing gain, baseline against ${other}`, found.pairing_gain, "x", bar);
  }
}

/** The same run, with workers killed every few seconds: the same bytes. */
async function faults(report, pairs) {
  const folder = mkdtempSync(join(scratch, "runs."));
  const words = [...kPlain, "--pairs", pairs, "--jobs", 2];
  let kills = 0;
  await run([...words, "--out", join(folder, "calm")]);
  await run([...words, "--out", join(folder, "torn")], {
    every: kKillEvery,
    watch: (pid) => {
      const workers = childrenOf(pid);
      if (workers.length > 0) process.kill(workers[kills++ % workers.length], "SIGKILL");
    },
  });
  const same = readFileSync(join(folder, "calm/result.json")).equals(readFileSync(join(folder, "torn/result.json")));
  report.figure("workers killed", kills, "", { above: 0 });
  report.figure("results that differ for it", same ? 0 : 1, "", { exactly: 0 });
}

export async function compare({ games = 4000 }) {
  const report = new Report("compare", "what does a verdict cost beyond its games, and is it kept?");
  const pairs = Math.ceil(games / 2);
  console.log(`   spl2012, models match, ${pretty(pairs)} pairs of games, two processes.`);
  report.figure("other programs on this machine", await otherLoad(), "cores");
  await speed(report, pairs);
  await honesty(report, pairs);
  await faults(report, Math.max(100, Math.ceil(pairs / 5)));
  return report.finish();
}
