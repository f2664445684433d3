import assert from "node:assert/strict";
import { test } from "node:test";
import { commandsIn, wrongCommands } from "./commands.mjs";
import { repositoryOf } from "./repository.mjs";

const texts = {
  "foresight-lab": "Usage\nSubcommands:\n  play   plays\n  what-if   asks\n",
  "foresight-lab what-if": "Subcommands:\n  ask   asks\n",
  "foresight-lab what-if ask": "  --trials UINT\n",
  "foresight-lab play": "  --loop   again\n  --port UINT\n",
  "scripts/test": "scripts/test [--yes]\n",
  "scripts/fresh-root": "scripts/fresh-root [--keep] COMMAND\n",
};
const help = (program, subcommand) => texts[subcommand ? `${program} ${subcommand}` : program];
const wrong = (t, code) => wrongCommands(repositoryOf(t, { "a/README.md": `\`\`\`sh\n${code}\n\`\`\`\n` }), help);

test("a shell line is split at comments, pipes and quotes, and goes on behind a backslash", () => {
  const text = "```sh\nA=1 scripts/test --yes  # says --no\nfoo 'a b' | bar \\\n  --x & baz\n```\n```c\nno\n```\n";
  assert.deepEqual(commandsIn(text), [
    { line: 2, words: ["scripts/test", "--yes"] },
    { line: 3, words: ["foo", "a b"] },
    { line: 3, words: ["bar", "--x"] },
    { line: 3, words: ["baz"] },
  ]);
});

test("commands that exist, and programs of others, are no finding", (t) => {
  const code =
    "scripts/test --yes\nforesight-lab play x --loop --port=9 # --gone\nbuild/release/bin/foresight-lab what-if\nls --gone";
  assert.deepEqual(wrong(t, code), []);
});

test("each fault is one sentence", (t) => {
  assert.deepEqual(wrong(t, "scripts/gone\nforesight-lab sing\nforesight-lab play --lo\nscripts/test --yes --no"), [
    "a/README.md:2: there is no program scripts/gone",
    "a/README.md:3: foresight-lab has no command 'sing'; there are play, what-if",
    "a/README.md:4: foresight-lab play has no option --lo",
    "a/README.md:5: scripts/test has no option --no",
  ]);
});

test("the options of a command that another one runs are its own", (t) => {
  assert.deepEqual(wrong(t, "scripts/fresh-root --keep scripts/test --yes"), []);
});

test("a sub-command of a sub-command has its own options", (t) => {
  assert.deepEqual(wrong(t, "foresight-lab what-if ask --trials 3\nforesight-lab what-if ask --seed 3"), [
    "a/README.md:3: foresight-lab what-if has no option --seed",
  ]);
});
