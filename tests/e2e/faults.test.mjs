// Faults around a robot do not harm it: clients that hang, floods, nonsense, and the end of the process.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import net from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { kSubprotocols, Live } from "./live.mjs";
import { readSession } from "./mcap.mjs";
import {
  atEnd,
  play,
  recordedSession,
  request,
  require,
  robot,
  run,
  statusOf,
  synthesize,
  temporaryFolder,
  until,
  within,
} from "./support.mjs";

/** Starts a process that subscribes to everything and is then stopped, like a closed laptop. */
async function hangingViewer(t, server) {
  const code = `
    const WebSocket = require(${JSON.stringify(require.resolve("ws"))});
    const socket = new WebSocket("ws://localhost:${server.port}", ${JSON.stringify(kSubprotocols)});
    socket.on("message", (bytes, isBinary) => {
      if (isBinary && bytes[0] === 1) process.stdout.write("watching\\n");
      const message = isBinary ? {} : JSON.parse(bytes);
      if (message.op === "advertise")
        socket.send(JSON.stringify({ op: "subscribe", subscriptions: message.channels.map(({ id }) => ({ id, channelId: id })) }));
    });`;
  const viewer = spawn(process.execPath, ["-e", code], { stdio: ["ignore", "pipe", "inherit"] });
  atEnd(t, () => viewer.kill("SIGKILL"));
  await within(new Promise((resolve) => viewer.stdout.once("data", resolve)), "the viewer that will hang");
  viewer.kill("SIGSTOP");
  return viewer;
}

/** Asserts that the messages of `topic` are those of the looped recording, without a gap. */
function assertNothingMissing(topic, arrived, recorded) {
  const order = recorded.map(({ logTime }) => logTime);
  let at = order.indexOf(arrived[0].log_ns);
  for (const { log_ns } of arrived) {
    assert.equal(log_ns, order[at], topic);
    at = (at + 1) % order.length;
  }
}

test("a viewer that hangs loses its own messages only", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 2 });
  const server = await play(t, folder, session, "--loop");
  await hangingViewer(t, server);
  const recorded = readSession(session);
  const live = await Live.open(t, server, { path: "/?delivery=lossless" });
  await live.subscribe(...recorded.keys());
  await live.subscribe("/lab/1/runtime");

  // the robot counts the losses of each client
  const losses = () => {
    const newest = live.messages.get("/lab/1/runtime").at(-1);
    const clients = newest ? live.decoded("/lab/1/runtime", newest).clients : [];
    return clients.flatMap(({ lossless, channels }) =>
      channels.map(({ topic, dropped }) => ({ lossless, topic, dropped: Number(dropped) })),
    );
  };
  await live.until(
    () => losses().some(({ lossless, topic, dropped }) => !lossless && topic === "/14/2/camera_top" && dropped > 20),
    "dropped pictures",
  );
  assert.ok(losses().every(({ lossless, dropped }) => !lossless || dropped === 0));
  for (const [topic, { messages }] of recorded) {
    await live.until(() => live.messages.get(topic).length > messages.length, `more than a pass of ${topic}`);
    assertNothingMissing(topic, live.messages.get(topic), messages);
  }
});

const residentBytes = (pid) =>
  1024 * Number(/^VmRSS:\s+(\d+) kB$/m.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]);

test("a thousand silent connections cost less than 20 MB and keep no client out", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 1 }), "--speed", "1000");
  const live = await Live.open(t, server);
  await request(server, "/");
  const before = residentBytes(server.pid);

  const sockets = [];
  atEnd(t, () => sockets.forEach((socket) => socket.destroy()));
  const connect = (begin) =>
    new Promise((resolve) => {
      const socket = net.connect(server.port, "127.0.0.1", () => resolve(socket.write(begin)));
      socket.on("error", resolve); // a refusal is allowed
      sockets.push(socket);
    });
  const begins = ["", "G", "GET / HTTP/1.1\r\nHost: ", "GET / HTTP/1.1\r\nX: " + "x".repeat(4000)];
  for (let i = 0; i < 1000; i += 50)
    await within(Promise.all(Array.from({ length: 50 }, (_, j) => connect(begins[j % 4]))), "connections");

  for (let i = 0; i < 5; ++i) assert.equal((await request(server, "/api/status")).status, 200);
  await Live.open(t, server);
  const grown = residentBytes(server.pid) - before;
  assert.ok(grown < 20e6, `grew by ${grown / 1e6} MB`);
  assert.ok(readdirSync(`/proc/${server.pid}/fd`).length < 400, "the oldest connections are closed");
  await live.subscribe("/14/2/pose"); // an earlier client is still served
  await live.newest("/14/2/pose");
});

/** Upgrades by hand, then sends `bytes`; returns the code and reason of the close frame. */
function closeAfter(server, bytes) {
  const socket = net.connect(server.port, "127.0.0.1");
  const head = `GET / HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${Buffer.alloc(16).toString("base64")}\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n`;
  socket.write(Buffer.concat([Buffer.from(head), bytes]));
  let all = Buffer.alloc(0);
  socket.on("data", (piece) => (all = Buffer.concat([all, piece])));
  const closed = new Promise((resolve, reject) => socket.on("error", reject).on("close", resolve));
  return within(closed, "the close").then(() => {
    // frames of the server are not masked: skip them up to the one that closes
    for (let at = all.indexOf("\r\n\r\n") + 4; at < all.length;) {
      const short = all[at + 1];
      const head_size = short === 127 ? 10 : short === 126 ? 4 : 2;
      const size =
        short === 127 ? Number(all.readBigUInt64BE(at + 2)) : short === 126 ? all.readUInt16BE(at + 2) : short;
      const payload = all.subarray(at + head_size, at + head_size + size);
      if (all[at] === 0x88) return { code: payload.readUInt16BE(0), reason: payload.subarray(2).toString() };
      at += head_size + size;
    }
    return assert.fail("closed without a close frame");
  });
}

test("a frame that is too large or breaks the protocol ends its own connection with a close code", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 1 }), "--speed", "1000");
  const [witness, sender] = [await Live.open(t, server), await Live.open(t, server)];

  sender.send(Buffer.alloc(1 << 20)); // the largest allowed size is answered
  await sender.until(() => sender.statuses.length > 0, "an answer");
  sender.send(Buffer.alloc((1 << 20) + 1));
  await sender.until(() => sender.closed, "the close");
  assert.equal(sender.closed.code, 1009);
  assert.match(sender.closed.reason, /expected at most 1048576/);

  const huge = Buffer.from([0x82, 0xff, 0, 0, 0x7f, 0, 0, 0, 0, 0, 1, 2, 3, 4]); // announces 139 TB
  assert.equal((await closeAfter(server, huge)).code, 1009);
  assert.equal((await closeAfter(server, Buffer.from([0x81, 0x02, 0x7b, 0x7d]))).code, 1002); // not masked
  assert.equal((await closeAfter(server, Buffer.from([0xf1, 0x80, 1, 2, 3, 4]))).code, 1002); // reserved bits
  assert.equal((await closeAfter(server, Buffer.from([0x81, 0x81, 0, 0, 0, 0, 0xff]))).code, 1007); // not UTF-8
  assert.equal((await closeAfter(server, Buffer.from([0x88, 0x80, 0, 0, 0, 0]))).code, 1000); // a goodbye

  await until(async () => (await statusOf(server)).clients === 1, "only the witness to be left");
  await witness.subscribe("/14/2/pose");
  await witness.newest("/14/2/pose");
});

for (const signal of ["SIGTERM", "SIGINT"]) {
  test(`${signal} ends the runtime with status 0 and a complete recording while a client watches`, async (t) => {
    const folder = temporaryFolder(t);
    const session = await synthesize(folder, { seconds: 4 });
    const server = await robot(t, folder, session, "--record", "--profile", "full", "--loop", "--speed", "2");
    const live = await Live.open(t, server);
    await live.subscribe("/14/2/joints", "/14/2/camera_top", "/14/2/camera_top/jpeg");
    await hangingViewer(t, server);
    net.connect(server.port, "127.0.0.1").on("error", () => {}); // and a silent one
    await live.until(() => live.messages.get("/14/2/joints").length > 300, "some joints");
    const id = await recordedSession(server);

    server.kill(signal);
    const { status } = await within(server.ended, `the end after ${signal}`);
    assert.equal(status, 0, server.output);
    await live.until(() => live.closed, "the goodbye").catch(() => {});
    assert.deepEqual(live.closed, { code: 1001, reason: "the server stops" });

    const recording = join(folder, "logs", id);
    assert.equal(JSON.parse((await run("foresight-lab", "info", recording, "--json")).stdout).state, "complete");
    const joints = readSession(recording).get("/14/2/joints").messages;
    assert.ok(joints.length >= live.messages.get("/14/2/joints").length);
    assert.ok(joints.every(({ sequence }, i) => sequence === joints[0].sequence + i));
  });
}
