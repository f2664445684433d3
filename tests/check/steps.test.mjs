// Tests of the progress that scripts/demo, scripts/build, scripts/test and scripts/check show.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const scripts = fileURLToPath(new URL("../../scripts", import.meta.url));
const read = (name) => readFileSync(join(scripts, name), "utf8");
const stepsIn = (text) => text.match(/\bstep (prepare|check|tests) '/g).length;

/** Lines that a piece of bash prints once scripts/lib-test.sh is read. */
function linesOf(code, environment = {}) {
  const { stdout, stderr } = spawnSync("bash", ["-c", `. ${join(scripts, "lib-test.sh")}; ${code}`], {
    encoding: "utf8",
    env: { ...process.env, ...environment },
  });
  assert.equal(stderr, "");
  return stdout.trimEnd().split("\n");
}

test("scripts/test and scripts/check announce as many steps as they have", () => {
  for (const [script, count] of [
    ["lib-test.sh", "program_step_count"],
    ["test", "own_step_count"],
    ["check", "own_step_count"],
  ])
    assert.equal(Number(new RegExp(`^${count}=(\\d+)$`, "m").exec(read(script))[1]), stepsIn(read(script)), script);
});

for (const name of ["demo", "test", "check"])
  test(`scripts/${name} prints its duration first`, () => {
    assert.match(
      linesOf(`say_duration ${name}`)[0],
      /^scripts\/\w+: a first run takes \d+( to \d+)? min on two quiet cores \(\d+( to \d+)? min of/,
    );
    assert.ok(read(name).indexOf(`say_duration ${name}`) < read(name).search(/scripts\/setup"? (demo|test|check) /));
  });

test("a step prints its number and the number of steps", () => {
  const lines = linesOf(
    "results=$(mktemp -d); begin_steps 2; step check one true; step check two false || true; rm -r $results",
  );
  assert.deepEqual(lines, [
    "== 1 of 2: one (after 0 min)",
    "   passed after 0 s",
    "== 2 of 2: two (after 0 min)",
    "   failed after 0 s",
  ]);
});

test("what runs beside is awaited: its words and its status", () => {
  const lines = linesOf(`results=$(mktemp -d)
    beside one bash -c 'echo words; chrt -p $$'; beside two false
    awaited one; echo $?; awaited two || echo $?; rm -r $results`);
  if (spawnSync("chrt", ["-i", "0", "true"]).status === 0) assert.match(lines[1], /SCHED_IDLE/);
  assert.deepEqual([lines[0], ...lines.slice(-2)], ["words", "0", "1"]);
});

test("what runs beside runs one after the other, in the order of its begin", () => {
  const lines = linesOf(`results=$(mktemp -d); cd "$results"
    beside first bash -c 'sleep 0.3; echo first >>order'; beside second bash -c 'echo second >>order'
    beside third bash -c 'echo third >>order'; awaited third; cat order; rm -r $results`);
  assert.deepEqual(lines, ["first", "second", "third"]);
});

test("what runs beside ends with the script", async () => {
  const [pid] = linesOf(`results=$(mktemp -d); beside long bash -c 'sleep 1000 & wait'; sleep 0.2
    rm -r $results; echo \${beside_pids[long]}`);
  const runs = () => readdirSync("/proc").some((name) => /^\d+$/.test(name) && groupOf(name) === pid);
  for (let tries = 0; runs(); ++tries) {
    assert.ok(tries < 600, "it still runs after a minute");
    await new Promise((done) => setTimeout(done, 100));
  }
});

/** The process group of a process that runs. */
function groupOf(pid) {
  try {
    const [state, , group] = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ").at(-1).split(" ");
    return state === "Z" ? undefined : group;
  } catch {
    return undefined; // it has just ended
  }
}

test("progress is one line a minute, and every other line is shown", () => {
  const ninja = "printf '[1/9] a.o\\n[2/9] b.o\\nb.cpp:1: warning\\n 3/9 Test  #3: T.b ....   Passed    0.01 sec\\n'";
  assert.deepEqual(linesOf(`${ninja} | once_a_minute 'build dev'`), ["b.cpp:1: warning"]);
  assert.deepEqual(linesOf(`${ninja} | once_a_minute 'build dev'`, { FORESIGHT_PROGRESS_SECONDS: "0" }), [
    "   build dev: 1 of 9",
    "   build dev: 2 of 9",
    "b.cpp:1: warning",
    "   build dev: 3 of 9",
  ]);
});
