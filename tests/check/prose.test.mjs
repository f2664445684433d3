import assert from "node:assert/strict";
import { test } from "node:test";
import { faultsIn, findings, sentencesOf, unplain } from "./prose.mjs";
import { proseOf } from "./comments.mjs";
import { repositoryOf } from "./repository.mjs";

const textsOf = (path, text) => proseOf(path, text).map((block) => `${block.line} ${block.text}`);
const long = `${"one two three four five six ".repeat(5)}seven.`; // 31 words

test("whole-line comments below each other are one paragraph, a trailing comment is its own", () => {
  const code =
    "/// The ball\n/// rolls.\n///\n/// It stops.\nint a = 1;  // first\nint b = 2;  // second\n            // goes on\n";
  assert.deepEqual(textsOf("ball.h", code), ["1 The ball rolls.", "4 It stops.", "5 first", "6 second goes on"]);
});

test("a list item ends where the next one begins", () => {
  const code = "// Two things:\n// - the first,\n//   which is long\n// - the second\n";
  assert.deepEqual(textsOf("a.cpp", code), ["1 Two things:", "2 the first, which is long", "4 the second"]);
});

test("a column of names in a script's help is left out", () => {
  const code =
    "#!/usr/bin/env bash\n# Does it.\n#\n#   PATH     a file,\n#            or a folder\n#   --yes    agree\nrun  # at once\n";
  assert.deepEqual(textsOf("scripts/do", code), ["2 Does it.", "4 a file, or a folder", "6 agree", "7 at once"]);
});

test("strings, characters, raw strings and regular expressions hold no comments", () => {
  assert.deepEqual(
    textsOf("a.cpp", 'auto a = "// no"; char q = \'"\'; int n = 1\'000; auto r = R"x(// no)x";  // yes\n'),
    ["1 yes"],
  );
  assert.deepEqual(
    textsOf("a.mjs", 'const a = /[/"]\\/\\/ no/; const b = `// ${f("`")} no`; const c = 4 / 2; // yes\n'),
    ["1 yes"],
  );
});

test("Svelte's script, markup and style each have their comments", () => {
  const text =
    "<script>\n  // in the script\n</script>\n<!-- in the markup -->\n<p>// no</p>\n<style>\n/* in the style */\n</style>\n";
  assert.deepEqual(textsOf("a.svelte", text), ["2 in the script", "4 in the markup", "7 in the style"]);
});

test("Python's docstrings count as comments", () => {
  assert.deepEqual(textsOf("a.py", 'def f():\n    """Returns\n    nothing."""\n    x = 1  # one\n'), [
    "2 Returns nothing.",
    "4 one",
  ]);
});

test("in a document code between fences is left out, and each cell of a table stands alone", () => {
  const text = "# What it is\n\nText\ngoes on.\n```sh\nwhat\n```\n| a | b c |\n| --- | --- |\n";
  assert.deepEqual(textsOf("a.md", text), ["1 What it is", "3 Text goes on.", "8 a", "8 b c"]);
});

test("sentences end at a full stop, not at an abbreviation, a decimal point or within code", () => {
  assert.deepEqual(sentencesOf("Takes 0.5 s, e.g. on a robot. Then it ends."), [
    "Takes 0.5 s, e.g. on a robot.",
    "Then it ends.",
  ]);
  assert.deepEqual(textsOf("a.h", "// See `a. b`. Next.\n").length, 1);
});

const refused = [
  "What it is; empty where there is no role.",
  "Returns the newest; who has gone needs no place.",
  "Frees whoever waits.",
  "Of which three are kept.",
  "Waits so many seconds.",
  "Changed of late.",
  "It comes out as zero.",
  "The one heard of of both.",
  "Such a process has the harm itself.",
  "Again is nothing.",
  "Empty where nothing is.",
  "Proved on robots that are none.",
  "The object tells the state.",
  long,
];
for (const text of refused)
  test(`refused: ${text.slice(0, 50)}`, () =>
    assert.equal(faultsIn({ kind: "text", text }).length, 1, faultsIn({ kind: "text", text }).join("; ")));

const accepted = [
  "What is shown? Who says so?",
  "What to do next.",
  "Returns so many bytes that two reads are needed.",
  "Says who decides and what was decided.",
  "Tells one robot from another; it tells clocks apart.",
  "It had had that that time.",
  `${long.replace(" two", ".")}`,
];
for (const text of accepted)
  test(`accepted: ${text.slice(0, 50)}`, () => assert.deepEqual(faultsIn({ kind: "text", text }), []));

test("headings and cells of tables may be clauses", () => {
  assert.deepEqual(faultsIn({ kind: "heading", text: "What was proved" }), []);
  assert.deepEqual(faultsIn({ kind: "table", text: long }), []);
});

test("a finding names file, line, phrase and remedy", (t) => {
  const root = repositoryOf(t, { "a/b.cpp": "\n// Fine.\n// Changed of late.\n" });
  assert.deepEqual(findings(root), [{ folder: "a", sentence: 'a/b.cpp:2: "of late.…": write "recently"' }]);
});

test("folders of the list are passed over, those below are not, and a clean folder in the list is a finding", (t) => {
  const root = repositoryOf(t, {
    "a/b.h": "// Changed of late.\n",
    "a/c/d.h": "// Changed of late.\n",
    "e/f.h": "// Fine.\n",
  });
  assert.deepEqual(unplain(root, ["a", "e"]), [
    'a/c/d.h:1: "of late.…": write "recently"',
    "tests/check/prose.mjs: notYet names e, which has no findings; node tests/check/run.mjs prose --shrink takes it out",
  ]);
  assert.deepEqual(unplain(root, ["a", "a/c"]), []);
});
