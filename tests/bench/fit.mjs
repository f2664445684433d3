// How exact are models that were fitted to recordings, and how honest are their intervals?
import { rmSync } from "node:fs";
import { join } from "node:path";
import { cases, scratch, start } from "./programs.mjs";
import { Report } from "./report.mjs";

/** Records a quarter of an hour of ten robots, fits all models, and returns the time for an hour of five robots [s]. */
async function secondsOfAnHour() {
  const file = join(scratch, "game.mcap");
  const game = ["match", "--rules", "spl2025:5", "--every-tick", "--seconds", 900, "--mcap", file];
  await start("foresight-sim", game).output;
  const began = performance.now();
  await start("foresight-lab", ["fit", file]).output;
  const took = (performance.now() - began) / 1000;
  rmSync(file);
  return (took * 5 * 3600) / (10 * 900);
}

const kRanges = { in_range_cm: "0.5 to 3 m", near_cm: "0.15 to 0.5 m", far_cm: "3 to 4.5 m" };

export async function fit({ choices = 100 }) {
  const report = new Report("fit", "are fitted models exact, and their intervals honest?");
  const all = await cases("bench_fit", [choices]);
  const of = (name) => all.filter((one) => one.case === name);
  const [study] = of("study");
  for (const [range, about] of Object.entries(kRanges)) {
    const law = study.power_law[range];
    report.figure(`ball distance, ${about}: pinhole, mean error`, study.pinhole[range], "cm", { atMost: law });
    report.figure(`ball distance, ${about}: power law, mean error`, law, "cm");
    report.figure(`ball distance, ${about}: constant, mean error`, study.constant[range], "cm");
  }
  report.figure("460 images: fit, intervals and held-out errors", study.seconds, "s", { atMost: 2 });
  report.figure("an hour of recordings of five robots: all fits", await secondsOfAnHour(), "s", { atMost: 60 });
  for (const { partial, repetitions, ...kicks } of of("kicks")) {
    const name = partial > 0 ? `50 kicks, ${100 * partial} % partial` : "50 kicks";
    const bar = partial > 0 ? () => ({}) : (limit) => limit; // the bars are for kicks on an empty field
    report.figure(`${name}: error of the speed, p95`, kicks.speed_percent, `% of ${repetitions}`, bar({ atMost: 5 }));
    report.figure(`${name}: error of the direction, p95`, kicks.direction_degrees, "deg", bar({ atMost: 2 }));
    report.figure(`${name}: landed in the region of 90 %, held out`, kicks.covered_percent, "%", {
      between: [85, 95],
    });
    report.figure(`${name}: CRPS, relative to a constant's`, kicks.crps_share, "", { atMost: 1 });
  }
  for (const { figure, repetitions, coverage, half_width, bias_share } of of("planted")) {
    report.figure(`${figure}: interval covers the planted value`, 100 * coverage, `% of ${repetitions}`, {
      between: [90, 99],
    });
    report.figure(`${figure}: bias, share of the interval`, bias_share, "", { atMost: 1 / 3 });
    report.figure(`${figure}: half the interval`, half_width);
  }
  return report.finish();
}
