// How old are the data at the end of a slow link, and which messages arrive?
import { link, whyNoNetwork } from "./network.mjs";
import { sleep, startClients, startRobot } from "./programs.mjs";
import { Report } from "./report.mjs";

const jpeg = "/14/2/camera_top/jpeg";
const sensors = ["joints", "inertial", "fsr", "sonar", "touch", "odometry", "motion_status"].map(
  (name) => `/14/2/${name}`,
);
const events = ["/14/2/game"];

export async function shaped({ seconds = 60 }) {
  const report = new Report("shaped", "how fresh is what a viewer sees over 5 Mbit/s?");
  const missing = whyNoNetwork();
  const network = missing ? undefined : link({ rate: "5mbit", latency: 400 });
  // a reader that takes 5 Mbit/s with a small buffer stands for the link: no queue of a router, no lost packets
  const slow = network ? [] : ["--bytes-per-second", 625_000, "--receive-buffer", 16_384];
  console.log(network ? `   link: ${network.words}` : `   ${missing}: a reader of 5 Mbit/s on the loopback instead`);

  const robot = await startRobot(["--cameras", 1, "--seconds", seconds, "--warm-up", 2, "--cool-down", 3], {
    address: network?.robot.address,
    before: network?.robot.before,
  });
  const set = ["--set", "jpeg_rate_hz=30", "--set", "jpeg_quality=75", "--set", "jpeg_width=640"];
  const viewer = startClients(robot.url(), ["--watch", "objects,jpeg", "--seconds", seconds + 10, ...slow, ...set], {
    before: network?.lab.before,
  });
  const { written } = await robot.report;
  await sleep(1);
  viewer.stop();
  const { topics, statuses } = (await viewer.report).clients[0];

  const part = (names) => Math.min(...names.map((topic) => topics[topic].messages / written[topic]));
  report.figure("image: age p50", topics[jpeg].age_p50_ms, "ms");
  report.figure("image: age p95", topics[jpeg].age_p95_ms, "ms", { below: 500 });
  report.figure("image: rate", topics[jpeg].rate_hz, "Hz");
  report.figure("image: size", topics[jpeg].bytes / topics[jpeg].messages / 1000, "kB");
  report.figure(
    "events that did not arrive",
    events.reduce((n, topic) => n + written[topic] - topics[topic].messages, 0),
    "",
    { exactly: 0 },
  );
  report.figure("sensors that arrived, of the worst", 100 * part(sensors), "%", { atLeast: 90 });
  report.figure("sensors: age p95", Math.max(...sensors.map((topic) => topics[topic].age_p95_ms)), "ms");
  report.figure("statuses that told of drops", statuses.length);
  return report.finish();
}
