// MCAP files of any writer: what @mcap/core reads, we read, in the same order; or a sentence says what is left out.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Live } from "./live.mjs";
import { difference, mcapOf } from "./mcap.mjs";
import { atEnd, bin, play, run, temporaryFolder, until, within } from "./support.mjs";

const kFiles = 300;
const kEndMs = 1000 + 2000; // the promise, and room for a busy machine
const kStart = 1_764_000_000_000_000_000n; // [ns]

test(`${kFiles} generated files are read as @mcap/core reads them`, async (t) => {
  const folder = temporaryFolder(t);
  const written = await run("mcap_files", "write", folder, "0", String(kFiles));
  assert.equal(written.status, 0, written.stderr);
  const read = await run("mcap_files", "read", folder, "0", String(kFiles));
  assert.equal(read.status, 0, read.stderr);
  const rows = read.stdout
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));
  assert.equal(rows.length, kFiles);
  for (const [seed, row] of rows.entries())
    assert.equal(
      difference(row, readFileSync(join(folder, `${seed}.mcap`))),
      undefined,
      `seed ${seed}: ${row.features}`,
    );
  // the files are not all alike
  assert(rows.filter(({ left_out }) => left_out > 0).length > 10);
  assert(rows.filter(({ valid, messages }) => valid && messages > 20).length > kFiles / 2);
});

/** A file whose topic /a has two schemas, and a message at time 0. */
async function twins(folder) {
  const schema = (name) => ({ name, encoding: "jsonschema", data: Buffer.from("{}") });
  const channels = ["Old", "New"].map((name) => ({ topic: `/${name}`, encoding: "json", schema: schema(name) }));
  const message = (topic, i) => ({
    topic,
    logTime: i === 0n ? 0n : kStart + i * 10_000_000n,
    data: Buffer.from(`{"i": ${i}}`),
  });
  const messages = [
    message("/Old", 0n),
    message("/Old", 1n),
    ...Array.from({ length: 100 }, (_, i) => message("/New", BigInt(i + 1))),
  ];
  const file = join(folder, "twins.mcap");
  // the topics get one name, of the same length
  const bytes = await mcapOf(channels, messages, { useChunks: false, useSummaryOffsets: false });
  writeFileSync(file, Buffer.from(bytes.toString("latin1").replaceAll("/Old", "/New"), "latin1"));
  return file;
}

const kLeftOut =
  /\/New: 2 messages of channel 0 left out: expected json of schema "New" \(jsonschema, 2 bytes\) as in channel 1, got json of schema "Old" \(jsonschema, 2 bytes\)/;
const kStray = /1 message before 2025-11-24 16:00:00 UTC left out of the strip/;

test("info and play say which messages they leave out, and why", async (t) => {
  const folder = temporaryFolder(t);
  const file = await twins(folder);
  const { status, stdout } = await run("foresight-lab", "info", file);
  assert.equal(status, 0);
  assert.match(stdout, kLeftOut);
  assert.match(stdout, kStray);
  assert.match(stdout, /^time .* 1\.0 s$/m);
  const server = await play(t, folder, file, "--speed", "1000");
  assert.match(server.output, kLeftOut);
  assert.match(server.output, kStray);
  const live = await Live.open(t, server, { path: "/?delivery=lossless" });
  await live.until(() => live.channels.has("/New"), "the topic");
  assert.equal(live.channels.get("/New").schemaName, "New");
});

test("a recording of 10 GB is served and ends at once", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "huge.mcap");
  assert.equal((await run("mcap_files", "huge", file)).status, 0);
  const server = await play(t, folder, file);
  const live = await Live.open(t, server, { path: "/?delivery=lossless" });
  await live.until(() => live.channels.has("/many/0"), "the topic");
  await live.subscribe("/many/0");
  assert.equal((await live.newest("/many/0")).log_ns, kStart);
  const began = performance.now();
  server.kill("SIGTERM");
  assert.equal((await within(server.ended, "the end")).status, 0);
  assert(performance.now() - began < kEndMs, `it ended after ${performance.now() - began} ms`);
});

test("SIGTERM ends play while it reads a file that takes a minute", async (t) => {
  const file = join(temporaryFolder(t), "slow.mcap");
  assert.equal((await run("mcap_files", "slow", file)).status, 0);
  const child = spawn(join(bin, "foresight-lab"), ["play", file, "--port", "0"]);
  atEnd(t, () => child.kill("SIGKILL"));
  const ended = new Promise((resolve) => child.on("close", (status, signal) => resolve({ status, signal })));
  // it reads: its memory holds an unpacked chunk
  await until(
    () => Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${child.pid}/status`, "utf8"))?.[1]) > 60_000,
    "an unpacked chunk",
  );
  const began = performance.now();
  child.kill("SIGTERM");
  const { status, signal } = await within(ended, "the end");
  assert.deepEqual([status, signal], [null, "SIGTERM"]);
  assert(performance.now() - began < kEndMs, `it ended after ${performance.now() - began} ms`);
});
