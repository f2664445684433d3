// Are simulated games like real ones, by the figures of positions alone, and does the same estimator confirm the real ones?
import { existsSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { words } from "./games.mjs";
import { scratch, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const kChoices = [
  { name: "5 a side", choice: { rules: "spl2025:5" }, bar: { atLeast: 18 } },
  { name: "5 a side, without falls", choice: { rules: "spl2025:5", models: "match,falls=off" } },
  { name: "7 a side", choice: { rules: "spl2025:7" } },
  { name: "rules of 2012", choice: { rules: "spl2012" } },
];

const json = async (program, ...args) => JSON.parse(await start(program, [...args, "--json"]).output);
const shown = (value) => Number(value.toPrecision(3));

/** Reports the number of figures inside, and each figure that is not. */
function tell(report, name, realism, bar = {}) {
  report.figure(`${name}: figures inside the interval of real games`, realism.inside, `of ${realism.judged}`, bar);
  for (const { about, unit, real, measured, inside } of Object.values(realism.figures))
    if (inside === false)
      report.figure(
        `${name}: ${about}`,
        shown(measured.mean),
        `${unit} ± ${shown(measured.standard_error ?? 0)}, real ${real.low} .. ${real.high}`.trim(),
      );
}

/** Imports the halves in $FORESIGHT_DATA; returns their sessions. */
async function importHalves() {
  const folder = join(process.env.FORESIGHT_DATA ?? "", "spl_labels");
  if (!process.env.FORESIGHT_DATA || !existsSync(folder)) return [];
  const sessions = [];
  for (const file of readdirSync(folder)
    .filter((name) => name.endsWith(".csv"))
    .sort()) {
    const session = join(scratch, `half${sessions.length + 1}`);
    const { about } = await json("foresight-lab", "import", "spl_labels", join(folder, file), "--session", session);
    console.log(`   ${basename(file, ".csv")}: ${about}`);
    sessions.push(session);
  }
  return sessions;
}

export async function realism({ games = 100, jobs = 2 }) {
  const report = new Report("realism", "are simulated games like real ones?");
  for (const { name, choice, bar } of kChoices)
    tell(
      report,
      name,
      await json("foresight-sim", "match", "--statistics", "--games", games, "--threads", jobs, ...words(choice)),
      bar,
    );
  const halves = await importHalves();
  if (halves.length > 0) {
    const real = await json("foresight-lab", "game-statistics", ...halves);
    tell(report, "real halves", real, { exactly: real.judged });
  } else console.log("   the real halves are left out; set FORESIGHT_DATA to the folder of recordings");
  return report.finish();
}
