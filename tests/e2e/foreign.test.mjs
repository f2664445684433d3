// Recordings of another program with unknown messages: played as they are, and mapped to our objects.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { Live } from "./live.mjs";
import { mcapOf } from "./mcap.mjs";
import { play, require, run, temporaryFolder, until } from "./support.mjs";

const { create, createFileRegistry, toBinary } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = require("@bufbuild/protobuf/wkt");

const kStart = 1_700_000_000_000_000_000n,
  kCount = 300,
  kPeriod = 33_000_000n; // [ns]
const kDouble = 1,
  kMessage = 11,
  kOptional = 1;

/** `theirs.Sighting {theirs.Spot spot {double ahead_mm, left_mm}}`: a ball as another team's robot describes it. */
function sightings() {
  const field = (name, number, type, typeName) => ({ name, number, type, typeName, label: kOptional });
  const set = create(FileDescriptorSetSchema, {
    file: [
      {
        name: "theirs.proto",
        package: "theirs",
        syntax: "proto3",
        messageType: [
          { name: "Spot", field: [field("ahead_mm", 1, kDouble), field("left_mm", 2, kDouble)] },
          { name: "Sighting", field: [field("spot", 1, kMessage, ".theirs.Spot")] },
        ],
      },
    ],
  });
  const schema = createFileRegistry(set).getMessage("theirs.Sighting");
  const spot = createFileRegistry(set).getMessage("theirs.Spot");
  return {
    schema: { name: "theirs.Sighting", encoding: "protobuf", data: toBinary(FileDescriptorSetSchema, set) },
    bytes: (aheadMm, leftMm) => toBinary(schema, create(schema, { spot: create(spot, { aheadMm, leftMm }) })),
  };
}

/** Ten seconds: the robot walks along the middle line and the ball lies before it. */
async function recording(folder, options) {
  const { schema, bytes } = sightings();
  const messages = [];
  for (let i = 0; i < kCount; ++i) {
    const logTime = kStart + BigInt(i) * kPeriod;
    messages.push({
      topic: "/estimate",
      logTime,
      data: Buffer.from(
        JSON.stringify({ where: { x: -2 + i / 100, y: 0.5 }, degrees: 90, mode: i < 150 ? "wait" : "play" }),
      ),
    });
    messages.push({ topic: "/vision/ball", logTime: logTime + 1n, data: bytes(500 + i, -250) });
  }
  const channels = [
    { topic: "/estimate", encoding: "json" },
    { topic: "/vision/ball", encoding: "protobuf", schema },
    {
      topic: "/quiet",
      encoding: "json",
      schema: { name: "Quiet", encoding: "jsonschema", data: Buffer.from('{"type": "object"}') },
    },
  ];
  const file = join(folder, "theirs.mcap");
  writeFileSync(file, await mcapOf(channels, messages, options));
  return file;
}

const kMapping = {
  robot: "21/4",
  topics: {
    "/estimate": [
      {
        object: "pose",
        fields: {
          x: "where.x",
          y: "where.y",
          heading: { from: "degrees", scale: Math.PI / 180 },
          deviation_x: { value: 0.1 },
          deviation_y: { value: 0.1 },
          deviation_heading: { value: 0.1 },
        },
      },
      { object: "game", fields: { state: { from: "mode", names: { wait: "STATE_SET", play: "STATE_PLAYING" } } } },
    ],
    "/vision/ball": {
      object: "ball",
      fields: {
        x: { from: "spot.ahead_mm", scale: 0.001 },
        y: { from: "spot.left_mm", scale: 0.001 },
        seen_ns: "@time",
        visible: { value: true },
        deviation: { value: 0.05 },
      },
    },
  },
};

const row = (page, name) =>
  page
    .getByRole("treeitem")
    .filter({ has: page.locator(".name", { hasText: new RegExp(`^\\s*[▾▸]?${name}\\s*$`) }) })
    .first();

for (const [what, options] of [
  ["with chunks and an index", {}],
  ["without chunks", { useChunks: false }],
  [
    "without an index",
    { useMessageIndex: false, useChunkIndex: false, useStatistics: false, useSummaryOffsets: false },
  ],
])
  test(`any MCAP of JSON and protobuf is played, ${what}`, async (t) => {
    const folder = temporaryFolder(t);
    const live = await Live.open(t, await play(t, folder, await recording(folder, options), "--speed", "1000"), {
      path: "/?delivery=lossless",
    });
    await live.until(() => live.channels.has("/estimate") && live.channels.has("/vision/ball"), "their channels");
    await live.subscribe("/estimate", "/vision/ball");
    await live.until(
      () =>
        ["/estimate", "/vision/ball"].every(
          (topic) => live.messages.get(topic).at(-1)?.log_ns >= kStart + BigInt(kCount - 1) * kPeriod,
        ),
      "the last messages",
    );
    assert.deepEqual(JSON.parse(live.messages.get("/estimate").at(-1).data), {
      where: { x: -2 + 299 / 100, y: 0.5 },
      degrees: 90,
      mode: "play",
    });
    assert.deepEqual(live.decoded("/vision/ball", live.messages.get("/vision/ball").at(-1)), {
      spot: { ahead_mm: 799, left_mm: -250 },
    });
    const { encoding, schemaName } = live.channels.get("/estimate");
    assert.deepEqual([encoding, schemaName], ["json", ""]);
  });

test("unknown objects show in the tree and in plots", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await recording(folder), "--loop");
  const { page, problems } = await open(t, `${server.http}/#//objects`);
  await page.getByRole("searchbox").fill("degrees");
  await row(page, "degrees").waitFor();
  await until(
    async () => (await row(page, "degrees").locator(".value > span").first().textContent()) === "90",
    "the value",
  );
  await page.getByRole("searchbox").fill("ahead_mm");
  await row(page, "ahead_mm").waitFor();
  await shoot(page, "foreign-objects");
  const plot = await open(t, `${server.http}/#//plot?plot=/estimate.where.x%20/vision/ball.spot.ahead_mm`);
  await plot.page.getByRole("list", { name: "Lines" }).getByText("/estimate.where.x").waitFor();
  await until(async () => (await plot.page.locator("main canvas").count()) > 0, "the plot");
  const values = plot.page.getByRole("list", { name: "Lines" }).locator(".number");
  await until(
    async () => (await values.allTextContents()).filter((text) => /\d/.test(text)).length === 2,
    "a value of each line",
    undefined,
    () => values.allTextContents(),
  );
  await shoot(plot.page, "foreign-plot");
  // a page that learns that this is a recording connects anew, perhaps before the first connection stands
  assert.deepEqual(
    [...problems, ...plot.problems].filter((text) => !/closed before the connection is established/.test(text)),
    [],
  );
});

test("a mapping file makes their topics our objects, which the field shows", async (t) => {
  const folder = temporaryFolder(t);
  const map = join(folder, "map.json");
  writeFileSync(map, JSON.stringify(kMapping));
  const server = await play(t, folder, await recording(folder), "--map", map, "--loop", "--speed", "0.5");
  const live = await Live.open(t, server);
  await live.until(
    () => ["/21/4/pose", "/21/4/ball", "/21/4/game", "/estimate"].every((topic) => live.channels.has(topic)),
    "the channels",
  );
  assert.equal(live.channels.get("/21/4/ball").schemaName, "foresight.Ball");
  await live.subscribe("/21/4/pose", "/21/4/ball", "/21/4/game", "/vision/ball", "/estimate");
  for (const topic of ["/21/4/pose", "/21/4/ball", "/21/4/game", "/vision/ball"]) await live.newest(topic);
  // each of their messages becomes one of ours at the same time
  const pair = (theirs, ours) =>
    live.until(
      () =>
        live.messages.get(theirs).flatMap((their) =>
          live.messages
            .get(ours)
            .filter(({ log_ns }) => log_ns === their.log_ns)
            .map((our) => [their, our]),
        )[0],
      `${theirs} and ${ours} of one time`,
    );
  const [seen, ball] = await pair("/vision/ball", "/21/4/ball");
  const { spot } = live.decoded("/vision/ball", seen);
  const { x, y, seen_ns, visible } = live.decoded("/21/4/ball", ball);
  assert.deepEqual([x, y, seen_ns, visible], [Math.fround(spot.ahead_mm * 0.001), -0.25, String(ball.log_ns), true]);
  const [estimate, pose] = await pair("/estimate", "/21/4/pose");
  const believed = live.decoded("/21/4/pose", pose);
  assert.deepEqual(
    [believed.x, believed.y, believed.heading],
    [Math.fround(JSON.parse(estimate.data).where.x), 0.5, Math.fround(Math.PI / 2)],
  );
  assert.match(live.decoded("/21/4/game", await live.newest("/21/4/game")).state, /^STATE_(SET|PLAYING)$/);

  const { page, problems } = await open(t, `${server.http}/#/21/4/field`);
  await page.getByLabel("The field from above").waitFor();
  await until(
    async () => (await page.title()).includes("21/4"),
    "the robot",
    undefined,
    () => page.title(),
  );
  await shoot(page, "foreign-field");
  assert.deepEqual(problems, []);
});

test("info describes such a file, and counts no gaps without sequence numbers", async (t) => {
  const { status, stdout } = await run("foresight-lab", "info", await recording(temporaryFolder(t)), "--json");
  assert.equal(status, 0);
  const { streams, clock } = JSON.parse(stdout);
  assert.deepEqual(
    streams.map(({ topic, schema, messages, missing }) => [topic, schema, messages, missing]),
    [
      ["/estimate", "", kCount, 0],
      ["/vision/ball", "theirs.Sighting", kCount, 0],
      ["/quiet", "Quiet", 0, 0],
    ],
  );
  assert.deepEqual(clock.peers, {});
});

test("a mapping with a mistake is one sentence and status 2", async (t) => {
  const folder = temporaryFolder(t);
  const file = await recording(folder);
  const map = join(folder, "map.json");
  const refused = async (change) => {
    const mapping = structuredClone(kMapping);
    change(mapping);
    writeFileSync(map, JSON.stringify(mapping));
    const { status, stderr } = await run("foresight-lab", "play", file, "--map", map, "--port", "0");
    assert.equal(status, 2);
    return stderr.trim();
  };
  assert.equal(
    await refused((m) => (m.robot = "four")),
    `foresight-lab: ${map}: $.robot: expected <team>/<player> such as "14/2", got "four"`,
  );
  assert.match(
    await refused((m) => (m.topics["/vision/ball"].object = "boll")),
    /\$\.topics\["\/vision\/ball"\]\.object: expected one of .*ball.*, got "boll"$/,
  );
  assert.match(
    await refused((m) => (m.topics["/vision/ball"].fields.z = "spot.z")),
    /expected fields of foresight\.Ball \(seen_ns, x, .*\), got "z"$/,
  );
  assert.equal(
    await refused((m) => (m.topics["/vision/ball"].fields.x = "spot.up")),
    `foresight-lab: ${map}: /vision/ball: expected 'spot.up' for x, it is not there`,
  );
  assert.match(
    await refused((m) => (m.topics["/vision/balls"] = m.topics["/vision/ball"])),
    /expected one of the topics that have messages \(.*\/estimate, \/vision\/ball.*\), got '\/vision\/balls'$/,
  );
  const { status, stderr } = await run(
    "foresight-lab",
    "play",
    file,
    "--map",
    join(folder, "none.json"),
    "--port",
    "0",
  );
  assert.equal(status, 2);
  assert.match(stderr, /none\.json/);
});
