// A lock file names versions and checksums, not where somebody once downloaded them: everybody has a registry of their own.
//
//   node tests/check/run.mjs lock_files
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { filesBelow } from "./files.mjs";

/** One sentence per lock file below `root` that holds a download address. */
export function addresses(root) {
  const sentences = [];
  for (const path of filesBelow(root)) {
    if (!["package-lock.json", "npm-shrinkwrap.json"].includes(posix.basename(path))) continue;
    const packages = JSON.parse(readFileSync(join(root, path), "utf8")).packages ?? {};
    const withAddress = Object.keys(packages).filter((name) => /^[a-z+]+:/.test(packages[name].resolved ?? ""));
    if (withAddress.length)
      sentences.push(
        `${path}: ${withAddress.length} packages carry a download address, the first is ${withAddress[0]}; ` +
          `write it again with the setting omit-lockfile-registry-resolved=true of viewer-web/.npmrc`,
      );
  }
  return sentences;
}
