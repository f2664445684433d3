// Writes the tables of tests/bench/README.md anew; called by scripts/bench --table.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { resultsOf, withTables } from "./table.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const readme = `${root}tests/bench/README.md`;
writeFileSync(readme, withTables(readFileSync(readme, "utf8"), resultsOf(root)));
