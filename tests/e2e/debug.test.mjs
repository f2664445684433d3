// foresight-sim why, whynot and debug from outside: answers, a script, and the exit status of bad input.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { bin } from "./support.mjs";

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

test("bad input is one sentence with exit status 2, and a script names the line", () => {
  const cases = [
    [["why", "--at", "60", "--robot", "15/2"], "", /--robot: expected home\/N, away\/N, 14\/N or 5\/N/],
    [["why", "--at", "6000", "--robot", "14/2"], "", /--at: the game ends [\d.]+ s after its first tick, got 6000/],
    [["whynot", "--at", "60", "--robot", "14/2", "--skill", "dribbel"], "", /did you mean 'dribble'\?/],
    [["debug", "--home", "pipe:true"], "", /'pipe:true' is no decision tree, and the debugger needs one/],
    [["debug"], "goto 40\nuntil ball_xx > 1\n", /line 2: expected a fact .*did you mean 'ball_x'\?/],
  ];
  for (const [args, input, sentence] of cases) {
    const { status, stderr } = sim(args, input);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
    assert.equal(stderr.trim().split("\n").length, 1, stderr);
  }
});
