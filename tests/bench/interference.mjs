// Measures whether recording and viewers slow the robot down, and whether a writer ever waits.
import { sleep, startClients, startRobot } from "./programs.mjs";
import { median, otherLoad, pretty, Report } from "./report.mjs";

const kRounds = 3;

/** One run of the robot; `audience` are groups of viewers. */
async function run(robotArgs, seconds, audience) {
  const robot = await startRobot([...robotArgs, "--seconds", seconds, "--warm-up", 1]);
  const viewers = audience.map((args) => startClients(robot.url(), ["--seconds", seconds + 10, ...args]));
  const report = await robot.report;
  for (const viewer of viewers) viewer.stop();
  await Promise.allSettled(viewers.map((viewer) => viewer.report));
  await sleep(0.2);
  return report;
}

const stalled = ["--watch", "objects,images", "--clients", 1, "--stall-after", 1];

export async function interference({ seconds = 20 }) {
  const report = new Report("interference", "does the robot notice that it is recorded and watched?");
  report.figure("other programs on this machine", await otherLoad(), "cores");

  // a loop that uses 70 % of a core, alone and with viewers, in turns, so that other programs disturb both alike
  const working = ["--work", 0.7, "--no-costs"].slice(0, 2);
  const alone = [];
  const company = [];
  for (let round = 0; round < kRounds; ++round) {
    console.log(`   round ${round + 1} of ${kRounds}: alone, then recorded (full) with 3 viewers and a stalled one …`);
    alone.push(await run(working, seconds, []));
    company.push(
      await run([...working, "--profile", "full"], seconds, [["--watch", "objects,jpeg", "--clients", 3], stalled]),
    );
  }
  const p99 = (runs) => runs.map((each) => each.period_p99_ms);
  report.figure("period p99, alone", median(p99(alone)), "ms");
  report.figure("period p99, in company", median(p99(company)), "ms");
  report.figure("period p99, change", median(p99(company)) - median(p99(alone)), "ms", { atMost: 1 });
  console.log(`   p99 alone ${p99(alone).map(pretty)}; in company ${p99(company).map(pretty)} ms`);

  // the cost of a write without viewers, and with ten, of which one is stalled
  const nobody = [];
  const ten = [];
  for (let round = 0; round < kRounds; ++round) {
    console.log(
      `   round ${round + 1} of ${kRounds}: writing for nobody, then for 10 viewers of whom one is stalled …`,
    );
    nobody.push(await run(["--profile", "full"], seconds, []));
    ten.push(await run(["--profile", "full"], seconds, [["--watch", "objects,images", "--clients", 9], stalled]));
  }
  const figure = (runs, what, which = "write") => median(runs.map((each) => each[which][what]));
  for (const [name, runs] of [
    ["recorded, no viewer", nobody],
    ["recorded, 10 viewers", ten],
  ]) {
    report.figure(`write, ${name}: CPU p99.9`, figure(runs, "cpu_p999_us"), "us", { below: 20 });
    report.figure(`write, ${name}: wall p99`, figure(runs, "wall_p99_us"), "us", { below: 100 });
    report.figure(`as long computing beside it, ${name}: CPU p99.9`, figure(runs, "cpu_p999_us", "control"), "us");
    report.figure(`as long computing beside it, ${name}: wall p99`, figure(runs, "wall_p99_us", "control"), "us");
    report.figure(`write, ${name}: CPU p50`, figure(runs, "cpu_p50_us"), "us");
    report.figure(`write of images, ${name}: CPU p99`, figure(runs, "cpu_p99_us", "image_write"), "us");
    report.figure(`write of images, ${name}: wall p99`, figure(runs, "wall_p99_us", "image_write"), "us");
  }
  const times = (what) => figure(ten, what) / figure(nobody, what);
  report.figure("10 viewers against none: CPU p99.9", times("cpu_p999_us"), "x", { atMost: 2 });
  report.figure("10 viewers against none: wall p99", times("wall_p99_us"), "x", { atMost: 2 });
  return report.finish();
}
