// The page as the programs serve it, in Chromium.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { coloursOfYuyv, coloursOnScreen, kPhone, open, shoot } from "./browser.mjs";
import { decode } from "./live.mjs";
import { readSession, readStreamed, writeSession } from "./mcap.mjs";
import {
  importReal,
  needsData,
  play,
  require,
  robot,
  run,
  sessionsOf,
  statusOf,
  synthesize,
  temporaryFolder,
  until,
  within,
} from "./support.mjs";

const { create, createFileRegistry, fromJson, toBinary } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = require("@bufbuild/protobuf/wkt");

const lastOf = ({ schema, messages }) => decode(schema.name, schema.data, messages.at(-1).data);
const show = (page, view) => page.getByRole("link", { name: view, exact: true }).click();
const connected = (page) =>
  page
    .getByRole("status")
    .filter({ hasText: /^●\s*connected$/ })
    .waitFor();

/** A recording that was played to its end, so that every view stands still at a known moment. */
async function played(t, session, folder) {
  const server = await play(t, folder, session, "--speed", "1000");
  const { end_ns } = (await sessionsOf(server)).find(({ url }) => url === `/logs/${session.split("/").pop()}.mcap`);
  await until(async () => (await statusOf(server)).time_ns === end_ns, "the end of the recording");
  return { server, recorded: readSession(session) };
}

async function synthetic(t) {
  const folder = temporaryFolder(t);
  return played(t, await synthesize(folder, { seconds: 1 }), folder);
}

/** Asserts that the picture has the colours of the recorded one; a warning may cover its lower end. */
async function assertPicture(context, page, image) {
  const [columns, rows, compared] = [8, 6, 4];
  const expected = coloursOfYuyv({ ...image, data: Buffer.from(image.data, "base64") }, columns, rows);
  const spread = expected.flat(2);
  assert.ok(Math.max(...spread) - Math.min(...spread) > 30, "a picture with something in it");
  const canvas = page.locator("main canvas[aria-label$=' camera']:visible");
  await canvas.waitFor();
  const difference = async () => {
    const seen = await coloursOnScreen(context, canvas, columns, rows);
    return Math.max(
      ...expected
        .slice(0, compared)
        .flatMap((row, y) => row.flatMap((cell, x) => cell.map((value, i) => Math.abs(value - seen[y][x][i])))),
    );
  };
  await until(async () => (await difference()) < 12, "the colours of the recorded picture");
}

test("a picture has its colours, as JPEG and as raw image", async (t) => {
  const { server, recorded } = await synthetic(t);
  const image = lastOf(recorded.get("/14/2/camera_top"));
  const { page, problems, context } = await open(t, `${server.http}/#/14/2/camera?over=none`);
  await connected(page);
  await assertPicture(context, page, image);
  await page.getByRole("button", { name: "Full" }).click();
  await assertPicture(context, page, image);
  assert.equal(await page.title(), "14/2 · camera · Foresight");
  await page.getByText("a recording", { exact: true }).waitFor(); // a live robot has no such label
  await shoot(page, "camera");
  assert.deepEqual(problems, []);
});

test("a real recording's picture appears with its colours", needsData, async (t) => {
  const folder = temporaryFolder(t);
  const { server, recorded } = await played(t, await importReal(folder), folder);
  const { page, problems, context } = await open(t, `${server.http}/#/14/2/camera?over=none`);
  await assertPicture(context, page, lastOf(recorded.get("/14/2/camera_bottom")));
  for (const key of ["d", "h", "l"]) await page.keyboard.press(key);
  await page.waitForURL((url) => !url.hash.includes("over="));
  await shoot(page, "camera-real");
  assert.deepEqual(problems, []);
});

/** A field's row in the tree of objects. */
const fieldRow = (page, field) =>
  page.getByRole("treeitem").filter({ has: page.locator(".name", { hasText: new RegExp(`^\\s*[▾▸]?${field}\\s*$`) }) });

const valueOf = (page, field) => fieldRow(page, field).first().locator(".value > span").first().textContent();
const seven = (value) => Number(value.toPrecision(7)); // the digits the page shows of a float

/** Waits until a field shows this number: the recording may still play. */
async function shows(page, field, expected) {
  let shown;
  const equal = async () => (shown = Number(await valueOf(page, field))) === seven(expected);
  await until(equal, `${field} is ${seven(expected)}`, undefined, () => shown);
}

test("the tree shows each field as the recording holds it; search finds fields by words", async (t) => {
  const { server, recorded } = await synthetic(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
  const names = page.locator(".row.root .name");
  await until(async () => (await names.count()) >= 10, "the objects");
  await shoot(page, "objects-closed");

  const pose = lastOf(recorded.get("/14/2/pose"));
  await page.getByRole("searchbox").fill("pose x");
  await shows(page, "x", pose.x);
  await fieldRow(page, "x").first().click(); // the second row belongs to a particle
  await page.getByText("/14/2/pose.x", { exact: true }).waitFor();
  await shoot(page, "objects-search");

  await page.getByRole("searchbox").fill("inertial accelerometer");
  const inertial = lastOf(recorded.get("/14/2/inertial"));
  for (const field of ["accelerometer_x", "accelerometer_y", "accelerometer_z"])
    await shows(page, field, inertial[field]);
  await page.getByRole("searchbox").fill("no such field");
  await page.getByText("No field is called").waitFor();
  assert.deepEqual(problems, []);
});

const headOf = (page, object) => page.getByRole("rowheader", { name: object, exact: true });
const rowOf = (page, object) => page.getByRole("row").filter({ has: headOf(page, object) });
/** The texts of a row of the table of channels, by the column's head. */
async function rates(page, object) {
  const table = page.getByRole("table").filter({ has: headOf(page, object) });
  const row = rowOf(page, object);
  return until(async () => {
    const heads = await table.locator("thead th").allTextContents();
    const cells = await row.locator("th, td").allTextContents();
    return (
      cells.length > 0 &&
      cells.length === heads.length &&
      Object.fromEntries(heads.map((head, i) => [head.trim(), cells[i].trim()]))
    );
  }, `the row of ${object}`);
}

test("rates show the received messages and the counts of the recording's server", async (t) => {
  const { server, recorded } = await synthetic(t);
  const { page, problems } = await open(t, `${server.http}/#/health`);
  const count = recorded.get("/14/2/joints").messages.length;
  const joints = await until(async () => {
    const row = await rates(page, "joints").catch(() => undefined);
    // a busy page may receive the server's count before the first joints
    return row?.Sequence === String(count) && Number(row.Received) >= 1 && row;
  }, "the server's count, and joints");
  assert.equal(joints.Schema, "foresight.Joints");
  // a busy page is too slow for some; nothing else loses any
  const [dropped, where] = await rowOf(page, "joints")
    .getByTitle(/dropped for viewers/)
    .evaluate(({ textContent, title }) => [textContent.trim(), title]);
  assert.equal(where, `${dropped} dropped for viewers, 0 lost in recording, 0 within the robot`);
  assert.ok(Number(joints.Received) <= count); // only messages since the page subscribed
  await until(
    async () => (await rates(page, "camera_top/jpeg"))["Rate [Hz]"] === "not shown",
    "a row of a stream without subscribers",
  );
  await shoot(page, "health");
  assert.deepEqual(problems, []);
});

test("recordings are listed, and the page downloads them whole, in parts and by stream", async (t) => {
  const { server, recorded } = await synthetic(t);
  const { page, problems } = await open(t, `${server.http}/#/sessions`);
  await page.getByText("1 recording,").waitFor();
  await page.getByLabel(/^Events:/).waitFor();
  await page.getByText("A part of it").click();
  await page.getByLabel("From").fill("soon");
  await page.getByText("Expected minutes and seconds such as 1:05, got 'soon'.").waitFor();
  await page.getByLabel("From").fill("0:00.3");
  await page.getByLabel("To", { exact: true }).fill("0:00.7"); // not the button that dismisses a warning
  await shoot(page, "sessions");
  const [excerpt] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "Download this part" }).click(),
  ]);
  const of = (streams, topic) => streams.get(topic).messages.map(({ logTime }) => logTime);
  const part = of(readStreamed(readFileSync(await excerpt.path())).topics, "/14/2/joints");
  const from = of(recorded, "/14/2/joints")[0] + 300_000_000n;
  assert.ok(part.some((time) => time >= from && time <= from + 400_000_000n)); // the part also holds other messages of the same chunks
  assert.match(await page.getByRole("link", { name: "Download this part" }).getAttribute("href"), /\?from=\d+&to=\d+$/);

  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "Download", exact: true }).click(),
  ]);
  assert.equal(download.suggestedFilename(), "synthetic.mcap");
  const { topics } = readStreamed(readFileSync(await download.path()));
  assert.deepEqual([...topics.keys()].sort(), [...recorded.keys()].sort());

  await page.getByText(/^\d+ streams$/).click();
  const [stream] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "/14/2/pose" }).click(),
  ]);
  assert.deepEqual([...readStreamed(readFileSync(await stream.path())).topics.keys()], ["/14/2/pose"]);
  const foxglove = await page.getByRole("link", { name: "Open in Foxglove" }).getAttribute("href");
  assert.match(foxglove, /^https:\/\/app\.foxglove\.dev\/.*ds\.url=http/);
  assert.deepEqual(problems, []);
});

test("streams without a description are listed by their files", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 1 });
  for (const file of ["one.mcap", "two.mcap"]) writeFileSync(join(session, file), "");
  const { stdout } = await run("foresight-lab", "info", session);
  assert.match(stdout, /^note {5}one\.mcap: (?!one\.mcap)/m);
  assert.match(stdout, /^two\.mcap .* 0 .*\n {2}damaged: two\.mcap: /m);
  const server = await play(t, folder, session);
  const { page, problems } = await open(t, `${server.http}/#/sessions`);
  await page.getByText(/^\d+ streams$/).click();
  for (const name of ["one.mcap", "two.mcap", "/14/2/joints"])
    await page.getByRole("link", { name, exact: true }).waitFor();
  await shoot(page, "sessions-damaged");
  assert.deepEqual(problems, []);
});

test("the button records and stops, and the list follows", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder, { seconds: 2 }), "--loop");
  const { page, problems } = await open(t, `${server.http}/#/sessions`);
  await page.getByText("Nothing recorded yet.").waitFor();
  await page.getByRole("button", { name: "● Record" }).click();
  await page.getByRole("button", { name: "■ Stop" }).waitFor();
  assert.equal((await statusOf(server)).recording.state, "recording");
  await page.locator("article").getByText("recording", { exact: true }).waitFor();
  await shoot(page, "recording");
  await page.getByRole("button", { name: "■ Stop" }).click();
  await page.getByRole("button", { name: "● Record" }).waitFor();
  assert.equal((await statusOf(server)).recording.state, "off");
  await page.locator("article").getByText("recording", { exact: true }).waitFor({ state: "detached" });

  await page.getByLabel("Name").fill("corner kicks");
  await page.getByLabel("Profile").selectOption("full");
  await page.getByRole("button", { name: "Start recording" }).click();
  await page.getByRole("heading", { name: "corner kicks" }).waitFor();
  assert.equal((await statusOf(server)).recording.profile, "full");

  assert.ok(await page.getByRole("button", { name: "Start recording" }).isDisabled()); // one at a time

  // the box follows the robot, not the mouse
  const keep = page.locator("article").filter({ hasText: "corner kicks" }).getByLabel("keep");
  await keep.click();
  await until(() => keep.isChecked(), "the robot to keep it");
  await shoot(page, "recording-kept");
  assert.deepEqual(problems, []);
});

test("a page survives the end of its server, and continues without a reload when a server runs again", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 2 });
  const server = await robot(t, folder, session, "--loop");
  const { page, problems } = await open(t, `${server.http}/#/health`, { breaksConnections: true });
  await connected(page);
  const jointsCome = () =>
    until(async () => Number((await rates(page, "joints"))["Rate [Hz]"].split(" ")[0]) > 50, "joints");
  await jointsCome();
  await page.evaluate(() => (window.loadedOnce = true));
  server.kill("SIGKILL");
  await within(server.ended, "the end");
  await page
    .getByRole("alert")
    .filter({ hasText: /Trying localhost:\d+ again/ })
    .waitFor();
  await shoot(page, "lost");

  await robot(t, folder, session, "--loop", "--port", String(server.port));
  await connected(page);
  await page.getByRole("alert").waitFor({ state: "detached" });
  await jointsCome();
  assert.ok(await page.evaluate(() => window.loadedOnce));
  assert.deepEqual(problems, []);
});

// a team's own message, unknown to the page and with hostile content
const kHostile = "<img src=x onerror=document.title=1><script>document.title=2</script>";
const kStrangeSet = fromJson(FileDescriptorSetSchema, {
  file: [
    {
      name: "them/thing.proto",
      package: "them",
      syntax: "proto3",
      messageType: [
        {
          name: "Thing",
          field: [
            { name: "words", number: 1, type: "TYPE_STRING", label: "LABEL_OPTIONAL" },
            { name: "__proto__", number: 2, type: "TYPE_STRING", label: "LABEL_OPTIONAL" },
            { name: "numbers", number: 3, type: "TYPE_DOUBLE", label: "LABEL_REPEATED" },
          ],
        },
      ],
    },
  ],
});

test("an unknown object is shown field by field, and always as text", async (t) => {
  const folder = temporaryFolder(t);
  const thing = createFileRegistry(kStrangeSet).getMessage("them.Thing");
  const data = toBinary(thing, create(thing, { words: kHostile, numbers: [0.5, 1e300] }));
  await writeSession(join(folder, "strange"), {
    name: kHostile,
    topic: `/14/2/${kHostile}`,
    schema: { name: "them.Thing", data: toBinary(FileDescriptorSetSchema, kStrangeSet) },
    messages: [1, 2].map((second) => ({ logTime: BigInt(second) * 1_000_000_000n + 1_800_000_000_000_000_000n, data })),
  });
  const server = await play(t, folder, join(folder, "strange"), "--speed", "1000");

  const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
  await page.getByRole("button", { name: "Open all" }).click();
  await page.getByRole("treeitem").filter({ hasText: "words" }).getByText(kHostile).first().waitFor();
  await page.getByRole("treeitem").filter({ hasText: "__proto__" }).waitFor();
  assert.match(await fieldRow(page, "numbers").locator(".value").textContent(), /^2 entries/);
  await shoot(page, "strange");
  for (const view of ["Health", "Log", "Camera", "Plot", "Decision", "Sessions"]) await show(page, view.toLowerCase());
  await page.getByRole("heading", { name: kHostile }).waitFor();
  await shoot(page, "strange-sessions");
  assert.deepEqual(problems, []);
  await page.goto(`${server.http}/logs/`); // the page for browsers without the viewer; it has no icon
  await page.getByRole("cell", { name: kHostile }).waitFor();
  assert.equal(await page.locator("img, script").count(), 0);
  assert.equal(await page.title(), "Recordings");
  assert.deepEqual(
    problems.filter((problem) => !problem.includes("404")),
    [],
  );
});

test("on a phone every control can be reached", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder, { seconds: 2 }), "--loop");
  const { page, problems } = await open(t, server.http, {
    viewport: kPhone,
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
  });
  await page.locator("main canvas[aria-label$=' camera']:visible").first().waitFor();
  for (const view of ["field", "camera", "objects", "plot", "decision", "what-if", "health", "log", "sessions"]) {
    await show(page, view);
    await page
      .getByRole("region", { name: new RegExp(view.replace("-", "."), "i") })
      .first()
      .waitFor();
    assert.ok(
      await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
      `${view} is as wide as the phone`,
    );
    // nothing that can be pressed is cut off at the side; the row of views scrolls
    const cut = () =>
      [...document.querySelectorAll("header :is(a, button), .bar :is(button, select, input)")]
        .filter((element) => {
          element.scrollIntoView({ inline: "nearest", block: "nearest" });
          return element.getBoundingClientRect().left < 0 || element.getBoundingClientRect().right > innerWidth;
        })
        .map((element) => element.textContent);
    assert.deepEqual(await page.evaluate(cut), [], view);
    await shoot(page, `phone-${view}`);
  }
  assert.deepEqual(problems, []);
});

test("a page watches another server than its own", async (t) => {
  const folder = temporaryFolder(t);
  const [here, there] = await Promise.all([
    synthesize(folder, { name: "here" }),
    synthesize(folder, { name: "there" }),
  ]);
  const near = await play(t, folder, here, "--bind", "127.0.0.1");
  const far = await robot(t, folder, there, "--team", "5", "--player", "1", "--bind", "127.0.0.2", "--loop");
  const { page, problems } = await open(t, `${near.http}/?ws=ws://127.0.0.2:${far.port}`);
  await page.getByText("Robot 5/1").waitFor();
  await page.locator("main canvas[aria-label$=' camera']:visible").first().waitFor();
  await show(page, "sessions");
  await page.getByText("a page may list only its own host's recordings").waitFor();

  const own = await open(t, `${near.http}/`);
  await own.page.getByText("Robot 14/2").waitFor();
  assert.deepEqual([...problems, ...own.problems], []);
});

test("a token is used and removed from the address", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder), "--loop");
  const token = readFileSync(join(folder, "state/token"), "utf8").trim();
  const { page, problems } = await open(t, `${server.http}/?token=${token}#/14/2/health`);
  await connected(page);
  assert.equal(page.url(), `${server.http}/#/14/2/health`);
  for (const view of ["camera", "sessions"]) {
    await show(page, view);
    assert.ok(!page.url().includes(token) && !(await page.content()).includes(token));
  }
  assert.deepEqual(problems, []);
});
