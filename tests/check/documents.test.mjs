import assert from "node:assert/strict";
import { test } from "node:test";
import { missingPaths } from "./documents.mjs";
import { repositoryOf } from "./repository.mjs";

test("a path that exists, a path that is not ours and plain code are no finding", (t) => {
  const text =
    "`scripts/demo [PATH]`, `robot/core/`, `build/dev/bin`, `/api/status`, `ball_in_field`, scripts/absent\n";
  const root = repositoryOf(t, { "README.md": text, "scripts/demo": "", "robot/core/clock.h": "" });
  assert.deepEqual(missingPaths(root), []);
});

test("a path that does not exist is one sentence", (t) => {
  const root = repositoryOf(t, { "README.md": "\nSee `scripts/gone --help`.\n", "scripts/demo": "" });
  assert.deepEqual(missingPaths(root), ["README.md:2: speaks of scripts/gone, which does not exist"]);
});
