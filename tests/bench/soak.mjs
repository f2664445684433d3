// Does memory grow? Ten minutes with viewers that connect and disconnect; with `speed`, as much data as in the thesis's two weeks.
import { startClients, startRobot } from "./programs.mjs";
import { median, pretty, Report } from "./report.mjs";

const kDay = 86_400; // [s]
const kDays = 14;
const kConnectionsPerDay = 100;
const kSessionsPerDay = 20;
const kTruthHz = 10;
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

function judge(report, { found, viewers }, expected = 0) {
  const written = Object.values(found.written).reduce((a, b) => a + b, 0);
  report.figure("messages written", written, "", expected ? { atLeast: expected } : {});
  report.figure("messages received", viewers.messages);
  report.figure("connections", viewers.connections);
  report.figure("sessions", found.recorded.sessions);
  report.figure("recordings on the disk at the end", found.recorded.disk_bytes / 1e6, "MB");
  report.figure("sessions that are damaged", found.recorded.damaged, "", { exactly: 0 });
  report.figure("messages lost to the disk", found.recorded.dropped, "", { exactly: 0 });
  report.figure("resident set, largest, image buffers included", Math.max(...found.memory_mb), "MB", { atMost: 64 });
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
    Math.floor(0.999 * kDays * kDay * kTruthHz),
  );
  return report.finish();
}

export const soak = ({ seconds = 600, speed }) => (speed ? twoWeeks(speed) : ten(seconds));
