// scripts/deploy --undo: removes every trace of Foresight from a robot.
import { agrees, kFavours, runAsRoot } from "./as_root.mjs";
import { refuseInGame } from "./game.mjs";
import { RobotFailed } from "./failure.mjs";
import { kReplaceKeys, withoutKey } from "./key.mjs";
import { kStopAll } from "./layout.mjs";
import { forgetHost, oneByOne } from "./setup.mjs";
import { connected, quoted } from "./ssh.mjs";

const kReload = "XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/run/user/$(id -u)} systemctl --user daemon-reload 2>/dev/null || :";

// `made` is removed last, so that an interrupted undo can be repeated; with kept recordings it stays, empty
const kRemove = (withLogs) => `
set -e
rm -f /dev/shm/foresight-$(id -u).*
cd foresight
rm -rf staging versions current previous current.new previous.new guardian guardian.old state
${withLogs ? "rm -rf logs made" : ": >made"}
cd ..
rmdir foresight 2>/dev/null || :`;

async function removeKey(connection, line) {
  const text = (await connection.run("cat .ssh/authorized_keys 2>/dev/null")).stdout;
  const without = withoutKey(text, line);
  if (without !== text) await connection.must("writing .ssh/authorized_keys", kReplaceKeys, { input: without });
}

/** Undoes one line of ~/foresight/made. Returns what could not be undone, or undefined. A second call does no harm. */
async function takeBack(connection, line, options) {
  const [kind, ...rest] = line.split(" ");
  const what = rest.join(" ");
  if (kind === "key") return removeKey(connection, what);
  // files that others have put there since stay
  if (kind === "folder") await connection.run(`rmdir ${quoted(what)} 2>/dev/null`);
  else if (what === ".ssh/authorized_keys") await connection.run(`[ -s ${what} ] || rm -f ${what}`);
  else if (kind === "file") await connection.run(`rm -f ${quoted(what)}`);
  if (kind !== "root") return undefined;
  const command = kFavours[what]?.undo(connection.robot);
  if (command && (await agrees(`${connection.robot.name}: root on the robot: ${command}\n  It takes back what was set up. Do it?`, options)) && (await runAsRoot(connection, command))) return undefined;
  return `as root on the robot: ${command ?? what}`;
}

/** Returns true if the recordings may be removed too, or if there are none. */
async function mayRemoveLogs(connection, options) {
  const { stdout } = await connection.run("ls foresight/logs 2>/dev/null | wc -l; du -sk foresight/logs 2>/dev/null");
  const [count, kb] = stdout.split("\n").map((line) => parseInt(line, 10));
  if (!count) return true;
  return agrees(`${connection.robot.name}: recordings are still on the robot: ${count}, together ${Math.ceil(kb / 1000)} MB. Remove them?`, options);
}

async function undoOne(robot, options) {
  const say = (text) => console.log(`${robot.name}  ${text}`);
  await connected(robot, async (connection) => {
    const { status, stdout } = await connection.run("cat foresight/made");
    if (status !== 0) throw new RobotFailed("expected ~/foresight with the file made, got none: there is nothing of ours to remove");
    await refuseInGame(connection, options);
    const withLogs = await mayRemoveLogs(connection, options);
    await connection.must("stopping", kStopAll);
    for (const line of stdout.trim().split("\n").reverse()) {
      const left = await takeBack(connection, line, options);
      if (left) say(`NOT undone: ${left}`);
    }
    await connection.run(kReload);
    await connection.must("removing ~/foresight", kRemove(withLogs));
    say(withLogs ? "nothing of ours is left" : "nothing of ours is left but ~/foresight/logs");
  });
  await forgetHost(robot);
}

export const undo = (robots, options) => oneByOne(robots, (robot) => undoOne(robot, options));
