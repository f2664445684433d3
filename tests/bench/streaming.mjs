// Are messages lost on the way to the disk and to lossless viewers? The thesis's Table 1 beside ours.
import { link, whyNoNetwork } from "./network.mjs";
import { sleep, startClients, startRobot } from "./programs.mjs";
import { pretty, Report, table } from "./report.mjs";

const vision = "/14/2/vision";
const images = "/14/2/camera_top";
const kOwn = ["clock", "runtime", "log"]; // written by the runtime itself too: they do not count frames

/** One robot, its disk and its viewers, for `seconds`. */
async function scene({ title, seconds, cameras, clients, jpeg, network }) {
  const robot = await startRobot(
    ["--profile", "full", "--cameras", cameras, "--seconds", seconds, "--warm-up", 2, "--cool-down", 2],
    { address: network?.robot.address, before: network?.robot.before },
  );
  const watch = jpeg ? "objects,jpeg" : "objects,images";
  const set = jpeg ? ["--set", "jpeg_rate_hz=30"] : [];
  const viewers = startClients(
    robot.url("&delivery=lossless"),
    ["--clients", clients, "--watch", watch, "--seconds", seconds + 10, ...set],
    { before: network?.lab.before },
  );
  const written = await robot.report;
  await sleep(0.5);
  viewers.stop();
  const seen = await viewers.report;

  const counted = Object.entries(written.written).filter(([topic]) => !kOwn.some((own) => topic.endsWith("/" + own)));
  const lostOn = (messages) => counted.reduce((sum, [topic, n]) => sum + Math.abs(n - (messages[topic] ?? 0)), 0);
  const lost = seen.clients.map(({ topics }) =>
    lostOn(
      Object.fromEntries(
        Object.entries(topics).map(([topic, { messages, missed }]) => [
          topic.replace(/\/jpeg$/, ""),
          missed > 0 && messages === written.written[topic] ? -missed : messages,
        ]),
      ),
    ),
  );
  const frames = cameras ? images : vision;
  const fps = (topics) => topics[cameras && jpeg ? images + "/jpeg" : frames].rate_hz;
  const slowest = seen.clients.reduce((a, b) => (fps(a.topics) <= fps(b.topics) ? a : b));
  return {
    title,
    written: counted.reduce((sum, [, n]) => sum + n, 0),
    sentAway: seen.clients.filter(({ ended, topics }) => !ended.startsWith("1001") || !topics[vision]).length,
    diskLost: lostOn(written.recorded.messages),
    clientsLost: Math.max(...lost),
    diskFps: written.recorded.messages[frames] / written.seconds,
    clientFps: fps(slowest.topics),
    age: slowest.topics[cameras && jpeg ? images + "/jpeg" : frames].age_p95_ms,
    cores: written.cpu_cores,
    statuses: seen.clients.flatMap(({ statuses }) => statuses),
  };
}

export async function streaming({ seconds = 60 }) {
  const report = new Report("streaming", "is a frame lost on its way to the disk or to a viewer who wants them all?");
  const missing = whyNoNetwork();
  if (missing) console.log(`   ${missing}: only the loopback is measured`);
  const gigabit = missing ? undefined : link({ rate: "1gbit", burst: "256kb", latency: 50 });
  const slow = missing ? undefined : link({ rate: "100mbit", burst: "32kb", latency: 50 });
  const places = [
    { name: "10 viewers, loopback", clients: 10 },
    ...(missing
      ? []
      : [
          { name: "4 viewers, 1 Gbit/s", clients: 4, network: gigabit },
          { name: "1 viewer of JPEG, 100 Mbit/s", clients: 1, jpeg: true, network: slow },
        ]),
  ];

  const rows = [];
  const disk = { normal: [], heavy: [] };
  for (const place of places) {
    const found = {};
    for (const [kind, cameras] of [
      ["normal", 0],
      ["heavy", 1],
    ]) {
      const title = `${place.name}, ${cameras ? "raw images and all objects" : "all objects"}`;
      console.log(`   ${title}: ${seconds} s …`);
      const seen = await scene({ title, seconds, cameras, ...place });
      found[kind] = seen;
      disk[kind].push(seen.diskFps);
      report.figure(`${place.name}, ${kind}: lost on the way to the disk`, seen.diskLost, `of ${seen.written}`, {
        exactly: 0,
      });
      report.figure(`${place.name}, ${kind}: lost by the worst viewer`, seen.clientsLost, `of ${seen.written}`, {
        exactly: 0,
      });
      report.figure(`${place.name}, ${kind}: viewers sent away`, seen.sentAway, "", { exactly: 0 });
      report.figure(`${place.name}, ${kind}: slowest viewer`, seen.clientFps, "fps", { atLeast: 29.5 });
      report.figure(`${place.name}, ${kind}: age p95`, seen.age, "ms");
      report.figure(`${place.name}, ${kind}: robot's processor`, seen.cores, "cores");
      if (seen.sentAway) console.log(`   ${seen.statuses.slice(0, 3).join("\n   ")}`);
    }
    rows.push([place.name, "", "", pretty(found.normal.clientFps), pretty(found.heavy.clientFps)]);
  }
  console.log(
    "\n" +
      table([
        ["vision stream at 30 Hz [fps]", "thesis normal", "thesis heavy", "ours normal", "ours heavy"],
        ["disk", 29, 29, pretty(Math.min(...disk.normal)), pretty(Math.min(...disk.heavy))],
        ["M_1 (Ethernet)", 29, 26, "", ""],
        ["M_2 (Ethernet)", 29, 22, "", ""],
        ...rows,
      ]),
  );
  console.log("normal: all objects but images; heavy: with raw 640x480 images (JPEG where it says so).");
  return report.finish();
}
