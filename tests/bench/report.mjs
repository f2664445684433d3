// Figures of a bench beside their bars, on the screen and in tests/bench/results/<machine>.csv.
import { execFileSync } from "node:child_process";
import { appendFileSync, existsSync, mkdirSync, readFileSync } from "node:fs";
import { cpus, release } from "node:os";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));

export const machine = { cpu: cpus()[0].model.trim(), cores: cpus().length, kernel: release() };
const slug = machine.cpu
  .toLowerCase()
  .replace(/\((r|tm)\)/g, "")
  .replace(/[^a-z0-9]+/g, "-")
  .replace(/^-|-$/g, "");

const build = () => {
  try {
    return execFileSync("git", ["describe", "--always", "--dirty=+", "--abbrev=12"], {
      cwd: here,
      encoding: "utf8",
    }).trim();
  } catch {
    return "unknown";
  }
};

/** Returns the median; of two middle values the smaller one. */
export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor((values.length - 1) / 2)];

/** Formats 0.123 as "0.123" and 1234.5 as "1235": three significant digits, never 1e3. */
export const pretty = (value) => {
  if (typeof value !== "number" || Number.isInteger(value)) return String(value);
  const digits = Math.max(0, Math.min(3, 2 - Math.floor(Math.log10(Math.abs(value) || 1))));
  return value.toFixed(digits);
};

/** Formats rows as columns, with numbers to the right. */
export function table(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => String(row[column]).length)));
  const isNumber = (text) => /^[<>]?=?\s*[-\d.]/.test(text);
  return rows
    .map((row) =>
      row
        .map((cell, column) => {
          const text = String(cell);
          return column > 0 && isNumber(text) ? text.padStart(widths[column]) : text.padEnd(widths[column]);
        })
        .join("  ")
        .trimEnd(),
    )
    .join("\n");
}

/** The figures of one bench. A figure without a bar is printed, not judged. */
export class Report {
  #rows = [];

  constructor(bench, question) {
    this.bench = bench;
    console.log(`\n== ${bench}: ${question}`);
    console.log(`   ${machine.cpu}, ${machine.cores} cores, Linux ${machine.kernel}, build ${build()}`);
  }

  /** `bar`: {atMost}, {below}, {atLeast}, {above}, {between: [from, to]} or {exactly}. */
  figure(name, value, unit = "", bar = {}) {
    let met;
    let text = "";
    if ("atMost" in bar) [met, text] = [value <= bar.atMost, `<= ${bar.atMost}`];
    if ("below" in bar) [met, text] = [value < bar.below, `< ${bar.below}`];
    if ("atLeast" in bar) [met, text] = [value >= bar.atLeast, `>= ${bar.atLeast}`];
    if ("above" in bar) [met, text] = [value > bar.above, `> ${bar.above}`];
    if ("between" in bar) [met, text] = [value >= bar.between[0] && value <= bar.between[1], bar.between.join(" .. ")];
    if ("exactly" in bar) [met, text] = [value === bar.exactly, `= ${bar.exactly}`];
    this.#rows.push({ name, value, unit, bar: text, met });
  }

  /** Prints the table and appends the figures to the CSV file; returns true if every bar is met. */
  finish() {
    const verdict = { true: "met", false: "MISSED", undefined: "" };
    const rows = this.#rows.map((row) => [row.name, pretty(row.value), row.unit, row.bar, verdict[row.met]]);
    console.log("\n" + table([["figure", "value", "unit", "bar", ""], ...rows]));
    const file = `${here}results/${slug}.csv`;
    mkdirSync(`${here}results`, { recursive: true });
    if (!existsSync(file)) appendFileSync(file, "date,build,kernel,cores,bench,options,figure,value,unit,bar,met\n");
    const date = new Date().toISOString().slice(0, 19) + "Z";
    // the options distinguish a quick look from a full measurement
    const known = [date, build(), machine.kernel, machine.cores, this.bench, process.argv.slice(3).join(" ")];
    const cell = (text) => (/[",]/.test(text) ? `"${String(text).replaceAll('"', '""')}"` : text);
    for (const row of this.#rows)
      appendFileSync(
        file,
        [...known, row.name, pretty(row.value), row.unit, row.bar, row.met === undefined ? "" : row.met ? "yes" : "no"]
          .map(cell)
          .join(",") + "\n",
      );
    return this.#rows.every((row) => row.met !== false);
  }
}

/** Returns the load of other programs on this machine, in cores, measured over a second. */
export async function otherLoad() {
  const busy = () => {
    const [user, nice, system, , , irq, soft, steal] = readFileSync("/proc/stat", "utf8")
      .split("\n")[0]
      .split(/\s+/)
      .slice(1)
      .map(Number);
    return user + nice + system + irq + soft + steal;
  };
  const before = busy();
  await new Promise((done) => setTimeout(done, 1000));
  return (busy() - before) / 100;
}
