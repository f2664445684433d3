// From a recording through the robot's memory into another recording and out over HTTP: nothing may be lost or changed.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Live } from "./live.mjs";
import { readIndexed, readSession, readStreamed } from "./mcap.mjs";
import {
  download,
  importReal,
  needsData,
  request,
  robot,
  sessionsOf,
  statusOf,
  synthesize,
  temporaryFolder,
} from "./support.mjs";

// foresight-robot writes these objects itself, so those of the recording are left out
const kOwn = ["/14/2/runtime", "/14/2/clock", "/14/2/log"];

/** Plays `session` into a robot that records all of it; returns the running robot and its recording. */
async function recordAgain(t, folder, session) {
  const original = readSession(session);
  for (const topic of kOwn) original.delete(topic);
  const server = await robot(t, folder, session, "--speed", "10", "--record", "--profile", "full");
  const live = await Live.open(t, server);
  await live.subscribe("/14/2/runtime");

  // the robot's own statistics report when its loggers have written all messages
  const written = () => {
    const newest = live.messages.get("/14/2/runtime").at(-1);
    const loggers = new Map(
      newest && live.decoded("/14/2/runtime", newest).loggers.map((logger) => [logger.topic, logger]),
    );
    return [...original].every(([topic, { messages }]) => Number(loggers.get(topic)?.written) >= messages.length);
  };
  await live.until(written, "all messages to be written");
  const { dropped } = (await statusOf(server)).recording;
  assert.equal(dropped, 0);
  const { session: id } = await live.call("stop_recording");
  const [recorded] = (await sessionsOf(server)).filter(({ session }) => session === id);
  return { server, original, recorded };
}

/** Asserts that `messages` are all those of the original, in order, numbered without a gap. */
function assertSame(topic, messages, original) {
  assert.deepEqual(
    messages.map(({ logTime }) => logTime),
    original.map(({ logTime }) => logTime),
    `${topic}: log times`,
  );
  for (const [i, { data, sequence }] of messages.entries()) {
    assert.ok(data.equals(original[i].data), `${topic}: bytes of message ${i}`);
    assert.equal(sequence, messages[0].sequence + i, `${topic}: sequence of message ${i}`);
  }
}

async function checkRoundTrip(t, session, folder) {
  const { server, original, recorded } = await recordAgain(t, folder, session);
  assert.equal(recorded.state, "complete");

  // the whole session as one file, read from front to end and by its index
  const whole = await download(server, recorded.url);
  const streamed = readStreamed(whole);
  const indexed = await readIndexed(whole);
  for (const [topic, { schema, messages }] of original) {
    assertSame(topic, streamed.topics.get(topic).messages, messages);
    // the index gives messages of one time in any order
    assert.deepEqual(
      indexed.get(topic).map(({ logTime }) => logTime),
      messages.map(({ logTime }) => logTime),
    );
    assert.equal(streamed.topics.get(topic).schema.name, schema.name);
  }
  assert.ok(kOwn.slice(0, 2).every((topic) => streamed.topics.get(topic).messages.length > 0));
  const { team, player, robot: name, profile } = streamed.metadata.get("foresight.session");
  assert.deepEqual({ team, player, name, profile }, { team: "14", player: "2", name: "14/2", profile: "full" });

  // each stream alone
  for (const { topic, url, messages } of recorded.streams) {
    const alone = readStreamed(await download(server, url));
    assert.equal(alone.metadata.get("foresight.session").robot, "14/2");
    assert.deepEqual([...alone.topics.keys()], topic === "" ? [] : [topic]);
    assert.equal(alone.topics.get(topic).messages.length, messages);
    if (original.has(topic)) assertSame(topic, alone.topics.get(topic).messages, original.get(topic).messages);
  }

  await checkTimeRange(server, recorded, streamed);
}

/** A range of times holds the chunks that overlap it, whole, and no others. */
async function checkTimeRange(server, recorded, streamed) {
  const start = BigInt(recorded.start_ns);
  const length = BigInt(recorded.end_ns) - start;
  const [from, to] = [start + length / 3n, start + length / 2n];
  const part = readStreamed(await download(server, `${recorded.url}?from=${from}&to=${to}`));
  const overlaps = streamed.chunks.filter((chunk) => chunk.end >= from && chunk.start <= to);
  assert.ok(overlaps.length > 0 && overlaps.length < streamed.chunks.length);
  assert.deepEqual(part.chunks, overlaps);
  const inside = ({ logTime }) => logTime >= from && logTime <= to;
  for (const [topic, { messages }] of streamed.topics)
    assert.deepEqual(part.topics.get(topic).messages.filter(inside), messages.filter(inside), topic);

  assert.ok((await request(server, `${recorded.url}?from=yesterday`)).status >= 400);
  const nothing = readStreamed(await download(server, `${recorded.url}?from=${BigInt(recorded.end_ns) + 1n}`));
  assert.ok([...nothing.topics.values()].every(({ messages }) => messages.length === 0));
}

test("a synthetic recording survives memory, recorder and download", async (t) => {
  const folder = temporaryFolder(t);
  await checkRoundTrip(t, await synthesize(folder, { seconds: 8 }), folder);
});

test("a real recording survives memory, recorder and download", needsData, async (t) => {
  const folder = temporaryFolder(t);
  await checkRoundTrip(t, await importReal(folder), folder);
});
