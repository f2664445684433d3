// scripts/deploy: sets robots up, installs Foresight on them, or removes it.
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { BadInput, runMain } from "./failure.mjs";
import { install, rehearse } from "./install.mjs";
import { Lines, sideBySide } from "./lines.mjs";
import { anyText, oneOf, readCommandLine, wholeNumber } from "./options.mjs";
import { setUp } from "./setup.mjs";
import { connected } from "./ssh.mjs";
import { kColours, kPlayers, kTeams, pick, readTeam, robotsFile } from "./team.mjs";
import { undo } from "./undo.mjs";
import { withVersion } from "./version.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));

function fieldName(value, option) {
  if (!/^[A-Za-z0-9-]{1,16}$/.test(value)) throw new BadInput(`${option}: expected up to 16 letters, digits and -, got '${value}'`);
  return value;
}

const kOptions = {
  setup: true,
  undo: true,
  robots: anyText,
  player: wholeNumber(...kPlayers),
  team: wholeNumber(...kTeams),
  colour: oneOf(kColours),
  field: fieldName,
  practice: true,
  build: anyText,
  "no-build": true,
  program: anyText,
  guardian: anyText,
  "dry-run": true,
  "no-restart": true,
  force: true,
  yes: true,
};

/** Returns the robots with the identity from the command line, which overrides that of the file. */
function identified(robots, { player, team, colour, practice }) {
  if (player !== undefined && robots.length > 1) throw new BadInput(`--player: expected one robot to give number ${player}, got ${robots.length}`);
  const given = Object.fromEntries(Object.entries({ player, team, colour, practice }).filter(([, value]) => value !== undefined));
  return robots.map((robot) => ({ ...robot, ...given }));
}

/** Returns the path of a file that was built elsewhere. */
function givenFile(option, path) {
  if (path !== undefined && !existsSync(path)) throw new BadInput(`${option}: expected a file, got '${path}'`);
  return path && resolve(path);
}

const kPrograms = { runtime: "foresight-robot", guardian: "foresight-guardian" };

/** The keys of kPrograms that a robot needs. */
const neededBy = ({ body }) => (body === "nao" ? ["runtime", "guardian"] : ["runtime"]);

function builtFile(robot, preset, kind) {
  const path = join(root, "build", preset, "bin", kPrograms[kind]);
  if (!existsSync(path)) throw new BadInput(`${robot.name}: expected the program ${path}, got none: leave out --no-build`);
  return path;
}

/**
 * Returns the programs of each robot by its name, {runtime, guardian}; only robots with the body nao have a guardian. Unless
 * --no-build is given, missing programs are built: once per preset, before any robot is touched.
 */
function programs(robots, { build, program, guardian, ...options }) {
  const given = { runtime: givenFile("--program", program), guardian: givenFile("--guardian", guardian) };
  const needed = (some) => [...new Set(some.flatMap(neededBy))];
  if (given.guardian && !needed(robots).includes("guardian")) throw new BadInput("--guardian: expected a robot with the body nao, got none");
  const presetOf = (robot) => build ?? robot.model;
  if (!options["no-build"])
    for (const preset of new Set(robots.map(presetOf))) {
      const kinds = needed(robots.filter((robot) => presetOf(robot) === preset)).filter((kind) => !given[kind]);
      if (kinds.length === 0) continue;
      const { status } = spawnSync(join(root, "scripts/build"), [preset, ...kinds.map((kind) => kPrograms[kind])], { stdio: "inherit" });
      if (status !== 0) throw new BadInput(`scripts/build ${preset} ended with status ${status}; no robot was touched`);
    }
  const programsOf = (robot) => Object.fromEntries(neededBy(robot).map((kind) => [kind, given[kind] ?? builtFile(robot, presetOf(robot), kind)]));
  return new Map(robots.map((robot) => [robot.name, programsOf(robot)]));
}

async function main(words) {
  const { names, options } = readCommandLine("deploy", words, kOptions);
  const file = robotsFile(options.robots);
  const robots = identified(pick(readTeam(file), names, file), options);
  if (options.setup && options.undo) throw new BadInput("expected --setup or --undo, got both");
  if (options.setup) return setUp(robots, options);
  if (options.undo) return undo(robots, options);

  const programsOf = programs(robots, options);
  const lines = new Lines(robots.map((robot) => robot.name));
  const good = await sideBySide(lines, robots, (robot) => {
    const say = (text) => lines.say(robot.name, text);
    return withVersion(robot, programsOf.get(robot.name), options, (folder) =>
      connected(robot, (connection) => {
        if (options["dry-run"]) return rehearse(connection, folder, options, say);
        return install(connection, folder, { restart: !options["no-restart"], force: options.force }, say);
      }),
    );
  });
  return good.length === robots.length ? 0 : 1;
}

await runMain("deploy", main);
