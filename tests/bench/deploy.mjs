// How long until the recordings of five robots are home in the half-time break, and until a changed file runs on a robot?
import { cpSync, readdirSync, rmSync, statSync, utimesSync } from "node:fs";
import { join } from "node:path";
import { kUser, whyNoField } from "../deploy/field.mjs";
import { World } from "../deploy/world.mjs";
import { root } from "../e2e/support.mjs";
import { built, needsMovbe } from "../nao/robots.mjs";
import { atEnd, command, onlySession, scratch, sleep, startRobot } from "./programs.mjs";
import { Report } from "./report.mjs";

const kRobots = ["tim", "lea", "kim", "ben", "eva"];
const kRate = "100mbit";
const kHalf_s = 600;
const kRecordingSpeed = 20; // speed at which the load of a half is recorded

// one of the most expensive files, and one that changes often
const kChanged = ["robot/net/serve/server.cpp", "robot/app/robot_main.cpp"];

/** Runs a script; returns its duration [s]. When it fails, its output is the error. */
async function timed(world, script, ...words) {
  const began = performance.now();
  const { status, output } = await world.run(script, ...words);
  if (status !== 0) throw new Error(`scripts/${script} ${words.join(" ")} ended with status ${status}:\n${output}`);
  return (performance.now() - began) / 1000;
}

/** Records a half in profile game with the load of a robot's threads; returns the folder of its session. */
async function recordHalf() {
  const logs = join(scratch, "half");
  await (
    await startRobot(
      [
        "--profile",
        "game",
        "--cameras",
        0,
        "--no-costs",
        "--seconds",
        kHalf_s / kRecordingSpeed,
        "--speed",
        kRecordingSpeed,
      ],
      { logs },
    )
  ).report;
  return onlySession(logs);
}

const sizeOf = (folder) => readdirSync(folder).reduce((sum, name) => sum + statSync(join(folder, name)).size, 0);

async function halfTime(report, world) {
  const session = await recordHalf();
  for (const name of kRobots) {
    cpSync(session, join(world[name].home, "foresight/logs/half"), { recursive: true });
    command("chown", "-R", `${kUser}:${kUser}`, join(world[name].home, "foresight/logs/half"));
  }
  report.figure("a half without images, per robot", sizeOf(session) / 1e6, "MB");
  const seconds = await timed(world, "logs", ...kRobots, "--no-images", "--out", "home");
  report.figure("half-time: five robots' halves home", seconds, "s", { atMost: 60 });
  report.figure("half-time: of what the link carries", ((5 * sizeOf(session) * 8) / 1e8 / seconds) * 100, "%");

  // beside what was on the robots, bit for bit
  const [day] = readdirSync(join(world.home, "home"));
  let different = 0;
  for (const name of kRobots)
    try {
      command("diff", "-r", "--exclude=*.camera_*", session, join(world.home, "home", day, name, "half"));
    } catch {
      ++different;
    }
  report.figure("half-time: sessions that differ", different, "", { exactly: 0 });
}

/** Makes the file look changed: it is compiled and linked anew, without a cache. */
function change(path) {
  const now = new Date();
  utimesSync(join(root, path), now, now);
  process.env.CCACHE_DISABLE = "1";
}

export async function deploy() {
  const report = new Report("deploy", "how long until recordings are home, and until a change runs on a robot?");
  const why = whyNoField() || needsMovbe.skip;
  if (why) throw new Error(why);
  const world = new World(kRobots);
  atEnd(() => {
    world.field.kill();
    rmSync(world.field.folder, { recursive: true, force: true });
  });
  world.field.shape(kRate);
  console.log(
    `   five robots in namespaces, one link of ${kRate}; the program is ${(statSync(built("nao-v6")).size / 1e6).toFixed(1)} MB`,
  );

  await timed(world, "deploy", "--setup", ...kRobots);
  report.figure(
    "first installation on five robots, built before",
    await timed(world, "deploy", ...kRobots, "--no-build"),
    "s",
  );
  await halfTime(report, world);
  for (const path of kChanged) {
    await sleep(1); // a file system may count whole seconds only
    change(path);
    report.figure(`time to robot: ${path} changed`, await timed(world, "deploy", "tim"), "s", { atMost: 60 });
  }
  await world.field.end();
  return report.finish();
}
