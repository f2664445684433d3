// A long recording in the viewer, in Chromium: its events, numbers and decisions are known as a whole, also of parts that
// nobody has played.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { kDesktop, kPhone, open, shoot, shootEach } from "./browser.mjs";
import { play, request, run, synthesize, temporaryFolder, until } from "./support.mjs";

const kSeconds = 1200;

const kPatienceForSummaries_ms = 180_000; // a debug build reads the whole recording on a busy machine

/** A game of ten robots for 20 minutes, recorded: its server, paused at the beginning, and its goals. */
async function longGame(t) {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const { status, stdout, stderr } = await run(
    "foresight-sim",
    "match",
    "--seed",
    "3",
    "--rules",
    "spl2025:5",
    "--seconds",
    String(kSeconds),
    "--json",
    "--mcap",
    file,
  );
  assert.equal(status, 0, stderr);
  const { events } = JSON.parse(stdout);
  const goals = events.filter(({ kind }) => kind === "goal").map(({ tick }) => tick / 30);
  assert.ok(goals.length > 1, "the game has goals");
  return { server: await play(t, folder, file), goals };
}

/** "12:34" in seconds. */
const seconds = (text) => text.split(":").reduce((sum, part) => 60 * sum + Number(part), 0);
const elapsed = async (page) => seconds((await page.getByLabel("Elapsed").textContent()).split(" / ")[0]);
const near = (one, other, by) => Math.abs(one - other) <= by;

/** The events of the list: [{at, text}], at in seconds. */
async function listed(page) {
  const rows = await page.getByRole("list", { name: "Events" }).getByRole("button").allTextContents();
  return rows.map((row) => {
    const [, at, text] = /^\s*([\d:]+)\s+(.*?)\s*$/s.exec(row);
    return { at: seconds(at), text };
  });
}

/**
 * Counts the pixels of a canvas in `parts` columns of equal width: those that are drawn, or those of roughly `colour`.
 */
const drawnIn = (canvas, parts, colour) =>
  canvas.evaluate(
    (element, { parts, colour }) => {
      const { width, height } = element;
      const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(element, 0, 0);
      const { data } = copy.getImageData(0, 0, width, height);
      const counts = Array(parts).fill(0);
      for (let i = 0; i < width * height; ++i)
        if (colour ? colour.every((value, c) => Math.abs(data[4 * i + c] - value) < 24) : data[4 * i + 3] > 0)
          ++counts[Math.floor((parts * (i % width)) / width)];
      return counts;
    },
    { parts, colour },
  );
const kFirstLine = [0x00, 0x7a, 0xad]; // in the light theme: src/draw/plot.ts

test("all events of a long recording are listed before it is played; n and p and a click reach each", async (t) => {
  const { server, goals } = await longGame(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await page.keyboard.press("Space");
  await page.getByRole("button", { name: "Find moments" }).click();
  await page.getByRole("list", { name: "Events" }).waitFor();
  const events = await listed(page);
  const found = events.filter(({ text }) => text.startsWith("goal of"));
  assert.equal(found.length, goals.length, JSON.stringify(found));
  for (const [i, { at }] of found.entries()) assert.ok(near(at, goals[i], 20), `goal ${at} of ${goals}`);
  for (const kind of ["kick long", "falls", "penalised", "playing"])
    assert.ok(
      events.some(({ text, at }) => text.includes(kind) && at > kSeconds / 2),
      `${kind} in the second half`,
    );
  assert.ok((await elapsed(page)) < kSeconds / 4, "before it is played");
  assert.deepEqual(
    events.map(({ at }) => at),
    events.map(({ at }) => at).sort((a, b) => a - b),
  );

  // the strip shows marks up to the end
  const marks = await drawnIn(page.getByLabel("Timeline"), 20);
  assert.ok(marks.every((count) => count > 0));
  await shoot(page, "whole-events");

  // a click goes there; p and n go on from there to the neighbours
  const last = events.findLastIndex(({ text }) => text.startsWith("goal of"));
  const row = (i) => page.getByRole("list", { name: "Events" }).getByRole("button").nth(i);
  await row(last).click();
  await until(async () => near(await elapsed(page), events[last].at, 1), "the last goal");
  await page.locator("body").press("p");
  const before = events.findLast(({ at }) => at < events[last].at);
  await until(async () => near(await elapsed(page), before.at, 1), `the event before it, at ${before.at}`);
  await page.locator("body").press("n");
  await until(async () => near(await elapsed(page), events[last].at, 1), "the last goal again");
  await until(async () => (await row(last).getAttribute("aria-current")) === "true", "the last goal is marked");
  await page.getByLabel("Timeline").click({ position: { x: 2, y: 10 } });
  await until(async () => (await elapsed(page)) < 30, "the beginning");
  for (let i = 0; i < 2 * events.length && (await elapsed(page)) < events[last].at; ++i) {
    const from = await page.locator('footer [aria-label="Moment"]').textContent();
    await page.locator("body").press("n");
    await until(
      async () => (await page.locator('footer [aria-label="Moment"]').textContent()) !== from,
      `the event after ${from}`,
    );
  }
  assert.ok(near(await elapsed(page), events[last].at, 1), `n reaches the last goal, not ${await elapsed(page)}`);

  // kinds can be left out of the list
  await page.getByRole("group", { name: "Kinds of events" }).getByText(/kicks/).click();
  await until(
    async () => !(await listed(page)).some(({ text }) => /^kick .*\d\/\d+$/s.test(text)),
    "no kicks of robots in the list",
  );
  assert.deepEqual(problems, []);
});

test("a plot and the decisions show the whole recording at once; what is not loaded is hatched", async (t) => {
  const { server } = await longGame(t);
  const { page, problems } = await open(t, "about:blank");
  // the summaries come when the test says so
  let release;
  const released = new Promise((done) => (release = done));
  const asked = [];
  await page.route(/\/api\/whole\/(numbers|runs)/, async (route) => {
    asked.push(new URL(route.request().url()).searchParams);
    await released;
    await route.continue();
  });
  await page.goto(`${server.http}/#/14/2/plot?plot=/14/2/ball.x%20/14/2/pose.x`);
  const canvas = page.locator("canvas[aria-label=Plot]");
  await canvas.waitFor();
  await page.keyboard.press("Space");
  await page.getByText("summarising the recording…").waitFor();
  const hatched = await drawnIn(canvas, 10);
  await shoot(page, "whole-plot-unloaded");
  release();
  await until(
    async () => (await drawnIn(canvas, 12, kFirstLine)).slice(1, 11).filter((count) => count > 0).length >= 8,
    "a line from the beginning to the end",
    kPatienceForSummaries_ms,
  );
  await page.getByText("summarising the recording…").waitFor({ state: "detached" });
  const whole = await drawnIn(canvas, 10);
  assert.ok(hatched[8] > 0 && whole[8] > 0);
  assert.ok((await elapsed(page)) < kSeconds / 4, "before it is played");
  await shoot(page, "whole-plot");

  // the value under the pointer is known where nothing was played
  const box = await canvas.boundingBox();
  const value = page.getByRole("list", { name: "Lines" }).locator(".number").first();
  const line = (await drawnIn(canvas, 100, kFirstLine)).findLastIndex((count) => count > 0);
  assert.ok(line > 70, `a line up to ${line} %`);
  await page.mouse.move(box.x + (line / 100) * box.width, box.y + box.height / 2);
  await until(async () => /^-?[\d.]+ m$/.test((await value.textContent()).trim()), "a value late in the recording");

  // the wheel zooms about the pointer, and the server refines
  const before = asked.length;
  for (let i = 0; i < 12; ++i) await page.mouse.wheel(0, -200);
  await until(() => asked.length > before, "a finer summary");
  const finer = asked.at(-1);
  assert.ok(Number(BigInt(finer.get("to")) - BigInt(finer.get("from"))) / 1e9 < kSeconds / 2);
  await until(async () => (await drawnIn(canvas, 12, kFirstLine)).some((count) => count > 0), "the finer line");
  await shoot(page, "whole-plot-zoomed");
  await canvas.dblclick();
  await until(() => !/span=/.test(page.url()), "the whole again");

  // an expression is hatched outside the part that was played: no server summarises it
  await page.goto(`${server.http}/#/14/2/plot?plot=/14/2/ball.x%20distance(ball,truth.ball)`);
  await until(async () => (await drawnIn(canvas, 12, kFirstLine))[9] > 0, "the line of a number");
  const below = (part) => part.slice(Math.floor(0.7 * part.length));
  await until(async () => below(await drawnIn(canvas, 100)).every((count) => count > 4), "hatching up to the end");
  await page.mouse.move(box.x + 0.9 * box.width, box.y + box.height / 2);
  const values = page.getByRole("list", { name: "Lines" }).locator(".number");
  await until(async () => (await values.nth(1).textContent()).trim() === "not loaded here", "the reason");
  await shootEach(page, "whole-plot-hatched");
  await page.setViewportSize(kDesktop);
  await page.emulateMedia({ colorScheme: "light" });
  // a played part is drawn
  await page.mouse.move(0, 0);
  await page.locator("body").press("Space");
  await until(async () => /^[\d.]+ m$/.test((await values.nth(1).textContent()).trim()), "a distance");
  await page.locator("body").press("Space");

  // an enum is summarised, too
  await page.goto(`${server.http}/#/14/2/plot?plot=/14/2/game.state`);
  await until(async () => (await drawnIn(canvas, 12, kFirstLine))[9] > 0, "the line of the states");
  await page.mouse.move(box.x + 0.9 * box.width, box.y + box.height / 2);
  await until(async () => (await values.first().textContent()).trim() === "playing", "a state by name");
  await shoot(page, "whole-plot-states");

  // decisions
  await page.goto(`${server.http}/#/14/2/decision`);
  const strip = page.getByLabel("The agent's skills over time");
  await strip.waitFor();
  await until(
    async () => (await page.getByRole("list", { name: "Skills" }).getByRole("listitem").count()) > 3,
    "the skills of the whole recording",
  );
  await shoot(page, "whole-decision");
  const { width } = await strip.boundingBox();
  await strip.click({ position: { x: 0.75 * width, y: 12 } }); // waits until the tree above it has grown
  await until(async () => near(await elapsed(page), 0.75 * kSeconds, 5), "the moment that was pressed");
  assert.deepEqual(problems, []);
});

test("a phone shows the events and the whole plot", async (t) => {
  const { server } = await longGame(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/plot?plot=/14/2/ball.x`, {
    viewport: kPhone,
    hasTouch: true,
  });
  await page.getByRole("button", { name: "Find moments" }).click();
  await page.getByRole("list", { name: "Events" }).waitFor();
  const canvas = page.locator("canvas[aria-label=Plot]");
  await until(async () => (await drawnIn(canvas, 12, kFirstLine))[9] > 0, "the line near the end");
  await shoot(page, "whole-phone");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
  assert.deepEqual(problems, []);
});

test("two plots side by side have finer summaries of their own", async (t) => {
  const { server } = await longGame(t);
  const address = "#/14/2/plot?panes=row(plot,plot)&plot=/14/2/ball.x&span=30&2.plot=/14/2/pose.x&2.span=120";
  const { page, problems } = await open(t, "about:blank");
  const answered = { 30: 0, 120: 0 };
  page.on("requestfinished", (request) => {
    const { pathname, searchParams: asked } = new URL(request.url());
    if (pathname !== "/api/whole/numbers") return;
    // a view and as much on each side of it, as far as the recording goes
    const length = Number(BigInt(asked.get("to")) - BigInt(asked.get("from"))) / 1e9;
    for (const span of [30, 120]) if (length >= span && length <= 3 * span + 1) ++answered[span];
  });
  await page.goto(`${server.http}/${address}`);
  const canvases = page.locator("canvas[aria-label=Plot]");
  await until(async () => (await canvases.count()) === 2, "two plots");
  await page.keyboard.press("Space");
  await until(
    () => answered[30] > 0 && answered[120] > 0,
    "both answers",
    undefined,
    () => answered,
  );
  for (const i of [0, 1])
    await until(async () => (await drawnIn(canvases.nth(i), 12, kFirstLine)).some((count) => count > 0), `line ${i}`);
  await shoot(page, "whole-panes");
  assert.deepEqual(problems, []);
});

test("after another session is watched, its events are known", async (t) => {
  const folder = temporaryFolder(t);
  const first = await synthesize(folder, { name: "first", seconds: 20 });
  const made = await run("foresight-lab", "synthesize", join(folder, "second"), "--seconds", "8", "--robot", "14/3");
  assert.equal(made.status, 0, made.stderr);
  const server = await play(t, folder, first);
  const { page } = await open(t, `${server.http}/#/14/2/field`, { breaksConnections: true });
  await page.getByRole("button", { name: "Find moments" }).click();
  const names = async () => (await listed(page)).map(({ text }) => text);
  await until(
    async () => (await names()).includes("goal of team 14"),
    "the goal of the first session",
    undefined,
    names,
  );
  const choose = (view) =>
    page
      .getByRole("link", { name: new RegExp(`^${view}$`, "i") })
      .or(page.getByRole("button", { name: view, exact: true }))
      .click();
  await choose("Sessions");
  await page.getByRole("article").filter({ hasText: "robot 14/3" }).getByRole("button", { name: "Watch" }).click();
  await page.getByText("Robot 14/3").first().waitFor();
  await choose("Field");
  await until(
    async () => (await names()).join() === "ready,set,playing",
    "the events of the second session",
    undefined,
    names,
  );
});

test("a wrong question about a recording gets one sentence", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const { status } = await run("foresight-sim", "match", "--rules", "spl2012:2,half_duration=30", "--mcap", file);
  assert.equal(status, 0);
  const server = await play(t, folder, file);
  for (const [path, sentence] of [
    ["numbers", /expected 1 to 16 fields/],
    ["numbers?fields=/14/2/ball.x&intervals=0", /expected 1 to 4096 intervals, got 0/],
    ["numbers?fields=/14/2/ball.x&from=7&to=6", /expected 'from' before 'to'/],
    ["numbers?fields=/9/9/ball.x", /expected a field of a topic that is played, got '\/9\/9\/ball.x'/],
    ["runs?topic=/9/9/ball&fields=x", /topic '\/9\/9\/ball' is not played/],
  ]) {
    const answer = await request(server, `/api/whole/${path}`);
    const said = String(answer.body);
    assert.deepEqual([answer.status, sentence.test(said)], [400, true], said);
    assert.equal(said.trim().split("\n").length, 1);
  }
});
