// foresight-sim compare as people and scripts use it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import {
  chmodSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { delimiter, join } from "node:path";
import { test } from "node:test";
import { kDesktop, kPhone, open, shoot } from "./browser.mjs";
import { atEnd, bin, getJson, play, root, run, temporaryFolder, until } from "./support.mjs";

// short games, because the tests are about the counting
const kShort = ["--seconds", "150"];
const compare = (...words) => run("foresight-sim", "compare", ...words, ...kShort);

/** Returns a result without the values that depend on the machine. */
function found({ stdout }) {
  const { seconds, decision_us, ...rest } = JSON.parse(stdout);
  assert.ok(seconds > 0);
  return rest;
}

test("a behaviour compared with itself is exactly identical", async () => {
  const { status, stdout } = await compare("baseline", "--pairs", "100", "--json");
  assert.equal(status, 1);
  const report = JSON.parse(stdout);
  assert.equal(report.verdict, "identical");
  assert.equal(report.sentence, "baseline and baseline are identical: each plays the games of the other");
  assert.deepEqual([report.same_pairs, report.different_pairs], [100, 100]);
  assert.deepEqual(report.gain, { mean: 0, low: 0, high: 0 });
  assert.equal(report.games, 200);
  const sequential = JSON.parse((await compare("baseline", "--json")).stdout);
  assert.deepEqual([sequential.verdict, sequential.pairs], ["identical", 50]);
});

test("settings that change games without goals are not identical, and the answer says that goals are too rare", async () => {
  const words = ["compare", "align_first", "kick_now", "--from", "far_free", "--seconds", "3"];
  const { status, stdout } = await run("foresight-sim", ...words, "--pairs", "200");
  assert.equal(status, 3);
  assert.match(
    stdout,
    /^too rare to tell whether kick_now is better than align_first: 0 of 200 pairs had a gain; raise --pairs or choose a longer metric\n/,
  );
  // without a number of pairs it gives up, too
  const sequential = await run("foresight-sim", ...words, "--json");
  const { verdict, pairs } = JSON.parse(sequential.stdout);
  assert.deepEqual([sequential.status, verdict, pairs], [3, "too rare", 1000]);
});

test("games that repeat are refused", async () => {
  const words = [
    "compare",
    "align_first",
    "kick_now",
    "--models",
    "perfect",
    "--metric",
    "score_within:30s",
    "--from",
    "near_free",
    "--pairs",
    "50",
  ];
  const { status, stdout, stderr } = await run("foresight-sim", ...words);
  assert.deepEqual([status, stdout], [2, ""]);
  assert.match(
    stderr,
    /the games repeat: expected 25 different pairs, got 1; with models 'perfect' a seed changes too little: choose models with noise, or vary the start with --from and --fuzz/,
  );
  const varied = await run("foresight-sim", ...words, "--fuzz");
  assert.match(varied.stdout, /\ngames {12}100 in 50 pairs, no two alike/);
  const kickedOff = await run("foresight-sim", "compare", "--aa", "baseline", "--models", "perfect", "--seconds", "60");
  assert.equal(kickedOff.status, 2);
  assert.match(kickedOff.stderr, /the games repeat: expected 25 different pairs, got \d; /);
});

test("the usual question is a part of the metric's standard deviation, and the sentence has the gain corrected for the stop", async () => {
  const { stdout } = await run(
    "foresight-sim",
    "compare",
    "align_first",
    "kick_now",
    "--from",
    "close_free",
    "--fuzz",
    "--metric",
    "score_within:30s",
    "--json",
  );
  const report = JSON.parse(stdout);
  assert.equal(report.verdict, "better");
  assert.equal(report.h1_part, 0.1);
  assert.ok(Math.abs(report.h1 - 0.1 * report.standard_deviation) < 1e-12);
  assert.ok(report.h1 > 0.01 && report.h1 < 0.06, `${report.h1}`);
  const { mean, low, high } = report.unbiased_gain;
  const signed = (value) => (value < 0 ? "" : "\\+") + value.toFixed(3);
  assert.match(
    report.sentence,
    new RegExp(
      `: ${signed(mean)} of scoring in time per game \\(95 %: ${signed(low)} \\.\\. ${signed(high)}, corrected for the early stop\\)$`,
    ),
  );
});

test("a team that hardly plays is not better, and its opponent is", async () => {
  const worse = await compare("baseline", "idle", "--json");
  const better = await compare("idle", "baseline", "--json");
  assert.deepEqual([worse.status, better.status], [1, 0]);
  const [w, b] = [JSON.parse(worse.stdout), JSON.parse(better.stdout)];
  assert.deepEqual([w.verdict, b.verdict], ["not better", "better"]);
  assert.ok(b.gain.low > 0 && w.gain.high < 0.1);
  assert.ok(b.llr >= 2.944 && w.llr <= -2.944);
  assert.match(w.sentence, /^idle is worse than baseline: -\d\.\d+ goals /);
  assert.deepEqual([w.worse, b.worse], [true, false]);
  assert.match(b.sentence, /^baseline is better than idle: \+\d\.\d+ goals /);
  assert.match(
    b.decisive[0].replay,
    /^foresight-sim match --home baseline --away idle .*--seed \d+ --mcap game\.mcap$/,
  );
});

test("the number of processes and kills do not change the result", async (t) => {
  const folder = temporaryFolder(t);
  const words = ["baseline", "kick_now", "--pairs", "200", "--json"];
  const alone = await compare(...words, "--jobs", "1");
  assert.ok([0, 1, 3].includes(alone.status), alone.stderr);
  assert.deepEqual(found(await compare(...words, "--jobs", "3")), found(alone));

  const out = join(folder, "run");
  const blocks = () =>
    readdirSync(out, { withFileTypes: true }).filter(({ name }) => /^block-\d+\.json$/.test(name)).length;
  const child = spawn(join(bin, "foresight-sim"), ["compare", ...words, ...kShort, "--out", out], { stdio: "ignore" });
  await until(() => {
    try {
      return blocks() > 1;
    } catch {
      return false;
    }
  }, "the first blocks");
  child.kill("SIGKILL");
  await new Promise((ended) => child.on("close", ended));

  const refused = await compare(...words, "--out", out);
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /it exists already; --resume continues it/);
  const resumed = await compare(...words, "--out", out, "--resume");
  assert.deepEqual(found(resumed), found(alone));
  assert.equal(blocks(), 8);

  // a changed block is played again
  const damaged = join(out, "block-00000003.json");
  const sound = readFileSync(damaged, "utf8");
  writeFileSync(
    damaged,
    sound.replace(/"pairs":\[\[\[(-?\d+)/, (_, gain) => `"pairs":[[[${Number(gain) + 1}`),
  );
  assert.notEqual(readFileSync(damaged, "utf8"), sound);
  assert.deepEqual(found(await compare(...words, "--out", out, "--resume")), found(alone));
  assert.equal(readFileSync(damaged, "utf8"), sound);

  const verified = await compare(...words, "--out", out, "--verify");
  assert.equal(verified.status, 0);
  assert.match(verified.stdout, /^block \d+: identical\nblock 7: identical\n$/);
  const other = await compare("baseline", "passing", "--pairs", "200", "--out", out, "--resume");
  assert.equal(other.status, 2);
  assert.match(other.stderr, /expected nothing or the same comparison on the same build, got another one/);
});

test("against a third behaviour both play the same games", async () => {
  const { stdout } = await compare(
    "idle",
    "baseline",
    "--vs",
    "kick_now",
    "--metric",
    "conceded",
    "--pairs",
    "50",
    "--json",
  );
  const report = JSON.parse(stdout);
  assert.equal(report.run.vs, "kick_now");
  assert.ok(report.a.conceded > report.b.conceded, stdout);
  assert.ok(Math.abs(report.gain.mean - (report.a.conceded - report.b.conceded)) < 1e-9);
});

test("a sequential test gives up at its limit", async () => {
  const { status, stdout } = await compare(
    "baseline",
    "align_first",
    "--sprt",
    "0,0.01",
    "--most-pairs",
    "30",
    "--json",
  );
  const { pairs, verdict } = JSON.parse(stdout);
  assert.deepEqual({ status, pairs, verdict }, { status: 3, pairs: 30, verdict: "undecided" });
});

test("a plan reports how many games an answer takes", async (t) => {
  const { status, stdout } = await compare("baseline", "kick_now", "--plan", "--sprt", "0,0.05", "--json");
  assert.equal(status, 0);
  const plan = JSON.parse(stdout);
  assert.equal(plan.delta, 0.05);
  // two-sided 5 %, found in 80 %: (1.96 + 0.84)^2 variance / delta^2 pairs of two games
  assert.ok(Math.abs(plan.fixed_80.games - (2 * 7.849 * plan.pair_variance) / 0.0025) < 3, stdout);
  assert.ok(plan.sequential.games < plan.fixed_80.games && plan.fixed_80.games < plan.fixed_95.games);

  // an earlier run can be the pilot
  const run = join(temporaryFolder(t), "run");
  await compare("baseline", "kick_now", "--pairs", "200", "--out", run);
  const again = JSON.parse(
    (await compare("baseline", "kick_now", "--plan", "--delta", "0.05", "--pilot", run, "--json")).stdout,
  );
  assert.deepEqual(
    [again.pilot_pairs, again.pair_variance, again.fixed_80.games],
    [200, plan.pair_variance, plan.fixed_80.games],
  );
});

test("wrong input is refused with a sentence", async () => {
  for (const [words, sentence] of [
    [["baseline", "nobody"], /nobody/],
    [
      ["baseline", "kick_now", "--sprt", "0.1,0"],
      /--sprt: expected two gains, the smaller one first, such as 0,0\.1, got '0\.1,0'/,
    ],
    [[], /expected behaviours to compare, such as baseline kick_now/],
    [
      ["baseline", "kick_now", "--metric", "beauty"],
      /--metric: expected goals, first_goal, conceded, score_within:30s or ball_advance:30s, got 'beauty'/,
    ],
    [["baseline", "kick_now", "--metric", "gaols"], /, got 'gaols'; did you mean 'goals'\?/],
    [["baseline", "kick_now", "--fuzz"], /--fuzz needs --from/],
    [["baseline", "kick_now", "--from", "nowhere"], /no situation 'nowhere'; there are: blocked, close_free/],
    [["baseline", "--aa", "kick_now"], /--aa names the behaviour; got another one: 'baseline'/],
    [["baseline", "kick_now", "--merge"], /--merge and --blocks need --out/],
    [["baseline", "kick_now", "--engine", "slurm"], /--engine slurm needs --pairs, and --out/],
    [["baseline", "./nowhere.so"], /behaviour '\.\/nowhere\.so': cannot be loaded/],
    [["baseline", "kick_now", "--metric", "conceded"], /'conceded' needs --vs/],
    [["baseline", "--plan"], /--plan: the pilot's 200 pairs all came out even/],
    [["baseline", "kick_now", "--resume"], /--resume, --verify, --merge and --blocks need --out/],
    [["baseline", "kick_now", "--pairs", "50", "--out", "/proc/none/run"], /run \/proc\/none\/run: /],
  ]) {
    const { status, stderr } = await compare(...words);
    assert.equal(status, 2, words.join(" "));
    assert.match(stderr, sentence);
  }
});

test("a behaviour in a library and one in a process play in match, situation and compare", async () => {
  const library = join(bin, "charge.so");
  const command = `pipe:python3 ${join(root, "sim/guest/examples/charge.py")}`;
  const tree = join(root, "sim/guest/examples/shadowing.json");
  for (const behaviour of [tree, library, command]) {
    const short = ["--rules", "spl2012:2,half_duration=20,ready_duration=5"];
    const { status, stdout, stderr } = await run("foresight-sim", "match", "--home", behaviour, ...short);
    assert.equal(status, 0, stderr);
    assert.match(stdout, /a decision costs {2}home \d+\.\d\d us, away \d+\.\d\d us\n$/);
    const situation = await run(
      "foresight-sim",
      "situation",
      "near_free",
      "--home",
      behaviour,
      "--rollouts",
      "4",
      "--seconds",
      "5",
    );
    assert.equal(situation.status, 0, situation.stderr);
    assert.match(situation.stdout, /a decision costs/);
    const compared = await run("foresight-sim", "compare", "baseline", behaviour, ...short, "--pairs", "4", "--json");
    assert.ok([0, 1, 3].includes(compared.status), compared.stderr);
    assert.ok(JSON.parse(compared.stdout).decision_us.every((us) => us > 0));
    const vetted = await run("foresight-sim", "vet", behaviour, "--seconds", "10", "--json");
    const { same_each_time, taken_back, taken_back_by } = JSON.parse(vetted.stdout);
    assert.deepEqual([vetted.status, same_each_time, taken_back], [0, true, true], behaviour);
    assert.equal(taken_back_by, behaviour === command ? "replay" : "memory");
  }
});

test("a process that dies, stalls or talks nonsense ends the run with a sentence and no verdict", async (t) => {
  const folder = temporaryFolder(t);
  const program = (name, body) => {
    const file = join(folder, `${name}.py`);
    writeFileSync(
      file,
      `import json, os, sys, time\nsys.stdin.readline()\nprint('{"version": 1}', flush=True)\nfor n, line in enumerate(sys.stdin):\n    ${body}\n    print("{}", flush=True)\n`,
    );
    return `pipe:python3 ${file}`;
  };
  for (const [behaviour, sentence] of [
    [
      program("dies", "n == 300 and sys.exit(5)"),
      /player \d, tick \d+: the process ended with status 5 instead of answering/,
    ],
    [program("killed", "n == 300 and os.kill(os.getpid(), 9)"), /the process was killed by signal 9/],
    [program("stalls", "n == 300 and time.sleep(100)"), /the process did not answer within 5 s/],
    [
      program("babbles", "n == 300 and print('hello', flush=True)"),
      /expected (a JSON object as answer, got 'hello'|one line as answer)/,
    ],
    [
      program("flies", 'n == 300 and print(\'{"x": 1e9, "body": "walk_to"}\', flush=True)'),
      /x must be -100 \.\. 100, got 1e\+09|expected one line/,
    ],
  ])
    for (const words of [
      ["match", "--home", behaviour],
      ["compare", "baseline", behaviour, "--pairs", "4", "--jobs", "1"],
    ]) {
      const { status, stdout, stderr } = await run(
        "foresight-sim",
        ...words,
        "--rules",
        "spl2012:2,half_duration=30,ready_duration=5",
      );
      assert.deepEqual([status, stdout], [2, ""], `${words.join(" ")}: ${stderr}`);
      assert.match(stderr, sentence);
      assert.equal(stderr.match(/foresight-sim: /g).length, 1, stderr);
    }
  const file = join(folder, "game.mcap");
  const failed = await run(
    "foresight-sim",
    "match",
    "--home",
    program("ends", "n == 300 and sys.exit(5)"),
    "--mcap",
    file,
  );
  assert.deepEqual([failed.status, existsSync(file)], [2, false], "a game that failed leaves no recording");
  // vet detects a behaviour whose decisions depend on more than its input
  const vetted = await run(
    "foresight-sim",
    "vet",
    program(
      "dice",
      "print(json.dumps({'body': 'walk_speed', 'x': os.getpid() % 97 / 97 - 0.5}), flush=True); continue",
    ),
    "--seconds",
    "10",
  );
  assert.equal(vetted.status, 1, vetted.stderr);
  assert.match(vetted.stdout, /the same each time {3}NO/);
});

test("a comparison can change only some players", async () => {
  const play = async (...words) =>
    JSON.parse((await compare("baseline", "idle", "--pairs", "20", "--json", ...words)).stdout);
  const [keeper, all] = [await play("--changed", "1"), await play()];
  assert.equal(keeper.run.changed, 1);
  assert.match(keeper.sentence, /idle of players 1 \.\. 1/);
  // a team that stands still scores no goal; a team whose goalkeeper stands still plays on
  assert.equal(all.b.goals, 0);
  assert.ok(keeper.b.goals > 0);
});

test("games begin in the situations of a folder, evenly, and each pair can vary them", async (t) => {
  const play = async (...words) =>
    JSON.parse(
      (
        await run(
          "foresight-sim",
          "compare",
          "align_first",
          "kick_now",
          "--metric",
          "score_within:30s",
          "--pairs",
          "40",
          "--json",
          ...words,
        )
      ).stdout,
    );
  const [plain, again, fuzzed] = [
    await play("--from", "near_free"),
    await play("--from", "near_free"),
    await play("--from", "near_free", "--fuzz"),
  ];
  assert.deepEqual(found({ stdout: JSON.stringify(again) }), found({ stdout: JSON.stringify(plain) }));
  assert.notDeepEqual(fuzzed.histogram, plain.histogram);
  const folder = temporaryFolder(t);
  for (const name of ["near_free", "far_free"])
    copyFileSync(join(root, `sim/data/situations/${name}.json`), join(folder, `${name}.json`));
  const both = await play("--from", folder);
  assert.equal(both.pairs, 40);
  assert.match(both.decisive[0].replay, /--from \S+ --seconds 30 --seed \d+/);

  // the game behind a decisive pair is the one that the command plays
  const goals = await play("--from", "near_free", "--fuzz");
  const { gain, replay } = goals.decisive[0];
  const words = replay.split(" ").slice(1, -2);
  const { score } = JSON.parse((await run("foresight-sim", ...words, "--json")).stdout);
  assert.ok(score[0] <= 1 && score[1] <= 1 && Math.abs(gain) >= 1, replay);
});

test("the advance of the ball is a metric", async () => {
  const { stdout } = await run(
    "foresight-sim",
    "compare",
    "idle",
    "baseline",
    "--from",
    "far_free",
    "--metric",
    "ball_advance:30s",
    "--pairs",
    "50",
    "--json",
  );
  const report = JSON.parse(stdout);
  assert.equal(report.verdict, "better");
  assert.ok(report.gain.mean > 0.3 && report.gain.mean < 6, stdout);
  assert.equal(report.histogram.column, 0.5);
});

test("a behaviour gains nothing against itself, at either end of the field", async () => {
  const { status, stdout } = await compare("--aa", "baseline", "--pairs", "100", "--json");
  const { paired, unpaired } = JSON.parse(stdout);
  assert.deepEqual(paired, { pairs: 50, gain: 0, even: true });
  assert.equal(unpaired.games, 200);
  assert.equal(status, unpaired.fair ? 0 : 1);
  assert.ok(unpaired.home_advantage.low < unpaired.home_advantage.high);
  // a lopsided moment is nobody's advantage when the sides exchange it
  const moment = await run(
    "foresight-sim",
    "compare",
    "--aa",
    "baseline",
    "--from",
    "close_free",
    "--metric",
    "score_within:30s",
    "--pairs",
    "200",
    "--json",
  );
  const { mean, low, high } = JSON.parse(moment.stdout).unpaired.home_advantage;
  assert.ok(Math.abs(mean) < 0.15 && high - low < 0.3, `${low} .. ${high}`);
  assert.match(
    (await compare("--aa", "baseline", "--pairs", "50")).stdout,
    /50 pairs of the same luck {3}gain \+0\.000 ± 0\.000, 0 in each, as it must be/,
  );
});

test("a robust verdict is repeated under other models", async () => {
  const { status, stdout } = await compare(
    "baseline",
    "idle",
    "--robust",
    "--pairs",
    "25",
    "--metric",
    "first_goal",
    "--vs",
    "baseline",
    "--json",
  );
  const report = JSON.parse(stdout);
  assert.equal(status, ["undecided", "too rare"].includes(report.verdict) ? 3 : 1);
  assert.deepEqual(
    report.conditions.map(({ name }) => name),
    [
      "as modelled",
      "walk x0.8",
      "walk x1.2",
      "kick x0.8",
      "kick x1.2",
      "ball noise x0.5",
      "ball noise x2",
      "opponent x0.8",
      "opponent x1.2",
    ],
  );
  assert.equal(new Set(report.conditions.map(({ gain }) => gain.mean)).size > 1, true);
  assert.deepEqual(
    report.turned_by,
    report.conditions.filter(({ verdict }) => verdict !== report.verdict).map(({ name }) => name),
  );
  assert.match(
    report.sentence,
    report.throughout ? /throughout, under all 9 models$/ : /under these models; another verdict with /,
  );
});

test("blocks of a run that are played separately merge to the same result", async (t) => {
  const folder = temporaryFolder(t);
  const words = ["baseline", "kick_now", "--pairs", "150"];
  const [alone, shared] = [join(folder, "alone"), join(folder, "shared")];
  const whole = await compare(...words, "--out", alone, "--json");
  const parts = await Promise.all(
    ["0..2", "2..4", "4..5"].map((blocks) => compare(...words, "--out", shared, "--blocks", blocks, "--jobs", "1")),
  );
  for (const { status, stderr } of parts) assert.equal(status, 0, stderr);
  const early = await compare(...words, "--out", shared, "--merge");
  assert.equal(early.status, 2);
  assert.match(early.stderr, /expected 6 blocks, 1 are missing: 5/);
  await compare(...words, "--out", shared, "--blocks", "5..6");
  const merged = await compare(...words, "--out", shared, "--merge", "--json");
  assert.equal(merged.status, whole.status);
  assert.ok(readFileSync(join(shared, "result.json")).equals(readFileSync(join(alone, "result.json"))));

  // blocks that are damaged or of another run are never merged
  const block = join(shared, "block-00000002.json");
  const sound = readFileSync(block, "utf8");
  for (const [text, sentence] of [
    [
      sound.replace(/"pairs":\[\[\[(-?\d+)/, (_, gain) => `"pairs":[[[${Number(gain) + 1}`),
      /its pairs do not have its hash/,
    ],
    [sound.slice(0, 100), /is damaged/],
    [sound.replace(/"run":"./, '"run":"!'), /belongs to another run, or to another build/],
    [readFileSync(join(shared, "block-00000001.json"), "utf8"), /is another block than its name says/],
  ]) {
    writeFileSync(block, text);
    const { status, stdout, stderr } = await compare(...words, "--out", shared, "--merge");
    assert.deepEqual([status, stdout], [2, ""]);
    assert.match(stderr, sentence);
  }
});

test("workers that are killed repeatedly do not change the result", async (t) => {
  const folder = temporaryFolder(t);
  const [calm, torn] = [join(folder, "calm"), join(folder, "torn")];
  const words = ["baseline", "passing", "--pairs", "150", "--jobs", "2"];
  await compare(...words, "--out", calm);
  const child = spawn(join(bin, "foresight-sim"), ["compare", ...words, ...kShort, "--out", torn], { stdio: "ignore" });
  const ended = new Promise((done) => child.on("close", done));
  let kills = 0;
  const kill = () => {
    try {
      const children = readFileSync(`/proc/${child.pid}/task/${child.pid}/children`, "utf8")
        .trim()
        .split(" ")
        .filter(Boolean);
      if (children.length > 0 && process.kill(Number(children[kills % children.length]), "SIGKILL")) ++kills;
    } catch (error) {
      if (!["ENOENT", "ESRCH"].includes(error.code)) throw error; // it has ended already
    }
    return kills;
  };
  await until(kill, "a worker"); // the first one at once, because a fast machine finishes within a second
  const killing = setInterval(kill, 1000);
  atEnd(t, () => clearInterval(killing));
  const status = await ended;
  clearInterval(killing);
  assert.ok([0, 1, 3].includes(status));
  assert.ok(kills > 0);
  assert.ok(readFileSync(join(torn, "result.json")).equals(readFileSync(join(calm, "result.json"))));
});

test("one folder has one run at a time", async (t) => {
  const out = join(temporaryFolder(t), "run");
  const words = ["baseline", "passing", "--pairs", "2000", "--out", out];
  const child = spawn(join(bin, "foresight-sim"), ["compare", ...words, ...kShort], { stdio: "ignore" });
  atEnd(t, () => child.kill("SIGKILL"));
  await until(() => existsSync(join(out, "run.json")), "the run");
  const second = await compare(...words, "--resume");
  assert.equal(second.status, 2);
  assert.match(second.stderr, /another process is working on it/);
});

test(
  "a full disk is reported, and the written blocks are complete",
  { skip: process.getuid() === 0 ? false : "a small disk needs root" },
  async (t) => {
    const disk = join(temporaryFolder(t), "disk");
    mkdirSync(disk);
    const mounted = await new Promise((done) =>
      spawn("mount", ["-t", "tmpfs", "-o", "size=24k", "tmpfs", disk]).on("close", done),
    );
    if (mounted !== 0) return t.skip("a small disk cannot be mounted here");
    atEnd(t, () => new Promise((done) => spawn("umount", [disk]).on("close", done)));
    const { status, stdout, stderr } = await compare(
      "baseline",
      "kick_now",
      "--pairs",
      "500",
      "--out",
      join(disk, "run"),
    );
    assert.deepEqual([status, stdout], [2, ""]);
    assert.match(stderr, /cannot write .*block-\d+\.json: No space left on device/);
    for (const name of readdirSync(join(disk, "run")).filter((name) => /^block-\d+\.json$/.test(name)))
      assert.equal(JSON.parse(readFileSync(join(disk, "run", name), "utf8")).pairs.length, 25);
  },
);

test("on a cluster an array of jobs plays and another one merges", async (t) => {
  const folder = temporaryFolder(t);
  // a stand-in for sbatch that plays the tasks here, one after the other, and kills each of them once
  writeFileSync(
    join(folder, "sbatch"),
    `#!/bin/bash
exec 2>/dev/null
script=\${@: -1}
last=$(sed -n 's/^#SBATCH --array=0-//p' "$script")
echo "$*" >>"${folder}/calls"
for task in $(seq 0 "\${last:-0}"); do
  (sleep 0.4; pkill -KILL -P "$(pgrep -of "^/bin/sh .*shared run/blocks.sh")") &
  SLURM_ARRAY_TASK_ID=$task "$script" >>"${folder}/output" 2>&1 || exit
done
wc -l <"${folder}/calls"
`,
  );
  chmodSync(join(folder, "sbatch"), 0o755);
  const path = process.env.PATH;
  process.env.PATH = `${folder}${delimiter}${path}`;
  atEnd(t, () => (process.env.PATH = path));
  const [calm, out] = [join(folder, "calm"), join(folder, "shared run")];
  const words = ["baseline", "kick_now", "--pairs", "100"];
  await compare(...words, "--out", calm);
  const { status, stdout, stderr } = await compare(...words, "--out", out, "--engine", "slurm");
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^4 blocks in \d tasks: job 1; their verdict: job 2, in .*\/result\.json\n$/);
  assert.match(readFileSync(join(folder, "calls"), "utf8"), /--dependency=afterok:1 /);
  assert.ok(readFileSync(join(out, "result.json")).equals(readFileSync(join(calm, "result.json"))));

  rmSync(join(folder, "sbatch"));
  process.env.PATH = "/nowhere";
  const without = await compare(...words, "--out", out, "--engine", "slurm");
  assert.equal(without.status, 2);
  assert.match(without.stderr, /sbatch: expected the number of a job, got/);
});

test("the page shows the figures of the JSON, and needs no other file", async (t) => {
  const file = join(temporaryFolder(t), "report.html");
  const { stdout } = await compare("idle", "baseline", "--json", "--html", file);
  const report = JSON.parse(stdout);
  const html = readFileSync(file, "utf8");
  assert.ok(!/<script|https?:|src=|@import/.test(html), "no other files");
  for (const [scheme, viewport] of [
    ["light", kDesktop],
    ["dark", kDesktop],
    ["light", kPhone],
  ]) {
    const { page, problems } = await open(t, `file://${file}`, { colorScheme: scheme, viewport });
    const figures = await page.$$eval("[data-of]", (all) => all.map((each) => [each.dataset.of, each.textContent]));
    assert.ok(figures.length > 25);
    for (const [key, shown] of figures) {
      const value = key.split(".").reduce((json, name) => json[name], report);
      if (typeof value === "string") assert.equal(shown, value, key);
      else
        assert.ok(
          Math.abs(Number(shown.replace("×", "")) - value) <=
            0.5 * 10 ** -(shown.split(".")[1]?.replace("×", "").length ?? 0) + 1e-9,
          `${key}: ${shown} is not ${value}`,
        );
    }
    assert.equal(await page.title(), "baseline is better than idle");
    assert.equal((await page.$$("svg")).length, 3);
    assert.deepEqual(
      await page.$$eval(".replay code", (all) => all.map((each) => each.textContent)),
      report.decisive
        .slice()
        .sort((a, b) => Math.abs(b.gain) - Math.abs(a.gain))
        .slice(0, 5)
        .map(({ replay }) => replay),
    );
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${wide} px wider than the screen`);
    assert.deepEqual(problems, []);
    await shoot(page, `compare-${scheme}-${viewport.width}`);
  }
});

test("the decisive games are saved beside the page, whose links open them in the viewer", async (t) => {
  const folder = join(temporaryFolder(t), "decisive");
  const words = ["idle", "baseline", "--rules", "spl2012:2,half_duration=30,ready_duration=5", "--pairs", "6"];
  const { status, stdout, stderr } = await compare(...words, "--games-to", folder);
  assert.equal(status, 3, `undecided after six pairs; ${stderr}`);
  assert.match(stdout, /report\.html: the most decisive games; foresight-lab play .*\/seed-N\.mcap serves it at/);
  const games = readdirSync(folder).filter((name) => name.endsWith(".mcap"));
  assert.ok(games.length > 0 && games.length <= 5, games.join());
  assert.deepEqual(
    readdirSync(folder).filter((name) => !games.includes(name)),
    ["report.html"],
  );

  // each file is the game that the page's command plays
  const html = readFileSync(join(folder, "report.html"), "utf8");
  const seed = /--seed (\d+)/.exec(html)[1];
  assert.ok(games.includes(`seed-${seed}.mcap`), seed);
  const again = join(folder, "..", "again.mcap");
  const replayed = /foresight-sim (match [^<]*) --mcap game\.mcap/.exec(html)[1].replaceAll("&#39;", "'").split(" ");
  assert.equal((await run("foresight-sim", ...replayed, "--mcap", again)).status, 0);
  assert.ok(readFileSync(again).equals(readFileSync(join(folder, `seed-${seed}.mcap`))), "the same game");

  // served by foresight-lab, a link opens the viewer with that game
  const server = await play(t, folder, join(folder, games[0]));
  const { page, problems } = await open(t, `${server.http}/#/sessions`, { breaksConnections: true });
  await page.getByRole("link", { name: "report.html" }).click();
  await page.getByRole("heading", { name: "The most decisive pairs" }).waitFor();
  await shoot(page, "compare-decisive");
  const last = games.at(-1);
  await page.getByRole("link", { name: last }).click();
  await page.waitForURL((url) => url.hash.includes(`session=${last}`));
  if (games.length > 1) await page.getByRole("button", { name: "Watch it" }).click();
  await until(
    () =>
      getJson(server, "/api/status").then(
        (answer) => answer.body === "recording",
        () => false,
      ),
    "the server plays",
  );
  await page.getByRole("region", { name: "Field" }).waitFor();
  await page.getByText(new RegExp(`seed ${/\d+/.exec(last)[0]}`)).waitFor();
  await shoot(page, "compare-decisive-field");
  assert.deepEqual(problems, []);

  const mixed = await compare(...words, "--games-to", folder);
  assert.deepEqual(
    [mixed.status, mixed.stderr],
    [2, `foresight-sim: --games-to: expected a new or an empty folder, got ${folder}\n`],
  );
});
