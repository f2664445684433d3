// Files and folders of ours that the documents name exist.
//
//   node tests/check/run.mjs documents
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow } from "./files.mjs";

/** One sentence per `path` in the Markdown files below `root` that begins like one of ours and does not exist. */
export function missingPaths(root) {
  const files = filesBelow(root);
  const topLevels = new Set(files.filter((path) => path.includes("/")).map((path) => path.split("/")[0]));
  const sentences = [];
  for (const path of files.filter((path) => path.endsWith(".md"))) {
    const lines = readFileSync(join(root, path), "utf8").split("\n");
    lines.forEach((line, index) => {
      for (const [, name] of line.matchAll(/`([\w.-]+\/[\w./-]*)[^`]*`/g))
        if (topLevels.has(name.split("/")[0]) && !existsSync(join(root, name)))
          sentences.push(`${path}:${index + 1}: speaks of ${name}, which does not exist`);
    });
  }
  return sentences;
}
