// Pages with playheads of their own in one recording, and pages that follow the shared playback, in Chromium.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { kPhone, open, shoot } from "./browser.mjs";
import { decode, Live, playbackControl } from "./live.mjs";
import { readSession } from "./mcap.mjs";
import { play, run, synthesize, temporaryFolder, until } from "./support.mjs";

const kSecond = 1_000_000_000n;
const kMostOwn = 16; // playheads of their own at one server

/** A game of a minute and more, played from its begin. */
async function game(t, ...options) {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const rules = "spl2012:2,half_duration=30,ready_duration=5";
  const { status, stderr } = await run("foresight-sim", "match", "--seed", "7", "--rules", rules, "--mcap", file);
  assert.equal(status, 0, stderr);
  return play(t, folder, file, ...options);
}

/** A client that shares the playback: its newest state, and an order to it. */
async function sharer(t, server) {
  const live = await Live.open(t, server, { path: "/?playback" });
  const states = [];
  live.onFrame = (bytes) => {
    if (bytes[0] === 5)
      states.push({ status: bytes[1], time_ns: bytes.readBigUInt64LE(2), id: bytes.subarray(19).toString() });
  };
  let asked = 0;
  const order = async (wish) => {
    const id = `order ${++asked}`;
    live.send(playbackControl({ ...wish, id }));
    return live.until(() => states.find((state) => state.id === id), `the answer to ${id}`);
  };
  return { live, states, order };
}

const at = (page) => BigInt(/[?&]at=(\d+)/.exec(page.url())?.[1] ?? 0);
/** The shown place in the recording [s]. */
async function place(page) {
  const [minutes, seconds] = (await page.getByLabel("Elapsed").textContent()).split(" / ")[0].split(":").map(Number);
  return 60 * minutes + seconds;
}
const goesOn = (page) => page.getByRole("button", { name: "Freeze view" }).waitFor();
const stands = (page) => page.getByRole("button", { name: "Go on" }).waitFor();
async function pressStrip(page, share) {
  const box = await page.getByLabel("Timeline").boundingBox();
  await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
}
/** Waits until the address has a moment that `is` accepts and that stays, and returns it. */
const moment = (page, what, is = (ns) => ns > 0n) =>
  until(
    async () => {
      const seen = at(page);
      if (!is(seen)) return false;
      await sleep(500);
      return at(page) === seen && seen;
    },
    what,
    undefined,
    () => page.url(),
  );

test("each page has a time of its own: one pauses, seeks and steps while the other plays", async (t) => {
  const server = await game(t);
  const shared = await sharer(t, server);
  await shared.order({ play: false });
  const heard = shared.states.length;
  const [one, other] = [await open(t, "about:blank"), await open(t, `${server.http}/#/14/3/plot?plot=/14/2/pose.x`)];
  const events = one.page.waitForResponse(/\/api\/whole\/events/);
  await one.page.goto(`${server.http}/#/14/2/field`);
  await (await events).finished();
  await Promise.all([goesOn(one.page), goesOn(other.page)]); // although the shared playback is paused

  await one.page.keyboard.press("Space");
  await stands(one.page);
  await goesOn(other.page);
  await pressStrip(one.page, 0.7);
  const there = await moment(one.page, "the pressed place");
  await one.page.keyboard.press(".");
  const frame = await moment(one.page, "the next frame", (ns) => ns > there);
  await one.page.keyboard.press("n");
  const event = await moment(one.page, "the next event", (ns) => ns > frame);
  const begun = await place(other.page);
  await until(async () => (await place(other.page)) > begun + 1, "the other page plays on");
  assert.ok((await place(other.page)) < 40 && at(one.page) === event && at(other.page) === 0n);

  // at another speed, and in a loop
  await other.page.getByLabel("Pace").selectOption({ label: "5 ×" });
  await one.page.keyboard.press("[");
  await one.page.keyboard.press("ArrowRight");
  await one.page.keyboard.press("]");
  await one.page.keyboard.press("Space");
  await goesOn(one.page);
  assert.match(one.page.url(), /loop=\d+-\d+/);
  assert.equal(await one.page.getByLabel("Pace").inputValue(), "1");
  await shoot(one.page, "playhead-own");
  await other.page.getByText("ended").waitFor();
  const looped = await place(one.page);
  await goesOn(one.page);
  assert.ok(Math.abs((await place(one.page)) - looped) <= 2, "the loop holds the page");

  assert.equal(shared.states.length, heard, "no page moved the shared playback");
  assert.deepEqual([...one.problems, ...other.problems], []);
});

test("a page that follows is moved by all who follow; a page with its own time is not, and the button changes sides", async (t) => {
  const server = await game(t);
  const shared = await sharer(t, server);
  const { time_ns: begin_ns } = await shared.order({ play: false, to_ns: 0n });
  const follower = await open(t, `${server.http}/#/14/2/field?follow`);
  const own = await open(t, `${server.http}/#/14/2/field?at=${begin_ns + 20n * kSecond}`);
  await stands(own.page);
  await moment(own.page, "the moment of the link", (ns) => ns === begin_ns + 20n * kSecond);

  await shared.order({ play: false, to_ns: begin_ns + 30n * kSecond });
  await moment(follower.page, "the shared place", (ns) => ns === begin_ns + 30n * kSecond);
  assert.equal(at(own.page), begin_ns + 20n * kSecond);
  await shoot(follower.page, "playhead-follows");

  // a control of a follower moves all that follow
  await pressStrip(follower.page, 0.1);
  await until(() => shared.states.at(-1).time_ns < begin_ns + 20n * kSecond, "the shared playback moved");
  assert.equal(at(own.page), begin_ns + 20n * kSecond);

  // the other page joins
  await own.page.getByRole("button", { name: "Follow", exact: true }).click();
  await own.page.waitForURL(/follow=yes/);
  const joined = await moment(own.page, "the shared place", (ns) => ns < begin_ns + 20n * kSecond && ns > 0n);
  await own.page.getByRole("button", { name: "Go on" }).click();
  await Promise.all([goesOn(own.page), goesOn(follower.page)]);

  // and leaves, from where the shared playback is
  await own.page.getByRole("button", { name: "Own time" }).click();
  await own.page.waitForURL((url) => !url.href.includes("follow"));
  await own.page.getByRole("button", { name: "Follow", exact: true }).waitFor();
  await own.page.getByRole("button", { name: "Freeze view" }).click();
  await stands(own.page);
  assert.ok((await moment(own.page, "a moment")) >= joined);
  await goesOn(follower.page);
  const stood = at(own.page);
  await shared.order({ play: false, to_ns: begin_ns + 40n * kSecond });
  await moment(follower.page, "the shared place", (ns) => ns === begin_ns + 40n * kSecond);
  assert.equal(at(own.page), stood);

  // the key does the same
  await own.page.keyboard.press("t");
  await moment(own.page, "the shared place", (ns) => ns === begin_ns + 40n * kSecond);
  await own.page.getByText("nothing is kept here").waitFor({ state: "detached" });
  await own.page.setViewportSize(kPhone);
  await shoot(own.page, "playhead-phone");
  assert.deepEqual([...follower.problems, ...own.problems], []);
});

test("two pages show the pictures of their own moments", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 4 });
  const { schema, messages } = readSession(session).get("/14/2/camera_top");
  const server = await play(t, folder, session);
  const pages = await Promise.all([0.3, 0.8].map(() => open(t, `${server.http}/#/14/2/camera?over=none`)));
  const [x, y] = [51, 175];
  await Promise.all(
    pages.map(async ({ page }, i) => {
      await page.getByRole("button", { name: "Full" }).click();
      await page.locator("canvas[aria-label='top camera']:not([hidden])").waitFor();
      await page.keyboard.press("Space");
      await stands(page);
      await pressStrip(page, [0.3, 0.8][i]);
      const pressed_ns = messages[0].logTime + BigInt([12, 32][i]) * (kSecond / 10n); // of 4 s
      await moment(
        page,
        "the pressed moment",
        (ns) => ns > pressed_ns - kSecond / 2n && ns < pressed_ns + kSecond / 2n,
      );
      await page.keyboard.press("d"); // an overlay, over which pixels are told
    }),
  );
  assert.ok(at(pages[1].page) > at(pages[0].page) + kSecond);
  for (const { page } of pages) {
    const picture = () =>
      decode(schema.name, schema.data, messages.findLast(({ logTime }) => logTime <= at(page)).data);
    const box = await page.getByLabel("Over the top picture").boundingBox();
    const { width, height } = picture();
    await page.mouse.move(box.x + ((x + 0.5) / width) * box.width, box.y + ((y + 0.5) / height) * box.height);
    const told = () => {
      const bytes = Buffer.from(picture().data, "base64");
      const pair = 2 * (y * width + (x & ~1));
      return `pixel ${x}, ${y} · Y ${bytes[2 * (y * width + x)]} U ${bytes[pair + 1]} V ${bytes[pair + 3]}`;
    };
    await until(() => page.getByText(told()).isVisible(), `pixel ${x}, ${y} of the page's own moment`);
  }
  assert.deepEqual([...pages[0].problems, ...pages[1].problems], []);
});

test("a page stays at the pressed moment although the beliefs of its picture arrive later than the picture", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await synthesize(folder, { seconds: 4 }));
  const { page, problems } = await open(t, "about:blank");
  const topics = new Map(); // by channel
  const pictures = new Set(); // subscriptions
  const sought = [];
  const late = []; // sends what is held back, in order
  let holds = false;
  await page.routeWebSocket(/./, (socket) => {
    const behind = socket.connectToServer();
    behind.onMessage((data) => {
      if (typeof data === "string") for (const { id, topic } of JSON.parse(data).channels ?? []) topics.set(id, topic);
      const isBelief = typeof data !== "string" && data[0] === 1 && !pictures.has(data.readUInt32LE(1));
      if (holds && isBelief) late.push(() => socket.send(data));
      else socket.send(data);
    });
    socket.onMessage((data) => {
      if (typeof data === "string")
        for (const { id, channelId } of JSON.parse(data).subscriptions ?? [])
          if (/camera_(top|bottom)/.test(topics.get(channelId)) && !/matrix/.test(topics.get(channelId)))
            pictures.add(id);
      if (typeof data !== "string" && data[0] === 3 && data[6] === 1) sought.push(data.readBigUInt64LE(7));
      behind.send(data);
    });
  });
  await page.goto(`${server.http}/#/14/2/camera`);
  await page.locator("canvas[aria-label='top camera']:not([hidden])").waitFor();
  await page.keyboard.press("Space");
  await stands(page);
  const kPresses = [0.3, 0.8, 0.51, 0.13];
  for (const [i, share] of kPresses.entries()) {
    holds = true;
    await pressStrip(page, share);
    await until(
      () => sought.length > i,
      "the seek",
      undefined,
      () => sought.join(),
    );
    await page.waitForTimeout(250); // the picture is drawn meanwhile
    holds = false;
    for (const send of late.splice(0)) send();
    await moment(page, "the pressed moment", (ns) => ns === sought.at(-1));
  }
  await page.waitForTimeout(500);
  assert.equal(sought.length, kPresses.length, sought.join());
  assert.equal(at(page), sought.at(-1));
  assert.deepEqual(problems, []);
});

test("a playhead of a page's own goes on after a lost connection: place, speed, and whether it plays", async (t) => {
  const server = await game(t);
  const { page } = await open(t, "about:blank", { breaksConnections: true });
  let connection;
  await page.routeWebSocket(/./, (socket) => {
    connection = socket;
    socket.connectToServer();
  });
  await page.goto(`${server.http}/#/14/2/field`);
  await goesOn(page);
  await page.getByLabel("Pace").selectOption({ label: "0.25 ×" });
  const pace = () => page.getByLabel("Pace").inputValue();
  const quarter = (what) => until(async () => (await pace()) === "0.25", what, undefined, pace);
  await quarter("the chosen speed");
  await pressStrip(page, 0.6);
  await moment(page, "the pressed place");
  await page.keyboard.press("Space");
  await goesOn(page);
  await quarter("the speed after the seek");
  const before = await place(page);
  const lose = async () => {
    const lost = connection;
    await lost.close();
    await until(() => connection !== lost, "the next connection");
  };
  await lose();
  await quarter("the speed of the lost playhead");
  await goesOn(page);
  assert.ok(Math.abs((await place(page)) - before) <= 3, `${await place(page)} after ${before}`);

  // paused
  await page.keyboard.press("Space");
  await stands(page);
  const stood = await moment(page, "a moment");
  await lose();
  await page.getByText("The connection to the robot was lost").waitFor({ state: "detached" });
  await stands(page);
  assert.equal(at(page), stood);
});

test("a page beyond the bound on playheads follows, and says so", async (t) => {
  const server = await game(t);
  for (let i = 0; i < kMostOwn; ++i) await Live.open(t, server, { path: "/?playback&playhead=own" });
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await page.getByText(`${kMostOwn} pages have a playhead of their own, and there are no more`).waitFor();
  await page.getByRole("button", { name: "Own time" }).waitFor();
  await shoot(page, "playhead-bound");
  assert.deepEqual(problems, []);
});
