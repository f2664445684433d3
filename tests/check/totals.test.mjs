// Tests of the totals that scripts/test and scripts/check print last.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { repositoryOf } from "./repository.mjs";

const program = fileURLToPath(new URL("../../scripts/lib-totals.mjs", import.meta.url));

/** Lines that the program prints for the result files `files`, and its exit status. */
function totalsOf(t, files, environment = {}) {
  const folder = repositoryOf(t, files);
  const { stdout, status } = spawnSync(process.execPath, [program, folder], {
    encoding: "utf8",
    env: environment,
  });
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
    {
      name: "a.test.ts",
      status: "passed",
      assertionResults: [
        { fullName: "draws", status: "passed" },
        { fullName: "later", status: "todo" },
      ],
    },
    { name: "b.test.ts", status: "failed", assertionResults: [] },
  ],
});

test("each kind of result is counted test by test", (t) => {
  const steps = "failed\ttests\tC++\nfailed\ttests\tbrowser\nfailed\ttests\tviewer\n";
  const { lines, status } = totalsOf(t, {
    "steps.txt": steps,
    "C++.junit.xml": ctest,
    "browser.tap": tap,
    "viewer.vitest.json": vitest,
  });
  assert.deepEqual(lines, [
    "skipped: C++: Log.Reads: set FORESIGHT_DATA to <folder>",
    "skipped: browser: inner two: no tc",
    "skipped: viewer: later: no reason given",
    "FAILED: C++: Ball.Stops",
    "    no",
    "FAILED: C++: gone_NOT_BUILT (could not be started)",
    "FAILED: browser: alone",
    "FAILED: viewer: b.test.ts",
    "3 passed, 4 failed, 3 skipped",
  ]);
  assert.equal(status, 1);
});

test("a failure is followed by the beginning of what it said", (t) => {
  const output = `[ RUN      ] Ball.Stops
chatter
ball_test.cpp:7: Failure
Expected: (x) &lt; (1), actual: 2 vs 1

ball_test.cpp:9: Failure
Failed
[  FAILED  ] Ball.Stops (0 ms)`;
  const block = (error) => `  ---\n  duration_ms: 3\n  ${error}\n  code: 'ERR'\n  ...\n`;
  const { lines } = totalsOf(t, {
    "steps.txt": "failed\ttests\tC++\nfailed\ttests\tbrowser\nfailed\ttests\tviewer\n",
    "C++.junit.xml": `<testsuite><testcase name="Ball.Stops" time="0" status="fail"><failure message=""/><system-out>${output}</system-out></testcase></testsuite>`,
    "browser.tap": `not ok 1 - short\n${block("error: 'no ball'")}not ok 2 - long\n${block(
      `error: |-\n    first\n    \n${"    more\n".repeat(9)}    last`,
    )}`,
    "viewer.vitest.json": JSON.stringify({
      testResults: [
        {
          assertionResults: [
            {
              fullName: "draws",
              status: "failed",
              failureMessages: ["Error: 1\n  at x"],
            },
          ],
        },
      ],
    }),
  });
  assert.deepEqual(lines, [
    "FAILED: C++: Ball.Stops",
    "    ball_test.cpp:7: Failure",
    "    Expected: (x) < (1), actual: 2 vs 1",
    "    ball_test.cpp:9: Failure",
    "    Failed",
    "FAILED: browser: short",
    "    no ball",
    "FAILED: browser: long",
    "    first",
    ...Array(5).fill("    more"),
    "FAILED: viewer: draws",
    "    Error: 1",
    "    at x",
    "0 passed, 4 failed, 0 skipped",
  ]);
});

test("the ten slowest tests are named, the slowest one first, unless they take less than a second", (t) => {
  const junit = `<testsuite>${Array.from({ length: 9 }, (_, i) => `<testcase name="T.${i}" time="${i}.5" status="run"/>`).join("")}</testsuite>`;
  const block = (ms) => `  ---\n  duration_ms: ${ms}\n  ...\n`;
  const slow = `    ok 1 - inner\n    ${block(2000).replace(/\n(?=.)/g, "\n    ")}ok 1 - outer\n${block(9000)}ok 2 - page\n${block(61000)}`;
  const json = JSON.stringify({
    testResults: [
      {
        assertionResults: [{ fullName: "draws", status: "passed", duration: 3000 }],
      },
    ],
  });
  const steps = "passed\ttests\tC++\npassed\ttests\tbrowser\npassed\ttests\tviewer\n";
  const { lines } = totalsOf(t, {
    "steps.txt": steps,
    "C++.junit.xml": junit,
    "browser.tap": slow,
    "viewer.vitest.json": json,
  });
  assert.deepEqual(lines, [
    "The slowest tests:",
    "   61.0 s  browser: page",
    ...[8, 7, 6, 5, 4, 3].map((i) => `    ${i}.5 s  C++: T.${i}`),
    "    3.0 s  viewer: draws",
    "    2.5 s  C++: T.2",
    "    2.0 s  browser: inner",
    "12 passed, 0 failed, 0 skipped",
  ]);
});

test("a check counts once, a preparation only when it fails", (t) => {
  const { lines, status } = totalsOf(t, {
    "steps.txt": "passed\tcheck\tlints\npassed\tprepare\tbuild dev\nfailed\tprepare\tbuild asan\n",
  });
  assert.deepEqual(lines, ["FAILED: build asan", "1 passed, 1 failed, 0 skipped"]);
  assert.equal(status, 1);
});

test("a step that fails without a failing test is a failure", (t) => {
  const { lines } = totalsOf(t, {
    "steps.txt": "failed\ttests\tbrowser\n",
    "browser.tap": "ok 1 - fine\n",
  });
  assert.deepEqual(lines, ["FAILED: browser", "1 passed, 1 failed, 0 skipped"]);
});

test("with FORESIGHT_REQUIRE_DATA=1 a skip without recordings is a failure, another skip is not", (t) => {
  const files = {
    "steps.txt": "passed\ttests\tbrowser\n",
    "browser.tap": "ok 1 - a # SKIP set FORESIGHT_DATA\nok 2 - b # SKIP no tc\n",
  };
  assert.equal(totalsOf(t, files).status, 0);
  const { lines, status } = totalsOf(t, files, { FORESIGHT_REQUIRE_DATA: "1" });
  assert.equal(lines.at(-1), "0 passed, 1 failed, 1 skipped");
  assert.equal(status, 1);
});

test("a run without a passed test is no success", (t) => {
  assert.equal(totalsOf(t, { "steps.txt": "" }).status, 1);
});
