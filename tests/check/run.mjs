// Runs one check on this repository: a sentence per finding, and status 1 if there is any.
//
//   node tests/check/run.mjs includes|documents|lock_files|table|throwing|commands
//   node tests/check/run.mjs prose [FOLDER…|--counts|--shrink]
import { fileURLToPath } from "node:url";
import { commands } from "./commands.mjs";
import { missingPaths } from "./documents.mjs";
import { violations } from "./includes.mjs";
import { addresses } from "./lock_files.mjs";
import { prose } from "./prose.mjs";
import { throwing } from "./throwing.mjs";
import { staleTable } from "../bench/table.mjs";

const checks = {
  includes: violations,
  documents: missingPaths,
  lock_files: addresses,
  table: staleTable,
  throwing,
  commands,
  prose,
};
const [name, ...words] = process.argv.slice(2);
if (!(name in checks)) {
  console.error(`expected one of ${Object.keys(checks).join(", ")}, got '${name ?? ""}'`);
  process.exit(2);
}
if (words.length && name !== "prose") {
  console.error(`the check ${name} takes no argument, got '${words[0]}'`);
  process.exit(2);
}
const sentences = checks[name](fileURLToPath(new URL("../..", import.meta.url)), ...(words.length ? [words] : []));
for (const sentence of sentences) console.error(sentence);
process.exitCode = sentences.length ? 1 : 0;
