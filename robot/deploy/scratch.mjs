// Temporary folders on this machine, removed when the command ends or is stopped.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const folders = new Set();
const remove = (folder) => rmSync(folder, { recursive: true, force: true });

process.on("exit", () => folders.forEach(remove));
for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.on(signal, () => process.exit(130));

/** Makes an empty folder that only our user may read. */
export function scratchFolder() {
  const folder = mkdtempSync(join(tmpdir(), "foresight-"));
  folders.add(folder);
  return folder;
}

export function removeScratch(folder) {
  folders.delete(folder);
  remove(folder);
}
