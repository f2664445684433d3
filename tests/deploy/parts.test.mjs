// The parts of the commands that need no robot.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { crc32, crc32OfFile } from "../../robot/deploy/crc32.mjs";
import { gameUnderWay } from "../../robot/deploy/game.mjs";
import { hasKey, publicKey, withKey, withoutKey } from "../../robot/deploy/key.mjs";
import { Lines, sideBySide } from "../../robot/deploy/lines.mjs";
import { anyText, oneOf, readCommandLine, wholeNumber } from "../../robot/deploy/options.mjs";
import { described, readProbe, whyNotModel } from "../../robot/deploy/probe.mjs";
import { RobotFailed } from "../../robot/deploy/failure.mjs";
import { parseTeam } from "../../robot/deploy/team.mjs";
import { identityOf, settingsOf, withVersion } from "../../robot/deploy/version.mjs";
import { temporaryFolder } from "../e2e/support.mjs";

const robot = { name: "tim", team: 14, player: 2, colour: "blue", model: "nao-v6", body: "attached", http_port: 8765 };

test("settings are options of the program, one per line", () => {
  assert.deepEqual(settingsOf(robot, { field: "A" }).split("\n"), [
    "# written by scripts/deploy for the robot tim",
    "body=attached",
    "team=14",
    "player=2",
    "game-controller",
    "field=A",
    "bind=0.0.0.0",
    "port=8765",
    "log-dir=logs",
    "state-dir=state",
    "",
  ]);
  assert.match(settingsOf({ ...robot, body: "nao" }), /^body=nao$/m);
  assert.deepEqual(JSON.parse(identityOf(robot)), {
    name: "tim",
    team: 14,
    player: 2,
    colour: "blue",
    model: "nao-v6",
  });
});

test("a robot answers to the names that it has in the robots file", () => {
  const text = JSON.stringify({
    team: 14,
    robots: [
      { name: "tim", wired: "tim.lab", wireless: "fe80::1", model: "nao-v6", player: 2 },
      { name: "lea", address: "10.0.14.22", model: "nao-v6", player: 3 },
    ],
  });
  const [tim, lea] = parseTeam("robots.json", text);
  assert.match(settingsOf(tim), /^allow-host=tim\.lab\nbind=/m);
  assert.equal(settingsOf(tim).match(/allow-host/g).length, 1);
  assert.doesNotMatch(settingsOf(lea), /allow-host/);
});

test("a team's strategies go to all of its robots, with its own files in the version", async (t) => {
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, "press.json"), "{}");
  const file = join(folder, "robots.json");
  const text = (strategies) =>
    JSON.stringify({
      team: 14,
      rules: "spl2025",
      strategies,
      foresight: true,
      robots: [{ name: "tim", address: "10.0.14.22", model: "nao-v6", player: 2 }],
    });
  const [tim] = parseTeam(file, text(["baseline", "press.json"]));
  assert.match(
    settingsOf(tim),
    /^rules=spl2025\nstrategies=baseline,current\/etc\/strategies\/press\.json\nforesight$/m,
  );
  assert.doesNotMatch(settingsOf(tim), /practice/, "a match is the default");
  assert.match(settingsOf({ ...tim, practice: true }), /^practice$/m);
  await withVersion(tim, { runtime: file }, {}, async (version) =>
    assert.equal(readFileSync(join(version, "etc/strategies/press.json"), "utf8"), "{}"),
  );
  const [lost] = parseTeam(file, text(["baseline", "lost.json"]));
  await assert.rejects(
    withVersion(lost, { runtime: file }, {}, () => assert.fail()),
    { message: `strategies: expected a file, got ${join(folder, "lost.json")}, which is not there` },
  );
  for (const wrong of [[], ["a,b"], ["press.json", "other/press.json"], "baseline", ["foresight\nbind=1"]])
    assert.throws(() => parseTeam(file, text(wrong)), /\$\.strategies: expected a list of 1 \.\. 8 names/);
});

test("a strategy may have the name of a file that the deployment writes", async (t) => {
  const folder = temporaryFolder(t);
  const strategies = ["robot.json", "settings.json"].map((name) => join(folder, name));
  for (const file of strategies) writeFileSync(file, "{}");
  await withVersion({ ...robot, strategies }, { runtime: strategies[0] }, {}, async (version) => {
    assert.equal(readFileSync(join(version, "etc/strategies/robot.json"), "utf8"), "{}");
    assert.equal(JSON.parse(readFileSync(join(version, "etc/robot.json"), "utf8")).name, "tim");
  });
});

test("options can be anywhere; wrong ones give one sentence", () => {
  const known = { yes: true, player: wholeNumber(1, 20), colour: oneOf(["red", "blue"]), field: anyText };
  const read = (...words) => readCommandLine("deploy", words, known);
  assert.deepEqual(read("tim", "--player", "3", "lea", "--yes", "--field=A=B"), {
    names: ["tim", "lea"],
    options: { player: 3, yes: true, field: "A=B" },
  });
  const wrong = [
    [["--nothing"], "unknown option '--nothing'; see scripts/deploy --help"],
    [["-y"], "unknown option '-y'; see scripts/deploy --help"],
    [["--player"], "--player needs a value; see scripts/deploy --help"],
    [["--player", "21"], "--player: expected a whole number 1 .. 20, got '21'"],
    [["--colour=pink"], "--colour: expected red, blue, got 'pink'"],
    [["--yes=1"], "--yes takes no value, got '1'"],
    [["--toString"], "unknown option '--toString'; see scripts/deploy --help"],
  ];
  for (const [words, message] of wrong) assert.throws(() => read(...words), { message });
});

test("a key is added and removed without a change of any other byte", () => {
  const ours = "ssh-ed25519 AAAAours me@home";
  for (const text of [
    "",
    "ssh-rsa AAAAold other\n",
    "# note\n\nssh-rsa AAAAold",
    `${ours}\n`,
    `ssh-rsa AAAAold x\n${ours}`,
  ]) {
    assert.equal(withoutKey(withKey(text, ours), ours), text);
    assert.ok(hasKey(withKey(text, ours), ours));
  }
  assert.ok(hasKey('from="10.0.*" ssh-ed25519 AAAAours another name', ours));
  assert.ok(!hasKey("# ssh-ed25519 AAAAours\nssh-ed25519 AAAAother", ours));
  assert.equal(withoutKey("ssh-rsa AAAAold other\n", ours), "ssh-rsa AAAAold other\n");
});

test("the key is that of the robots file, or the user's own of a type that the robot supports", (t) => {
  const home = temporaryFolder(t);
  mkdirSync(join(home, ".ssh"));
  writeFileSync(join(home, ".ssh/id_ed25519.pub"), "ssh-ed25519 AAAA me\n");
  assert.equal(publicKey(robot, home), "ssh-ed25519 AAAA me");
  assert.throws(
    () => publicKey({ ...robot, model: "nao-v4" }, home),
    /^BadInput|^Error: tim: expected a public ssh key in .*id_rsa.pub/,
  );
  writeFileSync(join(home, "team.pub"), "-----BEGIN OPENSSH PRIVATE KEY-----\n");
  assert.throws(
    () => publicKey({ ...robot, key: join(home, "team") }, home),
    /expected one public ssh key, got '-----BEGIN/,
  );
});

test("CRC-32 equals zlib's, for pieces of any size", async (t) => {
  const bytes = Buffer.from("123456789");
  assert.equal(crc32(bytes), 0xcbf43926);
  for (let cut = 0; cut <= bytes.length; ++cut)
    assert.equal(crc32(bytes.subarray(cut), crc32(bytes.subarray(0, cut))), 0xcbf43926);
  const folder = temporaryFolder(t);
  writeFileSync(join(folder, "empty"), "");
  writeFileSync(join(folder, "nine"), bytes);
  assert.deepEqual(
    [await crc32OfFile(join(folder, "empty")), await crc32OfFile(join(folder, "nine"))],
    ["00000000", "cbf43926"],
  );
});

test("a game is in progress from READY to PLAYING, and while the runtime reports it", () => {
  const cases = [
    [undefined, undefined],
    [{}, undefined],
    [{ state: "initial" }, undefined],
    [{ state: "finished", in_progress: false }, undefined],
    [{ state: "ready" }, "READY"],
    [{ state: "set" }, "SET"],
    [{ state: "playing" }, "PLAYING"],
    [{ state: "standby", in_progress: true }, "STANDBY"],
    [{ in_progress: true }, "in progress"],
  ];
  for (const [game, expected] of cases) assert.equal(gameUnderWay(game === undefined ? undefined : { game }), expected);
});

const b_human = `
== clock
1000
== release
NAME="Ubuntu"
ID=ubuntu
PRETTY_NAME="Ubuntu 22.04.4 LTS"

== kernel
Linux 5.4.0
== machine
x86_64
== flags
flags		: fpu ssse3 sse4_2 movbe popcnt rdrand

== disk
/dev/mmcblk0p3    7000000 1 2345678 1% /home
== init
systemd

== user
systemd

== linger

== me
nao

== priority
0

== lola
srw-rw-rw- 1 nao nao 0 Jan  1 00:00 /tmp/robocup

== programs
bhuman
sshd

== folders
Config
bin

== head
P0000000000000000023

== rsync
/usr/bin/rsync
`;

test("a robot of B-Human's image is recognised", () => {
  const probe = readProbe(b_human, 1030, 1032);
  assert.deepEqual(described(probe), [
    "image: B-Human's image (Ubuntu 22.04.4 LTS), systemd",
    "processor: x86_64, Linux 5.4.0",
    "head: P0000000000000000023",
    "disk: 2345 MB free",
    "LoLA: its socket belongs to nao; there runs bhuman; we leave it alone",
    "clock: 31 s behind this machine's: recordings carry its dates",
  ]);
  assert.deepEqual([probe.hasUserSystemd, probe.lingers, probe.priority, probe.hasRsync], [true, false, 0, true]);
  assert.equal(whyNotModel("nao-v6", probe), undefined);
  assert.equal(whyNotModel("nao-v6", { ...probe, machine: "i686" }), "expected a 64-bit kernel for nao-v6, got 'i686'");
  assert.equal(
    whyNotModel("nao-v4", { ...probe, flags: ["ssse3"] }),
    "expected the processor of a nao-v4, got one without movbe",
  );
});

test("other images are recognised by their release files and kernels", () => {
  const imageOf = (release, kernel = "Linux 5.4") =>
    readProbe(`== release\n${release}\n\n== kernel\n${kernel}\n`, 0, 0).image;
  assert.equal(
    imageOf("opennao-atom release 2.1.4.13", "Linux 2.6.33.9-rt31-aldebaran-rt"),
    "stock NAOqi OS (opennao-atom release 2.1.4.13)",
  );
  assert.equal(imageOf("", "Linux 2.6.33.9-rt31-aldebaran-rt"), "stock NAOqi OS (Linux 2.6.33.9-rt31-aldebaran-rt)");
  assert.equal(imageOf('ID=ubuntu\nPRETTY_NAME="Ubuntu 20.04 LTS"'), "an Ubuntu (Ubuntu 20.04 LTS)");
  assert.equal(imageOf('ID=poky\nPRETTY_NAME="HULKs-OS 5.1"'), "a Yocto image (HULKs-OS 5.1)");
  assert.equal(imageOf("PRETTY_NAME=Debian"), "an unknown image (Debian)");
});

test("every truncation of a robot's description is read without harm", () => {
  for (let size = 0; size < b_human.length; ++size) described(readProbe(b_human.slice(0, size), 0, 0));
});

test("a robot that fails gives the reason and does not delay the others", async () => {
  let text = "";
  const lines = new Lines(["tim", "lena"], { write: (piece) => (text += piece) });
  const good = await sideBySide(lines, [{ name: "tim" }, { name: "lena" }], async ({ name }) => {
    if (name === "tim") throw new RobotFailed("it is off\nsaid the switch");
    lines.say(name, "50 %", { passing: true });
    lines.say(name, "done");
  });
  assert.deepEqual(good, [{ name: "lena" }]);
  assert.deepEqual(text.trim().split("\n").sort(), ["lena  done", "tim   FAILED: it is off", "tim   said the switch"]);
});

test("on a terminal there is one line per robot, as wide as the terminal", () => {
  let text = "";
  const lines = new Lines(["tim", "lena"], { isTTY: true, columns: 20, write: (piece) => (text += piece) });
  lines.say("lena", "a long story about a robot");
  assert.equal(text.split("\x1b[2A\x1b[J").at(-1), "tim   …\nlena  a long story \n");
});
