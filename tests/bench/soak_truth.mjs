// The ground-truth server in use for a long time: it records, viewers come and go, some of them stall, a lossless one stays.
import { join } from "node:path";
import { memoryOf } from "./disk.mjs";
import { command, onlySession, scratch, sleep, start, startClients } from "./programs.mjs";

const kSeats = 4;
let runs = 0;

/** Returns the resident sets [MB] of a process until `ended` is kept. */
async function memoriesOf(pid, every, ended) {
  const memories = [];
  let goes = true;
  ended = ended.finally(() => (goes = false));
  while (goes) {
    memories.push(memoryOf(pid, "VmRSS"));
    await Promise.race([sleep(every), ended]);
  }
  await ended;
  return memories;
}

/** Returns the description of the only session below `logs` by foresight-lab info. */
function sessionIn(logs) {
  const lab = new URL("../../build/release/bin/foresight-lab", import.meta.url).pathname;
  return JSON.parse(command(lab, "info", "--json", onlySession(logs)));
}

/**
 * Runs the server with these sources, about `seconds` long, until the promise of `use()` is kept. There are `connections`
 * connections of viewers, who watch `topics`. Returns what judge() of soak.mjs needs, the counts of recorded messages by
 * topic, and the counts of the viewer that stays.
 */
export async function runTruth({ sources, topics, seconds, connections, use }) {
  const folder = join(scratch, `soak-truth${++runs}`);
  const logs = join(folder, "logs");
  const server = start("foresight-lab", [
    ...["truth", "--port", 0, "--state-dir", folder],
    ...sources.flatMap((source) => ["--source", source]),
    ...["--record", "--log-dir", logs],
  ]);
  const url = `${(await server.address).replace("http", "ws")}/`;
  await sleep(2); // until each source has sent something
  const longest = 10 * seconds; // they are stopped before
  const lifetime = (kSeats * seconds) / connections;
  const coming = ["--clients", kSeats, "--lifetime", lifetime, "--watch", topics.join()];
  const viewers = startClients(url, [...coming, "--seconds", longest]);
  const staying = startClients(`${url}?delivery=lossless`, ["--watch", "/truth/world", "--seconds", longest]);
  const memory_mb = await memoriesOf(server.pid, Math.max(0.5, seconds / 120), use());
  for (const clients of [viewers, staying]) clients.stop();
  const seen = { viewers: await viewers.report, world: (await staying.report).clients[0].topics["/truth/world"] };
  server.stop();
  await server.output;

  const { streams, damages, size_bytes, state } = sessionIn(logs);
  const written = Object.fromEntries(streams.map(({ topic, messages }) => [topic, messages]));
  const dropped = streams.reduce((sum, { missing }) => sum + missing, 0);
  const damaged = damages.length > 0 || state !== "complete" ? 1 : 0;
  const recorded = { sessions: 1, disk_bytes: size_bytes, damaged, dropped };
  return { found: { memory_mb, written, recorded }, written, ...seen };
}
