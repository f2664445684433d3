// The cost of a simulated game: on this processor, with the robots' compiler flags, and by the game's length.
import { startCounted } from "./atom.mjs";
import { words } from "./games.mjs";
import { canStart, start } from "./programs.mjs";
import { median, otherLoad, pretty, Report } from "./report.mjs";
import { exponentOf } from "./statistics.mjs";

const kRounds = 3;
const kBestOf = 10;
const kTogether = 32; // games side by side
const kFrames = 36000; // of two halves of ten minutes; with dead time it is more
// without the mercy rule, because a game that ends early has no fixed length
const kWhole = "mercy_goals=0";

async function cost(choice, games, threads = 1, together = 1) {
  const args = ["bench", "--json", "--games", games, "--threads", threads, "--together", together, ...words(choice)];
  return JSON.parse(await start("foresight-sim", args).output);
}

/** Each choice `kRounds` times, in turns, so that other programs disturb all alike; returns the median of each figure. */
async function inTurns(measurements) {
  const found = measurements.map(() => []);
  for (let round = 0; round < kRounds; ++round)
    for (const [i, measure] of measurements.entries()) found[i].push(await measure());
  return found.map((runs) => (figure) => median(runs.map(figure)));
}

const mean = (run) => run.game_ms.mean;
const middle = (run) => run.game_ms.median;
const cycles = (run) => run.robot_tick_cycles;

/** The cost of a game and of a robot's frame in it, with bars for both. */
function tellCost(report, name, of, players, figure, bar, cycleBar) {
  const ms = of(figure);
  report.figure(`${name}: game`, ms, "ms", bar);
  report.figure(`${name}: game`, ms * of((run) => run.clock_ghz), "M cycles");
  report.figure(`${name}: robot and tick, dead time counted`, of(cycles), "cycles");
  const robotFrames = kFrames * 2 * players;
  report.figure(`${name}: robot-frame of ${kFrames}`, (ms * 1e6) / robotFrames, "ns");
  report.figure(
    `${name}: robot-frame of ${kFrames}`,
    (ms * 1e6 * of((run) => run.clock_ghz)) / robotFrames,
    "cycles",
    cycleBar,
  );
}

async function games(report, count) {
  const few = Math.max(1, Math.ceil(count / 5));
  const spl2012 = { rules: "spl2012" };
  const [match, plain, five, seven] = await inTurns([
    () => cost(spl2012, count),
    () => cost({ ...spl2012, everyTick: true }, few),
    () => cost({ rules: "spl2025:5" }, few),
    () => cost({ rules: "spl2025:7" }, few),
  ]);
  tellCost(report, "spl2012, 4 a side", match, 4, mean, { atMost: 12 }, { atMost: 150 });
  tellCost(report, "spl2012, 4 a side, every tick", plain, 4, mean, { atMost: 40 });
  tellCost(report, "spl2025, 5 a side, single", five, 5, middle, { atMost: 25 });
  tellCost(report, "spl2025, 7 a side, single", seven, 7, middle);
}

/** Returns the instructions of a game of a series that is played side by side, without loading, in millions. */
async function instructions(...lanes) {
  const count = async (games) => {
    const program = startCounted("sim_cost", [games, "together", ...lanes], "sim-release");
    await program.report;
    return program.count();
  };
  return ((await count(2 * kTogether)) - (await count(kTogether))) / kTogether / 1e6;
}

/** Games side by side: the best of ten runs, because the host's speed varies, and instructions, which it cannot change. */
async function sideBySide(report) {
  const runs = { wide: [], narrow: [], five: [] };
  for (let run = 0; run < kBestOf; ++run) {
    runs.wide.push(await start("sim_cost", [kTogether, "together"], [], "sim-release").report);
    runs.narrow.push(await start("sim_cost", [kTogether, "together", "narrow"], [], "sim-release").report);
    runs.five.push(await cost({ rules: "spl2025:5" }, kTogether, 1, kTogether));
  }
  const best = (of, figure) => Math.min(...of.map(figure));
  const ms = (run) => run.game_ms;
  report.figure("spl2012, 4 a side, side by side: game, best of ten", best(runs.wide, ms), "ms", { atMost: 10 });
  report.figure("spl2012, 4 a side, side by side: robot and tick", best(runs.wide, cycles), "cycles");
  report.figure("spl2012, 4 a side, side by side: game", await instructions(), "M instructions", { atMost: 85 });
  report.figure("the same with SSE2 alone: game, best of ten", best(runs.narrow, ms), "ms", { atMost: 13 });
  report.figure("the same with SSE2 alone: game", await instructions("narrow"), "M instructions", { atMost: 115 });
  report.figure("spl2025, 5 a side, side by side: game, best of ten", best(runs.five, mean), "ms", { atMost: 14 });
}

/** The same program by other compilers' flags, on this processor. */
async function processors(report, count) {
  const builds = ["sim-release", "sim-silvermont"];
  if (canStart("sim_cost", "sim-i686")) builds.push("sim-i686");
  else console.log("   This kernel starts no programs for 32-bit processors: their figures are left out.");
  const [release, silvermont, i686] = await inTurns(
    builds.map((preset) => () => start("sim_cost", [count], [], preset).report),
  );
  const ms = (run) => run.game_ms;
  for (const [name, of, most] of [
    ["nao-v6 (silvermont)", silvermont, 2.5],
    ["i686 SSE (bonnell)", i686, 3],
  ]) {
    if (!of) continue;
    report.figure(`flags of ${name}: game`, of(ms), "ms");
    report.figure(`flags of ${name}: robot and tick`, of(cycles), "cycles");
    report.figure(`flags of ${name}, against x86-64`, of(ms) / release(ms), "x", { atMost: most });
  }
  for (const [name, of] of [
    ["x86-64", release],
    ["i686", i686],
  ]) {
    if (!of) continue;
    report.figure(
      `State on ${name}`,
      of((run) => run.state_bytes),
      "bytes",
      { atMost: 8192 },
    );
    report.figure(
      `State on ${name}: copy`,
      of((run) => run.copy_ns),
      "ns",
      name === "x86-64" ? { below: 500 } : {},
    );
  }
}

async function scaling(report, count) {
  const lengths = [300, 600, 1200].map((half) => ({ rules: `spl2012,${kWhole},half_duration=${half}` }));
  const sides = [3, 4, 5, 6, 7].map((players) => ({ rules: `spl2025:${players},${kWhole}` }));
  const few = Math.max(1, Math.ceil(count / 5));
  const found = await inTurns([...lengths, ...sides].map((choice) => () => cost(choice, few)));
  const [half, whole, twice, ...bySide] = found.map((of) => of(mean));
  for (const [name, ratio] of [
    ["10 min against 5 min a half", whole / half],
    ["20 min against 10 min a half", twice / whole],
  ])
    report.figure(`time, ${name}`, ratio, "x", { between: [1.8, 2.2] });
  console.log(`   3 to 7 a side: ${bySide.map(pretty).join(", ")} ms`);
  const points = bySide.map((ms, i) => [3 + i, ms]);
  report.figure("time grows with robots to the power of", exponentOf(points), "", { atMost: 2 });

  const [one, two] = await inTurns([1, 2].map((threads) => () => cost({ rules: "spl2012" }, count * threads, threads)));
  const rate = (run) => run.games_per_second;
  report.figure("games a second on one thread", one(rate), "1/s");
  report.figure("games a second on two threads", two(rate), "1/s");
  report.figure("two threads against one", two(rate) / one(rate), "x", { atLeast: 1.9 });
  const [single, pair] = await inTurns(
    [1, 2].map((threads) => () => cost({ rules: "spl2012" }, 4 * kTogether * threads, threads, kTogether)),
  );
  report.figure("games a second on one thread, side by side", single(rate), "1/s");
  report.figure("two threads against one, side by side", pair(rate) / single(rate), "x", { atLeast: 1.9 });
}

export async function sim({ games: count = 200 }) {
  const report = new Report("sim", "what does a simulated game cost?");
  console.log(
    "   baseline against itself, models match, referee and radio on; CPU time of one thread, medians of 3 rounds in turns.",
  );
  console.log(
    "   Cycles by a loop of additions timed before each game. That a step allocates nothing is a test (sim_match_test).",
  );
  report.figure("other programs on this machine", await otherLoad(), "cores");
  await games(report, count);
  await sideBySide(report);
  await processors(report, Math.max(1, Math.ceil(count / 5)));
  await scaling(report, count);
  return report.finish();
}
