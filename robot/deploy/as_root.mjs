// Steps on a robot that need root; each asks the user first.
import { createInterface } from "node:readline/promises";
import { quoted } from "./ssh.mjs";

/** Asks for yes or no at the terminal; `yes` agrees to everything. Without a terminal the answer is no. */
export async function agrees(question, { yes = false } = {}) {
  if (yes) return true;
  if (!process.stdin.isTTY) {
    console.log(`${question} [y/N] there is no terminal to ask: no (--yes agrees)`);
    return false;
  }
  const terminal = createInterface({ input: process.stdin, output: process.stdout });
  const answer = await terminal.question(`${question} [y/N] `);
  terminal.close();
  return /^y/i.test(answer);
}

/** Runs a line of shell on the robot as root, by sudo or su, which may ask for a password. Returns true on success. */
export async function runAsRoot(connection, command) {
  const { status } = await connection.run(`sudo -n sh -c ${quoted(command)} 2>/dev/null`);
  if (status === 0) return true;
  if (!process.stdin.isTTY) return false;
  const withPassword = `if command -v sudo >/dev/null; then sudo sh -c ${quoted(command)}; else su root -c ${quoted(command)}; fi`;
  return (await connection.runAtTerminal(withPassword)) === 0;
}

const kDropIn = "/etc/systemd/system/user@.service.d/foresight.conf";

/** The real-time priority that our programs need: that of the guardian, which answers LoLA, or the lowest. */
export const priorityOf = ({ body }) => (body === "nao" ? 40 : 1);

/** The steps that need root: reason, command and the command that undoes it. Only for robots with systemd. */
export const kFavours = {
  linger: {
    isWanted: (probe) => probe.init === "systemd" && !probe.lingers,
    why: "Foresight starts when the robot is switched on, and not only while somebody is logged in",
    command: ({ user }) => `loginctl enable-linger ${user}`,
    undo: ({ user }) => `loginctl disable-linger ${user}`,
  },
  priority: {
    isWanted: (probe, robot) => probe.init === "systemd" && probe.priority < priorityOf(robot),
    why: "Foresight may have a real-time priority, from the next start of the robot",
    command: (robot) =>
      `mkdir -p ${kDropIn.replace(/\/[^/]*$/, "")} && printf '[Service]\\nLimitRTPRIO=${priorityOf(robot)}\\n${robot.body === "nao" ? "LimitMEMLOCK=infinity\\n" : ""}' >${kDropIn}`,
    undo: () => `rm -f ${kDropIn} && { rmdir ${kDropIn.replace(/\/[^/]*$/, "")} 2>/dev/null || :; }`,
  },
};
