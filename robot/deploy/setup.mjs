// scripts/deploy --setup: examines a robot, installs our key, asks for steps that need root, reports what it could not do.
import { agrees, kFavours, priorityOf, runAsRoot } from "./as_root.mjs";
import { RobotFailed } from "./failure.mjs";
import { refuseOther } from "./install.mjs";
import { hasKey, kMakeKeysFile, kReplaceKeys, publicKey, withKey } from "./key.mjs";
import { kPrepare } from "./layout.mjs";
import { described, kProbe, readProbe, whyNotModel } from "./probe.mjs";
import { connected, knownHosts, quoted, run } from "./ssh.mjs";

const kLeast_mb = 100; // two versions and a half in profile game

/** Forgets the host key of a robot, which may have been flashed again. The next login learns it. */
export const forgetHost = ({ name }) => run(["ssh-keygen", "-q", "-R", `${name}.foresight`, "-f", knownHosts()]);

async function probed(connection) {
  const before_s = Date.now() / 1000;
  const text = await connection.must("looking at the robot", kProbe);
  return readProbe(text, before_s, Date.now() / 1000);
}

async function bringKey(connection, line) {
  const text = (await connection.run("cat .ssh/authorized_keys 2>/dev/null")).stdout;
  if (hasKey(text, line)) return "our key is there already";
  await connection.must("noting what is made", `${kMakeKeysFile}\necho ${quoted(`key ${line}`)} >>foresight/made`);
  await connection.must("writing .ssh/authorized_keys", kReplaceKeys, { input: withKey(text, line) });
  return "our key is there now";
}

/** Asks for the steps that need root, and returns those that were not done. */
async function askFavours(connection, probe, options) {
  const { robot } = connection;
  const missing = [];
  for (const [name, favour] of Object.entries(kFavours)) {
    if (!favour.isWanted(probe, robot)) continue;
    const command = favour.command(robot);
    const agreed = await agrees(`${robot.name}: root on the robot: ${command}\n  ${favour.why}. Do it?`, options);
    if (agreed) await connection.must("noting what is made", `echo root ${name} >>foresight/made`);
    if (!agreed || !(await runAsRoot(connection, command))) missing.push(`${favour.why}: as root on the robot: ${command}`);
  }
  return missing;
}

/** Returns what the user should know or do. Foresight runs without it. */
function shortcomings(probe, robot) {
  const missing = [];
  if (!probe.hasUserSystemd) missing.push("starting with the robot: no systemd of this user; the team's own start-up may call ~/foresight/current/foresight start");
  if (!probe.hasRsync) missing.push("deploying: the robot has no rsync");
  if (probe.free_mb < kLeast_mb) missing.push(`recording: expected ${kLeast_mb} MB of free disk, got ${probe.free_mb} MB`);
  if (probe.init !== "systemd" && probe.priority < priorityOf(robot)) missing.push("a real-time priority: not allowed here, it runs without");
  return missing;
}

async function setUpOne(robot, options) {
  const line = publicKey(robot);
  const say = (text) => console.log(`${robot.name}  ${text}`);
  await forgetHost(robot);
  await connected(
    robot,
    async (connection) => {
      const probe = await probed(connection);
      for (const text of described(probe)) say(text);
      await refuseOther(connection);
      const misfit = whyNotModel(robot.model, probe);
      if (misfit) throw new RobotFailed(misfit);
      await connection.must("preparing ~/foresight", kPrepare);
      say(await bringKey(connection, line));
      const missing = [...(await askFavours(connection, probe, options)), ...shortcomings(probe, robot)];
      for (const text of missing) say(`NOT done: ${text}`);
    },
    { interactive: true },
  );
  await connected(robot, async () => say("set up: scripts/deploy logs in without a password"));
}

/** Does `work` for one robot after the other, because it may ask questions. Returns the exit status. */
export async function oneByOne(robots, work) {
  let failed = 0;
  for (const robot of robots) {
    try {
      await work(robot);
    } catch (error) {
      if (!(error instanceof RobotFailed)) throw error;
      console.log(`${robot.name}  FAILED: ${error.message}`);
      ++failed;
    }
  }
  return failed === 0 ? 0 : 1;
}

export const setUp = (robots, options) => oneByOne(robots, (robot) => setUpOne(robot, options));
