// The files that a check reads: written files, not built or fetched files.
import { readdirSync } from "node:fs";
import { join } from "node:path";

const made = new Set([".git", "build", "dist", "logs", "node_modules"]);

/** Paths of all written files below `root`, relative to it, sorted; `/` between folders. */
export function filesBelow(root, folder = "") {
  const paths = [];
  for (const entry of readdirSync(join(root, folder), { withFileTypes: true })) {
    if (made.has(entry.name)) continue;
    const path = folder ? `${folder}/${entry.name}` : entry.name;
    if (entry.isDirectory()) paths.push(...filesBelow(root, path));
    else if (entry.isFile()) paths.push(path);
  }
  return paths.sort();
}
