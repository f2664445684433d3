// A client that only writes plain frames pauses, seeks and speeds up recordings.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Live, playbackControl } from "./live.mjs";
import { readSession } from "./mcap.mjs";
import { play, run, synthesize, temporaryFolder } from "./support.mjs";

const kPlaying = 0,
  kPaused = 1,
  kEnded = 3;

const stateOf = (bytes) => ({
  status: bytes[1],
  time_ns: bytes.readBigUInt64LE(2),
  speed: bytes.readFloatLE(10),
  didSeek: bytes[14] === 1,
  id: bytes.subarray(19).toString(),
});

/** Connects and keeps the reported states of the playback; `ask` resolves with the answer. */
async function viewer(t, server) {
  const states = [];
  const live = await Live.open(t, server, { path: "/?playback" });
  live.onFrame = (bytes) => {
    if (bytes[0] === 5) states.push(stateOf(bytes));
  };
  let asked = 0;
  const ask = async (wish) => {
    const id = `r${++asked}`;
    live.send(playbackControl({ ...wish, id }));
    await live.until(
      () => states.some((state) => state.id === id),
      `the answer to ${JSON.stringify(wish, (_, v) => String(v))}`,
    );
    return states.find((state) => state.id === id);
  };
  return { live, states, ask };
}

/** Two robots of different lengths, played in one time base: {server, recorded: topic -> messages, start_ns, end_ns}. */
async function twoRobots(t, ...options) {
  const folder = temporaryFolder(t);
  const first = await synthesize(folder, { name: "first", seconds: 2 });
  const second = `${folder}/second`;
  const { status, stderr } = await run("foresight-lab", "synthesize", second, "--seconds", "1.5", "--robot", "14/3");
  assert.equal(status, 0, stderr);
  const recorded = new Map();
  for (const session of [second, first])
    for (const [topic, { messages }] of readSession(session)) recorded.set(topic, messages);
  const server = await play(t, folder, first, second, ...options);
  const times = [...recorded.values()].flat().map(({ logTime }) => logTime);
  const least = (a, b) => (a < b ? a : b),
    most = (a, b) => (a > b ? a : b);
  return { server, recorded, start_ns: times.reduce(least), end_ns: times.reduce(most) };
}

test("after a seek in a paused recording, every object of every robot has its value of that moment", async (t) => {
  const { server, recorded, start_ns, end_ns } = await twoRobots(t);
  const { live, ask } = await viewer(t, server);
  assert.ok(live.infos[0].capabilities.includes("playbackControl"));
  const span = ({ sec, nsec }) => BigInt(sec) * 1_000_000_000n + BigInt(nsec);
  assert.equal(span(live.infos[0].dataStartTime), start_ns);
  assert.equal(span(live.infos[0].dataEndTime), end_ns);
  assert.ok(recorded.has("/14/2/ball") || recorded.has("/14/2/vision"));
  assert.ok([...recorded.keys()].some((topic) => topic.startsWith("/14/3/")));

  await ask({ play: false });
  // images would cost time and prove nothing more
  const topics = [...recorded.keys()].filter((topic) => !/camera_(top|bottom)$/.test(topic));
  await live.subscribe(...topics);
  let random = 1;
  for (let probe = 0; probe < 60; ++probe) {
    random = (random * 48271) % 2147483647;
    const to_ns = start_ns + (BigInt(random) * (end_ns - start_ns)) / 2147483647n;
    for (const topic of topics) live.messages.get(topic).length = 0;
    const state = await ask({ play: false, to_ns });
    assert.deepEqual([state.status, state.time_ns, state.didSeek], [kPaused, to_ns, true]);
    for (const topic of topics) {
      const expected = recorded.get(topic).findLast(({ logTime }) => logTime <= to_ns);
      if (!expected) continue; // it has no value yet
      const newest = () => live.messages.get(topic).at(-1);
      await live.until(() => newest()?.log_ns === expected.logTime, `${topic} at ${to_ns}`);
      assert.deepEqual(newest().data, expected.data, topic);
    }
  }
});

test("a recording plays from a seek to its end, and again on request", async (t) => {
  const { server, start_ns, end_ns } = await twoRobots(t);
  const { live, states, ask } = await viewer(t, server);
  const other = await viewer(t, server);
  assert.equal((await ask({ play: false, to_ns: end_ns - 100_000_000n })).status, kPaused);
  const told = await other.live.until(
    () => other.states.find(({ didSeek }) => didSeek),
    "the state at the other viewer",
  );
  assert.deepEqual(told, { status: kPaused, time_ns: end_ns - 100_000_000n, speed: 1, didSeek: true, id: "" });

  const playing = await ask({ play: true, speed: 0.0625 }); // a busy machine answers before the end, too
  assert.deepEqual([playing.status, playing.speed, playing.didSeek], [kPlaying, 0.0625, false]);
  await live.until(() => states.at(-1).status === kEnded, "the end");
  await live.until(() => live.times.at(-1) === end_ns, "the time of the end");

  const again = await ask({ play: true, speed: 1 });
  assert.deepEqual([again.status, again.didSeek], [kPlaying, true]);
  assert.ok(again.time_ns < start_ns + 1_000_000_000n);
});

test("an impossible request is refused with a sentence", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 1 });
  const { live } = await viewer(t, await play(t, folder, session));
  live.send(playbackControl({ play: true, speed: 0, id: "slow" }));
  await live.until(
    () => live.statuses.some(({ message }) => message.startsWith("playback: expected a speed of 0.01 .. 1000, got 0")),
    "a refusal",
  );
  const { status, stderr } = await run("foresight-lab", "play", session, session);
  assert.equal(status, 2);
  assert.match(stderr, /expected recordings of different robots, .* has no topic beyond those before it/);
});
