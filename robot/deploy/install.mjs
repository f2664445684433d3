// Brings a version to one robot: staged beside what runs, then swapped, then proved by its own answer; else rolled back.
import { RobotFailed } from "./failure.mjs";
import { refuseInGame, statusOf } from "./game.mjs";
import { kGuardianStatus, kPrepare, kPutGuardianBack, kRollBack, kSwapGuardian, switchTo } from "./layout.mjs";

const kPatience_ms = 20000; // until a version that starts must have answered: a V4's flash is slow
const kPause_ms = 200;

/** A name for a version that sorts by time: 20261122-041546_0123abcd. */
const versionName = (build) => `${new Date().toISOString().slice(0, 19).replace(/[-:]/g, "").replace("T", "-")}_${build.replace(/[^\w+.-]/g, "")}`;

/** The build of the program in `folder`, told by itself, on the robot. */
async function buildOf(connection, folder) {
  const build = (await connection.must(`the program does not run on this robot`, `${folder}/bin/foresight-robot --version`)).trim();
  if (!/^[\w+.-]{1,64}$/.test(build)) throw new RobotFailed(`the program: expected its build for --version, got '${build.slice(0, 60)}'`);
  return build;
}

/** Refuses a robot that is not the one of the robots file: addresses were mixed up, or heads. */
export async function refuseOther(connection) {
  const { head_id } = connection.robot;
  const { stdout } = await connection.run("cat /sys/qi/head_id 2>/dev/null");
  if (head_id && stdout.trim() && stdout.trim() !== head_id) throw new RobotFailed(`this is another robot: expected head_id ${head_id}, got ${stdout.trim()}`);
}

/** Waits for the service to answer as `build`. Undefined when it does, else a sentence why not. */
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

/** What nobody but us may use. */
async function refuseTakenPort(connection) {
  const { status } = await connection.run("foresight/current/foresight status 2>/dev/null");
  const other = status === 0 ? undefined : await statusOf(connection);
  if (other) throw new RobotFailed(`port ${connection.robot.http_port} is taken by a runtime (build ${other.build}) that was not started by us: stop it first`);
}

/** Waits for the guardian to answer. Undefined when it does, else what it said. */
async function whyNoGuardian(connection) {
  const end = performance.now() + kPatience_ms;
  for (;;) {
    const { status, stdout, stderr } = await connection.run(kGuardianStatus);
    if (status < 2) return undefined;
    if (status === 4 || performance.now() > end) return (stdout + stderr).trim();
    await new Promise((done) => setTimeout(done, kPause_ms));
  }
}

/** The guardian of what was staged, before the runtime that speaks to it. One that does not run is put back. */
async function installGuardian(connection, say) {
  const [told, ...how] = (await connection.must("the guardian could not be swapped", kSwapGuardian)).trim().split(" ");
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

/** What push() would change in the current version of the robot, in words. */
async function changesIn(connection, folder) {
  if ((await connection.run("[ -e foresight/current ]")).status !== 0) return "everything";
  const files = (await connection.push(folder, "foresight/current", { dry: true })).split("\n");
  const changed = files.filter((line) => /^(<f|\*deleting)/.test(line)).map((line) => line.trim().split(/\s+/).at(-1));
  return changed.join(", ") || "nothing new";
}

/** Tells what install() would do, and changes nothing. */
export async function rehearse(connection, folder, { force }, say) {
  await refuseOther(connection);
  await refuseInGame(connection, { force });
  const status = await statusOf(connection);
  say(`would send ${await changesIn(connection, folder)}; ${status ? `build ${status.build} runs` : "nothing runs"} now`);
}

/**
 * Installs what lies in `folder`. `say` tells how far it is. `restart`: false leaves what runs running until somebody starts
 * it anew. `force`: also while a game is under way. Throws RobotFailed; then what ran before runs, as far as it can.
 */
export async function install(connection, folder, { restart, force }, say) {
  await refuseOther(connection);
  await refuseInGame(connection, { force });

  say("sends");
  await connection.must("preparing ~/foresight", kPrepare);
  await connection.push(folder, "foresight/staging", { like: "../current" });
  const build = await buildOf(connection, "foresight/staging");

  // sending takes a while, and games begin
  await refuseInGame(connection, { force });
  if (restart) {
    await refuseTakenPort(connection);
    await installGuardian(connection, say);
  }
  say(restart ? "starts" : "swaps");
  await connection.must("the version could not be swapped", switchTo(versionName(build), { restart }));
  if (!restart) return say(`build ${build} is there and runs when it is started next`);
  const whyNot = await whyNotUp(connection, build).catch((error) => {
    throw new RobotFailed(`${error.message}; build ${build} was started, but not proved`);
  });
  if (whyNot) await rollBack(connection, `build ${build}: ${whyNot}`);
  say(`runs build ${build}`);
}
