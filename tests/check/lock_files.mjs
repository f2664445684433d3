// Lock files hold versions and checksums but no download addresses, because every site may have its own registry.
//
//   node tests/check/run.mjs lock_files
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { filesBelow } from "./files.mjs";

/** Returns one sentence per lock file below `root` that holds a download address. */
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
