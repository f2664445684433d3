// Is any MCAP file read as @mcap/core reads it, and at what cost?
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { Live } from "../e2e/live.mjs";
import { difference } from "../e2e/mcap.mjs";
import { require } from "../e2e/support.mjs";
import { cases, scratch, start } from "./programs.mjs";
import { median, Report } from "./report.mjs";

const WebSocket = require("ws");

const kBatch = 500; // files on the disk at one time
const kRuns = 5;
const kLargestChunkMB = 1.1; // unpacked, of the file with many topics
const kManyEndNs = 1_764_000_059_900_000_000n; // of its last message of /many/0

/** Reads `count` generated files with both readers. */
async function compare(report, count) {
  const differences = [];
  let [messages, leftOut] = [0, 0];
  for (let first = 0; first < count; first += kBatch) {
    const folder = join(scratch, `files${first}`);
    const size = Math.min(kBatch, count - first);
    mkdirSync(folder);
    await start("mcap_files", ["write", folder, first, size]).output;
    const rows = await cases("mcap_files", ["read", folder, first, size]);
    for (const [i, row] of rows.entries()) {
      const found = difference(row, readFileSync(join(folder, `${first + i}.mcap`)));
      if (found) differences.push(`seed ${first + i}: ${found} (${row.features})`);
      messages += row.messages ?? 0;
      leftOut += row.left_out ?? 0;
    }
    rmSync(folder, { recursive: true });
  }
  for (const found of differences.slice(0, 10)) console.log(`   ${found}`);
  report.figure("generated files", count);
  report.figure("messages in them", messages);
  report.figure("messages of a topic's other channels, left out with a sentence", leftOut);
  report.figure("files that @mcap/core reads in another way", differences.length, "", { exactly: 0 });
}

/** Returns the greatest resident memory of a process up to now [MB]. */
const peakMB = (pid) => Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1024;

const served = ["--port", 0, "--state-dir", join(scratch, "state")];

/** Plays `file` until a client has the first message of /many/0, and on until `untilNs`. Returns seconds and MB. */
async function playOnce(file, untilNs = 0n) {
  const began = performance.now();
  const lab = start("foresight-lab", ["play", file, "--speed", untilNs > 0n ? 20 : 1, ...served]);
  const address = await lab.address;
  const ready = (performance.now() - began) / 1000;
  const live = new Live(new WebSocket(`ws://${new URL(address).host}/`, ["foxglove.websocket.v1"]));
  await live.until(() => live.channels.has("/many/0"), "the topic");
  await live.subscribe("/many/0");
  await live.newest("/many/0");
  const shown = (performance.now() - began) / 1000;
  await live.until(() => live.messages.get("/many/0").at(-1).log_ns >= untilNs, "the last messages");
  const memory = peakMB(lab.pid);
  live.socket.terminate();
  const ends = performance.now();
  lab.stop();
  await lab.output;
  return { ready, shown, memory, end: (performance.now() - ends) / 1000 };
}

async function times(action) {
  const all = [];
  for (let i = 0; i < kRuns; ++i) all.push(await action());
  return all;
}

const middle = (all, key) => median(all.map((one) => one[key]));

async function costs(report) {
  const many = join(scratch, "many.mcap");
  await start("mcap_files", ["many", many]).output;
  const info = await times(async () => {
    const began = performance.now();
    await start("foresight-lab", ["info", many]).output;
    return { seconds: (performance.now() - began) / 1000 };
  });
  report.figure("60,000 messages in 100 topics, 22 MB: info", middle(info, "seconds"), "s", { atMost: 0.5 });
  const plays = await times(() => playOnce(many, kManyEndNs));
  report.figure("the same: play is ready", middle(plays, "ready"), "s", { atMost: 0.5 });
  report.figure(
    "the same: memory beyond the largest chunk, when all was played",
    middle(plays, "memory") - kLargestChunkMB,
    "MB",
    { atMost: 64 },
  );
  report.figure("the same: until it ends after SIGTERM", middle(plays, "end"), "s", { atMost: 1 });
  rmSync(many);

  const huge = join(scratch, "huge.mcap");
  await start("mcap_files", ["huge", huge]).output;
  const large = await times(() => playOnce(huge));
  report.figure("10 GB with a summary: first message at a client", middle(large, "shown"), "s", { atMost: 1 });
  report.figure("the same: until it ends after SIGTERM", middle(large, "end"), "s", { atMost: 1 });
  rmSync(huge);
}

export async function mcap({ files = 10000 }) {
  const report = new Report("mcap", "is any MCAP file read as @mcap/core reads it, and at what cost?");
  await costs(report);
  await compare(report, files);
  return report.finish();
}
