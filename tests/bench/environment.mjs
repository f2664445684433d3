// The environment of learners: agents' steps a second on one core, and a random policy that never leaves the valid states.
import { start } from "./programs.mjs";
import { median, Report } from "./report.mjs";

const kRounds = 3;
const kGames = 64; // side by side
const kAgents = 8;
const kWanted = 10_000_000; // steps of agents

// name, options, bar; spl2012 with 4 a side, beliefs and noise
const kChoices = [
  ["a step each tick, menu, all features", { ticks: 1 }, { atLeast: 1_000_000 }],
  ["a step each tick, motion, all features", { ticks: 1, actions: "motion" }],
  ["a step each 3 ticks, menu, all features", { ticks: 3 }],
  ["a step each 10 ticks, menu, all features", { ticks: 10 }],
  ["a step each tick, menu, all features, 7 a side by the rules of 2025", { ticks: 1, rules: "spl2025:7" }],
];

async function play(choice, steps) {
  const options = JSON.stringify({ games: kGames, control: "both", ...choice });
  return JSON.parse(await start("bench_environment", [options, steps]).output);
}

export async function environment({ games: million = 10 }) {
  const report = new Report("environment", "how fast do learners play, and does a random policy break the simulator?");
  const steps = Math.ceil((million * kWanted) / 10 / (kGames * kAgents));
  // in turns, so that other programs disturb all alike
  const runs = kChoices.map(() => []);
  for (let round = 0; round < kRounds; ++round)
    for (const [i, [, choice]] of kChoices.entries()) runs[i].push(await play(choice, Math.ceil(steps / 2)));
  for (const [i, [name, , bar]] of kChoices.entries())
    report.figure(name, median(runs[i].map((run) => run.per_second)), "agent steps/s", bar);
  for (const actions of ["menu", "motion"]) {
    const { agent_steps: played, outside } = await play({ ticks: 1, actions }, steps);
    report.figure(`random policy, ${actions}: steps of agents without an invalid state`, played, "", {
      atLeast: million * 1e6,
    });
    report.figure(`random policy, ${actions}: observations beyond -1 .. 1`, outside, "", { atMost: 0 });
  }
  return report.finish();
}
