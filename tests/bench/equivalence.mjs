// Does a game have the same statistics when robots far from the ball decide less often?
import { firstGoal, lead, play, sum } from "./games.mjs";
import { pretty, Report, table } from "./report.mjs";
import { differenceOf, equivalence as test, meanOf } from "./statistics.mjs";

const kPairings = [
  { name: "baseline against itself, models match", models: "match" },
  // without any noise there would be only two games, one for each side's kick-off
  { name: "baseline against itself, models perfect with kick_noise", models: "perfect,kick_noise=on" },
  // unequal sides: neither the better side nor its lead may change
  { name: "baseline against kick_now, models match", models: "match", away: "kick_now" },
];

// margins as absolute numbers, or as a part of the mean at every tick
const kOutcomes = [
  { name: "goals", value: sum("goals"), unit: "", margin: 0.15 },
  { name: "goals, home less away", value: lead("goals"), unit: "", margin: 0.15 },
  { name: "possession of home", value: (game) => 100 * game.home.possession, unit: "%", margin: 3 },
  { name: "shots", value: sum("shots"), unit: "", part: 0.05 },
  { name: "first goal after", value: firstGoal, unit: "s", part: 0.05 },
];

export async function equivalence({ games = 5000, jobs = 2 }) {
  const report = new Report("equivalence", "is the thinned game the game at 30 decisions a second?");
  console.log(
    `   ${games} games each with the same seeds; 90 % intervals of thinned less every tick (two one-sided tests at 5 %).`,
  );
  console.log(
    "   Margins: 0.15 goals, 3 % possession, 5 % of shots and of the time to the first goal (goalless: the whole game).",
  );
  for (const { name: pairing, ...choice } of kPairings) {
    const thinned = await play(choice, games, { jobs });
    const plain = await play({ ...choice, everyTick: true }, games, { jobs });
    const rows = kOutcomes.map(({ name, value, unit, margin, part }) => {
      const known = plain.map(value);
      const within = margin ?? part * meanOf(known).mean;
      const { from, to, farthest } = test(differenceOf(thinned.map(value), known), within);
      report.figure(`${pairing}: ${name}, farthest end of the interval`, farthest, unit, {
        atMost: Number(pretty(within)),
      });
      return [
        name,
        pretty(meanOf(known).mean),
        pretty(meanOf(thinned.map(value)).mean),
        `${pretty(from)} .. ${pretty(to)}`,
        unit,
      ];
    });
    console.log(
      `\n   ${pairing}\n` + table([["", "every tick", "thinned", "difference", ""], ...rows]).replaceAll(/^/gm, "   "),
    );
  }
  return report.finish();
}
