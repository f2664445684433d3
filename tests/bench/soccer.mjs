// Do simulated games have the statistics of robot soccer, and does each effect of reality act as intended?
import { both, lead, play, Series, sum } from "./games.mjs";
import { pretty, Report, table } from "./report.mjs";
import { kEffects, kSure, settle } from "./soccer_effects.mjs";
import { interval, meanOf } from "./statistics.mjs";

/** Goals of a game and goalless games [%] between equals. Those of 7 a side and of 2026 are printed, not judged. */
const kEqual = [
  { name: "spl2012", rules: "spl2012", goals: [1.5, 2.3], goalless: [10, 25] },
  { name: "spl2025, 5 a side", rules: "spl2025:5", goals: [2.4, 3.5], goalless: [5, 20] },
  { name: "spl2025, 7 a side", rules: "spl2025:7" },
  { name: "hsl2026", rules: "hsl2026" },
];
const kTaken = 95; // [%] of the set plays of a kind are taken before their time is up

const percent = (value) => 100 * value;
const rounded = (value) => Number(pretty(value));
const meanBy = (games, value) => meanOf(games.map(value)).mean;
const error = ({ error: value }) => `± ${pretty(rounded(value))}`;

/** The share of set plays that were taken in time, by kind, for the kinds that the rules have. */
function tellSetPlays(report, name, games) {
  for (const kind of Object.keys(games[0].set_plays)) {
    const total = (end) => games.reduce((count, game) => count + game.set_plays[kind][end], 0);
    const [taken, expired] = [total("taken"), total("expired")];
    if (taken + expired > 0)
      report.figure(`${name}: ${kind} taken in time`, percent(taken / (taken + expired)), `% of ${taken + expired}`, {
        atLeast: kTaken,
      });
  }
}

/** Goals of real teams of equal strength (shared/facts/models.md 2.9), and how often real robots see the ball. */
function tellEqual(report, { name, goals: [fewest, most] = [], goalless: [rarest, oftenest] = [] }, games) {
  const within = (least, greatest) => (least === undefined ? {} : { between: [least, greatest] });
  const goals = meanOf(games.map(sum("goals")));
  report.figure(`${name}: goals of a game`, goals.mean, error(goals), within(fewest, most));
  const goalless = games.filter((game) => sum("goals")(game) === 0).length / games.length;
  report.figure(`${name}: goalless games`, percent(goalless), "%", within(rarest, oftenest));
  tellSetPlays(report, name, games);

  const ahead = meanOf(games.map(lead("goals")));
  const [, even] = interval({ mean: 0, error: ahead.error }, 95);
  report.figure(`${name}: goals, home less away`, ahead.mean, error(ahead), { between: [-even, even].map(rounded) });
  const wins = (side) => percent(games.filter((game) => side * lead("goals")(game) > 0).length / games.length);
  report.figure(`${name}: won by home`, wins(1), "%");
  report.figure(`${name}: won by away`, wins(-1), "%");

  const seen = games[0].seen.map((_, robot) => percent(meanBy(games, (game) => game.seen[robot])));
  report.figure(`${name}: ball seen by a robot`, percent(meanBy(games, both("ball_seen"))), "% of frames", {
    between: [30, 60],
  });
  report.figure(`${name}: by the one who sees it least`, Math.min(...seen), "% of frames");
  report.figure(`${name}: by the one who sees it most`, Math.max(...seen), "% of frames");
  for (const [what, unit, value] of [
    ["shots of a game", "", sum("shots")],
    ["kicks of a game", "", sum("kicks")],
    ["kicks that missed the ball", "", sum("whiffs")],
    ["ball out", "", (game) => game.out],
    ["penalties", "", sum("penalties")],
    ["walked by a side", "m", both("walked")],
    ["packets of a side", "", both("packets")],
  ])
    report.figure(`${name}: ${what}`, meanBy(games, value), unit);
}

/** `by`: how many goals better home must be, beyond the 95 % interval; none: printed, not judged. */
const kUnequal = [
  { name: "perfect models against match", choice: { homeModels: "perfect", awayModels: "match" }, by: 0 },
  { name: "baseline against idle", choice: { away: "idle" }, by: 3 },
  { name: "kick_now against align_first", choice: { home: "kick_now", away: "align_first" } },
  { name: "passing against baseline", choice: { home: "passing" } },
];

function tellUnequal(report, { name, by }, games) {
  const ahead = meanOf(games.map(lead("goals")));
  const [from] = interval(ahead, 95);
  report.figure(`${name}: goals, home less away`, ahead.mean, error(ahead));
  if (by !== undefined) report.figure(`${name}: surely ahead by`, from, "goals", { above: by });
  report.figure(`${name}: won by home`, percent(meanBy(games, (game) => (lead("goals")(game) > 0 ? 1 : 0))), "%");
  report.figure(`${name}: shots, home less away`, meanBy(games, lead("shots")), "");
}

async function tellEffects(report, most, jobs) {
  console.log(
    `\n   each effect alone, against models match with the same seeds, until ${kSure} standard errors or ${most} games`,
  );
  const plain = new Series({}, jobs);
  const rows = [];
  for (const effect of kEffects) {
    const { games, without, difference } = await settle(effect, plain, most, jobs);
    const name = `${effect.name} ${effect.to}: ${effect.statistic}`;
    const sure = rounded(kSure * difference.error);
    const unit = [effect.unit, error(difference)].filter(Boolean).join(" ");
    report.figure(name, difference.mean, unit, effect.sign > 0 ? { above: sure } : { below: -sure });
    const change = [pretty(without), pretty(difference.mean), error(difference), effect.unit];
    rows.push([`${effect.name} ${effect.to}`, effect.statistic, ...change, games]);
  }
  const head = ["effect", "statistic", "match", "changes by", "", "unit", "games"];
  console.log("\n" + table([head, ...rows]).replaceAll(/^/gm, "   "));
}

export async function soccer({ games: count = 500, jobs = 2 }) {
  const report = new Report("soccer", "is it soccer, and does each effect do what it should?");
  console.log(`   ${count} games each; ± one standard error. Intervals of 95 %.`);
  for (const equal of kEqual) tellEqual(report, equal, await play({ rules: equal.rules }, count, { jobs }));
  for (const pairing of kUnequal) tellUnequal(report, pairing, await play(pairing.choice, count, { jobs }));
  await tellEffects(report, count, jobs);
  return report.finish();
}
