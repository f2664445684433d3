// The robots file: allowed content, and the errors for other content.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { parseTeam, pick } from "../../robot/deploy/team.mjs";

const tim = { name: "tim", address: "10.0.14.2", model: "nao-v6", player: 2 };
const lea = { name: "lea", wired: "10.1.14.3", wireless: "10.0.14.3", model: "nao-v4", player: 3 };

/** Reads a file of these robots. */
const read = (robots, team = { team: 14 }) => parseTeam("robots.json", JSON.stringify({ ...team, robots }), "/home/me");

test("the example is valid", () => {
  const file = new URL("../../robot/deploy/robots.example.json", import.meta.url);
  assert.deepEqual(
    parseTeam("example", readFileSync(file, "utf8")).map(({ name }) => name),
    ["tim", "lea", "old"],
  );
});

test("missing values of a robot come from the team or the defaults; the cable comes first", () => {
  const [one, other] = read([tim, { ...lea, team: 15, colour: "red", user: "robot", ssh_port: 2222 }], {
    team: 14,
    colour: "blue",
    key: "~/.ssh/nao",
  });
  assert.deepEqual(one, {
    name: "tim",
    model: "nao-v6",
    body: "attached",
    player: 2,
    team: 14,
    colour: "blue",
    key: "/home/me/.ssh/nao",
    user: "nao",
    ssh_port: 22,
    http_port: 8765,
    addresses: ["10.0.14.2"],
  });
  assert.deepEqual(
    [other.team, other.colour, other.user, other.ssh_port, other.addresses],
    [15, "red", "robot", 2222, ["10.1.14.3", "10.0.14.3"]],
  );
});

const wrong = [
  ["no JSON", "{", /^robots.json: expected JSON, got /],
  ["no object", "[]", "robots.json: $: expected an object, got []"],
  ["no robots", "{}", "robots.json: $.robots: expected a list of robots, got nothing"],
  [
    "an unknown key of the team",
    '{"robotz": []}',
    "robots.json: $: expected team, colour, key, rules, strategies, foresight, practice, robots, got the unknown key 'robotz'",
  ],
  ["a robot that is none", '{"robots": [3]}', "robots.json: $.robots[0]: expected an object, got 3"],
];
for (const [name, text, says] of wrong)
  test(`${name} is one sentence`, () => assert.throws(() => parseTeam("robots.json", text), { message: says }));

const where = "robots.json: $.robots[1]";
const wrongRobots = [
  [
    "an unknown key",
    { ...lea, plyer: 3 },
    new RegExp(`^${where.replace(/[$.[\]]/g, "\\$&")}: expected name, address, .*, got the unknown key 'plyer'$`),
  ],
  ["no model", { ...lea, model: undefined }, `${where}.model: expected nao-v4, nao-v5, nao-v6, got nothing`],
  ["another model", { ...lea, model: "nao-v3" }, `${where}.model: expected nao-v4, nao-v5, nao-v6, got "nao-v3"`],
  ["an unknown body", { ...lea, body: "sim" }, `${where}.body: expected attached, nao, got "sim"`],
  [
    "a body of ours where there is no LoLA",
    { ...lea, body: "nao" },
    `${where}.body: expected attached of a nao-v4, which has no LoLA, got nao`,
  ],
  ["a player that is no number", { ...lea, player: "3" }, `${where}.player: expected a whole number 1 .. 20, got "3"`],
  ["a player beyond all", { ...lea, player: 21 }, `${where}.player: expected a whole number 1 .. 20, got 21`],
  [
    "a colour that nobody wears",
    { ...lea, colour: "pink" },
    `${where}.colour: expected blue, red, yellow, black, white, green, orange, purple, brown, grey, got "pink"`,
  ],
  [
    "an address like an option",
    { ...lea, wired: "-oProxyCommand=x" },
    `${where}.wired: expected an IP address or host name, got "-oProxyCommand=x"`,
  ],
  [
    "no address",
    { ...lea, wired: undefined, wireless: undefined },
    `${where}: expected an address, or wired and wireless, got neither`,
  ],
  [
    "two kinds of address",
    { ...lea, address: "10.0.14.9" },
    `${where}.address: expected either address or wired and wireless, got both`,
  ],
  [
    "a name twice",
    { ...lea, name: "tim" },
    `${where}.name: expected every name once, got tim of robots.json: $.robots[0] again`,
  ],
  [
    "a player twice",
    { ...lea, player: 2 },
    `${where}.player: expected every player once, got 14/2 of robots.json: $.robots[0] again`,
  ],
  [
    "an address twice",
    { ...lea, wireless: "10.0.14.2" },
    `${where}.address: expected every address once, got 10.0.14.2:22 of robots.json: $.robots[0] again`,
  ],
  [
    "a name that is a number",
    { ...lea, name: "3" },
    `${where}.name: expected a letter, then letters, digits, _ and -, got "3"`,
  ],
];
for (const [name, robot, says] of wrongRobots)
  test(`${name} is one sentence`, () => assert.throws(() => read([tim, robot]), { message: says }));

test("a robot without a team in a file without one is refused", () => {
  assert.throws(() => read([tim], {}), {
    message: "robots.json: $.robots[0].team: expected a whole number 0 .. 255 here or for all, got nothing",
  });
});

test("every truncation of the file is refused", () => {
  const text = JSON.stringify({ team: 14, robots: [tim, lea] });
  for (let size = 0; size < text.length; ++size)
    assert.throws(() => parseTeam("robots.json", text.slice(0, size)), /^BadInput|expected JSON/);
});

test("robots are picked by name, by number and by address; an address selects exactly that one", () => {
  const team = read([tim, lea]);
  const picked = (...words) => pick(team, words, "robots.json").map(({ name, addresses }) => [name, ...addresses]);
  assert.deepEqual(picked("lea"), [["lea", "10.1.14.3", "10.0.14.3"]]);
  assert.deepEqual(picked("3", "tim"), [
    ["lea", "10.1.14.3", "10.0.14.3"],
    ["tim", "10.0.14.2"],
  ]);
  assert.deepEqual(picked("10.0.14.3"), [["lea", "10.0.14.3"]]);
  assert.throws(() => picked(), {
    message: "expected the name, player number or address of at least one robot, got none",
  });
  assert.throws(() => picked("bob"), { message: "expected one of tim, lea (robots.json), got 'bob'" });
  assert.throws(() => picked("lea", "3"), { message: "expected each robot once, got lea twice" });
});

test("a player number of two teams selects no robot", () => {
  const team = read([tim, { ...lea, player: 2, team: 15 }]);
  assert.throws(() => pick(team, ["2"], "robots.json"), {
    message: "expected the name of one robot, but '2' are tim and lea",
  });
});
