// foresight-sim check from outside: tables, exit status, and the watch over files.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { atEnd, bin, root, run, temporaryFolder, until } from "./support.mjs";

const check = (...args) => run("foresight-sim", "check", ...args);

/** Writes a situation in which home 2 stands behind the ball and scores at once, with that limit of the share of goals. */
function write(folder, name, limit) {
  const robots = [{ side: "home", player: 2, x: 1.6, y: 0 }];
  const metrics = { goal: "our goal", "first touch": "time of our touch" };
  const situation = {
    seed: 3,
    ball: { x: 1.8, y: 0 },
    robots,
    check: { seconds: 30, seeds: 20, metrics, expect: { goal: limit } },
  };
  writeFileSync(join(folder, name), JSON.stringify(situation));
}

test("a folder of situations is a table, and the exit status says whether one failed", async (t) => {
  const folder = temporaryFolder(t);
  write(folder, "open_goal.json", { at_least: 0.2 });
  const good = await check(folder);
  assert.equal(good.status, 0, good.stdout + good.stderr);
  assert.match(good.stdout, /^situation +metric +games +mean +95 % +expected +verdict\n/);
  assert.match(good.stdout, /open_goal\.json +goal +20 +[\d.]+ +[\d.]+ \.\. [\d.]+ +at least 0\.2 +passed\n/);
  assert.match(good.stdout, /\n1 passed, 0 unsure, 0 failed\n$/);

  write(folder, "closed_goal.json", { at_most: 0 });
  const bad = await check(folder, "--json");
  assert.equal(bad.status, 1, bad.stderr);
  const report = JSON.parse(bad.stdout);
  assert.equal(report.passed, false);
  assert.deepEqual(
    report.situations.map(({ file, metrics }) => [file, metrics[0].verdict]),
    [
      ["closed_goal.json", "failed"],
      ["open_goal.json", "passed"],
    ],
  );
  assert.equal((await check(folder, "--json")).stdout, bad.stdout);
  assert.equal((await check(join(folder, "closed_goal.json"), "--home", "idle")).status, 0); // a standing robot scores no goal
});

test("the example of the documentation passes", async (t) => {
  const file = join(temporaryFolder(t), "example.json");
  const [, example] = /```json\n([\s\S]*?)```/.exec(readFileSync(join(root, "sim/check/README.md"), "utf8"));
  writeFileSync(file, example);
  const { status, stdout, stderr } = await check(file);
  assert.equal(status, 0, stdout + stderr);
  assert.match(stdout, /\n2 passed, 0 unsure, 0 failed\n$/);
});

test("the situation of a check serves other commands too", async (t) => {
  const folder = temporaryFolder(t);
  write(folder, "open_goal.json", { at_least: 0.2 });
  assert.equal(
    (await run("foresight-sim", "situation", join(folder, "open_goal.json"), "--rollouts", "2", "--seconds", "3"))
      .status,
    0,
  );
});

test("wrong input is refused with a sentence and exit status 2", async (t) => {
  const folder = temporaryFolder(t);
  const empty = await check(folder);
  assert.deepEqual(
    [empty.status, empty.stderr],
    [2, `foresight-sim: folder '${folder}': expected situations, files that end in .json, there are none\n`],
  );
  write(folder, "it.json", { at_least: "x" });
  const wrong = await check(folder);
  assert.deepEqual(
    [wrong.status, wrong.stderr],
    [
      2,
      `foresight-sim: situation '${join(folder, "it.json")}': check.expect.goal.at_least must be a number, got "x"\n`,
    ],
  );
});

test("--watch checks again when a file changes", async (t) => {
  const folder = temporaryFolder(t);
  write(folder, "it.json", { at_least: 0.2 });
  const watching = spawn(join(bin, "foresight-sim"), ["check", folder, "--watch"]);
  atEnd(t, () => watching.kill());
  let output = "";
  for (const stream of [watching.stdout, watching.stderr]) stream.on("data", (data) => (output += data));
  await until(
    () => output.includes("1 passed, 0 unsure, 0 failed"),
    "the first table",
    undefined,
    () => output,
  );
  write(folder, "it.json", { at_most: 0 });
  await until(
    () => output.includes("0 passed, 0 unsure, 1 failed"),
    "the second table",
    undefined,
    () => output,
  );
  writeFileSync(join(folder, "it.json"), "{");
  await until(
    () => output.includes("not JSON"),
    "the refusal",
    undefined,
    () => output,
  );
  assert.equal(output.match(/^situation /gm).length, 2); // it does not repeat without a change
});
