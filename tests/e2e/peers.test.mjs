// The live protocol with independent clients: the Foxglove client from npm, and a client that writes plain frames.
import assert from "node:assert/strict";
import { test } from "node:test";
import { foxgloveClient } from "./foxglove.mjs";
import { decode, kSubprotocols, Live, refusal, serviceCall } from "./live.mjs";
import { readSession, spanOf } from "./mcap.mjs";
import { play, robot, sessionsOf, statusOf, synthesize, temporaryFolder, until, within } from "./support.mjs";

/** Connects the Foxglove client; returns it with all its events. */
function foxglove(t, server) {
  const { ws, client } = foxgloveClient(t, server);
  const sent = [];
  const send = ws.send.bind(ws);
  ws.send = (data) => send(data, sent.push(data) && undefined);
  const events = {};
  for (const name of [
    "serverInfo",
    "status",
    "message",
    "time",
    "advertise",
    "advertiseServices",
    "parameterValues",
    "serviceCallResponse",
    "serviceCallFailure",
    "error",
    "close",
  ]) {
    events[name] = [];
    client.on(name, (event) => events[name].push(event));
  }
  return { ws, client, events, sent };
}

/** A recording that was played to its end: every object holds its last value, and time stands still. */
async function played(t, { seconds = 1 } = {}) {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds });
  const server = await play(t, folder, session, "--speed", "1000");
  const recorded = readSession(session);
  const { last_ns: end_ns } = spanOf(recorded);
  const live = await Live.open(t, server);
  await live.until(() => live.times.at(-1) === end_ns, "the end of the recording");
  return { folder, session, server, recorded, end_ns, live };
}

const hex = (bytes) => Buffer.from(bytes.buffer ?? bytes, bytes.byteOffset, bytes.byteLength).toString("hex");
const kDerived = [
  [/camera_(top|bottom)$/, ["raw", "jpeg"]],
  [/camera_(top|bottom)_matrix$/, ["transforms", "calibration"]],
  [/\/log$/, ["foxglove"]],
  [/\/pose$/, ["scene", "transforms"]],
  [/^\/truth\/world$/, ["scene"]],
];
const derivedOf = (topic) =>
  kDerived.filter(([source]) => source.test(topic)).flatMap(([, names]) => names.map((name) => `${topic}/${name}`));

test("both subprotocols introduce the server and offer every stream and its derived streams", async (t) => {
  const { server, recorded, live } = await played(t);
  const own = ["/lab/1/runtime", "/lab/1/clock", "/lab/1/log"];
  const all = [...recorded.keys(), ...own].flatMap((topic) => [topic, ...derivedOf(topic)]);
  const expected = [...all, "/field/scene"].sort();

  for (const subprotocol of kSubprotocols) {
    const peer = await Live.open(t, server, { protocols: [subprotocol] });
    assert.equal(peer.socket.protocol, subprotocol);
    await peer.until(() => peer.channels.size >= expected.length, "all channels");
    assert.deepEqual([...peer.channels.keys()].sort(), expected);
  }
  assert.equal(live.socket.protocol, "foxglove.sdk.v1"); // of both subprotocols the server prefers this one

  const { name, capabilities, supportedEncodings, metadata, sessionId } = live.infos[0];
  assert.equal(name, "foresight-lab 14/2");
  assert.deepEqual(capabilities, ["time", "parameters", "parametersSubscribe", "services", "playbackControl"]);
  assert.deepEqual(supportedEncodings, ["json"]);
  const { build } = await statusOf(server);
  assert.deepEqual(metadata, {
    build,
    body: "recording",
    own_playheads: "yes",
    robots: "14/2",
    rules: "spl2025",
    session: "synthetic",
  });
  assert.match(sessionId, /^\d+$/);

  const about = (topic) => live.channels.get(topic).metadata;
  assert.deepEqual(about("/14/2/odometry"), { delivery: "fifo", robot: "14/2", object: "odometry" });
  assert.deepEqual(about("/14/2/camera_top/jpeg"), {
    delivery: "latest",
    robot: "14/2",
    object: "camera_top/jpeg",
    derived: "true",
  });
  assert.equal(about("/truth/world").robot, undefined);
  for (const { id, encoding, schemaEncoding } of live.channels.values()) {
    assert.ok(id > 0 && id <= 65535); // MCAP's channel ids
    assert.deepEqual([encoding, schemaEncoding], ["protobuf", "protobuf"]);
  }
});

test("a new subscriber gets the newest value at once, as the recording holds it", async (t) => {
  const { recorded, server, live } = await played(t);
  await live.subscribe(...recorded.keys());
  const { client, events } = foxglove(t, server);
  await until(() => events.advertise.length > 0, "channels of the Foxglove client");
  const channels = new Map(events.advertise.flat().map((channel) => [channel.topic, channel]));
  const subscriptions = new Map([...recorded.keys()].map((topic) => [client.subscribe(channels.get(topic).id), topic]));

  for (const [topic, { schema, messages }] of recorded) {
    const last = messages.at(-1);
    const message = await live.newest(topic);
    assert.equal(message.log_ns, last.logTime, topic);
    assert.ok(message.data.equals(last.data), `${topic}: the bytes of the recording`);
    // the schema that is announced decodes them as the one in the recording does
    assert.deepEqual(live.decoded(topic, message), decode(schema.name, schema.data, last.data), topic);
  }
  await until(() => events.message.length >= recorded.size, "as many messages of the Foxglove client");
  for (const { subscriptionId, timestamp, data } of events.message) {
    const topic = subscriptions.get(subscriptionId);
    assert.equal(timestamp, recorded.get(topic).messages.at(-1).logTime, topic);
    assert.equal(hex(data), hex(recorded.get(topic).messages.at(-1).data), topic);
  }
  assert.deepEqual(events.error, []);
});

test("decoded values are in their physical ranges", async (t) => {
  const { live } = await played(t);
  const topics = ["camera_top", "joints", "pose", "game", "inertial"].map((object) => `/14/2/${object}`);
  await live.subscribe(...topics);
  const [image, joints, pose, game, inertial] = await Promise.all(
    topics.map(async (topic) => live.decoded(topic, await live.newest(topic))),
  );
  assert.equal(image.encoding, "ENCODING_YUYV");
  assert.equal(Buffer.from(image.data, "base64").length, 2 * image.width * image.height);
  assert.equal(joints.position.length, 25);
  assert.ok(Math.hypot(pose.x, pose.y) < 6, "on the field");
  assert.ok(JSON.stringify(game).includes("INITIAL"));
  assert.ok(Math.abs(inertial.accelerometer_z - 9.81) < 2);
});

test("time messages come repeatedly and never go back", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 1 }));
  const live = await Live.open(t, server);
  await live.until(() => live.times.length >= 15, "15 Time frames"); // beyond the end of the recording
  for (const [index, time] of live.times.entries()) assert.ok(index === 0 || time >= live.times[index - 1]);
});

test("a lossless client gets every message of a pass; when the recording begins again, so does the session", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 1 });
  const server = await play(t, folder, session, "--speed", "2", "--loop");
  const recorded = readSession(session);
  const live = await Live.open(t, server, { path: "/?delivery=lossless" });
  await live.subscribe(...recorded.keys());
  // time may go back only with a new session id, so each pass is checked separately
  const passes = [];
  live.onText = ({ op }) => op === "serverInfo" && passes.push({ from: live.times.length });
  await live.until(() => passes.length >= 2, "two new beginnings");
  assert.equal(new Set(live.infos.map(({ sessionId }) => sessionId)).size, live.infos.length);
  const times = live.times.slice(passes[0].from, passes[1].from);
  for (let i = 1; i < times.length; ++i) assert.ok(times[i] >= times[i - 1]);

  for (const [topic, { messages }] of recorded) {
    // one whole pass: from a first message to the next first message
    const got = live.messages.get(topic);
    const start = got.findIndex(({ log_ns }, i) => i > 0 && log_ns === messages[0].logTime);
    await live.until(() => got.length >= start + messages.length, `the pass of ${topic}`);
    assert.ok(start > 0, `${topic}: began again`);
    const pass = got.slice(start, start + messages.length);
    assert.deepEqual(
      pass.map(({ log_ns }) => log_ns),
      messages.map(({ logTime }) => logTime),
      topic,
    );
    assert.ok(
      pass.every(({ data }, i) => data.equals(messages[i].data)),
      `${topic}: bytes`,
    );
  }
});

/** Width and height of a JPEG by its frame header. */
function sizeOfJpeg(bytes) {
  assert.equal(bytes.readUInt16BE(0), 0xffd8, "starts with SOI");
  assert.equal(bytes.readUInt16BE(bytes.length - 2), 0xffd9, "ends with EOI");
  for (let at = 2; bytes[at] === 0xff; at += 2 + bytes.readUInt16BE(at + 2))
    if (bytes[at + 1] >= 0xc0 && bytes[at + 1] <= 0xc2) return [bytes.readUInt16BE(at + 7), bytes.readUInt16BE(at + 5)];
  return assert.fail("no frame header");
}

test("pictures and log have streams in the formats of Foxglove and Lichtblick", async (t) => {
  const { live, recorded } = await played(t, { seconds: 2 });
  const topics = [
    "/14/2/camera_top",
    "/14/2/camera_top/raw",
    "/14/2/camera_top/jpeg",
    "/14/2/log",
    "/14/2/log/foxglove",
  ];
  await live.subscribe(...topics);
  const last = recorded.get("/14/2/camera_top").messages.at(-1).logTime;
  await live.until(() => live.messages.get("/14/2/camera_top/raw").at(-1)?.log_ns === last, "the last picture");
  const messages = await Promise.all(topics.map((topic) => live.newest(topic)));
  const [image, raw, jpeg, text, log] = messages.map((message, i) => live.decoded(topics[i], message));

  assert.equal(live.channels.get(topics[1]).schemaName, "foxglove.RawImage");
  const { timestamp, width, height, encoding, step, frame_id, data } = raw;
  assert.deepEqual(
    { width, height, encoding, step, frame_id },
    {
      width: image.width,
      height: image.height,
      encoding: "yuyv",
      step: 2 * image.width,
      frame_id: "robot 14/2 camera_top",
    },
  );
  assert.equal(data, image.data);
  assert.equal(Date.parse(timestamp), Number(messages[1].log_ns / 1000000n));
  assert.equal(messages[1].log_ns, recorded.get("/14/2/camera_top").messages.at(-1).logTime);

  assert.equal(live.channels.get(topics[2]).schemaName, "foxglove.CompressedImage");
  assert.deepEqual([jpeg.format, jpeg.frame_id], ["jpeg", "robot 14/2 camera_top"]);
  assert.deepEqual(sizeOfJpeg(Buffer.from(jpeg.data, "base64")), [image.width, image.height]);

  assert.equal(live.channels.get(topics[4]).schemaName, "foxglove.Log");
  assert.deepEqual([log.message, log.name, log.level], [text.text, text.source, text.level.replace("LEVEL_", "")]);
});

test("parameters are read, set within their ranges, and followed", async (t) => {
  const { server, live } = await played(t);
  const { client, events } = foxglove(t, server);
  await until(() => events.serverInfo.length > 0, "the introduction");
  client.getParameters([], "all");
  const answer = async (id) =>
    (await until(() => events.parameterValues.find((event) => event.id === id), `parameters ${id}`)).parameters;
  assert.deepEqual(await answer("all"), [
    { name: "jpeg_quality", value: 75 },
    { name: "jpeg_rate_hz", type: "float64", value: 15 },
    { name: "jpeg_width", value: 640 },
  ]);

  // another client follows one of them and receives only that one
  live.send({ op: "subscribeParameterUpdates", parameterNames: ["jpeg_width", "none of this name"] });
  live.send({ op: "getParameters", parameterNames: ["jpeg_width"], id: "asked" });
  await live.until(() => live.values.find(({ id }) => id === "asked"), "the answer");
  client.setParameters(
    [
      { name: "jpeg_quality", value: 40 },
      { name: "jpeg_width", value: 320 },
    ],
    "set",
  );
  assert.deepEqual(await answer("set"), [
    { name: "jpeg_quality", value: 40 },
    { name: "jpeg_width", value: 320 },
  ]);
  await live.until(() => live.values.length >= 2, "the change");
  assert.deepEqual(live.values.slice(1), [{ op: "parameterValues", parameters: [{ name: "jpeg_width", value: 320 }] }]);

  const refused = [
    [{ name: "jpeg_quality", value: 0 }, "parameter 'jpeg_quality': expected 1 .. 100, got 0"],
    [{ name: "jpeg_rate_hz", value: 31 }, "parameter 'jpeg_rate_hz': expected 0.1 .. 30, got 31"],
    [{ name: "jpeg_width", value: 500 }, "parameter 'jpeg_width': expected 640 or 320, got 500"],
    [{ name: "jpeg_width", value: "wide" }, "parameter 'jpeg_width': expected a whole number, got a text"],
    [{ name: "jpeg_quality" }, "parameter 'jpeg_quality': expected true, false, a number or a text"],
    [{ name: "nonsense", value: 1 }, "parameter 'nonsense': there is no parameter of this name"],
  ];
  for (const [parameter, sentence] of refused) {
    client.setParameters([parameter], sentence);
    const actual = await answer(sentence); // the actual values, not the requested ones
    assert.ok(actual.every(({ value }) => [40, 15, 320].includes(value)));
    await until(() => events.status.find(({ level, message }) => level === 2 && message === sentence), sentence);
  }
});

test("clock_sync answers as an NTP server would, and a client's measurement becomes a clock sample", async (t) => {
  const { live, end_ns } = await played(t);
  await live.subscribe("/lab/1/clock");
  const first = await live.call("clock_sync", { sent_ns: "123" });
  assert.deepEqual(first, { ok: true, sent_ns: "123", received_ns: String(end_ns) });
  await live.call("clock_sync", { sent_ns: "1", offset_ns: "-5", round_trip_ns: "18446744073709551615" });
  const sample = await live.until(
    () =>
      live.messages
        .get("/lab/1/clock")
        .map((message) => live.decoded("/lab/1/clock", message))
        .find(({ source }) => source === "SOURCE_PEER"),
    "the sample",
  );
  assert.deepEqual([sample.offset_ns, sample.round_trip_ns], ["-5", "18446744073709551615"]);
  assert.match(sample.peer, /^(127\.0\.0\.1|\[?::1\]?):\d+$/);
});

test("a service that refuses gives a normal answer with an error; an unknown service is a failure", async (t) => {
  const { server, live } = await played(t);
  assert.deepEqual(
    [...live.services.keys()],
    [
      "clock_sync",
      "/foresight/what_if",
      "/foresight/strategies",
      "/decision/why",
      "/decision/why_not",
      "/decision/situation",
      "/decision/futures",
      "message_beside",
      "watch_session",
    ],
  ); // a server of a recording records nothing
  assert.deepEqual(await live.call("clock_sync", {}), {
    ok: false,
    error: "clock_sync: 'sent_ns' must be a text with a whole number",
  });
  live.send(serviceCall(live.services.get("clock_sync"), 77, "[1]"));
  assert.equal(
    (await live.until(() => live.answers.get(77), "the answer")).json.error,
    "clock_sync: expected a JSON object, got something else",
  );
  live.send(serviceCall(live.services.get("clock_sync"), 78, "\x01", "cdr"));
  assert.equal(
    (await live.until(() => live.answers.get(78), "the answer")).json.error,
    "service: expected the encoding 'json'",
  );

  const { client, events } = foxglove(t, server);
  await until(() => events.advertiseServices.length > 0, "the services");
  client.sendServiceCallRequest({ serviceId: 999, callId: 4, encoding: "json", data: Buffer.from("{}") });
  await until(() => events.serviceCallFailure.length > 0, "the failure");
  const { serviceId, callId, message } = events.serviceCallFailure[0];
  assert.deepEqual({ serviceId, callId, message }, { serviceId: 999, callId: 4, message: "there is no service 999" });
});

test("a recording is begun and ended by service or parameter, and all clients see it", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder, { seconds: 1 }));
  const [live, other] = [await Live.open(t, server), await Live.open(t, server)];
  assert.equal(live.infos[0].metadata.body, "replay");
  other.send({ op: "subscribeParameterUpdates", parameterNames: ["recording"] });
  const heard = (wanted) =>
    other.until(() => other.values.at(-1)?.parameters[0].value === wanted, `recording is ${wanted}`);

  const { ok, session } = await live.call("start_recording", { name: "over <here>", profile: "vision" });
  assert.ok(ok);
  assert.match(session, /_over__here_$/);
  await heard(true);
  const { recording } = await statusOf(server);
  assert.deepEqual([recording.state, recording.session, recording.profile], ["recording", session, "vision"]);

  const twice = await live.call("start_recording");
  assert.equal(twice.ok, false);
  assert.match(twice.error, /record/);
  assert.deepEqual(await live.call("stop_recording"), { ok: true, session });
  await heard(false);
  assert.equal((await live.call("stop_recording")).ok, false);
  assert.equal((await live.call("start_recording", { profile: "everything" })).ok, false);

  live.send({ op: "setParameters", parameters: [{ name: "recording", value: true }], id: "on" });
  await heard(true);
  live.send({ op: "setParameters", parameters: [{ name: "recording", value: false }], id: "off" });
  await heard(false);

  assert.deepEqual(await live.call("keep_session", { session, keep: true }), { ok: true });
  assert.equal((await live.call("keep_session", { session: "../x", keep: true })).ok, false);
  const sessions = await sessionsOf(server);
  assert.equal(sessions.length, 2);
  const { state, kept, name } = sessions.find((entry) => entry.session === session);
  assert.deepEqual({ state, kept, name }, { state: "complete", kept: true, name: "over <here>" });
});

test("nonsense is answered with a sentence, and the connection stays open", async (t) => {
  const { live } = await played(t);
  const cases = [
    ['{"op":"dance"}', "request: the op 'dance' is not known"],
    ["{", "request: expected JSON, got something else"],
    ["[]", "request: expected a JSON object with 'op', got something else"],
    ["{}", "request: expected a JSON object with 'op', got one without"],
    ['{"op":"subscribe","subscriptions":[{"id":900,"channelId":60000}]}', "subscribe: there is no channel 60000"],
    [
      '{"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]}',
      "request: 'subscriptions' must be an array of {id, channelId}, both numbers 0 .. 4294967295",
    ],
    ['{"op":"unsubscribe","subscriptionIds":[901]}', "unsubscribe: there is no subscription 901"],
    ['{"op":"advertise","channels":[]}', "'advertise' needs a capability that this server does not announce"],
    [
      '{"op":"subscribeConnectionGraph"}',
      "'subscribeConnectionGraph' needs a capability that this server does not announce",
    ],
    [
      '{"op":"fetchAsset","uri":"package://a","requestId":1}',
      "'fetchAsset' needs a capability that this server does not announce",
    ],
    [Buffer.alloc(0), "request: a binary message is empty"],
    [Buffer.from([9]), "request: the binary opcode 9 is not known"],
    [Buffer.from([2, 1]), "request: a binary message with opcode 2 is cut short at 2 bytes"],
    [Buffer.from([1, 1, 0, 0, 0, 9]), "this server takes no messages from clients"],
  ];
  for (const [sent, sentence] of cases) {
    live.send(sent);
    const { level } = await live.until(
      () => live.statuses.find(({ message }) => message === sentence),
      `'${sentence}' after ${sent}`,
    );
    assert.equal(level, 2);
    live.statuses.length = 0;
  }
  await live.subscribe("/14/2/pose");
  await live.newest("/14/2/pose");
});

test("a client without a known subprotocol is refused", async (t) => {
  const { server } = await played(t);
  for (const protocols of [[], ["graphql-ws"]]) {
    const { status, text } = await refusal(server, { protocols });
    assert.equal(status, 400);
    assert.match(text, /foxglove\.sdk\.v1 or foxglove\.websocket\.v1/);
  }
});

// the vectors are from the Foxglove SDK's own tests; only the numbers differ, because the server chooses them
test("bytes on the wire are those of the protocol's golden vectors", async (t) => {
  const { server, live, end_ns } = await played(t);
  const little = (value, size) =>
    Buffer.from(
      BigInt.asUintN(8 * size, BigInt(value))
        .toString(16)
        .padStart(2 * size, "0"),
      "hex",
    )
      .reverse()
      .toString("hex");
  const time = (ns) => `02${little(ns, 8)}`;
  const response = (service, call, text) =>
    `03${little(service, 4)}${little(call, 4)}040000006a736f6e${Buffer.from(text).toString("hex")}`;
  assert.equal(time(1234567890), "02d202964900000000");
  assert.equal(
    response(10, 12, '{"key": "value"}'),
    "030a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d",
  );

  let frame;
  live.onFrame = (bytes) => (frame = bytes[0] === 2 ? bytes : frame);
  await live.until(() => frame, "a Time frame");
  assert.equal(hex(frame), time(end_ns));
  const service = live.services.get("clock_sync");
  live.send(serviceCall(service, 12, '{"sent_ns":"7"}'));
  const { raw } = await live.until(() => live.answers.get(12), "the answer");
  assert.equal(
    hex(raw),
    response(service, 12, JSON.stringify({ ok: true, received_ns: String(end_ns), sent_ns: "7" })),
  );

  // messages of clients: ours written by hand here, Foxglove's by Foxglove
  const golden = "020a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d";
  assert.equal(hex(serviceCall(10, 12, '{"key": "value"}')), golden);
  const { ws, client, sent } = foxglove(t, server);
  await within(new Promise((resolve) => ws.on("open", resolve)), "the connection");
  client.sendServiceCallRequest({ serviceId: 10, callId: 12, encoding: "json", data: Buffer.from('{"key": "value"}') });
  client.sendMessage(30, Buffer.from('{"key": "value"}'));
  assert.deepEqual(sent.map(hex), [golden, "011e0000007b226b6579223a202276616c7565227d"]);
});
