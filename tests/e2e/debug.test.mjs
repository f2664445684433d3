// foresight-sim why, whynot and debug from outside: answers, a script, and the exit status of bad input.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { bin, temporaryFolder } from "./support.mjs";

const sim = (args, input = "") => spawnSync(join(bin, "foresight-sim"), args, { input, encoding: "utf8" });

test("why explains a decision: a sentence, then each comparison with value, truth and threshold", () => {
  const { status, stdout, stderr } = sim(["why", "--seed", "7", "--at", "60", "--robot", "14/2"]);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^14\/2 plays \w+ because /);
  assert.match(stdout, /\nnode +comparison +believed +true +threshold +otherwise\n/);
  assert.match(stdout, /\nread from\n/);
});

test("whynot names the change that leads to a skill", () => {
  const { status, stdout, stderr } = sim([
    "whynot",
    "--seed",
    "7",
    "--at",
    "60",
    "--robot",
    "14/2",
    "--skill",
    "dribble",
  ]);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /would have to be different:\n|does play dribble/);
});

test("a script goes to a moment, changes it and compares the futures", () => {
  const script = "goto 40\nrobot 14/2\nset ball 2 0\nstep 2 s\nshow\nfutures 20 10\nundo\nquit\nnot read\n";
  const { status, stdout, stderr } = sim(["debug", "--seed", "7"], script);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^at 40\.00 s, half 1, /);
  assert.match(stdout, /20 pairs of futures of 10 s/);
  assert.match(stdout, /scores .* % -> .* % +95 % [+-][\d.]+ \.\. [+-][\d.]+\n/);
  assert.equal(sim(["debug", "--seed", "7"], script).stdout, stdout, "the same script has the same answers");
});

test("coverage tells what each part of a tree does, as text, as JSON and as a page", (t) => {
  const page = join(temporaryFolder(t), "coverage.html");
  const few = ["coverage", "--games", "4", "--seconds", "60"];
  const { status, stdout, stderr } = sim([...few, "--html", page]);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^The tree baseline of the home side against baseline, 4 games from seed 1\.\n/);
  assert.match(stdout, /\nnever reached\n/);
  assert.match(readFileSync(page, "utf8"), /^<!doctype html>/);
  const { parts, games } = JSON.parse(sim([...few, "--json"]).stdout);
  assert.equal(games, 4);
  assert.equal(parts[0].path, "baseline");
  assert.equal(sim([...few, "--threads", "1"]).stdout, stdout, "the number of threads changes nothing");
});

test("breakpoints are kept in a file, and a wrong one is named by its line", (t) => {
  const file = join(temporaryFolder(t), "breakpoints");
  const debug = (script) => sim(["debug", "--seed", "7", "--breakpoints", file], script);
  const set = debug("robot 14/2\nbreak skill changes\nbreak our goal\nunbreak 2\nbreak 5/3 falls\n");
  assert.equal(set.status, 0, set.stderr);
  assert.equal(readFileSync(file, "utf8"), "14/2 skill changes\n5/3 falls\n");
  const { stdout } = debug("break\ncontinue\n");
  assert.match(stdout, /^ {2}1 {2}14\/2 skill changes\n {2}2 {2}5\/3 falls\nat .*\nbreakpoint [12]: /);
  writeFileSync(file, "# what we look for\nour goal\n\n14/2 flies\n");
  const wrong = debug("break\n");
  assert.equal(wrong.status, 2);
  assert.match(wrong.stderr, /breakpoints, line 4: expected a fact about the game or a robot, got 'flies'/);
});

/** Reads a log of BehaviorTree.CPP's FileLogger2, by its description: the XML, and the changes [{us, uid, status}]. */
function readBtlog(bytes) {
  assert.equal(bytes.subarray(0, 18).toString(), "BTCPP4-FileLogger2");
  assert.equal(bytes[18], 1, "the protocol");
  const size = bytes.readInt32LE(19);
  const xml = bytes.subarray(23, 23 + size).toString();
  const first = 23 + size + 8;
  assert.equal((bytes.length - first) % 9, 0);
  const changes = [];
  for (let at = first; at < bytes.length; at += 9)
    changes.push({ us: bytes.readUIntLE(at, 6), uid: bytes.readUInt16LE(at + 6), status: bytes[at + 8] });
  return { xml, changes };
}

test("the decisions of a robot are a table, and a log for Groot2 with the same skills", async (t) => {
  const folder = temporaryFolder(t);
  const game = ["decisions", "--seed", "7", "--seconds", "90", "--robot", "14/2"];
  const [csv, log] = [join(folder, "striker.csv"), join(folder, "striker.btlog")];
  for (const out of [csv, log]) {
    const { status, stderr } = sim([...game, "--out", out]);
    assert.equal(status, 0, stderr);
  }
  const [head, ...rows] = readFileSync(csv, "utf8").trim().split("\n");
  assert.match(head, /^time \[s\],skill,role,leaf,.*ball_distance \[m\]/);
  assert.equal(sim(game).stdout.trim().split("\n").length, rows.length + 1);

  const { xml, changes } = readBtlog(readFileSync(log));
  const { status, stderr } = spawnSync("python3", ["-c", "import sys, xml.dom.minidom as d; d.parse(sys.stdin)"], {
    input: xml,
    encoding: "utf8",
  });
  assert.equal(status, 0, `the XML is well formed: ${stderr}`);
  const actions = new Map(
    [...xml.matchAll(/<Action ID="(\w+)" name="[^"]*" _uid="(\d+)"/g)].map(([, skill, uid]) => [Number(uid), skill]),
  );
  // the skill at each time, by the log
  const begun = changes
    .filter(({ uid, status }) => status === 1 && actions.has(uid))
    .map(({ us, uid }) => `${(us / 1e6).toFixed(2)} ${actions.get(uid)}`);
  const told = new Set(rows.map((row) => row.split(",")).map(([time, skill]) => `${Number(time).toFixed(2)} ${skill}`));
  assert.ok(begun.length > 10, `${begun.length} skills`);
  for (const moment of begun) assert.ok(told.has(moment), moment);
});

test("bad input is one sentence with exit status 2, and a script names the line", () => {
  const cases = [
    [["why", "--at", "60", "--robot", "15/2"], "", /--robot: expected home\/N, away\/N, 14\/N or 5\/N/],
    [["why", "--at", "6000", "--robot", "14/2"], "", /--at: the game ends [\d.]+ s after its first tick, got 6000/],
    [["whynot", "--at", "60", "--robot", "14/2", "--skill", "dribbel"], "", /did you mean 'dribble'\?/],
    [["coverage", "--home", join(bin, "charge.so")], "", /charge\.so' is no decision tree, and one is needed here/],
    [["coverage", "--games", "1", "--seconds", "1"], "", /no robot decided in play; play more or longer games/],
    [
      ["decisions", "--robot", "14/9"],
      "",
      /--robot: expected home\/N, away\/N, 14\/N or 5\/N, N from 1 to 4, got '14\/9'/,
    ],
    [
      ["decisions", "--robot", "14/2", "--out", "a.txt"],
      "",
      /--out: expected a name that ends with .csv or .btlog, got 'a.txt'/,
    ],
    [["debug", "--home", "pipe:true"], "", /behaviour 'pipe:true': the process ended with status 0/],
    [["debug"], "goto 40\nuntil ball_xx > 1\n", /line 2: expected a fact .*did you mean 'ball_x'\?/],
  ];
  for (const [args, input, sentence] of cases) {
    const { status, stderr } = sim(args, input);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
    assert.equal(stderr.trim().split("\n").length, 1, stderr);
  }
});

test("the recorded beliefs through the same tree give the recorded decisions, and through another one others", async (t) => {
  const folder = temporaryFolder(t);
  const [game, table, expected] = ["game.mcap", "decisions.csv", "expected"].map((name) => join(folder, name));
  const made = sim(["match", "--seed", "7", "--rules", "spl2025:5,halves=1,half_duration=60", "--mcap", game]);
  assert.equal(made.status, 0, made.stderr);
  const lab = (...args) => spawnSync(join(bin, "foresight-lab"), ["redecide", game, ...args], { encoding: "utf8" });

  let [all, different] = [0, 0];
  for (const robot of ["14/1", "14/2", "14/3", "5/2"]) {
    const { status, stdout, stderr } = lab("--robot", robot, "--strategy", "baseline");
    assert.equal(status, 0, stderr);
    const [, decided, otherwise] = /^\S+: (\d+) decisions in play by baseline; baseline decides (\d+) of them/.exec(
      stdout,
    );
    all += Number(decided);
    different += Number(otherwise);
  }
  assert.ok(all > 500 && different / all < 0.02, `${different} of ${all}`);

  const other = lab("--robot", "14/2", "--strategy", "high_line", "--csv", table);
  assert.equal(other.status, 0, other.stderr);
  assert.match(other.stdout, /\n +[\d.]+ \.\. [\d.]+ +s {2}\w+.* -> /);
  const [head, first] = readFileSync(table, "utf8").split("\n");
  assert.equal(head, "time [s],recorded skill,recorded leaf,skill,leaf,where they part");
  const [time, skill] = first.split(",");
  writeFileSync(expected, `at ${time} s: ${skill}\n0 .. 3600 s: not stand\n`);
  const holds = lab("--robot", "14/2", "--strategy", "baseline", "--expect", expected);
  assert.equal(holds.status, 0, holds.stdout);
  assert.match(holds.stdout, /2 of 2 expectations hold/);
  writeFileSync(expected, `at ${time} s: not ${skill}\n`);
  const broken = lab("--robot", "14/2", "--strategy", "baseline", "--expect", expected);
  assert.equal(broken.status, 1);
  assert.match(broken.stdout, /broken: line 1, '.*': at [\d.]+ s it plays /);

  writeFileSync(expected, "at 5 s: kik\n");
  for (const [args, sentence] of [
    [["--strategy", "baselin"], /no strategy 'baselin'/],
    [["--strategy", "baseline", "--robot", "14/9"], /has no decisions of robot 14\/9/],
    [["--strategy", "baseline", "--expect", expected], /expected, line 1: .*did you mean 'kick'/],
  ]) {
    const { status, stderr } = lab(...args);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
  }
});

test("a recorded moment begins simulated games, varied by what the robot was unsure of", (t) => {
  const folder = temporaryFolder(t);
  const [game, moment, exact] = ["game.mcap", "moment.json", "exact.json"].map((name) => join(folder, name));
  const rules = "spl2025:5";
  const made = sim(["match", "--seed", "7", "--rules", rules, "--mcap", game, "--save-at", "40", exact]);
  assert.equal(made.status, 0, made.stderr);
  const lab = (...args) => spawnSync(join(bin, "foresight-lab"), ["situation", game, ...args], { encoding: "utf8" });
  const saved = lab("--at", "40", "--robot", "14/2", "--out", moment);
  assert.equal(saved.status, 0, saved.stderr);
  const [believed, truth] = [moment, exact].map((file) => JSON.parse(readFileSync(file, "utf8")));
  assert.match(believed.about, /^what robot 14\/2 believed 40\.000 s into ./);
  const robot = ({ robots }) => robots.find(({ side, player }) => side === "home" && player === 2);
  const apart = Math.hypot(robot(believed).x - robot(truth).x, robot(believed).y - robot(truth).y);
  assert.ok(apart < 4 * robot(believed).deviation + 0.2, `${apart} m, deviation ${robot(believed).deviation}`);

  const play = ["match", "--from", moment, "--rules", rules, "--fuzz", "--games", "4", "--json"];
  const { status, stdout, stderr } = sim(play);
  assert.equal(status, 0, stderr);
  assert.equal(sim(play).stdout, stdout, "the same seeds draw the same starts");

  for (const [args, sentence] of [
    [["--at", "1e9"], /--at: the session is [\d.]+ s long, got 1e\+09|1000000000/],
    [["--at", "40", "--robot", "99/1"], /has no object pose of robot 99\/1, and a situation needs it/],
    [["--at", "40", "--robot", "14/2", "--rules", "spl1999"], /no rules 'spl1999'/],
    [["--at", "0", "--robot", "14/2"], /robot 14\/2: .*/],
  ]) {
    const { status, stderr } = lab(...args);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
  }
});

test("the decisions of another tree stand in a copy of the recording, beside the recorded ones", async (t) => {
  const folder = temporaryFolder(t);
  const [game, copy] = ["game.mcap", "redecided"].map((name) => join(folder, name));
  const made = sim(["match", "--seed", "7", "--rules", "spl2025:5,halves=1,half_duration=60", "--mcap", game]);
  assert.equal(made.status, 0, made.stderr);
  const lab = (...args) => spawnSync(join(bin, "foresight-lab"), args, { encoding: "utf8" });
  const redecide = ["redecide", game, "--robot", "14/2", "--strategy", "high_line", "--session", copy];
  const told = lab(...redecide);
  assert.equal(told.status, 0, told.stderr);
  const count = Number(/: (\d+) decisions in play/.exec(told.stdout)[1]);
  const topics = (session) => {
    const { status, stdout, stderr } = lab("info", session, "--json");
    assert.equal(status, 0, stderr);
    return new Map(JSON.parse(stdout).streams.map(({ topic, messages }) => [topic, messages]));
  };
  const copied = topics(copy);
  assert.equal(copied.get("/14/2/redecision"), count);
  copied.delete("/14/2/redecision");
  assert.deepEqual(copied, topics(game), "nothing else was added or lost");
  const again = lab(...redecide);
  assert.equal(again.status, 2, "a session is never replaced");
  assert.equal(topics(copy).get("/14/2/redecision"), count);
});
