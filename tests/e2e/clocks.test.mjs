// Recordings of machines whose clocks are off by a known time, side by side.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Live } from "./live.mjs";
import { mcapOf } from "./mcap.mjs";
import { play, require, run, temporaryFolder } from "./support.mjs";

const { create, createFileRegistry, fromJson, toBinary } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = require("@bufbuild/protobuf/wkt");

const kStart = 1_700_000_000_000_000_000n,
  kMs = 1_000_000n;

/** Clock samples, with the fields that matter, and a message of an unknown type. */
function kSchemas() {
  const [kDouble, kInt64, kUint64, kString, kEnum] = [1, 3, 4, 9, 14];
  const field = (name, number, type, typeName) => ({ name, number, type, typeName, jsonName: name, label: 1 });
  const source = {
    name: "Source",
    value: ["SOURCE_UNSPECIFIED", "SOURCE_SYSTEM", "SOURCE_PEER"].map((name, number) => ({ name, number })),
  };
  const sample = {
    name: "ClockSample",
    enumType: [source],
    field: [
      field("source", 1, kEnum, ".foresight.ClockSample.Source"),
      field("offset_ns", 4, kInt64),
      field("peer", 6, kString),
      field("round_trip_ns", 7, kUint64),
    ],
  };
  const ball = { name: "Ball", field: [field("seen_ns", 1, kUint64), field("x", 2, kDouble)] };
  const file = (name, message) => ({ name: `${name}.proto`, package: name, syntax: "proto3", messageType: [message] });
  return create(FileDescriptorSetSchema, { file: [file("foresight", sample), file("theirs", ball)] });
}

/**
 * Two recordings of the same three seconds: the ball at the same places, and clock samples with a machine of the lab. The
 * clock of 14/3 is 350 ms ahead of that of 14/2, within the round trips.
 */
async function twoRecordings(t) {
  const folder = temporaryFolder(t);
  const set = kSchemas();
  const encoder = (name) => {
    const schema = createFileRegistry(set).getMessage(name);
    return {
      schema: { name, encoding: "protobuf", data: toBinary(FileDescriptorSetSchema, set) },
      encode: (json) => toBinary(schema, fromJson(schema, json)),
    };
  };
  const [clock, ball] = [encoder("foresight.ClockSample"), encoder("theirs.Ball")];
  const write = async (player, ahead, samples) => {
    const topic = (object) => `/14/${player}/${object}`;
    const messages = [];
    for (let i = 0n; i < 90n; ++i)
      messages.push({
        topic: topic("spot"),
        logTime: kStart + (ahead + 33n * i) * kMs,
        data: ball.encode({ seen_ns: String(kStart + (ahead + 33n * i) * kMs), x: Number(i) }),
      });
    for (const [i, { offset_ms, round_trip_ms, peer = "10.0.14.7:50001" }] of samples.entries())
      messages.push({
        topic: topic("clock"),
        logTime: kStart + (ahead + BigInt(i)) * kMs,
        data: clock.encode({
          source: "SOURCE_PEER",
          peer,
          offset_ns: String(offset_ms * 1e6),
          round_trip_ns: String(round_trip_ms * 1e6),
        }),
      });
    messages.sort((a, b) => Number(a.logTime - b.logTime));
    const file = join(folder, `${player}.mcap`);
    const channels = [
      ["spot", ball],
      ["clock", clock],
    ].map(([object, { schema }]) => ({ topic: topic(object), encoding: "protobuf", schema }));
    writeFileSync(file, await mcapOf(channels, messages));
    return file;
  };
  const first = await write(2, 0n, [
    { offset_ms: 80, round_trip_ms: 160 },
    { offset_ms: 1, round_trip_ms: 2 },
  ]);
  const second = await write(3, 350n, [
    { offset_ms: -349, round_trip_ms: 2 },
    { offset_ms: -300, round_trip_ms: 120 },
    { offset_ms: 5, round_trip_ms: 0.1, peer: "127.0.0.1:7" },
  ]);
  return { folder, first, second };
}

const kSentence = "14/3's clock is 0.350 s ahead (± 2.0 ms) of 14/2's, by 10.0.14.7: its times are shifted";

test("a session whose clock was off is played in the time of the first, and a sentence reports it", async (t) => {
  const { folder, first, second } = await twoRecordings(t);
  const server = await play(t, folder, first, second, "--speed", "1000");
  assert.ok(server.output.split("\n").includes(kSentence), server.output);
  const live = await Live.open(t, server, { path: "/?delivery=lossless" });
  await live.until(() => live.channels.has("/14/2/spot") && live.channels.has("/14/3/spot"), "both");
  const span = ({ sec, nsec }) => BigInt(sec) * 1_000_000_000n + BigInt(nsec);
  assert.equal(span(live.infos[0].dataStartTime), kStart);
  assert.equal(span(live.infos[0].dataEndTime), kStart + 89n * 33n * kMs);
  await live.subscribe("/14/2/spot", "/14/3/spot");
  const [two, three] = await Promise.all(
    ["/14/2/spot", "/14/3/spot"].map((topic) =>
      live.until(
        () => live.messages.get(topic).find(({ log_ns }) => log_ns === kStart + 89n * 33n * kMs),
        `the last of ${topic}`,
      ),
    ),
  );
  assert.equal(two.log_ns, three.log_ns);
  assert.deepEqual(
    live.decoded("/14/3/spot", three),
    { seen_ns: String(three.log_ns), x: 89 },
    "times within messages are shifted, too",
  );
});

test("info reports the clock offsets; both commands refuse a larger offset than allowed, and name it", async (t) => {
  const { first, second } = await twoRecordings(t);
  const told = await run("foresight-lab", "info", first, second);
  assert.equal(told.status, 0);
  assert.ok(told.stdout.trim().endsWith(kSentence), told.stdout);
  assert.match(told.stdout, /clock    10\.0\.14\.7 is 0\.349 s behind \(± 1\.0 ms\) of that of 14\/3/);
  const refusal =
    "14/3's clock is 0.350 s ahead (± 2.0 ms), more than the 0.1 s of --max-clock-offset: set the clock right, or allow more";
  for (const [command, ...options] of [["info"], ["play", "--port", "0"]]) {
    const { status, stderr } = await run(
      "foresight-lab",
      command,
      first,
      second,
      "--max-clock-offset",
      "0.1",
      ...options,
    );
    assert.equal(status, 2);
    assert.ok(stderr.trim().endsWith(refusal), stderr);
  }
  const { status, stderr } = await run(
    "foresight-lab",
    "play",
    first,
    second,
    "--max-clock-offset",
    "-1",
    "--port",
    "0",
  );
  assert.equal(status, 2);
  assert.match(stderr, /--max-clock-offset: expected 0 \.\. 1e9 \[s\], got -1/);
});
