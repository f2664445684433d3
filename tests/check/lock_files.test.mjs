import assert from "node:assert/strict";
import { test } from "node:test";
import { addresses } from "./lock_files.mjs";
import { repositoryOf } from "./repository.mjs";

const lockOf = (entry) => JSON.stringify({ packages: { "": {}, "node_modules/thing": entry } });

test("a lock file of versions and checksums is no finding", (t) => {
  const lock = lockOf({ version: "1.0.0", integrity: "sha512-abc" });
  // lock files inside fetched packages are not ours
  const fetched = lockOf({ version: "1.0.0", resolved: "https://example.org/thing.tgz" });
  const root = repositoryOf(t, { "web/package-lock.json": lock, "web/node_modules/thing/package-lock.json": fetched });
  assert.deepEqual(addresses(root), []);
});

test("a lock file with a download address is one sentence", (t) => {
  const lock = lockOf({ version: "1.0.0", resolved: "https://example.org/thing.tgz" });
  assert.deepEqual(addresses(repositoryOf(t, { "web/package-lock.json": lock })), [
    "web/package-lock.json: 1 packages carry a download address, the first is node_modules/thing; " +
      "write it again with the setting omit-lockfile-registry-resolved=true of viewer-web/.npmrc",
  ]);
});
