// The generated part of tests/bench/README.md: the table of proofs, and the newest figure of every bar.
//
//   scripts/bench --table
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { proofs } from "./proofs.mjs";

const folder = "tests/bench/results";
const begin = "<!-- begin of the table: written by scripts/bench --table -->";
const end = "<!-- end of the table -->";

/** The cells of one line of CSV. */
const cellsOf = (line) =>
  [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(
    ([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain,
  );

/** All lines of the CSV files below `root`: {machine, date, bench, options, figure, value, unit, bar, met}. */
export function resultsOf(root) {
  return readdirSync(join(root, folder))
    .filter((file) => file.endsWith(".csv"))
    .sort()
    .flatMap((file) => {
      const [head, ...lines] = readFileSync(join(root, folder, file), "utf8")
        .trim()
        .split("\n");
      const names = cellsOf(head);
      return lines.map((line) => ({
        machine: file.slice(0, -4),
        ...Object.fromEntries(cellsOf(line).map((cell, i) => [names[i], cell])),
      }));
    });
}

const cell = (text) => String(text).replaceAll("|", "\\|");
const row = (cells) => `| ${cells.map(cell).join(" | ")} |`;
const tableOf = (head, rows) => [row(head), row(head.map(() => "---")), ...rows.map(row)].join("\n");

/** Date and machine of the newest run of a bench on each machine. */
function lastRuns(results, bench) {
  const newest = new Map();
  for (const result of results) if (result.bench === bench) newest.set(result.machine, result.date.slice(0, 10));
  return [...newest].map(([machine, date]) => `${machine}, ${date}`).join("; ");
}

/** The generated part, as Markdown. */
export function tables(results) {
  const proved = proofs.map(({ question, bar, seen, by, report = by }) =>
    by === "a test"
      ? [question, bar, seen, "a test", ""]
      : [question, bar, seen, `\`scripts/bench ${by}\``, lastRuns(results, report)],
  );
  const newest = new Map();
  for (const result of results)
    if (result.bar) newest.set(`${result.bench}\n${result.figure}\n${result.machine}`, result);
  const figures = [...newest.values()]
    .sort(
      (a, b) =>
        a.bench.localeCompare(b.bench) || a.figure.localeCompare(b.figure) || a.machine.localeCompare(b.machine),
    )
    .map(({ bench, figure, bar, value, unit, met, options, machine, date }) => {
      const seen = `${value} ${unit}`.trim();
      return [
        bench,
        figure,
        `${bar} ${unit}`.trim(),
        met === "no" ? `**${seen}**` : seen,
        `${bench} ${options}`.trim(),
        machine,
        date.slice(0, 10),
      ];
    });
  return [
    "## What was proved",
    tableOf(["question", "bar", "seen", "command", "newest run"], proved),
    "## The newest figure of every bar",
    tableOf(["bench", "figure", "bar", "seen", "`scripts/bench …`", "machine", "date"], figures),
  ].join("\n\n");
}

/** Returns `text` of the README with the generated part of `results`. */
export function withTables(text, results) {
  const [before, rest] = text.split(begin);
  const after = rest?.split(end)[1];
  if (after === undefined) throw new Error(`tests/bench/README.md: expected the lines '${begin}' and '${end}'`);
  return `${before}${begin}\n\n${tables(results)}\n\n${end}${after}`;
}

/** The check: one sentence if the README's tables are not those that scripts/bench --table would write. */
export function staleTable(root) {
  const text = readFileSync(join(root, "tests/bench/README.md"), "utf8");
  return text === withTables(text, resultsOf(root))
    ? []
    : ["tests/bench/README.md: the tables are older than the results; write them anew with scripts/bench --table"];
}
