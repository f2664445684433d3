// foresight-sim compare as people and scripts use it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { bin, run, temporaryFolder, until } from "./support.mjs";

// short games: what is tested is the counting
const kShort = ["--seconds", "150"];
const compare = (...words) => run("foresight-sim", "compare", ...words, ...kShort);

/** All but what hangs on the machine. */
function found({ stdout }) {
  const { seconds, ...rest } = JSON.parse(stdout);
  assert.ok(seconds > 0);
  return rest;
}

test("a behaviour against itself is identical, exactly", async () => {
  const { status, stdout } = await compare("baseline", "--pairs", "100", "--json");
  assert.equal(status, 1);
  const report = JSON.parse(stdout);
  assert.equal(report.verdict, "identical");
  assert.deepEqual(report.gain, { mean: 0, low: 0, high: 0 });
  assert.equal(report.games, 200);
  const sequential = JSON.parse((await compare("baseline", "--json")).stdout);
  assert.deepEqual([sequential.verdict, sequential.pairs], ["identical", 50]);
});

test("who hardly plays is not better, and the other one is", async () => {
  const worse = await compare("baseline", "idle", "--metric", "first_goal", "--json");
  const better = await compare("idle", "baseline", "--metric", "first_goal", "--json");
  assert.deepEqual([worse.status, better.status], [1, 0]);
  const [w, b] = [JSON.parse(worse.stdout), JSON.parse(better.stdout)];
  assert.deepEqual([w.verdict, b.verdict], ["not better", "better"]);
  assert.ok(b.gain.low > 0 && w.gain.high < 0.1);
  assert.ok(b.llr >= 2.944 && w.llr <= -2.944);
  assert.match(b.sentence, /^baseline is better than idle: \+0\.\d+ /);
  assert.match(b.decisive[0].replay, /^foresight-sim match --home baseline --away idle .*--seed \d+ --mcap game\.mcap$/);
});

test("the number of threads, and being killed, change nothing", async (t) => {
  const folder = temporaryFolder(t);
  const words = ["baseline", "kick_now", "--pairs", "200", "--json"];
  const alone = await compare(...words, "--jobs", "1");
  assert.ok([0, 1, 3].includes(alone.status), alone.stderr);
  assert.deepEqual(found(await compare(...words, "--jobs", "3")), found(alone));

  const out = join(folder, "run");
  const blocks = () => readdirSync(out, { withFileTypes: true }).filter(({ name }) => /^block-\d+\.json$/.test(name)).length;
  const child = spawn(join(bin, "foresight-sim"), ["compare", ...words, ...kShort, "--out", out], { stdio: "ignore" });
  await until(() => { try { return blocks() > 1; } catch { return false; } }, "the first blocks");
  child.kill("SIGKILL");
  await new Promise((ended) => child.on("close", ended));

  const refused = await compare(...words, "--out", out);
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /it is there already; --resume goes on with it/);
  const resumed = await compare(...words, "--out", out, "--resume");
  assert.deepEqual(found(resumed), found(alone));
  assert.equal(blocks(), 8);

  // a block that was changed is played again, never believed
  const damaged = join(out, "block-00000003.json");
  const sound = readFileSync(damaged, "utf8");
  writeFileSync(damaged, sound.replace(/"pairs":\[\[\[(-?\d+)/, (_, gain) => `"pairs":[[[${Number(gain) + 1}`));
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
  const { stdout } = await compare("idle", "baseline", "--vs", "kick_now", "--metric", "conceded", "--pairs", "50", "--json");
  const report = JSON.parse(stdout);
  assert.equal(report.run.vs, "kick_now");
  assert.ok(report.a.conceded > report.b.conceded, stdout);
  assert.ok(Math.abs(report.gain.mean - (report.a.conceded - report.b.conceded)) < 1e-9);
});

test("a plan tells how many games an answer takes", async () => {
  const { status, stdout } = await compare("baseline", "kick_now", "--plan", "--sprt", "0,0.05", "--json");
  assert.equal(status, 0);
  const plan = JSON.parse(stdout);
  assert.equal(plan.delta, 0.05);
  // two-sided 5 %, found in 80 %: (1.96 + 0.84)^2 variance / delta^2 pairs of two games
  assert.ok(Math.abs(plan.fixed_80.games - (2 * 7.849 * plan.pair_variance) / 0.0025) < 3, stdout);
  assert.ok(plan.sequential.games < plan.fixed_80.games && plan.fixed_80.games < plan.fixed_95.games);
});

test("what makes no sense is refused with a sentence", async () => {
  for (const [words, sentence] of [
    [["baseline", "nobody"], /nobody/],
    [["baseline", "kick_now", "--sprt", "0.1,0"], /--sprt: expected two gains, the smaller one first, such as 0,0\.1, got '0\.1,0'/],
    [["baseline", "kick_now", "--metric", "beauty"], /--metric: expected goals, first_goal, conceded or score_within:30s, got 'beauty'/],
    [["baseline", "kick_now", "--metric", "conceded"], /'conceded' needs --vs/],
    [["baseline", "--plan"], /--plan: the pilot's 200 pairs all came out even/],
    [["baseline", "kick_now", "--resume"], /--resume and --verify need --out/],
    [["baseline", "kick_now", "--pairs", "50", "--out", "/proc/none/run"], /run \/proc\/none\/run: /],
  ]) {
    const { status, stderr } = await compare(...words);
    assert.equal(status, 2, words.join(" "));
    assert.match(stderr, sentence);
  }
});
