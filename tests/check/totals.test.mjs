// The last line of scripts/test and scripts/check tells the truth.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { repositoryOf } from "./repository.mjs";

const program = fileURLToPath(new URL("../../scripts/lib-totals.mjs", import.meta.url));

/** What the program prints, line by line, and its status, for the result files `files`. */
function totalsOf(t, files, environment = {}) {
  const folder = repositoryOf(t, files);
  const { stdout, status } = spawnSync(process.execPath, [program, folder], { encoding: "utf8", env: environment });
  return { lines: stdout.trim().split("\n"), status };
}

const ctest = `<testsuite>
  <testcase name="Ball.Rolls" time="0" status="run"><system-out>fine</system-out></testcase>
  <testcase name="Ball.Stops" time="0" status="fail"><failure message=""/><system-out>no</system-out></testcase>
  <testcase name="Log.Reads" time="0" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
    <system-out>[ RUN      ] Log.Reads
log_test.cpp:4: Skipped
set FORESIGHT_DATA to &lt;folder&gt;

[  SKIPPED ] Log.Reads (0 ms)</system-out></testcase>
  <testcase name="gone_NOT_BUILT" time="0" status="notrun"><skipped message="Unable to find executable"/></testcase>
</testsuite>`;
const tap = "    ok 1 - inner one\n    ok 2 - inner two # SKIP no tc\nok 1 - outer\nnot ok 2 - alone\n1..2\n";
const vitest = JSON.stringify({
  testResults: [
    { name: "a.test.ts", status: "passed", assertionResults: [{ fullName: "draws", status: "passed" }, { fullName: "later", status: "todo" }] },
    { name: "b.test.ts", status: "failed", assertionResults: [] },
  ],
});

test("each kind of result is counted test by test", (t) => {
  const steps = "failed\ttests\tC++\nfailed\ttests\tbrowser\nfailed\ttests\tviewer\n";
  const { lines, status } = totalsOf(t, { "steps.txt": steps, "C++.junit.xml": ctest, "browser.tap": tap, "viewer.vitest.json": vitest });
  assert.deepEqual(lines, [
    "skipped: C++: Log.Reads: set FORESIGHT_DATA to <folder>",
    "skipped: browser: inner two: no tc",
    "skipped: viewer: later: no reason given",
    "FAILED: C++: Ball.Stops",
    "FAILED: C++: gone_NOT_BUILT (could not be started)",
    "FAILED: browser: alone",
    "FAILED: viewer: b.test.ts",
    "3 passed, 4 failed, 3 skipped",
  ]);
  assert.equal(status, 1);
});

test("a check counts once, a preparation only when it fails", (t) => {
  const { lines, status } = totalsOf(t, { "steps.txt": "passed\tcheck\tlints\npassed\tprepare\tbuild dev\nfailed\tprepare\tbuild asan\n" });
  assert.deepEqual(lines, ["FAILED: build asan", "1 passed, 1 failed, 0 skipped"]);
  assert.equal(status, 1);
});

test("a step that fails without a failing test is a failure", (t) => {
  const { lines } = totalsOf(t, { "steps.txt": "failed\ttests\tbrowser\n", "browser.tap": "ok 1 - fine\n" });
  assert.deepEqual(lines, ["FAILED: browser", "1 passed, 1 failed, 0 skipped"]);
});

test("with FORESIGHT_REQUIRE_DATA=1 a skip for want of recordings is a failure, another skip is not", (t) => {
  const files = { "steps.txt": "passed\ttests\tbrowser\n", "browser.tap": "ok 1 - a # SKIP set FORESIGHT_DATA\nok 2 - b # SKIP no tc\n" };
  assert.equal(totalsOf(t, files).status, 0);
  const { lines, status } = totalsOf(t, files, { FORESIGHT_REQUIRE_DATA: "1" });
  assert.equal(lines.at(-1), "0 passed, 1 failed, 1 skipped");
  assert.equal(status, 1);
});

test("nothing that passed is no success", (t) => {
  assert.equal(totalsOf(t, { "steps.txt": "" }).status, 1);
});
