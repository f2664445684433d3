// Small repositories for the tests of the checks.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

/** Writes `files` ({path: text}) into an empty folder, which is removed when test `t` ends. Returns the folder. */
export function repositoryOf(t, files) {
  const root = mkdtempSync(join(tmpdir(), "foresight-check-"));
  t.after(() => rmSync(root, { recursive: true }));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(join(root, dirname(path)), { recursive: true });
    writeFileSync(join(root, path), text);
  }
  return root;
}
