// How soon does a recording that is moved to another time show everything as it was then?
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { Live } from "../e2e/live.mjs";
import { require } from "../e2e/support.mjs";
import { command, scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";

const WebSocket = require("ws");
const kSpeed = 100; // of the game that is recorded
const kSettled = 0.6; // [s] without any message: all has come
const kSeeks = 60;

const quantile = (values, part) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];

/** The request of playback control that pauses at `to_ns`. */
function pauseAt(to_ns, id) {
  const bytes = Buffer.alloc(19);
  bytes.set([3, 1]);
  bytes.writeFloatLE(1, 2);
  bytes[6] = 1;
  bytes.writeBigUInt64LE(to_ns, 7);
  bytes.writeUInt32LE(id.length, 15);
  return Buffer.concat([bytes, Buffer.from(id)]);
}

/** A whole simulated game of two teams of five, as one session. */
async function recordGame(minutes) {
  const logs = join(scratch, "seek-logs");
  const robot = start("foresight-robot", ["--body", "sim", "--rules", "spl2025", "--speed", kSpeed, "--record", "--profile", "game", "--port", 0,
    "--state-dir", join(scratch, "state"), "--log-dir", logs]);
  await robot.firstLine;
  await sleep((minutes * 60) / kSpeed);
  robot.stop();
  await robot.output;
  return join(logs, readdirSync(logs)[0]);
}

async function watch(session) {
  const began = performance.now();
  const lab = start("foresight-lab", ["play", session, "--port", 0, "--state-dir", join(scratch, "state")]);
  const port = /:(\d+)\/$/.exec((await lab.firstLine).trim())[1];
  const opened_s = (performance.now() - began) / 1000;
  const live = new Live(new WebSocket(`ws://127.0.0.1:${port}/`, ["foxglove.sdk.v1"]));
  await live.until(() => live.infos.length > 0, "introduction of the server");
  await sleep(1);
  return { lab, live, opened_s };
}

export async function seek({ minutes = 20 }) {
  const report = new Report("seek", "how soon does a recording show another time?");
  const session = await recordGame(minutes);
  const { lab, live, opened_s } = await watch(session);
  const size = Number(command("du", "-sb", session).split("\t")[0]);
  const robots = new Set([...live.channels.keys()].map((topic) => /^\/(\d+\/\d+)\//.exec(topic)?.[1]).filter(Boolean));
  const topics = [...live.channels.keys()].filter((topic) => !topic.startsWith("/lab/"));
  live.subscribe(...topics);

  const at = ({ sec, nsec }) => BigInt(sec) * 1_000_000_000n + BigInt(nsec);
  const [start_ns, end_ns] = [at(live.infos[0].dataStartTime), at(live.infos[0].dataEndTime)];
  let last = 0, seen;
  live.onFrame = (bytes) => {
    if (bytes[0] !== 1) return;
    last = performance.now();
    seen.add(bytes.readUInt32LE(1));
  };
  const times_s = [], objects = [];
  for (let i = 0; i < kSeeks; ++i) {
    seen = new Set();
    for (const messages of live.messages.values()) messages.length = 0;
    const asked = performance.now();
    live.send(pauseAt(start_ns + (BigInt(Math.floor(Math.random() * 1e9)) * (end_ns - start_ns)) / 1_000_000_000n, `r${i}`));
    do await sleep(kSettled); while (performance.now() - last < 1000 * kSettled);
    if (i === 0) continue; // it was playing until then
    times_s.push((last - asked) / 1000);
    objects.push(seen.size);
  }
  lab.stop();
  report.figure("robots", robots.size, "", { atLeast: 5 });
  report.figure("length", Number(end_ns - start_ns) / 6e10, "min");
  report.figure("size", size / 1e6, "MB");
  report.figure("from start to an address that answers", opened_s, "s", { atMost: 2 });
  report.figure("objects shown after a seek, at least", Math.min(...objects), `of ${topics.length} topics`);
  report.figure("until all are shown, median", 1000 * quantile(times_s, 0.5), "ms");
  report.figure("until all are shown, p95", 1000 * quantile(times_s, 0.95), "ms", { atMost: 200 });
  return report.finish();
}
