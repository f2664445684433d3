// A recording in the viewer, in Chromium: the whole of it on one strip of time. Pages that follow share its playback.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { decode } from "./live.mjs";
import { readSession, readStreamed, spanOf } from "./mcap.mjs";
import { play, run, synthesize, temporaryFolder, until } from "./support.mjs";

/** A game of a minute and more, recorded: its server and what @mcap/core reads in it. */
async function game(t, ...args) {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const { status, stderr } = await run(
    "foresight-sim",
    "match",
    "--seed",
    "7",
    "--rules",
    "spl2012:2,half_duration=30,ready_duration=5",
    "--mcap",
    file,
  );
  assert.equal(status, 0, stderr);
  const { topics } = readStreamed(readFileSync(file));
  return { server: await play(t, folder, file, ...args), topics, ...spanOf(topics) };
}

const at = (page) => BigInt(/[?&]at=(\d+)/.exec(page.url())?.[1] ?? 0);
const elapsed = (page) => page.getByLabel("Elapsed").textContent();
/** The shown place in the recording [s]. */
async function place(page) {
  const [minutes, seconds] = (await elapsed(page)).split(" / ")[0].split(":").map(Number);
  return 60 * minutes + seconds;
}
const goesOn = (page) => page.getByRole("button", { name: "Freeze view" }).waitFor();
const stands = (page) => page.getByRole("button", { name: "Go on" }).waitFor();
const row = (page, name) =>
  page
    .getByRole("treeitem")
    .filter({ has: page.locator(".name", { hasText: new RegExp(`^\\s*[▾▸]?${name}\\s*$`) }) })
    .first();
const shown = (page, name) => row(page, name).locator(".value > span").first().textContent();

/** Presses the strip at a share of its length, 0 .. 1. */
async function pressStrip(page, share) {
  const box = await page.getByLabel("Timeline").boundingBox();
  await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
}

test("a page paused before the first data shows the first data", async (t) => {
  const { server } = await game(t);
  const { page, problems } = await open(t, "about:blank");
  let release;
  let next = new Promise((done) => (release = done));
  await page.routeWebSocket(/./, (socket) => {
    const behind = socket.connectToServer();
    behind.onMessage((message) => void (next = next.then(() => socket.send(message))));
  });
  await page.goto(`${server.http}/#/14/2/objects`);
  await page.getByRole("button", { name: "Freeze view" }).click();
  await stands(page);
  await page.getByRole("button", { name: "Go on" }).click(); // changed again
  await goesOn(page);
  await page.keyboard.press("Space");
  await stands(page);

  release();
  await until(() => at(page) > 0n, "a moment in the address");
  const moment = at(page);
  await page.waitForTimeout(500); // the playing recording does not move the moment
  assert.equal(at(page), moment);
  await stands(page);
  await page.keyboard.press("Space");
  await until(() => at(page) === 0n, "time goes on");
  assert.deepEqual(problems, []);
});

test("the strip spans the whole recording; a press anywhere shows the tree of that moment", async (t) => {
  const { server, topics, first_ns, last_ns } = await game(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
  await goesOn(page);
  await page.getByRole("searchbox").fill("pose heading");
  await row(page, "heading").waitFor();
  const { schema, messages } = topics.get("/14/2/pose");
  const length = (last_ns - first_ns) / 1_000_000_000n;
  assert.match(await elapsed(page), new RegExp(`/ ${length / 60n}:`));
  for (const share of [0.8, 0.3, 0.31, 0.95, 0.02]) {
    await pressStrip(page, share);
    await stands(page);
    const wanted_ns = first_ns + BigInt(Math.round(share * Number(last_ns - first_ns)));
    await until(
      () => at(page) > wanted_ns - 500_000_000n && at(page) < wanted_ns + 500_000_000n,
      `the moment ${share}`,
    );
    const then = messages.findLast(({ logTime }) => logTime <= at(page));
    const { heading } = decode(schema.name, schema.data, then.data);
    await until(
      async () => Number(await shown(page, "heading")) === Number(heading.toPrecision(7)),
      `heading ${heading} at ${share}, not ${await shown(page, "heading")}`,
    );
  }

  // by frames: back to a part that was not played yet, and forward
  await pressStrip(page, 0.5);
  await until(() => at(page) > first_ns + (last_ns - first_ns) / 3n, "the middle");
  const truth = topics.get("/truth/world").messages.map(({ logTime }) => logTime);
  const middle = at(page);
  await page.keyboard.press(",");
  await until(() => at(page) < middle, "a frame back");
  await page.keyboard.press(",");
  // the press may have hit an event, which lies on a frame
  const last = truth.findLastIndex((time) => time < middle);
  /** Waits for the frame `by` frames behind the last one before the middle. */
  const frame = (by) =>
    until(
      () => at(page) === truth[last + by],
      `frame ${by}, ${truth[last + by]}`,
      undefined,
      () => `${at(page)}`,
    );
  await frame(-1);
  for (const ahead of [0, 1, 2]) {
    await page.keyboard.press(".");
    await frame(ahead);
  }
  // also when the keys follow each other fast
  for (let i = 0; i < 5; ++i) await page.keyboard.press(".");
  await frame(7);
  await shoot(page, "recording-objects");

  // a link opens the same moment in the other view
  const moment = at(page);
  const colleague = await open(t, page.url().replace("/objects", "/field"));
  await stands(colleague.page);
  await until(() => at(colleague.page) === moment, "the moment of the link");
  await shoot(colleague.page, "recording-field");
  assert.deepEqual([...problems, ...colleague.problems], []);
});

test("steps by frames miss none on a page that misses two of three messages", async (t) => {
  const { server, topics, first_ns } = await game(t);
  const { page, problems } = await open(t, "about:blank");
  let messages = 0;
  const isMissed = (data) => data[0] === 1 && ++messages % 3 !== 0; // message data; texts and other frames pass
  await page.routeWebSocket(/./, (socket) => {
    const behind = socket.connectToServer();
    behind.onMessage((data) => (typeof data === "string" || !isMissed(data) ? socket.send(data) : undefined));
  });
  await page.goto(`${server.http}/#/14/2/field`);
  await until(async () => (await place(page)) > 2, "two seconds were played");
  await page.keyboard.press("Space");
  await stands(page);
  await until(() => at(page) > first_ns, "a moment in the address");
  const truth = topics.get("/truth/world").messages.map(({ logTime }) => logTime);
  const begin = truth.findLastIndex((time) => time <= at(page));
  const isFrame = (wanted) =>
    until(
      () => at(page) === truth[wanted],
      `frame ${wanted - begin}, ${truth[wanted]}`,
      undefined,
      () => `${at(page)}`,
    );
  let index = begin;
  for (const key of "..,,,,.,..") {
    index += key === "." ? 1 : -1;
    await page.keyboard.press(key);
    await isFrame(index);
  }
  for (let i = 0; i < 20; ++i) await page.keyboard.press(","); // faster than the answers
  await isFrame(index - 20);
  assert.deepEqual(problems, []);
});

test("pages that follow share the playback: pause, speed, position; playing backwards is local to a page", async (t) => {
  const { server, first_ns, last_ns } = await game(t);
  const [one, other] = [
    await open(t, `${server.http}/#/14/2/field?follow`),
    await open(t, `${server.http}/#/14/3/plot?plot=/14/2/pose.x&follow=yes`),
  ];
  await Promise.all([goesOn(one.page), goesOn(other.page)]);
  await one.page.keyboard.press(" ");
  await Promise.all([stands(one.page), stands(other.page)]);
  await until(() => at(one.page) > 0n && at(one.page) === at(other.page), "both pages show one moment");

  await other.page.getByLabel("Pace").selectOption({ label: "0.5 ×" });
  await until(async () => (await one.page.getByLabel("Pace").inputValue()) === "0.5", "the other page shows the pace");
  await pressStrip(other.page, 0.6);
  await until(
    () => at(one.page) === at(other.page) && at(one.page) > first_ns + (last_ns - first_ns) / 2n,
    "the other page shows the place",
  );

  // backwards from there, through a part that was never played here
  const from = at(one.page);
  await one.page.getByLabel("Pace").selectOption({ label: "−5 ×" });
  await one.page.keyboard.press(" ");
  await goesOn(one.page);
  const begun = await place(one.page);
  await until(
    async () => (await place(one.page)) < begun - 2,
    "two seconds back",
    undefined,
    () => elapsed(one.page),
  );
  await one.page.keyboard.press(" ");
  await stands(one.page);
  await until(() => at(one.page) < from - 1_000_000_000n, "time went back");

  // a range in a loop
  await one.page.getByLabel("Pace").selectOption({ label: "2 ×" });
  const box = await one.page.getByLabel("Timeline").boundingBox();
  const x = (share) => box.x + share * box.width;
  await one.page.keyboard.down("Shift");
  await one.page.mouse.move(x(0.2), box.y + 20);
  await one.page.mouse.down();
  await one.page.mouse.move(x(0.24), box.y + 20, { steps: 4 });
  await one.page.mouse.up();
  await one.page.keyboard.up("Shift");
  await one.page.waitForURL(/loop=\d+-\d+/);
  await goesOn(one.page);
  const places = [];
  await until(async () => {
    places.push(await place(one.page));
    return places.some((place, i) => i > 0 && place < places[i - 1]);
  }, "it began again");
  const length = Number(last_ns - first_ns) / 1e9;
  for (const place of places.slice(1)) assert.ok(place > 0.19 * length - 1 && place < 0.25 * length + 1.5, `${places}`);
  await shoot(one.page, "recording-loop");
  await shoot(other.page, "recording-plot");
  await one.page.keyboard.press("o");
  await until(() => !one.page.url().includes("loop="), "no loop any more");

  // to its end, where it pauses
  await one.page.keyboard.press("End");
  await stands(one.page);
  await until(() => at(one.page) === last_ns, "the end");
  assert.deepEqual([...one.problems, ...other.problems], []);
});

test("a picture shows the vision's results for that very picture, and a pixel shows its value and place", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 4 });
  const recorded = readSession(session);
  const server = await play(t, folder, session);
  const { page, problems } = await open(t, `${server.http}/#/14/2/camera?over=none`);
  await page.getByRole("button", { name: "Full" }).click();
  await page.locator("canvas[aria-label='top camera']:not([hidden])").waitFor();
  await page.keyboard.press(" ");
  await stands(page);
  await pressStrip(page, 0.6);
  await until(() => at(page) > 0n, "a moment");
  const overlay = page.getByLabel("Over the top picture");
  const drawn = () => overlay.evaluate((canvas) => canvas.toDataURL());
  const drawings = [await drawn()];
  for (const key of ["h", "l", "d"]) {
    await page.keyboard.press(key);
    await until(async () => (await drawn()) !== drawings.at(-1), `something else after ${key}`);
    drawings.push(await drawn());
  }
  await page.waitForURL((url) => !url.hash.includes("over="));
  assert.equal(
    await page.getByLabel("Size of the field").count(),
    0,
    "the recording names its rules, so nobody is asked",
  );

  // a pixel has the value in the recording at the picture's capture time
  const { schema, messages } = recorded.get("/14/2/camera_top");
  const picture = () => decode(schema.name, schema.data, messages.findLast(({ logTime }) => logTime <= at(page)).data);
  const box = await overlay.boundingBox();
  for (const [x, y] of [
    [200, 200],
    [51, 175],
  ]) {
    const { width, height } = picture();
    await page.mouse.move(box.x + ((x + 0.5) / width) * box.width, box.y + ((y + 0.5) / height) * box.height);
    const told = () => {
      const bytes = Buffer.from(picture().data, "base64"); // of the moment that the page shows now
      const pair = 2 * (y * width + (x & ~1));
      return `pixel ${x}, ${y} · Y ${bytes[2 * (y * width + x)]} U ${bytes[pair + 1]} V ${bytes[pair + 3]}`;
    };
    await until(() => page.getByText(told()).isVisible(), `pixel ${x}, ${y}`);
    await page.getByText(/ground -?\d+\.\d\d m ahead, \d+\.\d\d m (left|right)/).waitFor();
  }
  await shoot(page, "recording-camera");
  assert.deepEqual(problems, []);
});

test("a search finds a condition in the whole recording, also in parts that no page has played; moments get names", async (t) => {
  const { server, topics, first_ns, last_ns } = await game(t);
  const { schema, messages } = topics.get("/14/2/game");
  const states = messages.map(({ logTime, data }) => ({
    logTime,
    state: decode(schema.name, schema.data, data).state,
  }));
  const begins = states
    .filter(({ state }, i) => state === "STATE_PLAYING" && states[i - 1]?.state !== state)
    .map(({ logTime }) => logTime);
  assert.ok(begins.length >= 2 && begins.at(-1) - begins[0] > 20_000_000_000n, "a game with several kick-offs");
  const first = begins[0];
  const { page, problems } = await open(t, `${server.http}/#/14/2/field?at=${first_ns + 100_000_000n}`);
  await stands(page);
  await page.keyboard.press("w");
  const query = page.getByLabel("Find when");
  await query.fill("game.state =");
  await page.getByText("“=” compares nothing").waitFor();
  await query.fill("game.state == playing && pose.x > -9");
  // the page stands at the beginning and has played nothing
  await page.getByText(`${begins.length} times in the whole recording`).waitFor();
  await page.getByText("100 %").waitFor({ state: "hidden" });
  await shoot(page, "find-whole");
  await page.keyboard.press("Escape");
  for (const begin of begins) {
    await page.keyboard.press("Shift+N");
    await until(() => at(page) === begin, `kick-off at ${begin}, not ${at(page)}`);
  }
  await page.keyboard.press("Shift+N");
  assert.ok(at(page) === begins.at(-1) && at(page) < last_ns, "there is no match after the last one");

  // a condition that never holds, and a simple one
  await query.fill("game.state == finished && game.state == playing");
  await page.getByText("never in the whole recording").waitFor();
  await query.fill("game.state == playing");
  await page.getByText(`${begins.length} times in the whole recording`).waitFor();
  await query.press("Escape");
  await page.keyboard.press("Home");
  await until(() => at(page) < first, "the beginning");
  await page.keyboard.press("Shift+N");
  await until(() => at(page) === first, `the first moment of play, ${first}`);

  await page.keyboard.press("b");
  await page.getByLabel("Name", { exact: true }).fill("kick-off; <b>");
  await page.keyboard.press("Enter");
  await page.waitForURL(/marks=\d+~kick-off/);
  await page.keyboard.press("ArrowRight");
  await until(() => at(page) > first, "on");
  await page.keyboard.press("b");
  await page.getByLabel("Name", { exact: true }).nth(1).waitFor();
  await page.keyboard.press("p");
  await until(() => at(page) === first, "back to the mark");
  await shoot(page, "moments");
  const colleague = await open(t, page.url());
  await until(
    async () => (await colleague.page.getByLabel("Name", { exact: true }).first().inputValue()) === "kick-off, <b>",
    "the same mark for a colleague",
  );
  assert.deepEqual([...problems, ...colleague.problems], []);
});

test("a layout is saved as a file and restores the views; another file is refused with a sentence", async (t) => {
  const { server } = await game(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/plot?plot=/14/2/ball.x%20/14/2/pose.y&span=60&at=1`);
  await page.getByText("The moment of this link is not within this recording.").waitFor();
  await page.getByRole("button", { name: "Layout" }).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save as a file" }).click(),
  ]);
  const text = readFileSync(await download.path(), "utf8");
  assert.deepEqual(JSON.parse(text), {
    foresight_layout: 1,
    robot: "14/2",
    view: "plot",
    settings: { plot: "/14/2/ball.x /14/2/pose.y", span: "60" },
  });

  const other = await open(t, `${server.http}/#/14/3/field`);
  const load = async (content) => {
    await other.page
      .getByLabel("Load a file")
      .setInputFiles({ name: "layout.json", mimeType: "application/json", buffer: Buffer.from(content) });
  };
  await other.page.getByRole("button", { name: "Layout" }).click();
  await load("{}");
  await other.page
    .getByRole("alert")
    .getByText("This is no layout: expected 'foresight_layout' to be 1, got nothing.")
    .waitFor();
  await shoot(other.page, "layout");
  await load(text);
  await other.page.getByRole("list", { name: "Lines" }).getByText("/14/2/pose.y").waitFor();
  await until(
    async () => (await other.page.getByLabel("Robot", { exact: true }).inputValue()) === "14/2",
    "the layout's robot",
  );
  assert.deepEqual([...problems, ...other.problems], []);
});

test("a number over another one: belief against truth, and a dot leads to its moment", async (t) => {
  const { server, topics } = await game(t);
  const truth = "distance(pose,truth.ball)";
  const curves = `plot=${truth} /14/2/ball.x&over=${truth}`;
  const { page, problems } = await open(t, `${server.http}/#/14/2/plot?${curves}`);
  const over = page.getByLabel("Over", { exact: true });
  assert.equal(await over.inputValue(), truth);
  const told = page.getByText(/^\d+ pairs of the part that this page has played$/);
  await until(
    async () => parseInt(await told.textContent()) > 100,
    "a hundred pairs",
    undefined,
    () => told.textContent(),
  );
  await page.keyboard.press("Space");
  await stands(page);
  const lines = page.getByRole("list", { name: "Lines" });
  assert.equal(await lines.getByText("no value yet").count(), 0, "a pause does not read the lines anew");
  await shoot(page, "plot-over");

  // a press beside all dots goes nowhere; one on a dot goes to the moment of its message
  const plane = await page.locator("canvas[aria-label=Plot]").boundingBox();
  await until(() => at(page) > 0n, "the moment of the pause");
  const paused = at(page);
  await page.mouse.click(plane.x + 4, plane.y + 4);
  await page.waitForTimeout(400);
  assert.equal(at(page), paused);
  const balls = topics.get("/14/2/ball").messages.map(({ logTime }) => logTime);
  let pressed = 0;
  const around = () => ({
    x: plane.x + plane.width * (0.1 + 0.05 * (pressed % 17)),
    y: plane.y + plane.height * (0.2 + 0.06 * (Math.floor(pressed / 17) % 11)),
  });
  await until(
    async () => {
      const { x, y } = around();
      ++pressed;
      await page.mouse.click(x, y);
      await page.waitForTimeout(50);
      return at(page) !== paused;
    },
    "a dot under the pointer",
    undefined,
    () => `${pressed} places pressed`,
  );
  const moment = at(page);
  const apart = (time) => Math.abs(Number(time - moment));
  assert.ok(Math.min(...balls.map(apart)) < 1_000_000, "the moment of a message of the ball");

  // over time again, and with the horizontal number removed
  await over.selectOption({ label: "time" });
  assert.doesNotMatch(page.url(), /over=/);
  await over.selectOption({ index: 1 });
  await page.getByRole("button", { name: `Remove ${truth}` }).click();
  await over.waitFor({ state: "detached" });
  await told.waitFor({ state: "detached" });
  assert.deepEqual(problems, []);
});
