// How exact, how fast and how steady is ground truth? Beside the bars of the sensors, and the thesis's table 2.
import { cases, isBuilt, scratch, sleep, start, startClients } from "./programs.mjs";
import { join } from "node:path";
import { Report } from "./report.mjs";
import { renderedGame } from "./truth_game.mjs";

const kThesis = { 1: 9, 5: "9 to 11", 10: "9 to 11" }; // frames a second at its clients, table 2

async function tellFrames(report, frames) {
  for (const { case: name, median_ms, p95_ms, robots, lying_robots, ball } of await cases("bench_truth_frames", [
    frames,
  ])) {
    const coloured = !name.includes("depth only"); // a ball without a colour of its own is found where it can be
    const exact = !name.includes("error");
    report.figure(`${name}: a frame, median`, median_ms, "ms", { atMost: 1.2 });
    report.figure(`${name}: a frame, p95`, p95_ms, "ms");
    report.figure(`${name}: robots, mean error`, robots.mean_cm, "cm", { atMost: exact ? 2 : 2.5 });
    report.figure(`${name}: robots, p95 error`, robots.p95_cm, "cm", { atMost: exact ? 3.5 : 5 });
    report.figure(`${name}: robots, recall`, robots.recall, "", { atLeast: 0.98 });
    report.figure(`${name}: false robots a frame`, robots.false_per_frame, "", { atMost: 0.02 });
    report.figure(`${name}: lying robots, recall`, lying_robots.recall);
    report.figure(`${name}: ball, mean error`, ball.mean_cm, "cm", exact ? { atMost: 1.2 } : {});
    report.figure(`${name}: ball, recall`, ball.recall, "", coloured ? { atLeast: 0.98 } : {});
  }
}

/** PCL's pipelines and ours, on the same images in turn. */
async function tellPeers(report, frames) {
  if (!isBuilt("bench_truth_pcl")) {
    console.log("   PCL is not installed, so its pipelines are not measured beside ours: install libpcl-dev");
    return;
  }
  const pipelines = await cases("bench_truth_pcl", [frames], ["env", "OMP_NUM_THREADS=1"]);
  const ours = pipelines.find(({ pipeline }) => pipeline === "ours");
  for (const { pipeline, median_ms, robots, uncorrected_robots, ball } of pipelines) {
    const name = pipeline === "ours" ? "ours, in turn with PCL" : pipeline;
    report.figure(`${name}: a frame, median`, median_ms, "ms");
    report.figure(`${name}: robots, mean error`, robots.mean_cm, "cm");
    report.figure(`${name}: robots, recall`, robots.recall);
    report.figure(`${name}: false robots a frame`, robots.false_per_frame);
    report.figure(`${name}: ball, mean error`, ball.mean_cm, "cm");
    if (pipeline === "ours") continue;
    report.figure(`${name}: a frame, relative to ours`, median_ms / ours.median_ms, "x");
    report.figure(`${name}: robots, mean error without a correction`, uncorrected_robots.mean_cm, "cm");
  }
}

async function tellCalibration(report, trials) {
  for (const { click_px, scale, robots, ball, refused } of await cases("bench_truth_calibration", [trials])) {
    const name = `clicks of ${click_px} px, depths off by ${Math.round(100 * (scale - 1))} %`;
    const bar = click_px === 1 ? (limit) => limit : () => ({});
    report.figure(`${name}: places by depth, mean error`, robots.mean_cm, "cm", bar({ atMost: 1 }));
    report.figure(`${name}: places by depth, p95`, robots.p95_cm, "cm", bar({ atMost: 2.2 }));
    report.figure(`${name}: the ball's, p95`, ball.p95_cm, "cm", bar({ atMost: 2.2 }));
    report.figure(`${name}: 95 % ellipse covers`, 100 * robots.coverage, "%", bar({ between: [92, 98] }));
    report.figure(`${name}: refused`, refused, `of ${trials}`);
  }
}

async function tellTracks(report) {
  const [kicked, switches, honest, cost] = await cases("bench_truth_tracks");
  report.figure("kicked ball: velocity, smoothed, rms", 100 * kicked.smoothed_rms, "cm/s", { atMost: 5 });
  report.figure("kicked ball: velocity, as it happens, rms", 100 * kicked.online_rms, "cm/s");
  report.figure("10 min of 4v4: switched tracks, at most", switches.of_tracks, "in three games", { atMost: 5 });
  report.figure("10 min of 4v4, with the robots' poses: switched players", switches.of_players, "", { exactly: 0 });
  const { band } = honest;
  for (const [what, squares] of Object.entries({ online: honest.online, smoothed: honest.smoothed }))
    for (const [i, square] of squares.entries())
      report.figure(`normalised error squared, ${what}, ${i + 1} sensors`, square, "expected 4", {
        between: [4 - band, 4 + band],
      });
  report.figure("an image of 10 robots, two sensors", cost.ms_per_image, "ms", { atMost: 0.1 });
}

async function tellOffsets(report, recordings) {
  for (const found of await cases("bench_truth_offset", [recordings])) {
    const name = `${found.seconds} s ${found.kicks ? "with kicks" : "of walking only"}`;
    report.figure(`clock offset, ${name}: accepted`, found.accepted, `of ${found.recordings}`, {
      ...(found.kicks ? {} : { exactly: 0 }),
    });
    if (!found.kicks) continue;
    report.figure(`clock offset, ${name}: error, median`, found.error_median_ms, "ms", { atMost: 10 });
    report.figure(`clock offset, ${name}: error, p95`, found.error_p95_ms, "ms", { atMost: 25 });
    if (found.accepted >= 100)
      report.figure(`clock offset, ${name}: 95 % interval covers`, 100 * found.coverage, "%", { between: [90, 99] });
    report.figure(`clock offset, ${name}: processor time`, found.estimate_cpu_ms, "ms");
  }
}

async function tellTags(report, frames) {
  const all = (await cases("bench_truth_tags", [frames])).find(({ name }) => name === "all");
  report.figure("printed tags: place, p95 error", all.position_cm.p95, "cm", { atMost: 2 });
  report.figure("printed tags: heading, p95 error", all.heading_deg.p95, "deg", { atMost: 2 });
  report.figure("printed tags: wrong identities", all.wrong_identities, `in ${all.frames} frames`, { exactly: 0 });
  report.figure("printed tags: recall of whole tags", all.recall);
  report.figure("printed tags: a picture of 1280x720, one thread", all.look_ms.median, "ms");
}

/** A game that two synthetic sensors watch, live and smoothed, beside the true places. */
async function tellGame(report, seconds) {
  const cm = (metres) => 100 * metres;
  for (const [how, found] of Object.entries(await renderedGame(seconds))) {
    const name = `rendered game, ${how}`;
    report.figure(`${name}: robots, mean error`, cm(found.robots.mean), "cm", { atMost: 2.5 });
    report.figure(`${name}: robots, p95 error`, cm(found.robots.p95), "cm", { atMost: 5 });
    report.figure(`${name}: false robots of a moment`, found.robots.strangers, "", { atMost: 0.02 });
    report.figure(`${name}: robots not reported, of a moment`, found.unseen);
    report.figure(`${name}: switched tracks`, found.switches, `in ${seconds} s`);
    report.figure(`${name}: ball, median error`, cm(found.ball.median), "cm", { atMost: 1.2 });
    report.figure(`${name}: ball, p95 error`, cm(found.ball.p95), "cm");
    report.figure(`${name}: ball reported`, 100 * found.ball.seen, "% of moments");
    const bar = how === "smoothed" ? { atMost: 5 } : {};
    report.figure(`${name}: rolling ball, velocity, rms`, cm(found.velocity), "cm/s", bar);
  }
}

/** The thesis's table 2: the truth of a sensor at 1, 5 and 10 clients. */
async function tellClients(report, seconds) {
  for (const clients of [1, 5, 10]) {
    const server = start("foresight-lab", [
      ...["truth", "--source", "synthetic", "--port", 0, "--state-dir", join(scratch, "truth")],
      ...["--log-dir", join(scratch, "truth-logs")],
    ]);
    const url = (await server.address).replace("http", "ws");
    await sleep(2);
    const viewers = startClients(`${url}/`, ["--clients", clients, "--watch", "/truth/world", "--seconds", seconds]);
    const seen = (await viewers.report).clients.map(({ topics }) => topics["/truth/world"]);
    server.stop();
    const rates = seen.map(({ rate_hz }) => rate_hz);
    report.figure(
      `${clients} clients: frames a second at the slowest`,
      Math.min(...rates),
      `thesis: ${kThesis[clients]}`,
      {
        between: [29.7, 30.3],
      },
    );
    report.figure(
      `${clients} clients: age of a truth, p95`,
      Math.max(...seen.map(({ age_p95_ms }) => age_p95_ms)),
      "ms",
    );
  }
}

export async function truth({ seconds = 20, probes = 200, files = 10_000, minutes = 5 }) {
  const report = new Report("truth", "how exact, fast and steady is ground truth, on synthetic images?");
  if (probes > 0) {
    await tellFrames(report, probes);
    await tellPeers(report, probes);
    await tellCalibration(report, probes);
    await tellTracks(report);
    await tellOffsets(report, probes);
  }
  if (files > 0) await tellTags(report, files);
  if (minutes > 0) await tellGame(report, 60 * minutes);
  if (seconds > 0) await tellClients(report, seconds);
  return report.finish();
}
