// Adds up the results that the steps of scripts/test and scripts/check left in build/results.
//
//   node scripts/lib-totals.mjs FOLDER
//
// Prints the ten slowest tests, the reasons of skips, each failure with the beginning of what it said, and last
// `N passed, N failed, N skipped`. Status 1 if anything failed.
// With FORESIGHT_REQUIRE_DATA=1 a test that was skipped because it has no recordings counts as failed. The reason of such
// a skip contains FORESIGHT_DATA.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

const kLinesOfFailure = 6;
const kLengthOfLine = 200;

const folder = process.argv[2];
const read = (name) => (existsSync(join(folder, name)) ? readFileSync(join(folder, name), "utf8") : undefined);

const unescape = (text) =>
  text.replace(
    /&(lt|gt|quot|apos|amp|#10);/g,
    (_, name) => ({ lt: "<", gt: ">", quot: '"', apos: "'", amp: "&", "#10": "\n" })[name],
  );

/** Yields the tests of a JUnit file that ctest wrote. */
function* fromCtest(xml) {
  for (const [, attributes, body = ""] of xml.matchAll(/<testcase ([^>]*?)(?:\/>|>([\s\S]*?)<\/testcase>)/g)) {
    const attribute = (name) => unescape(new RegExp(`\\b${name}="([^"]*)"`).exec(attributes)?.[1] ?? "");
    const name = attribute("name");
    const status = attribute("status");
    const seconds = Number(attribute("time"));
    const output = unescape(/<system-out>([\s\S]*?)<\/system-out>/.exec(body)?.[1] ?? "");
    if (status === "run") yield { name, outcome: "passed", seconds };
    else if (status === "fail") {
      // the words of Googletest, or the end of the output if there are none
      const said = [...output.matchAll(/^.+: Failure\n(?:(?!\[ )[^\n]+\n)+/gm)].map(([text]) => text).join("");
      yield {
        name,
        outcome: "failed",
        seconds,
        said: said || output.trimEnd().split("\n").slice(-kLinesOfFailure),
      };
    } else {
      // ctest reports "not run" also for a missing program; only a message of the test itself is a skip
      const said = /<skipped message="SKIP_/.test(body) || status === "disabled";
      const reason = /: Skipped\n([\s\S]*?)\n+\[ {2}SKIPPED/.exec(output)?.[1].trim() ?? "no reason given";
      yield said ? { name, outcome: "skipped", reason } : { name: `${name} (could not be started)`, outcome: "failed" };
    }
  }
}

/** Yields the tests of Vitest's JSON. */
function* fromVitest(json) {
  for (const file of JSON.parse(json).testResults) {
    if (file.status === "failed" && file.assertionResults.length === 0)
      yield { name: file.name, outcome: "failed", said: file.message };
    for (const test of file.assertionResults) {
      const outcome = test.status === "passed" || test.status === "failed" ? test.status : "skipped";
      const [said] = test.failureMessages ?? [];
      yield {
        name: test.fullName,
        outcome,
        reason: "no reason given",
        seconds: (test.duration ?? 0) / 1000,
        said,
      };
    }
  }
}

/** Yields the tests of TAP that node wrote. Tests inside a suite or another test count, the outer one does not. */
function* fromTap(tap) {
  const depthOf = (line) => line.length - line.trimStart().length;
  const lines = [];
  const durations = []; // [ms], from the block below each line
  const errors = []; // from the block below each line: `error: 'one line'`, or `error: |-` and deeper lines
  const text = tap.split("\n");
  for (const [at, line] of text.entries())
    if (/^ *(not )?ok \d+/.test(line)) lines.push(line);
    else if (/^ *duration_ms: [\d.]+$/.test(line)) durations[lines.length - 1] ??= Number(line.split(":")[1]);
    else if (/^ *error: /.test(line)) {
      const first = line.replace(/^ *error: (\|-)?/, "").replace(/^'(.*)'$/, "$1");
      const rest = text.slice(at + 1);
      const end = rest.findIndex((below) => below.trim() && depthOf(below) <= depthOf(line));
      errors[lines.length - 1] ??= first || rest.slice(0, end);
    }
  for (const [index, line] of lines.entries()) {
    // the line of a suite comes after the lines of the tests inside it
    if (index > 0 && depthOf(lines[index - 1]) > depthOf(line)) continue;
    const [, not, name, skip, reason] = /^ *(not )?ok \d+(?: - (.*?))?(?: # (SKIP|TODO)(?: (.*))?)?$/.exec(line);
    const outcome = skip ? "skipped" : not ? "failed" : "passed";
    const seconds = (durations[index] ?? 0) / 1000;
    yield {
      name,
      outcome,
      reason: reason ?? "no reason given",
      seconds,
      said: errors[index],
    };
  }
}

/** Returns the tests of one step from the file that it left, or undefined if it left none. */
function testsOf(name) {
  for (const [ending, parse] of [
    [".junit.xml", fromCtest],
    [".vitest.json", fromVitest],
    [".tap", fromTap],
  ]) {
    const text = read(name + ending);
    if (text !== undefined) return [...parse(text)];
  }
  return undefined;
}

const all = [];
for (const line of (read("steps.txt") ?? "").split("\n").filter(Boolean)) {
  const [outcome, kind, name] = line.split("\t");
  const tests =
    kind === "tests" ? (testsOf(name) ?? []) : kind === "check" || outcome === "failed" ? [{ name: "", outcome }] : [];
  // a step may fail although none of its tests did: it crashed, or found no tests
  if (outcome === "failed" && !tests.some((test) => test.outcome === "failed"))
    tests.push({ name: "", outcome: "failed" });
  all.push(
    ...tests.map((test) => ({
      ...test,
      name: test.name ? `${name}: ${test.name}` : name,
    })),
  );
}

if (process.env.FORESIGHT_REQUIRE_DATA === "1")
  for (const test of all)
    if (test.outcome === "skipped" && test.reason.includes("FORESIGHT_DATA")) {
      test.outcome = "failed";
      test.name += " (skipped without recordings, which FORESIGHT_REQUIRE_DATA forbids)";
    }

const having = (outcome) => all.filter((test) => test.outcome === outcome);
console.log("");
const slowest = all.filter(({ seconds }) => seconds >= 1).sort((a, b) => b.seconds - a.seconds);
if (slowest.length) console.log("The slowest tests:");
for (const { name, seconds } of slowest.slice(0, 10)) console.log(`${seconds.toFixed(1).padStart(7)} s  ${name}`);
const reasons = new Map();
for (const test of having("skipped")) reasons.set(test.reason, [...(reasons.get(test.reason) ?? []), test.name]);
for (const [reason, names] of reasons)
  console.log(
    `skipped: ${names[0]}${names.length > 1 ? ` and ${names.length - 1} more` : ""}: ${reason.replace(/\s+/g, " ")}`,
  );
for (const { name, said = [] } of having("failed")) {
  console.log(`FAILED: ${name}`);
  const lines = [said]
    .flat()
    .join("\n")
    .split("\n")
    .filter((line) => line.trim());
  for (const line of lines.slice(0, kLinesOfFailure)) console.log(`    ${line.trim().slice(0, kLengthOfLine)}`);
}
console.log(
  `${having("passed").length} passed, ${having("failed").length} failed, ${having("skipped").length} skipped`,
);
process.exitCode = having("failed").length || all.length === 0 ? 1 : 0;
