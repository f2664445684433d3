import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { repositoryOf } from "../check/repository.mjs";
import { proofs } from "./proofs.mjs";
import { resultsOf, staleTable, tables, withTables } from "./table.mjs";

const head = "date,build,kernel,cores,bench,options,figure,value,unit,bar,met\n";
const csv = `${head}2026-01-01T00:00:00Z,a,6,2,fanout,,"64 B, ""one""",3,ms,<= 5,yes
2026-02-01T00:00:00Z,b,6,2,fanout,--seconds 1,"64 B, ""one""",7,ms,<= 5,no
2026-02-01T00:00:00Z,b,6,2,fanout,,load,1,cores,,\n`;
const readme =
  "Text.\n<!-- begin of the table: written by scripts/bench --table -->\n<!-- end of the table -->\nAfter.\n";

test("the newest value of a bar is shown with command, machine and day; a missed bar is bold; no bar, no row", (t) => {
  const root = repositoryOf(t, { "tests/bench/results/some-cpu.csv": csv });
  const text = tables(resultsOf(root));
  assert.ok(
    text.includes('| fanout | 64 B, "one" | <= 5 ms | **7 ms** | fanout --seconds 1 | some-cpu | 2026-02-01 |'),
  );
  assert.ok(!text.includes("| 3 ms |"));
  assert.ok(!text.includes("| load |"));
  assert.ok(text.includes("`scripts/bench fanout` | some-cpu, 2026-02-01 |"));
});

test("a README that is older than the newest results is stale; the text around the tables stays", (t) => {
  const root = repositoryOf(t, { "tests/bench/results/some-cpu.csv": csv, "tests/bench/README.md": readme });
  assert.equal(staleTable(root).length, 1);
  const path = `${root}/tests/bench/README.md`;
  writeFileSync(path, withTables(readFileSync(path, "utf8"), resultsOf(root)));
  assert.deepEqual(staleTable(root), []);
  assert.match(readFileSync(path, "utf8"), /^Text\.\n[^]*\nAfter\.\n$/);
});

test("every row names an existing bench, or a test", () => {
  const script = readFileSync(new URL("../../scripts/bench", import.meta.url), "utf8");
  for (const { by, question } of proofs) assert.ok(by === "a test" || script.includes(`${by}`), question);
});
