// The viewer in use, in Chromium: looking back while the robot continues, several servers in one page, keys, phone, and its cost.
// Each view is tried on a simulated game and on a recorded one.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { kPhone, open, shoot } from "./browser.mjs";
import { framesOf } from "./frames.mjs";
import { Live } from "./live.mjs";
import { playGame, start, synthesize, temporaryFolder, until, within } from "./support.mjs";

const simulate = (t, folder, ...args) => start(t, folder, "foresight-robot", "--body", "sim", "--loop", ...args);
const simulated = (t, ...args) => simulate(t, temporaryFolder(t), "--seed", "7", ...args);
/** A simulated game that is past its kick-off, at its own speed. */
async function playing(t, ...args) {
  const server = await simulated(t, ...args);
  const live = await Live.open(t, server);
  await live.call("/sim/speed", { speed: 50 });
  await until(async () => (await live.call("/sim/state")).seconds > 60, "play");
  await live.call("/sim/speed", { speed: 1 });
  return { server, live };
}

const at = (page) => BigInt(/[?&]at=(\d+)/.exec(page.url())?.[1] ?? 0);
const footer = (page) => page.locator("footer");
const isLive = (page) => footer(page).getByText("● live").waitFor();
/** Returns a hash of the picture on a canvas. */
const pictureOf = async (locator) =>
  createHash("sha1")
    .update(await locator.screenshot())
    .digest("hex");
const field = (page) => page.getByLabel("The field from above");
const paused = (page) => footer(page).getByRole("button", { name: "Go on" }).waitFor();
/** Waits until the game has gone on for `seconds`; it plays 30 ticks a second. */
async function goneOn(live, seconds) {
  const { tick } = await live.call("/sim/state");
  await until(async () => (await live.call("/sim/state")).tick >= tick + 30 * seconds, `${seconds} s of the game`);
}
const row = (page, name) =>
  page
    .getByRole("treeitem")
    .filter({ has: page.locator(".name", { hasText: new RegExp(`^\\s*[▾▸]?${name}\\s*$`) }) })
    .first();

test("a page can be paused while the robot continues; its address leads to the same moment", async (t) => {
  const { server, live } = await playing(t);
  await live.subscribe("/truth/world", "/sim/state");
  const { page, problems } = await open(
    t,
    `${server.http}/#/14/4/field?layers=truth,belief,error,uncertainty,view,intent,trail,names`,
    { colorScheme: "dark" },
  );
  await field(page).waitFor();
  await isLive(page);
  await goneOn(live, 6); // the page's history is longer than the steps back below
  await shoot(page, "picture"); // viewer-web/picture.png
  await page.keyboard.press(" ");
  await paused(page);
  await page.waitForURL(/at=\d+/);
  const moment = at(page);
  const goesOn = async () => {
    const came = live.messages.get("/sim/state").length;
    await until(() => live.messages.get("/sim/state").length > came + 20, "the robot goes on");
  };
  // a busy browser first draws earlier messages
  const still = await until(async () => {
    const picture = await pictureOf(field(page));
    await goesOn();
    return (await pictureOf(field(page))) === picture && picture;
  }, "a picture that stands");
  await goesOn();
  assert.equal(await pictureOf(field(page)), still, "nothing moves on the field");
  assert.equal(at(page), moment);

  // by keys: a frame back, a second back, to the oldest, to now
  await page.keyboard.press(",");
  await until(() => at(page) < moment, "a frame back");
  // a busy page lacks some frames; the step is shorter than the other key's second
  assert.ok(moment - at(page) < 900_000_000n, `expected a frame back, went ${moment - at(page)} ns`);
  const before = at(page);
  await page.keyboard.press(".");
  await until(() => at(page) > before, "a frame on");
  await page.keyboard.press("ArrowLeft");
  await until(() => at(page) < before - 500_000_000n, "a second back");

  // the tree shows the newest value at that moment
  const shown = at(page);
  await page.keyboard.press("3");
  await page.getByRole("region", { name: "Objects" }).waitFor();
  await page.getByRole("searchbox").fill("sim/state tick");
  const then = live.messages.get("/sim/state").findLast(({ log_ns }) => log_ns <= shown);
  const { tick } = live.decoded("/sim/state", then);
  await until(
    async () => Number(await row(page, "tick").locator(".value > span").first().textContent()) === tick,
    `tick ${tick} in the tree`,
  );

  await page.getByRole("link", { name: "field", exact: true }).click();
  await shoot(page, "field-past");
  await page.keyboard.press("Home");
  await until(() => at(page) < shown - 300_000_000n, "the oldest moment");
  await page.keyboard.press(" ");
  await until(() => footer(page).getByRole("button", { name: "Freeze view" }).isVisible(), "playing on from there");
  await page.keyboard.press("End");
  await isLive(page);
  assert.equal(at(page), 0n);
  assert.deepEqual(problems, []);
});

test("the timeline is scrubbed with the pointer and zoomed with the wheel", async (t) => {
  const { server, live } = await playing(t);
  const { page, problems } = await open(t, server.http);
  await isLive(page);
  await goneOn(live, 3); // the strip's length
  const box = await page.getByLabel("Timeline").boundingBox();
  const middle = box.y + box.height / 2;
  await page.mouse.move(box.x + 0.5 * box.width, middle);
  await page.mouse.down();
  await page.waitForURL(/at=\d+/);
  const first = at(page);
  await page.mouse.move(box.x + 0.8 * box.width, middle, { steps: 5 });
  await until(() => at(page) > first + 100_000_000n, "the moment follows the pointer");
  await page.mouse.up();
  await page.mouse.wheel(0, -600);
  await shoot(page, "timeline-zoomed");
  assert.deepEqual(problems, []);
});

test("a page shows several servers, added by address, and connects again to one that was lost", async (t) => {
  const { server } = await playing(t);
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { seconds: 4 });
  const replay = (...args) =>
    start(
      t,
      folder,
      "foresight-robot",
      "--body",
      "replay",
      "--session",
      session,
      "--loop",
      "--team",
      "21",
      "--player",
      "3",
      ...args,
    );
  const other = await replay();
  const { page, problems } = await open(t, server.http, { breaksConnections: true });
  await isLive(page);
  await page.getByRole("button", { name: "Robots and servers" }).click();
  await page.getByLabel("Address of a robot").fill("no address");
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await page.getByText("Expected host or host:port").waitFor();
  await page.getByLabel("Address of a robot").fill(`http://localhost:${other.port}/?token=abc#/x`);
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await page.getByRole("dialog").getByRole("button", { name: "21/3", exact: true }).click();
  await page.waitForURL((url) => url.hash.startsWith(`#/21/3@localhost:${other.port}/`));
  assert.ok(!page.url().includes("abc"), "a token is in no address");
  await shoot(page, "robots");
  await page.keyboard.press("Escape");

  // a link shows a colleague the same robots
  const colleague = await open(t, page.url());
  await colleague.page.getByLabel("Robot", { exact: true }).getByText("Robot 21/3").waitFor({ state: "attached" });

  await page.getByRole("link", { name: "health", exact: true }).click();
  const rate = async () =>
    Number(
      (
        await page
          .getByRole("row")
          .filter({ has: page.getByRole("rowheader", { name: "joints", exact: true }) })
          .locator("td.number")
          .first()
          .textContent()
      ).split(" ")[0],
    );
  await until(async () => (await rate()) > 50, "joints of the other server");
  other.kill("SIGKILL");
  await within(other.ended, "the end");
  await page
    .getByRole("alert")
    .filter({ hasText: `Trying localhost:${other.port} again` })
    .waitFor();
  await replay("--port", String(other.port));
  const back = performance.now();
  await page.getByRole("alert").waitFor({ state: "detached" });
  await until(async () => (await rate()) > 10, "joints again");
  t.diagnostic(`data came again ${((performance.now() - back) / 1000).toFixed(2)} s after the robot did`);

  await page.getByRole("button", { name: "Robots and servers" }).click();
  await page.getByRole("button", { name: `Stop watching localhost:${other.port}` }).click();
  await until(() => !page.url().includes("with="), "it is out of the address");
  assert.deepEqual(
    [...problems, ...colleague.problems].filter((text) => !/WebSocket|REFUSED/.test(text)),
    [],
  );
});

for (const [what, serve] of [
  ["a simulated game", async (t) => (await playing(t)).server],
  ["a recorded game", playGame],
])
  test(`field, plot and decision show ${what}`, async (t) => {
    const server = await serve(t);
    const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
    const name = what.replaceAll(" ", "-");
    await field(page).waitFor();
    await until(
      async () => (await page.title()).includes("14/2"),
      "the robot",
      undefined,
      () => page.title(),
    );

    // the field: layers change it, hovering shows details
    const empty = async () => (await page.getByText(/is at x|believes x/).count()) === 0;
    const layer = page.getByRole("group", { name: "Layers" }).getByRole("button", { name: "names" });
    await layer.click();
    await page.waitForURL(/layers=[^&]*names/);
    await page.keyboard.press("f");
    await page.waitForURL(/follow=yes/);
    let moves = 0;
    await until(async () => {
      const box = await field(page).boundingBox();
      await page.mouse.move(box.x + box.width / 2 + (++moves % 2), box.y + box.height / 2); // a move asks again what is under the pointer
      return !(await empty());
    }, "what is under the pointer");
    await shoot(page, `field-${name}`);
    await page.keyboard.press("f");
    await page.keyboard.press("0");

    // plot: by search, and by dragging from the tree
    await page.getByRole("link", { name: "plot", exact: true }).click();
    await page.getByLabel("Add a number").fill("pose truth");
    await page
      .getByRole("listbox", { name: "Numbers that fit" })
      .getByRole("option", { name: "/14/2/pose~truth" })
      .click();
    await page.waitForURL(/plot=\/14\/2\/pose~truth/);
    await row(page, "pose").click();
    const number = row(page, "y");
    await number.dragTo(page.getByLabel("Plot", { exact: true }).last());
    await page.getByRole("list", { name: "Lines" }).getByText("/14/2/pose.y").waitFor();
    await page.getByLabel("Add a number").hover(); // at the pointer's time there may be no value yet
    await until(
      async () => /\d m/.test(await page.getByRole("list", { name: "Lines" }).locator("li").nth(1).textContent()),
      "a value with its unit",
    );
    await until(
      async () => {
        const plane = await page.locator("canvas[aria-label=Plot]").boundingBox();
        await page.mouse.click(plane.x + plane.width - 60, plane.y + 100);
        return until(() => at(page) > 0n, "a moment after this click", 3000).catch(() => false);
      },
      "the moment under the pointer",
      undefined,
      () => page.url(),
    );
    await paused(page);
    await shoot(page, `plot-${name}`);
    await page.keyboard.press(serve === playGame ? " " : "End");

    // decision: the taken path is lit, and a leaf gives the reason why it was not taken
    await page.getByRole("link", { name: "decision", exact: true }).click();
    const tree = page.getByRole("list", { name: "Decision tree" });
    await until(async () => (await tree.locator("li.lit").count()) > 0, "a way");
    await until(async () => (await tree.locator("li.leaf").count()) > 0, "a leaf");
    await page.keyboard.press(" ");
    await tree.locator("li .name").last().click();
    await page
      .getByRole("status")
      .filter({ hasText: /hold|on the taken path|decision reached/ })
      .first()
      .waitFor();
    await shoot(page, `decision-${name}`);
    assert.deepEqual(problems, []);
  });

test("? lists the keys, numbers open views, and typing in a field triggers no key", async (t) => {
  const { server } = await playing(t);
  const { page, problems } = await open(t, server.http);
  await isLive(page);
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keys" }).waitFor();
  await shoot(page, "keys");
  await page.keyboard.press("Escape");
  await page.getByRole("dialog", { name: "Keys" }).waitFor({ state: "detached" });
  for (const [key, view] of [
    ["7", "Health"],
    ["6", "What-if"],
    ["5", "Decision"],
    ["8", "Log"],
    ["4", "Plot"],
    ["3", "Objects"],
  ]) {
    await page.keyboard.press(key);
    await page.getByRole("region", { name: view, exact: true }).waitFor();
  }
  // a key that comes before the closed dialog has lost the focus
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keys" }).waitFor();
  await page.evaluate(() => {
    const dialog = document.querySelector("dialog");
    dialog.close();
    dialog.querySelector("button").dispatchEvent(new KeyboardEvent("keydown", { key: "1", bubbles: true }));
  });
  await page.getByRole("region", { name: "Field", exact: true }).waitFor();
  // a setting that changes before the page hears of a link that was followed
  await page.evaluate(() => {
    const named = (selector, name) =>
      [...document.querySelectorAll(selector)].find(({ textContent }) => textContent.trim() === name);
    const layer = named("button", "names");
    named("nav a", "objects").click();
    layer.click();
  });
  await page.waitForURL(/objects\?.*layers=[^&]*names/);
  await page.getByRole("region", { name: "Objects", exact: true }).waitFor();
  const robot = await page.getByLabel("Robot", { exact: true }).inputValue();
  await page.keyboard.press("j");
  await until(async () => (await page.getByLabel("Robot", { exact: true }).inputValue()) !== robot, "the next robot");
  await page.getByRole("searchbox").fill("1 , . [ ?");
  await page.keyboard.type(" 2");
  await page.getByRole("region", { name: "Objects" }).waitFor();
  await isLive(page);
  assert.deepEqual(problems, []);
});

test("a phone shows field and health of a game, dark and light", async (t) => {
  const { server } = await playing(t);
  for (const colorScheme of ["dark", "light"]) {
    const { page, problems } = await open(t, `${server.http}/#/14/2/field`, {
      viewport: kPhone,
      hasTouch: true,
      isMobile: true,
      deviceScaleFactor: 2,
      colorScheme,
    });
    await isLive(page);
    let box;
    await until(
      async () => (box = await field(page).boundingBox()) && box.height > 1.2 * box.width,
      "the field stands upright",
      undefined,
      () => box,
    );
    await shoot(page, `phone-field-${colorScheme}`);
    await page.getByRole("button", { name: "Layers" }).tap();
    await page.getByRole("button", { name: "everyone" }).tap();
    await page.waitForURL(/everyone/);
    await page.getByRole("link", { name: "health", exact: true }).tap();
    await page.getByText("Page draws").waitFor();
    await page.getByText("CPU").waitFor();
    await shoot(page, `phone-health-${colorScheme}`);
    assert.deepEqual(problems, []);
  }
});

test("the first load takes at most 150 kB, and a game of eight robots is drawn with 25 frames/s and an age below 500 ms", async (t) => {
  const { server } = await playing(t);
  const { page, problems } = await open(t, "about:blank");
  const bodies = [];
  page.on(
    "response",
    // the page itself; the last minutes of its objects come after it
    (response) =>
      response.url().startsWith(server.http) &&
      !response.url().includes("/api/") &&
      bodies.push(response.body().catch(() => Buffer.alloc(0))),
  );
  await page.goto(
    `${server.http}/#/14/2/field?layers=truth,belief,error,uncertainty,view,intent,team,trail,names,everyone`,
  );
  await isLive(page);
  const sizes = (await Promise.all(bodies)).map((body) => gzipSync(body, { level: 9 }).length);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  t.diagnostic(`first screen: ${(total / 1000).toFixed(1)} kB gzip in ${sizes.length} files`);
  assert.ok(total <= 150_000);

  // other programs may take the processor for a while, so a page may fail in some spans; tests/bench measures the budget
  const rates = async () => {
    const frames = await framesOf(page, 5);
    return [0.5, 0.95].map((share) => 1000 / frames[Math.floor(share * frames.length)]);
  };
  let median, p95;
  await until(
    async () => ([median, p95] = await rates()) && median > 25,
    "more than 25 frames/s",
    undefined,
    () => median,
  );
  t.diagnostic(`all layers of eight robots: ${median.toFixed(0)} frames/s median, ${p95.toFixed(0)} at p95`);

  await page.getByRole("link", { name: "health", exact: true }).click();
  const age = async () =>
    /^(\d+) ms$/.exec(
      await page
        .getByRole("row")
        .filter({ has: page.getByRole("rowheader", { name: "pose", exact: true }) })
        .locator("td")
        .nth(2)
        .textContent(),
    )?.[1];
  const sorted = async () => {
    const ages = [];
    for (let i = 0; i < 20; ++i) {
      const text = await age();
      if (text) ages.push(Number(text));
      await page.waitForTimeout(130); // between two samples
    }
    return ages.sort((a, b) => a - b);
  };
  let ages;
  await until(
    async () => (ages = await sorted())[10] < 500,
    "a median age below 500 ms",
    undefined,
    () => ages,
  );
  t.diagnostic(`age of a pose: median ${ages[10]} ms, p95 ${ages.at(-2)} ms`);
  assert.deepEqual(problems, []);
});
