// Scenes, frames and projections in Foxglove's own client: what its 3D and image panels draw without any set-up.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";
import { foxgloveClient } from "./foxglove.mjs";
import { decode, Live } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import {
  download,
  play,
  recordedSession,
  request,
  root,
  start,
  synthesize,
  temporaryFolder,
  until,
} from "./support.mjs";

const simulation = (t) => start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7");

/** Connects Foxglove's client and subscribes to `topics`; returns a function that waits for the newest message of one. */
async function watch(t, server, topics) {
  const { client } = foxgloveClient(t, server);
  const channels = new Map();
  const subscribed = new Map(); // subscription -> topic
  const newest = new Map(); // topic -> decoded
  client.on("advertise", (list) => list.forEach((channel) => channels.set(channel.topic, channel)));
  client.on("message", ({ subscriptionId, data }) => {
    const { topic, schemaName, schema } = channels.get(subscribed.get(subscriptionId));
    newest.set(
      topic,
      decode(schemaName, Buffer.from(schema, "base64"), new Uint8Array(data.buffer, data.byteOffset, data.byteLength)),
    );
  });
  await until(() => topics.every((topic) => channels.has(topic)), "the channels");
  for (const topic of topics) subscribed.set(client.subscribe(channels.get(topic).id), topic);
  return (topic) => until(() => newest.get(topic), `a message of ${topic}`);
}

const readMcap = (bytes) => readStreamed(bytes).topics;
const entity = ({ entities }, id) => entities.find((one) => one.id === id);
const near = (one, other, tolerance) => Math.hypot(one.x - other.x, one.y - other.y) < tolerance;

test("Foxglove's client sees the field, the truth and the beliefs of a simulated game", async (t) => {
  const server = await simulation(t);
  const newest = await watch(t, server, [
    "/field/scene",
    "/truth/world/scene",
    "/14/2/pose/scene",
    "/14/2/pose/transforms",
  ]);
  const field = await newest("/field/scene");
  assert.deepEqual(field.entities.map(({ id }) => id).sort(), ["carpet", "goals", "lines"]);
  const truth = await newest("/truth/world/scene");
  assert.ok(entity(truth, "ball"));
  assert.ok(truth.entities.filter(({ id }) => /^robot \d+\/\d+$/.test(id)).length > 1);
  const beliefs = await newest("/14/2/pose/scene");
  const { transforms } = await newest("/14/2/pose/transforms");
  assert.deepEqual([transforms[0].parent_frame_id, transforms[0].child_frame_id], ["field", "robot 14/2"]);
  for (const { frame_id } of [...field.entities, ...truth.entities, ...beliefs.entities])
    assert.equal(frame_id, "field");
});

test("the scene of the truth is the truth", async (t) => {
  const server = await simulation(t);
  const live = await Live.open(t, server);
  await live.subscribe("/truth/world", "/truth/world/scene");
  const of = (topic) => new Map(live.messages.get(topic).map((message) => [message.log_ns, message]));
  const both = await live.until(() => {
    const [truths, scenes] = [of("/truth/world"), of("/truth/world/scene")];
    const time = [...scenes.keys()].find((log_ns) => truths.has(log_ns));
    return (
      time && [live.decoded("/truth/world", truths.get(time)), live.decoded("/truth/world/scene", scenes.get(time))]
    );
  }, "a truth and its scene");
  const [truth, scene] = both;
  assert.ok(near(entity(scene, "ball").spheres[0].pose.position, truth.ball, 1e-5));
  for (const { team, player, x, y, fallen } of truth.robots) {
    const { texts } = entity(scene, `robot ${team}/${player}`);
    assert.ok(near(texts[0].pose.position, { x, y }, 1e-5));
    assert.equal(texts[0].text, fallen ? `${player} fallen` : `${player}`);
  }
});

test("a recording's cameras have a frame and a projection for its images", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 1 }));
  const matrix = "/14/2/camera_top_matrix";
  const newest = await watch(t, server, [`${matrix}/transforms`, `${matrix}/calibration`, "/14/2/camera_top/jpeg"]);
  const { transforms } = await newest(`${matrix}/transforms`);
  const calibration = await newest(`${matrix}/calibration`);
  const image = await newest("/14/2/camera_top/jpeg");
  assert.equal(transforms[0].child_frame_id, image.frame_id);
  assert.equal(calibration.frame_id, image.frame_id);
  assert.equal(calibration.K.length, 9);
  assert.ok(calibration.width > 0 && calibration.K[0] > 0);
});

test("a download with ?foxglove holds the recording and what other viewers draw of it", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 2 }));
  const plain = readMcap(await download(server, "/logs/synthetic.mcap"));
  const file = await download(server, "/logs/synthetic.mcap?foxglove");
  const drawn = readMcap(file);
  for (const [topic, { messages }] of plain)
    assert.deepEqual(
      drawn.get(topic).messages.map(({ logTime }) => logTime),
      messages.map(({ logTime }) => logTime),
      topic,
    );
  const added = [...drawn.keys()].filter((topic) => !plain.has(topic)).sort();
  for (const topic of [
    "/14/2/camera_top/jpeg",
    "/14/2/camera_top_matrix/calibration",
    "/14/2/camera_top_matrix/transforms",
    "/14/2/pose/scene",
    "/14/2/pose/transforms",
    "/field/scene",
    "/truth/world/scene",
  ])
    assert.ok(added.includes(topic), `${topic} in ${added}`);
  assert.ok(!added.some((topic) => topic.endsWith("/raw")));
  assert.equal(drawn.get("/truth/world/scene").messages.length, plain.get("/truth/world").messages.length);

  // the same bytes again, and parts of them
  assert.ok((await download(server, "/logs/synthetic.mcap?foxglove")).equals(file));
  const part = await request(server, "/logs/synthetic.mcap?foxglove", { headers: { Range: "bytes=100-199" } });
  assert.equal(part.status, 206);
  assert.ok(part.body.equals(file.subarray(100, 200)));
});

test("the robot's program makes no downloads with ?foxglove, and says who does", async (t) => {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7", "--record");
  const session = await recordedSession(server);
  const refused = await request(server, `/logs/${session}.mcap?foxglove`);
  assert.equal(refused.status, 404);
  assert.match(
    refused.body.toString(),
    new RegExp(
      `session ${session}: foresight-robot makes no downloads with \\?foxglove; ` +
        "scripts/logs fetches the session, and foresight-lab play makes them",
    ),
  );
  await until(
    async () => (await request(server, `/logs/${session}.mcap`)).status === 200,
    "a download without it, as soon as something is written",
  );
});

const kIndependent = join(root, "tests/e2e/independent");
const needsSchemas = {
  skip: existsSync(join(kIndependent, "node_modules/@foxglove/schemas"))
    ? false
    : "npm ci in tests/e2e/independent brings the schemas that this needs",
};

/** Checks a decoded message against a JSON schema of Foxglove: kinds of values, and no field that the schema lacks. */
function check(schema, value, where) {
  if (schema.oneOf)
    return assert.ok(
      schema.oneOf.some((one) => one.const === value),
      `${where}: ${value}`,
    );
  switch (schema.type) {
    case "object": {
      const known = new Set(Object.keys(schema.properties ?? {}));
      for (const [name, part] of Object.entries(value)) {
        assert.ok(known.has(name), `${where}.${name} is a field of the schema`);
        check(schema.properties[name], part, `${where}.${name}`);
      }
      return;
    }
    case "array":
      return value.forEach((one, i) => check(schema.items, one, `${where}[${i}]`));
    case "string":
      return assert.ok(
        typeof value === "string" || (schema.contentEncoding === "base64" && value?.byteLength >= 0),
        where,
      );
    case "integer":
    case "number":
      return assert.ok(Number.isFinite(Number(value)), `${where}: ${value}`);
    case "boolean":
      return assert.equal(typeof value, "boolean", where);
    default:
      return assert.fail(`${where}: the schema has an unknown type ${schema.type}`);
  }
}

// Lichtblick and Foxglove decode with protobufjs, by the descriptors in the file; their panels expect these schemas
test("protobufjs decodes every derived message, as Foxglove's schemas say", needsSchemas, async (t) => {
  const require = createRequire(join(kIndependent, "package.json"));
  const protobuf = require("protobufjs");
  const { FileDescriptorSet } = require("protobufjs/ext/descriptor");
  const schemas = require("@foxglove/schemas/jsonschema");
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 2 }));
  const topics = readMcap(await download(server, "/logs/synthetic.mcap?foxglove"));
  const seen = new Set();
  for (const [topic, { schema, messages }] of topics) {
    if (!schema.name.startsWith("foxglove.")) continue;
    const type = protobuf.Root.fromDescriptor(FileDescriptorSet.decode(schema.data)).lookupType(schema.name);
    const expected = schemas[schema.name.replace("foxglove.", "")];
    for (const { data } of messages) {
      // times are {seconds, nanos} in protobuf and {sec, nsec} in Foxglove
      const message = JSON.parse(
        JSON.stringify(type.toObject(type.decode(data), { defaults: true, bytes: String, longs: Number }))
          .replaceAll('"seconds"', '"sec"')
          .replaceAll('"nanos"', '"nsec"'),
      );
      check(expected, message, topic);
      seen.add(schema.name);
    }
  }
  assert.deepEqual([...seen].sort(), [
    "foxglove.CameraCalibration",
    "foxglove.CompressedImage",
    "foxglove.FrameTransforms",
    "foxglove.Log",
    "foxglove.PointCloud",
    "foxglove.SceneUpdate",
  ]);
});
