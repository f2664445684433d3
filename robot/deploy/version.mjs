// The files of a version for a robot: program, settings, identity of the robot, and service script.
import { existsSync, mkdirSync, symlinkSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { BadInput } from "./failure.mjs";
import { removeScratch, scratchFolder } from "./scratch.mjs";

const kOnRobot = fileURLToPath(new URL("on_robot/", import.meta.url));

const isFile = (strategy) => strategy.endsWith(".json");
/** Folder of the team's own strategies in a version. They may have any name, also "robot.json". */
const kStrategies = "etc/strategies";
/** Returns the name of a strategy on the robot; a team's own files are in the version. */
const onRobot = (strategy) => (isFile(strategy) ? `current/${kStrategies}/${basename(strategy)}` : strategy);

/** Returns the options of foresight-robot, one per line without dashes; paths are below ~/foresight. `field` may be absent. */
export function settingsOf(robot, { field } = {}) {
  const lines = [
    `body=${robot.body}`,
    `team=${robot.team}`,
    `player=${robot.player}`,
    ...(robot.rules === undefined ? [] : [`rules=${robot.rules}`]),
    ...(robot.strategies === undefined ? [] : [`strategies=${robot.strategies.map(onRobot).join(",")}`]),
    ...(robot.foresight ? ["foresight"] : []),
    "game-controller",
    ...(robot.practice ? ["practice"] : []),
    ...(field === undefined ? [] : [`field=${field}`]),
    ...(robot.host_names ?? []).map((host) => `allow-host=${host}`),
    "bind=0.0.0.0",
    `port=${robot.http_port}`,
    "log-dir=logs",
    "state-dir=state",
  ];
  return `# written by scripts/deploy for the robot ${robot.name}\n${lines.join("\n")}\n`;
}

/** Returns the identity of the robot as JSON, for the team's own code. */
export function identityOf({ name, team, player, colour, model, head_id, body_id }, { field } = {}) {
  return `${JSON.stringify({ name, team, player, colour, model, head_id, body_id, field }, null, 2)}\n`;
}

/** Adds the service script and its unit. The script's name selects the program beside it that it starts. */
function addStarter(folder, name, unit) {
  symlinkSync(join(kOnRobot, "foresight"), join(folder, name));
  symlinkSync(join(kOnRobot, unit), join(folder, unit));
}

/** Adds the guardian as a version inside the version, from which it is copied when the robot allows it. */
function addGuardian(folder, program) {
  for (const name of ["bin", "etc"]) mkdirSync(join(folder, name), { recursive: true });
  symlinkSync(program, join(folder, "bin/foresight-guardian"));
  addStarter(folder, "guardian", "foresight-guardian.service");
  writeFileSync(join(folder, "etc/settings"), "# written by scripts/deploy\n");
}

/** Adds the team's own strategies. */
function addStrategies(folder, files) {
  mkdirSync(join(folder, kStrategies));
  for (const file of files) {
    if (!existsSync(file)) throw new BadInput(`strategies: expected a file, got ${file}, which is not there`);
    symlinkSync(file, join(folder, kStrategies, basename(file)));
  }
}

/**
 * Calls `use` with a temporary folder of links to all files for `robot`. `programs` is {runtime, guardian}; only robots with the
 * body nao have a guardian.
 */
export async function withVersion(robot, programs, given, use) {
  const folder = scratchFolder();
  try {
    for (const name of ["bin", "etc"]) mkdirSync(join(folder, name));
    symlinkSync(programs.runtime, join(folder, "bin/foresight-robot"));
    addStarter(folder, "foresight", "foresight.service");
    writeFileSync(join(folder, "etc/settings"), settingsOf(robot, given));
    writeFileSync(join(folder, "etc/robot.json"), identityOf(robot, given));
    addStrategies(folder, (robot.strategies ?? []).filter(isFile));
    if (programs.guardian) addGuardian(join(folder, "guardian"), programs.guardian);
    return await use(folder);
  } finally {
    removeScratch(folder);
  }
}
