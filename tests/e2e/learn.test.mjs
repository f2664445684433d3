// foresight-sim learn as a team uses it: killed and gone on with, on a cluster, and its page in a browser.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { chmodSync, existsSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { kDesktop, kPhone, open, shoot } from "./browser.mjs";
import { atEnd, bin, run, temporaryFolder, until } from "./support.mjs";

const learn = (...words) => run("foresight-sim", "learn", ...words);

/** A striker that stands still before the goal, a layer that may teach it to kick, and words for a run of seconds. */
function striker(folder) {
  const [tree, layer] = [join(folder, "clumsy.json"), join(folder, "striker.json")];
  const rules = [
    { if: "not ball_known", do: "search_ball" },
    { name: "far", if: "ball_distance > 0.4", do: "walk_to_ball" },
    { name: "near the goal", if: "ball_goal_distance < 3", do: "stand" },
    { do: "kick", with: { range: "5 m", tolerance: "$tolerance" } },
  ];
  const parameters = { tolerance: { value: "160 deg", learn: [5, 170] } };
  writeFileSync(tree, JSON.stringify({ name: "clumsy", parameters, tree: rules }));
  const actions = [{ do: "kick", with: { range: "5 m" } }];
  writeFileSync(
    layer,
    JSON.stringify({
      skills: ["kick", "stand"],
      actions,
      exercises: { empty_goal: 1 },
    }),
  );
  const games = ["--rules", "spl2012,half_duration=10", "--opponents", "idle", "--unseen", "kick_now"];
  return [tree, "--layers", layer, "--budget", "0.1s", "--most-pairs", "50", ...games];
}

const ledgers = (folder) => readdirSync(folder).filter((name) => /^ledger-\d+\.txt$/.test(name));
const size = (folder) => ledgers(folder).reduce((sum, name) => sum + statSync(join(folder, name)).size, 0);

test("a run that is killed five times gives the same tree, and its page shows how it came about", async (t) => {
  const folder = temporaryFolder(t);
  const words = striker(folder);
  const [calm, killed, page] = [join(folder, "calm.json"), join(folder, "killed", "calm.json"), join(folder, "p.html")];
  const alone = await learn(...words, "--out", calm, "--html", page);
  assert.ok([0, 1].includes(alone.status), alone.stderr);
  assert.match(alone.stdout, /near the goal: stand → kick/);

  const from = join(folder, "killed");
  for (let kill = 0; kill < 5; ++kill) {
    const before = existsSync(from) ? size(from) : 0;
    const process = spawn(join(bin, "foresight-sim"), ["learn", ...words, "--from", from, "--out", killed]);
    const ended = new Promise((resolve) => process.once("exit", resolve));
    atEnd(t, () => process.kill("SIGKILL"));
    await until(() => process.exitCode !== null || (existsSync(from) && size(from) > before), "something is played");
    process.kill("SIGKILL");
    await ended;
  }
  const again = await learn(...words, "--from", from, "--out", killed);
  assert.equal(again.status, alone.status, again.stderr);
  assert.equal(readFileSync(killed, "utf8"), readFileSync(calm, "utf8"));
  assert.equal(again.stdout, alone.stdout);

  for (const [viewport, colorScheme] of [
    [kDesktop, "light"],
    [kDesktop, "dark"],
    [kPhone, "light"],
  ]) {
    const opened = await open(t, pathToFileURL(page).href, {
      viewport,
      colorScheme,
    });
    await opened.page.getByRole("heading", { name: /striker/ }).waitFor();
    const wide = await opened.page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(wide <= 0, `${wide} px beyond the screen`);
    await shoot(opened.page, `learn-${viewport.width}-${colorScheme}`);
    assert.deepEqual(opened.problems, []);
  }
  const played = await run("foresight-sim", "match", "--home", calm, "--seconds", "60");
  assert.equal(played.status, 0, played.stderr);
});

test("on a cluster an array of jobs shares a run, and the first one reports", async (t) => {
  const folder = temporaryFolder(t);
  const words = striker(folder);
  // a stand-in for sbatch that plays all tasks here at the same time
  writeFileSync(
    join(folder, "sbatch"),
    `#!/bin/bash
script=\${@: -1}
last=$(sed -n 's/^#SBATCH --array=0-//p' "$script")
for task in $(seq 0 "$last"); do SLURM_ARRAY_TASK_ID=$task "$script" >"${folder}/output.$task" 2>&1 & done
wait
echo 17
`,
  );
  chmodSync(join(folder, "sbatch"), 0o755);
  const path = process.env.PATH;
  process.env.PATH = `${folder}${delimiter}${path}`;
  atEnd(t, () => (process.env.PATH = path));
  const [alone, shared, from] = [join(folder, "one", "tree.json"), join(folder, "tree.json"), join(folder, "a run")];
  const first = await learn(...words, "--from", join(folder, "one"), "--out", alone);
  assert.ok([0, 1].includes(first.status), first.stderr);
  const { status, stdout, stderr } = await learn(
    ...words,
    ...["--from", from, "--out", shared, "--engine", "slurm", "--tasks", "3"],
  );
  assert.equal(status, 0, stderr);
  assert.equal(stdout, `job 17: 3 tasks share the run in ${from}; the first one writes ${shared}\n`);
  assert.equal(readFileSync(shared, "utf8"), readFileSync(alone, "utf8"));
  assert.equal(readFileSync(join(folder, "output.0"), "utf8").replace(/^\r.*\r/s, ""), first.stdout);
  assert.deepEqual(ledgers(from), ["ledger-0.txt", "ledger-1.txt", "ledger-2.txt"]);

  rmSync(join(folder, "sbatch"));
  process.env.PATH = "/nowhere";
  const without = await learn(...words, "--from", from, "--out", shared, "--engine", "slurm");
  assert.equal(without.status, 2);
  assert.match(without.stderr, /sbatch: expected the number of a job, got/);
});

test("wrong words get one sentence, and nothing is written", async (t) => {
  const folder = temporaryFolder(t);
  const out = join(folder, "out.json");
  for (const [words, sentence] of [
    [["baselin"], /no strategy 'baselin'/],
    [["baseline", "--layers", "kik"], /no layer 'kik'/],
    [["baseline", "--budget", "10x"], /--budget must be a time such as 90s, 10m or 2h, at most 100h, got '10x'/],
    [["baseline", "--share", "1/2"], /--share needs --from, the folder of the run/],
    [["baseline", "--from", folder, "--share", "2/2"], /--share must be K\/N with 0 <= K < N <= 1000, got '2\/2'/],
    [["baseline", "--engine", "slurm"], /--engine slurm needs --out, and --from, a folder that all machines/],
    [["baseline", "--unseen", "baseline"], /must be others than those of practice, got 'baseline'/],
  ]) {
    const { status, stdout, stderr } = await learn(...words, "--out", out);
    assert.deepEqual([status, stdout], [2, ""], words.join(" "));
    assert.match(stderr, sentence);
    assert.equal(stderr.trim().split("\n").length, 1, stderr);
  }
  assert.ok(!existsSync(out));
});
