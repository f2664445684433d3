// Does memory grow? Ten minutes each of a robot and of the ground-truth server, with viewers that connect and disconnect.
// With `speed`, each writes as many truths as in the thesis's two weeks.
import { sendPackets } from "../e2e/ssl_packets.mjs";
import { sleep, startClients, startRobot } from "./programs.mjs";
import { median, pretty, Report } from "./report.mjs";
import { runTruth } from "./soak_truth.mjs";

const kDay = 86_400; // [s]
const kDays = 14;
const kConnectionsPerDay = 100;
const kSessionsPerDay = 20;
const kTruthHz = 10; // in the thesis
const kImagesHz = 30; // of a depth camera
const kRobotMb = 64; // most of a robot's memory
const kLogMb = 300; // two days of data and the reserve: most of the time old sessions are deleted for new ones

/** Growth of memory from the third quarter to the last one [MB]. */
function growth(samples) {
  const quarter = Math.max(1, Math.floor(samples.length / 4));
  return median(samples.slice(-quarter)) - median(samples.slice(-2 * quarter, -quarter));
}

async function run(robotArgs, clientArgs, seconds) {
  const robot = await startRobot([
    ...robotArgs,
    "--seconds",
    seconds,
    "--no-costs",
    "--memory-every",
    Math.max(0.5, seconds / 120),
  ]);
  const viewers = startClients(robot.url(), ["--seconds", seconds + 10, ...clientArgs]);
  const found = await robot.report;
  viewers.stop();
  return { found, viewers: await viewers.report };
}

function judge(report, { found, viewers }, { atLeast, atMostMb } = {}) {
  const written = Object.values(found.written).reduce((a, b) => a + b, 0);
  report.figure("messages written", written, "", atLeast ? { atLeast } : {});
  report.figure("messages received", viewers.messages);
  report.figure("connections", viewers.connections);
  report.figure("sessions", found.recorded.sessions);
  report.figure("recordings on the disk at the end", found.recorded.disk_bytes / 1e6, "MB");
  report.figure("sessions that are damaged", found.recorded.damaged, "", { exactly: 0 });
  report.figure("messages lost to the disk", found.recorded.dropped, "", { exactly: 0 });
  const largest = Math.max(...found.memory_mb);
  report.figure("resident set, largest, image buffers included", largest, "MB", atMostMb ? { atMost: atMostMb } : {});
  report.figure("resident set, growth over the second half", growth(found.memory_mb), "MB", { atMost: 1 });
  const eighth = Math.max(1, Math.floor(found.memory_mb.length / 8));
  console.log(
    `   resident set, every eighth: ${found.memory_mb
      .filter((_, i) => i % eighth === 0)
      .map(pretty)
      .join(" ")} MB`,
  );
}

/** Ten minutes of a robot in use. */
async function ten(seconds) {
  const report = new Report("soak", "does the robot's memory grow while viewers come and go?");
  console.log(
    `   ${seconds} s, raw images and all objects, profile game, 8 viewers who stay 5 s on average; some stall`,
  );
  judge(
    report,
    await run(
      ["--cameras", 1, "--profile", "game"],
      ["--clients", 8, "--lifetime", 5, "--watch", "objects,images,jpeg"],
      seconds,
    ),
    { atMostMb: kRobotMb },
  );
  return report.finish();
}

/** As many messages, connections and sessions as in two weeks of ground truth. */
async function twoWeeks(speed) {
  const seconds = (kDays * kDay) / speed;
  const report = new Report("soak-two-weeks", "does it hold what the thesis's ground truth system held for two weeks?");
  console.log(
    `   ${kDays} days at ${speed} times the speed = ${Math.round(seconds)} s: ground truth at ${kTruthHz} Hz = ${kDays * kDay * kTruthHz} messages ` +
      `to 10 viewers, ${kConnectionsPerDay} connections and ${kSessionsPerDay} sessions a day = ${kDays * kConnectionsPerDay} and ${kDays * kSessionsPerDay}`,
  );
  const seats = 10;
  const lifetime = (seats * seconds) / (kDays * kConnectionsPerDay);
  judge(
    report,
    await run(
      [
        "--no-objects",
        "--cameras",
        0,
        "--truth-hz",
        kTruthHz,
        "--speed",
        speed,
        "--profile",
        "game",
        "--log-mb",
        kLogMb,
        "--session-seconds",
        seconds / (kDays * kSessionsPerDay),
      ],
      ["--clients", seats, "--lifetime", lifetime, "--watch", "objects"],
      seconds,
    ),
    { atLeast: Math.floor(0.999 * kDays * kDay * kTruthHz), atMostMb: kRobotMb },
  );
  return report.finish();
}

/** The ground-truth server for this time, with as many connections as in two weeks. */
async function truthServer(seconds) {
  const report = new Report("soak-truth", "does the ground-truth server's memory grow while viewers come and go?");
  const sources = ["synthetic", "synthetic:2"];
  const sensors = sources.map((_, i) => `/truth/${i + 1}/sensor`);
  console.log(
    `   ${seconds} s, two synthetic sensors in real time, recorded; connections as in ${kDays} days, and some viewers stall`,
  );
  const seen = await runTruth({
    sources,
    topics: ["/truth/world", ...sensors, "/truth/1/depth"],
    seconds,
    connections: kDays * kConnectionsPerDay,
    use: () => sleep(seconds),
  });
  judge(report, seen);
  const { written, world } = seen;
  const span = Math.round(((world.messages - 1) / world.rate_hz) * kImagesHz) + 1;
  const wanted = kDays * kDay * kImagesHz;
  report.figure(
    "reports of the sensors, one for each image in time",
    written[sensors[0]] + written[sensors[1]],
    `of ${wanted} of one sensor in ${kDays} days`,
  );
  report.figure("truths that a lossless viewer lacks", Math.max(0, span - world.messages), `of ${span}`, {
    exactly: 0,
  });
  return report.finish();
}

/** As many truths and connections as in two weeks, through the ground-truth server: packets of SSL-Vision. */
async function twoWeeksOfTruth(speed) {
  const report = new Report(
    "soak-truth-two-weeks",
    "does the ground-truth server hold what the thesis's held for two weeks?",
  );
  const [count, rate] = [kDays * kDay * kTruthHz, speed * kTruthHz];
  const vision = { group: "239.5.23.77", port: 20000 + (process.pid % 20000) };
  console.log(
    `   ${kDays} days at ${kTruthHz} Hz = ${count} packets of SSL-Vision, no depth images, ${rate} a second; recorded; ` +
      `${kDays * kConnectionsPerDay} connections`,
  );
  const seen = await runTruth({
    sources: [`ssl-vision:${vision.group}:${vision.port}`],
    topics: ["/truth/world"],
    seconds: count / rate,
    connections: kDays * kConnectionsPerDay,
    use: () => sendPackets(count, rate, vision),
  });
  judge(report, seen, { atLeast: Math.floor(0.999 * count) });
  report.figure(
    "truths lost between the socket and the recording",
    count - seen.written["/truth/world"],
    `of ${count}`,
  );
  return report.finish();
}

export async function soak({ seconds = 600, minutes = 10, speed }) {
  const ofRobot = seconds > 0 && (speed ? () => twoWeeks(speed) : () => ten(seconds));
  const ofTruth = minutes > 0 && (speed ? () => twoWeeksOfTruth(speed) : () => truthServer(60 * minutes));
  let met = true;
  for (const measure of [ofRobot, ofTruth]) if (measure) met = (await measure()) && met;
  return met;
}
