// Installation of a version on one robot: stage it beside the running one, swap, check that it answers, or else roll back.
import { RobotFailed } from "./failure.mjs";
import { refuseInGame, statusOf } from "./game.mjs";
import { kGuardianStatus, kPrepare, kPutGuardianBack, kRollBack, kSwapGuardian, switchTo } from "./layout.mjs";

const kPatience_ms = 20000; // timeout for the answer of a starting version: a V4's flash is slow
const kPause_ms = 200;

// exit statuses of kGuardianStatus
const kUnknownState = 3;
const kNotRunning = 4;

/** Returns the name of a version, which sorts by time: 20261122-041546_0123abcd. */
const versionName = (build) => `${new Date().toISOString().slice(0, 19).replace(/[-:]/g, "").replace("T", "-")}_${build.replace(/[^\w+.-]/g, "")}`;

/** Returns the build that the program in `folder` on the robot reports for --version. */
async function buildOf(connection, folder) {
  const build = (await connection.must(`the program does not run on this robot`, `${folder}/bin/foresight-robot --version`)).trim();
  if (!/^[\w+.-]{1,64}$/.test(build)) throw new RobotFailed(`the program: expected its build for --version, got '${build.slice(0, 60)}'`);
  return build;
}

/** Throws if the robot is not that of the robots file, because addresses or heads were mixed up. */
export async function refuseOther(connection) {
  const { head_id } = connection.robot;
  const { stdout } = await connection.run("cat /sys/qi/head_id 2>/dev/null");
  if (head_id && stdout.trim() && stdout.trim() !== head_id) throw new RobotFailed(`this is another robot: expected head_id ${head_id}, got ${stdout.trim()}`);
}

/** Waits until the service answers as `build`. Returns undefined then, else a sentence with the reason. */
async function whyNotUp(connection, build) {
  const end = performance.now() + kPatience_ms;
  while (performance.now() < end) {
    const { status, stdout } = await connection.run("foresight/current/foresight status");
    if (status !== 0) return `it ${stdout.trim()}`;
    const answered = (await statusOf(connection))?.build;
    if (answered === build) return undefined;
    if (answered !== undefined) return `it answers as build ${answered}`;
    await new Promise((done) => setTimeout(done, kPause_ms));
  }
  return `it did not answer within ${kPatience_ms / 1000} s`;
}

/** Throws if another runtime uses our port. */
async function refuseTakenPort(connection) {
  const { status } = await connection.run("foresight/current/foresight status 2>/dev/null");
  const other = status === 0 ? undefined : await statusOf(connection);
  if (other) throw new RobotFailed(`port ${connection.robot.http_port} is taken by a runtime (build ${other.build}) that was not started by us: stop it first`);
}

/** Waits until the guardian knows the robot's state, or at least answers. Returns undefined then, else its output. */
async function whyNoGuardian(connection) {
  const end = performance.now() + kPatience_ms;
  for (;;) {
    const { status, stdout, stderr } = await connection.run(kGuardianStatus);
    if (status < 2) return undefined;
    const late = performance.now() > end;
    if (status === kUnknownState && late) return undefined;
    if (status === kNotRunning || late) return (stdout + stderr).trim();
    await new Promise((done) => setTimeout(done, kPause_ms));
  }
}

/** Installs the staged guardian, before the runtime that needs it. If it does not run, the previous one is put back. */
async function installGuardian(connection, say) {
  const [told, ...how] = (await connection.must("the guardian could not be swapped", kSwapGuardian)).trim().split(" ");
  if (told === "unknown") say(`NOT done: the guardian stays the one before, as it is not known whether the robot has stiffness (${how.join(" ")}): deploy again when it sits`);
  if (told === "kept") say(`NOT done: the guardian stays the one before, as the robot has stiffness (${how.join(" ")}): deploy again when it sits`);
  if (told !== "new") return;
  const why = await whyNoGuardian(connection);
  if (why === undefined) return say("a new guardian owns LoLA");
  await connection.must("putting the guardian before it back", kPutGuardianBack);
  throw new RobotFailed(`the guardian does not run, and nothing else was changed\n${why}`);
}

async function rollBack(connection, why) {
  const log = (await connection.run("foresight/current/foresight log")).stdout.trimEnd();
  const left = (await connection.must(`${why}; rolling back failed too`, kRollBack)).trim();
  const told = log ? `\n${log}` : "";
  if (left === "none") throw new RobotFailed(`${why}; there was no version before it, nothing runs now${told}`);
  const build = await buildOf(connection, "foresight/current");
  const whyNot = await whyNotUp(connection, build);
  throw new RobotFailed(`${why}; rolled back to build ${build}${whyNot ? `, but ${whyNot}` : ", which runs"}${told}`);
}

/** Returns, in words, what push() would change in the current version of the robot. */
async function changesIn(connection, folder) {
  if ((await connection.run("[ -e foresight/current ]")).status !== 0) return "everything";
  const files = (await connection.push(folder, "foresight/current", { dry: true })).split("\n");
  const changed = files.filter((line) => /^(<f|\*deleting)/.test(line)).map((line) => line.trim().split(/\s+/).at(-1));
  return changed.join(", ") || "nothing new";
}

/** Reports what install() would do, and changes nothing. */
export async function rehearse(connection, folder, { force }, say) {
  await refuseOther(connection);
  await refuseInGame(connection, { force });
  const status = await statusOf(connection);
  say(`would send ${await changesIn(connection, folder)}; ${status ? `build ${status.build} runs` : "nothing runs"} now`);
}

/**
 * Installs the version in `folder` and reports each step to `say`. Without `restart` the running version continues until its
 * next start. `force` allows it during a game. After a RobotFailed the previous version runs, if possible.
 */
export async function install(connection, folder, { restart, force }, say) {
  await refuseOther(connection);
  await refuseInGame(connection, { force });

  say("sends");
  await connection.must("preparing ~/foresight", kPrepare);
  await connection.push(folder, "foresight/staging", { like: "../current" });
  const build = await buildOf(connection, "foresight/staging");

  // sending takes a while, and a game may have begun
  await refuseInGame(connection, { force });
  if (restart) {
    await refuseTakenPort(connection);
    await installGuardian(connection, say);
  }
  say(restart ? "starts" : "swaps");
  await connection.must("the version could not be swapped", switchTo(versionName(build), { restart }));
  if (!restart) return say(`build ${build} is there and runs when it is started next`);
  const whyNot = await whyNotUp(connection, build).catch((error) => {
    throw new RobotFailed(`${error.message}; build ${build} was started, but it is unknown whether it answers`);
  });
  if (whyNot) await rollBack(connection, `build ${build}: ${whyNot}`);
  say(`runs build ${build}`);
}
