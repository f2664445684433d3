// The robots file: names, addresses and identities of a team's robots.
//
// It is `~/.config/foresight/robots.json`, or the file that $FORESIGHT_ROBOTS or --robots names. Example: robots.example.json.
import { readFileSync } from "node:fs";
import { isIP } from "node:net";
import { homedir } from "node:os";
import { basename, dirname, join, resolve } from "node:path";
import { BadInput } from "./failure.mjs";

export const kModels = ["nao-v4", "nao-v5", "nao-v6"];
const kBodies = ["attached", "nao"];
export const kColours = ["blue", "red", "yellow", "black", "white", "green", "orange", "purple", "brown", "grey"];
export const kPlayers = [1, 20], kTeams = [0, 255];
const kPorts = [1, 65535];

const isIn = ([from, to]) => (value) => Number.isInteger(value) && value >= from && value <= to;
const whole = (range) => ({ isRight: isIn(range), words: `a whole number ${range[0]} .. ${range[1]}` });
const word = (pattern, words) => ({ isRight: (value) => typeof value === "string" && pattern.test(value), words });
const among = (words) => ({ isRight: (value) => words.includes(value), words: words.join(", ") });

// a word in a command line of ssh must not begin like an option
const address = word(/^[A-Za-z0-9][A-Za-z0-9.:_-]*$/, "an IP address or host name");
const name = word(/^[A-Za-z][A-Za-z0-9_-]*$/, "a letter, then letters, digits, _ and -");
const identity = word(/^[\x21-\x7e]+$/, "an id as the robot has it, without blanks");

const isListOfStrategies = (value) =>
  Array.isArray(value) &&
  value.length >= 1 &&
  value.length <= 8 &&
  value.every((one) => typeof one === "string" && /^[^,\n]*[\w-]$/.test(one)) &&
  new Set(value.map((one) => basename(one))).size === value.length;

const kTeamKeys = {
  team: whole(kTeams),
  colour: among(kColours),
  key: word(/^[^\s]+$/, "the path of a private ssh key, without blanks"),
  rules: word(/^[a-z0-9_]+$/, "the name of rules, such as spl2025"),
  strategies: { isRight: isListOfStrategies, words: "a list of 1 .. 8 names of strategies, or .json files of your own with different names" },
  foresight: { isRight: (value) => typeof value === "boolean", words: "true or false" },
  practice: { isRight: (value) => typeof value === "boolean", words: "true or false" },
  robots: { isRight: Array.isArray, words: "a list of robots" },
};
const kRobotKeys = {
  name,
  address,
  wired: address,
  wireless: address,
  model: among(kModels),
  body: among(kBodies),
  player: whole(kPlayers),
  team: whole(kTeams),
  colour: among(kColours),
  head_id: identity,
  body_id: identity,
  ssh_port: whole(kPorts),
  http_port: whole(kPorts),
  user: word(/^[a-z_][a-z0-9_-]*$/, "the name of a user on the robot"),
};
const kDefaults = { body: "attached", user: "nao", ssh_port: 22, http_port: 8765 };

/** Returns a value as JSON text, cut short. */
const shown = (value) => {
  const text = value === undefined ? "nothing" : JSON.stringify(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
};

function checkObject(where, value, keys, needed) {
  if (typeof value !== "object" || value === null || Array.isArray(value)) throw new BadInput(`${where}: expected an object, got ${shown(value)}`);
  for (const [key, got] of Object.entries(value)) {
    if (!Object.hasOwn(keys, key)) throw new BadInput(`${where}: expected ${Object.keys(keys).join(", ")}, got the unknown key '${key}'`);
    if (!keys[key].isRight(got)) throw new BadInput(`${where}.${key}: expected ${keys[key].words}, got ${shown(got)}`);
  }
  for (const key of needed)
    if (!Object.hasOwn(value, key)) throw new BadInput(`${where}.${key}: expected ${keys[key].words}, got nothing`);
}

/** Returns the addresses in the order of attempts: a cable is faster and does not disturb the wireless network. */
function addressesOf(where, robot) {
  const addresses = [robot.address, robot.wired, robot.wireless].filter((one) => one !== undefined);
  if (addresses.length === 0) throw new BadInput(`${where}: expected an address, or wired and wireless, got neither`);
  if (robot.address && addresses.length > 1) throw new BadInput(`${where}.address: expected either address or wired and wireless, got both`);
  return addresses;
}

/** A check of values that two robots must not share. */
class Taken {
  #owners = new Map();

  claim(where, what, value) {
    const key = `${what} ${value}`;
    if (this.#owners.has(key)) throw new BadInput(`${where}: expected every ${what} once, got ${value} of ${this.#owners.get(key)} again`);
    this.#owners.set(key, where.replace(/\.\w+$/, ""));
  }
}

/**
 * Parses `text` of the robots file. Returns [{name, addresses, model, body, player, team, colour, key, head_id, body_id,
 * user, ssh_port, http_port, rules, strategies, foresight, practice, host_names}]. `host_names` are the addresses that are names.
 * The members colour, key, ids, rules, strategies, foresight, practice and host_names may be absent.
 * `file` is its name in errors, and its folder is that of the files of strategies. `home` replaces ~.
 */
export function parseTeam(file, text, home = homedir()) {
  let team;
  try {
    team = JSON.parse(text);
  } catch (error) {
    throw new BadInput(`${file}: expected JSON, got ${error.message}`);
  }
  checkObject(`${file}: $`, team, kTeamKeys, ["robots"]);
  const atHome = (path) => path.replace(/^~(?=\/)/, home);
  const taken = new Taken();
  // all robots of a team choose between the same strategies
  const ofAll = Object.fromEntries(["rules", "foresight", "practice"].filter((key) => key in team).map((key) => [key, team[key]]));
  if (team.strategies) ofAll.strategies = team.strategies.map((one) => (one.endsWith(".json") ? resolve(dirname(file), atHome(one)) : one));
  return team.robots.map((robot, index) => {
    const where = `${file}: $.robots[${index}]`;
    checkObject(where, robot, kRobotKeys, ["name", "model", "player"]);
    const { address, wired, wireless, ...rest } = robot;
    const whole = { ...kDefaults, colour: team.colour, team: team.team, key: team.key && atHome(team.key), ...ofAll, ...rest };
    if (whole.team === undefined) throw new BadInput(`${where}.team: expected ${kRobotKeys.team.words} here or for all, got nothing`);
    if (whole.body === "nao" && whole.model !== "nao-v6") throw new BadInput(`${where}.body: expected attached of a ${whole.model}, which has no LoLA, got nao`);
    whole.addresses = addressesOf(where, robot);
    // browsers send these names, and the robot answers to no other than its own
    const names = whole.addresses.filter((one) => isIP(one) === 0);
    if (names.length > 0) whole.host_names = names;
    taken.claim(`${where}.name`, "name", robot.name);
    taken.claim(`${where}.player`, "player", `${whole.team}/${robot.player}`);
    for (const one of new Set(whole.addresses)) taken.claim(`${where}.address`, "address", `${one}:${whole.ssh_port}`);
    return whole;
  });
}

export const robotsFile = (given) => given ?? process.env.FORESIGHT_ROBOTS ?? join(homedir(), ".config/foresight/robots.json");

export function readTeam(file) {
  try {
    return parseTeam(file, readFileSync(file, "utf8"));
  } catch (error) {
    if (error.code === undefined) throw error;
    throw new BadInput(`${file}: expected the team's robots (robot/deploy/robots.example.json shows how), got ${error.code}`);
  }
}

/** Returns the robots of `team` that `words` name, each by its name, its player number or one of its addresses. */
export function pick(team, words, file) {
  if (words.length === 0) throw new BadInput("expected the name, player number or address of at least one robot, got none");
  const picked = words.map((word) => {
    const found = team.filter((robot) => robot.name === word || String(robot.player) === word || robot.addresses.includes(word));
    if (found.length === 0) throw new BadInput(`expected one of ${team.map((robot) => robot.name).join(", ")} (${file}), got '${word}'`);
    if (found.length > 1) throw new BadInput(`expected the name of one robot, but '${word}' are ${found.map((robot) => robot.name).join(" and ")}`);
    // a given address is the only one to use
    return found[0].addresses.includes(word) ? { ...found[0], addresses: [word] } : found[0];
  });
  const doubled = picked.find((robot, index) => picked.findIndex((other) => other.name === robot.name) !== index);
  if (doubled) throw new BadInput(`expected each robot once, got ${doubled.name} twice`);
  return picked;
}
