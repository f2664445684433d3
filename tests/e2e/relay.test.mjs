// Live robots through a machine of the lab: their channels at the relay, and the relay's recording.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import net from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { foxgloveClient } from "./foxglove.mjs";
import { decode, Live } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { download, robot, run, sessionsOf, start, statusOf, synthesize, temporaryFolder, until } from "./support.mjs";

const simulated = (t, player, ...args) =>
  start(
    t,
    temporaryFolder(t),
    "foresight-robot",
    "--body",
    "sim",
    "--team",
    "14",
    "--player",
    String(player),
    "--no-foresight",
    ...args,
  );

/** foresight-lab relay of `robots`, each a server or a word; sessions go to a folder of its own. */
function relay(t, robots, ...args) {
  const folder = temporaryFolder(t);
  const words = robots.map((one) => (typeof one === "string" ? one : `127.0.0.1:${one.port}`));
  return start(t, folder, "foresight-lab", "relay", ...words, "--log-dir", join(folder, "logs"), ...args);
}

/** A port of this machine on which nobody listens. */
async function freePort() {
  const server = net.createServer();
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  const { port } = server.address();
  await new Promise((closed) => server.close(closed));
  return port;
}

/** All that a server recorded, by topic, once recording has ended. */
async function recordedBy(server, live) {
  const { ok, session } = await live.call("stop_recording");
  assert.equal(ok, true);
  const entry = (await sessionsOf(server)).find((one) => one.session === session);
  return { entry, topics: readStreamed(await download(server, entry.url)).topics };
}

const newestLink = (live, name) => {
  const message = live.messages.get("/lab/1/runtime")?.at(-1);
  return message && live.decoded("/lab/1/runtime", message).links.find((link) => link.robot === name);
};

test("two robots, each over one connection: viewers see all of both, and the relay records bit for bit the same as the robots", async (t) => {
  const robots = [await simulated(t, 2, "--seed", "7", "--record"), await simulated(t, 3, "--seed", "8", "--record")];
  const lab = await relay(t, robots, "--record", "--lossless");
  const live = await Live.open(t, lab);
  await live.until(
    () =>
      live.channels.has("/14/2/decision") && live.channels.has("/14/3/decision") && live.channels.has("/truth/world"),
    "the channels of both",
  );

  // the Foxglove client, which knows nothing of relays
  const { client } = foxgloveClient(t, lab);
  const channels = new Map(),
    messages = [];
  client.on("advertise", (list) => list.forEach((channel) => channels.set(channel.topic, channel)));
  client.on("message", ({ subscriptionId, timestamp, data }) =>
    messages.push({ subscriptionId, timestamp, data: Buffer.from(data.buffer, data.byteOffset, data.byteLength) }),
  );
  await until(
    () => channels.has("/14/2/decision") && channels.has("/14/3/decision"),
    "the channels of the Foxglove client",
  );
  const wanted = new Map(
    ["/14/2/decision", "/14/3/decision", "/truth/world"].map((topic) => [
      client.subscribe(channels.get(topic).id),
      topic,
    ]),
  );
  await until(
    () => [...wanted.keys()].every((id) => messages.filter(({ subscriptionId }) => subscriptionId === id).length > 60),
    "two seconds of them",
  );
  for (const { subscriptionId, data } of messages) {
    const { topic, schemaName, schema } = channels.get(wanted.get(subscriptionId));
    const fields = decode(schemaName, Buffer.from(schema, "base64"), data);
    if (topic !== "/truth/world") assert.equal(fields.strategy, "baseline");
  }

  // the same channels, as each robot offers its own
  for (const [index, server] of robots.entries()) {
    const direct = await Live.open(t, server);
    const own = [...direct.channels.values()].filter(({ topic }) => topic.startsWith(`/14/${index + 2}/`));
    assert.ok(own.length > 10, `${own.length} channels of its own`);
    for (const { topic, encoding, schemaName, schema, schemaEncoding, metadata } of own) {
      const there = live.channels.get(topic);
      assert.deepEqual(
        [there.encoding, there.schemaName, there.schema, there.schemaEncoding, there.metadata],
        [encoding, schemaName, schema, schemaEncoding, metadata],
        topic,
      );
    }
    direct.socket.terminate();
    await until(async () => (await statusOf(server)).clients === 1, "the relay as the robot's only client");
  }

  await live.subscribe("/lab/1/runtime");
  const links = await live.until(
    () => newestLink(live, "14/2") && newestLink(live, "14/3") && [newestLink(live, "14/2"), newestLink(live, "14/3")],
    "statistics",
  );
  for (const link of links) {
    assert.deepEqual(
      [link.state, link.connections, link.lost, link.message, link.shift_ns],
      ["STATE_CONNECTED", 1, "0", "", "0"],
    );
    assert.ok(Math.abs(Number(link.clock_offset_ns)) <= Number(link.clock_error_ns) + 1e7, "two clocks of one machine");
  }

  const mine = await recordedBy(lab, live);
  assert.equal(mine.entry.state, "complete");
  assert.equal(mine.entry.robot, "14/2");
  for (const [index, server] of robots.entries()) {
    const { topics } = await recordedBy(server, await Live.open(t, server));
    let compared = 0;
    for (const [topic, { schema, messages }] of topics) {
      if (!topic.startsWith(`/14/${index + 2}/`) || messages.length === 0) continue;
      const relayed = mine.topics.get(topic);
      assert.deepEqual(relayed.schema.data, schema.data, topic);
      const plain = ({ logTime, publishTime, data }) => `${logTime} ${publishTime} ${data.toString("base64")}`;
      const [there, here] = [messages.map(plain), relayed.messages.map(plain)];
      const begin = there.indexOf(here[0]);
      assert.ok(begin >= 0, `${topic}: the first relayed message is one of the robot's`);
      const length = Math.min(here.length, there.length - begin);
      assert.deepEqual(here.slice(0, length), there.slice(begin, begin + length), topic);
      // numbered without a gap, as on the robot
      assert.ok(
        relayed.messages.every(({ sequence }, i) => sequence === relayed.messages[0].sequence + i),
        topic,
      );
      compared += length;
    }
    assert.ok(compared > 100, `${compared} messages were compared`);
  }
  const { stdout } = await run("foresight-lab", "info", join(lab.folder, "logs", mine.entry.session), "--json");
  assert.ok(JSON.parse(stdout).streams.every(({ missing }) => missing === 0));
});

test("the relay's page and recording have the rules of the robot's game, also of a robot that starts later", async (t) => {
  const port = String(await freePort());
  const lab = await relay(t, [`127.0.0.1:${port}`], "--record");
  const live = await Live.open(t, lab);
  assert.equal(live.infos[0].metadata.rules, undefined);
  await simulated(t, 2, "--rules", "spl2025:4", "--port", port);
  await live.until(() => live.infos.at(-1).metadata.rules === "spl2025:4", "the rules of the robot");
  await live.until(() => live.channels.has("/14/2/ball"), "its channels");
  const { page, problems } = await open(t, `${lab.http}/#/14/2/field`);
  await page.getByRole("region", { name: "Field" }).waitFor();
  assert.equal(await page.getByLabel("Size of the field").count(), 0, "nobody is asked for the field");
  const { entry } = await recordedBy(lab, live);
  const { rules } = JSON.parse(readFileSync(join(lab.folder, "logs", entry.session, "session.json"), "utf8"));
  assert.equal(rules, "spl2025:4");
  const file = readFileSync(join(lab.folder, "logs", entry.session, "14.2.ball.mcap"));
  assert.ok(file.includes("spl2025:4"), "the file of an object names them too");
  assert.deepEqual(problems, []);
});

test("the relay and its page show a robot again that was killed and started again", async (t) => {
  const first = await simulated(t, 2, "--seed", "7");
  const lab = await relay(t, [first]);
  const { page, problems } = await open(t, `${lab.http}/#/14/2/field`);
  await page.getByRole("region", { name: "Field" }).waitFor();
  await page.evaluate(() => (window.loadedOnce = true));
  const live = await Live.open(t, lab);
  await live.until(() => live.channels.has("/sim/state"), "the channels");
  await live.subscribe("/sim/state", "/lab/1/runtime");
  const seeds = () =>
    live.messages
      .get("/sim/state")
      .slice(-1)
      .map((message) => live.decoded("/sim/state", message).seed);
  await live.until(() => seeds()[0] === "7", "the first game");

  first.kill("SIGKILL");
  await first.ended;
  await live.until(
    () => newestLink(live, "14/2")?.state === "STATE_CONNECTING" && newestLink(live, "14/2").message !== "",
    "that it is gone, and why",
  );
  const again = await simulated(t, 2, "--seed", "99", "--port", String(first.port));
  const since = performance.now();
  await live.until(() => seeds()[0] === "99", "the game of the robot that came back");
  t.diagnostic(`data resumed ${((performance.now() - since) / 1000).toFixed(2)} s after the robot served again`);
  await page.getByText(/seed 99/).waitFor();
  assert.equal(await page.evaluate(() => window.loadedOnce), true);
  await live.until(() => newestLink(live, "14/2")?.connections === 2, "two connections");
  await shoot(page, "relay-field");

  // Health shows the link's state, and the reason when it ends
  await page.goto(`${lab.http}/#/14/2/health`);
  const links = page.getByRole("region", { name: "Relayed robots" });
  await links.getByRole("row", { name: /^14\/2 127\.0\.0\.1:\d+ / }).waitFor();
  await again.stop();
  await links.getByText(/it ended the connection: the server stops|Connection refused/).waitFor();
  await shoot(page, "relay-health");
  assert.deepEqual(problems, []);
});

test("pictures come over the relay as JPEG under the robot's own topic, and the relay offers all their derived streams", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder, { seconds: 2 }), "--loop");
  const lab = await relay(t, [server], "--max-clock-offset", "1e9");
  const live = await Live.open(t, lab);
  const topics = ["/14/2/camera_top", "/14/2/camera_top/jpeg", "/14/2/camera_top/raw"];
  await live.until(() => topics.every((topic) => live.channels.has(topic)), "the pictures");
  await live.subscribe(...topics);
  const [own, jpeg, raw] = await Promise.all(
    topics.map(async (topic) => live.decoded(topic, await live.newest(topic))),
  );
  assert.deepEqual([own.encoding, own.width, own.height], ["ENCODING_JPEG", 320, 240]);
  assert.equal(jpeg.format, "jpeg");
  assert.equal(Buffer.from(raw.data, "base64").length, 2 * 320 * 240);
  const { page, problems } = await open(t, `${lab.http}/#/14/2/camera`);
  await page
    .getByText(/320 × 240/)
    .first()
    .waitFor();
  await shoot(page, "relay-camera");
  assert.deepEqual(problems, []);
});

test("robots are found by their names in the robots file", async (t) => {
  const server = await simulated(t, 2);
  const file = join(temporaryFolder(t), "robots.json");
  writeFileSync(
    file,
    JSON.stringify({
      team: 14,
      robots: [{ name: "tim", address: "127.0.0.1", http_port: server.port, model: "nao-v6", player: 2 }],
    }),
  );
  const live = await Live.open(t, await relay(t, ["tim"], "--robots", file));
  await live.until(() => live.channels.has("/14/2/decision"), "the channels of tim");
  const { status, stderr } = await run("foresight-lab", "relay", "tom", "--robots", file, "--port", "0");
  assert.equal(status, 2);
  assert.equal(
    stderr.trim(),
    `foresight-lab: relay: expected an address such as 10.0.14.22:8765, or one of tim (${file}), got 'tom'`,
  );
});

test("an impossible relay gives one sentence and status 2", async (t) => {
  const folder = temporaryFolder(t);
  const refused = async (...args) => {
    const { status, stderr } = await run("foresight-lab", "relay", "--port", "0", "--state-dir", folder, ...args);
    assert.equal(status, 2, args.join(" "));
    return stderr.trim();
  };
  assert.match(
    await refused("10.0.14.22:port"),
    /^foresight-lab: relay: expected an address such as 10\.0\.14\.22:8765, got '10\.0\.14\.22:port'$/,
  );
  assert.match(await refused("127.0.0.1:1", "127.0.0.1:1"), /expected each robot once, got 127\.0\.0\.1:1 twice$/);
  assert.match(
    await refused("127.0.0.1:1", "--max-clock-offset", "-1"),
    /--max-clock-offset: expected 0 \.\. 1e9 \[s\], got -1/,
  );
  assert.match(await refused("127.0.0.1:1", "--pictures", "painted"), /pictures/);
  assert.match(await refused(), /robots is required/);
});
