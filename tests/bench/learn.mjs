// Does learning keep its promises? Three drills, the whole game, and runs whose rewards are dealt by chance.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { compare } from "./comparisons.mjs";
import { scratch, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const program = fileURLToPath(new URL("../../build/release/bin/foresight-sim", import.meta.url));

const kDrills = ["run_to_score", "two_against_one", "empty_goal"];
const kHeldOut = 2000; // attempts before and after, on seeds that the run never had
const kFirstHeldOut = 5_000_000_000;

/** Learns, and returns the report and the tree's text. Exit status 1, nothing better, is an answer. */
function learn(name, words) {
  const out = join(scratch, `${name}.json`);
  const began = performance.now();
  const options = { encoding: "utf8", maxBuffer: 1 << 28 };
  const { status, stdout, stderr } = spawnSync(
    program,
    ["learn", "baseline", ...words, "--out", out, "--json"],
    options,
  );
  if (![0, 1].includes(status)) throw new Error(stderr.trim());
  const minutes = (performance.now() - began) / 60_000;
  return { report: JSON.parse(stdout), out, text: readFileSync(out, "utf8"), minutes };
}

/** The share of successes in a drill [%] with its interval. */
async function success(drill, strategy) {
  const words = ["drills", "run", drill, strategy, "--trials", kHeldOut, "--seed", kFirstHeldOut, "--json"];
  const { success: share, low, high } = JSON.parse(await start("foresight-sim", words).output);
  return { share: 100 * share, low: 100 * low, high: 100 * high };
}

async function inDrills(report, minutes) {
  const learned = learn("drills", ["--layers", "kick", "--budget", `${minutes}m`, "--seed", "11"]);
  report.figure("three drills: time to learn, both cores", learned.minutes, "min", { atMost: 15 });
  for (const drill of kDrills) {
    const [before, after] = [await success(drill, "baseline"), await success(drill, learned.out)];
    report.figure(`${drill}: success of baseline on held-out seeds`, before.share, "%");
    report.figure(`${drill}: success of the learned tree`, after.share, "%");
    report.figure(`${drill}: between the two intervals of 95 %`, after.low - before.high, "%", { atLeast: 0 });
  }
}

async function inGames(report, minutes) {
  const learned = learn("learned", ["--budget", `${minutes}m`, "--seed", "12"]);
  report.figure("whole game: time to learn, both cores, with the gate", learned.minutes, "min", { atMost: 30 });
  const fresh = ["--seed", "7000000000", "--pairs", "400"];
  for (const opponent of ["baseline", "high_line"]) {
    const { gain } = (await compare([opponent, learned.out, ...fresh])).report;
    report.figure(
      `whole game: goals better than ${opponent}`,
      gain.mean,
      "",
      opponent === "baseline" ? { atLeast: 0.3 } : {},
    );
    report.figure(`whole game: lower end of the interval against ${opponent}`, gain.low, "", { atLeast: 0 });
  }
  const met = (await compare(["baseline", learned.out, "--vs", "align_first", ...fresh])).report;
  report.figure("whole game: gain against align_first, which it never met, upper end", met.gain.high, "", {
    atLeast: 0,
  });
}

function control(report, runs) {
  let passed = 0;
  for (let run = 0; run < runs; ++run) {
    const words = ["--layers", "kick", "--budget", "5s", "--control", "--most-pairs", "400", "--unseen", ""];
    const { report: answer } = learn("control", [...words, "--seed", String(100 + run)]);
    passed += answer.better ? 1 : 0;
  }
  report.figure(`rewards dealt by chance: of ${runs} runs pass the gate`, passed, "", {
    atMost: Math.max(1, runs / 20),
  });
}

function repeats(report) {
  const words = ["--layers", "kick", "--budget", "5s", "--seed", "3", "--most-pairs", "50", "--unseen", ""];
  const one = learn("one", [...words, "--threads", "1"]);
  const three = learn("one", [...words, "--threads", "3"]);
  report.figure("the same seed on one thread and on three: different bytes", one.text === three.text ? 0 : 1, "", {
    atMost: 0,
  });
}

export async function learning({ minutes = 15, choices = 20 }) {
  const report = new Report("learn", "does learning find better trees, and nothing where there is nothing?");
  repeats(report);
  await inDrills(report, minutes / 5);
  await inGames(report, minutes);
  control(report, choices);
  return report.finish();
}
