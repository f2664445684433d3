// Is LoLA answered in time while the machine is busy, and what do frames and pictures cost?
import { existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const kCycle = 0.012; // [s]

/** A stand-in for a robot, the guardian and a runtime that gives orders, while both cores are busy. */
async function answers(report, seconds) {
  console.log(`   a frame every 12 ms, both cores busy: ${seconds} s …`);
  const [lola, link] = [join(scratch, "lola"), join(scratch, "guardian")];
  const robot = start("fake_robot", [lola, "--busy", 2, "--seconds", seconds]);
  await robot.firstLine;
  const guardian = start("foresight-guardian", ["--lola", lola, "--link", link]);
  const allowed = (await guardian.firstLine).includes("priority: yes");
  await sleep(0.5);
  const runtime = start("fake_runtime", [link, "--heard"]);
  const told = await robot.report;
  runtime.stop();
  guardian.stop();
  report.figure("frames sent", told.frames, `of ${Math.floor(seconds / kCycle)}`);
  // the last answer may not have arrived yet
  report.figure("frames that were never answered", Math.max(0, told.frames - told.answers - 1), "", { exactly: 0 });
  report.figure("frames without an answer before the next one", told.unanswered, "", { exactly: 0 });
  report.figure("answers that were none", told.bad_answers, "", { exactly: 0 });
  report.figure("until the answer, median", told.median_ms, "ms");
  report.figure(
    `until the answer, p99.9, real-time priority ${allowed ? "allowed" : "not allowed"}`,
    told.p999_ms,
    "ms",
    allowed ? { atMost: 4 } : {},
  );
  report.figure("until the answer, longest", told.longest_ms, "ms");
  report.figure("cycles that the robot itself was late for", told.late_cycles);
}

export async function lola({ seconds = 600 }) {
  const report = new Report("lola", "is LoLA answered in time while the machine is busy?");
  const cost = await start("bench_lola", ["frames"]).report;
  report.figure(`a frame of ${cost.bytes} bytes, read in place`, cost.in_place_us, "us", { atMost: 1 });
  report.figure("the same, looked through", cost.looked_through_us, "us");
  report.figure("an answer, composed", cost.composed_us, "us");

  // a real picture if there is one
  let picture = process.env.FORESIGHT_DATA && join(process.env.FORESIGHT_DATA, "frames/htwk_benchmark_640x480.yuv422");
  if (!picture || !existsSync(picture))
    writeFileSync((picture = join(scratch, "picture")), Buffer.alloc(2 * 640 * 480, 128));
  const length = Math.min(seconds, 60);
  console.log(`   both cameras from a stand-in: ${length} s …`);
  const cameras = await start("bench_lola", ["cameras", length, picture]).report;
  for (const name of ["top", "bottom"]) {
    report.figure(`camera ${name}: pictures a second`, cameras[name].fps, "1/s", { between: [29.9, 30.1] });
    report.figure(
      `camera ${name}: that did not arrive`,
      cameras.delivered - cameras[name].images,
      `of ${cameras.delivered}`,
      { exactly: 0 },
    );
  }
  await answers(report, seconds);
  return report.finish();
}
