// The page for fingers and for people who cannot see its canvases: large targets, pinch and pan, a legend, words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { playGame, start, temporaryFolder, until } from "./support.mjs";

const kTablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true };

test("on a tablet all targets are at least 44 px high", async (t) => {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7");
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`, kTablet);
  const small = () =>
    [...document.querySelectorAll("button, select, nav a, summary, input:not([type=checkbox], [type=radio])")]
      .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44)
      .map((element) => element.getAttribute("aria-label") ?? element.textContent);
  for (const view of ["field", "objects", "plot", "decision", "what-if", "health", "log", "sessions"]) {
    await page.getByRole("link", { name: view, exact: true }).tap();
    await page
      .getByRole("region", { name: new RegExp(view.replace("-", "."), "i") })
      .first()
      .waitFor();
    assert.deepEqual(await page.evaluate(small), [], view);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), view);
    await shoot(page, `tablet-${view}`);
  }
  assert.deepEqual(problems, []);
});

test("two fingers zoom the time strip and move it; one finger seeks", async (t) => {
  const server = await playGame(t);
  const { page, problems, context } = await open(t, `${server.http}/#/14/2/field`, kTablet);
  const elapsed = async () => {
    const [minutes, seconds] = (await page.getByLabel("Elapsed").textContent()).split("/")[0].trim().split(":");
    return 60 * Number(minutes) + Number(seconds);
  };
  const strip = page.getByLabel("Timeline");
  await page
    .getByLabel("Elapsed")
    .filter({ hasText: /\/ 1:\d\d/ })
    .waitFor();
  const box = await strip.boundingBox();
  const tapAt = (share) => page.touchscreen.tap(box.x + share * box.width, box.y + box.height / 2);
  const paused = page.getByRole("button", { name: "Go on" });
  await tapAt(0.1);
  await paused.waitFor();
  await until(async () => (await elapsed()) < 15, "a moment near the beginning");

  const devtools = await context.newCDPSession(page);
  const touch = (type, ...shares) =>
    devtools.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: shares.map((share, id) => ({ x: box.x + share * box.width, y: box.y + box.height / 2, id })),
    });
  const before = await elapsed();
  await touch("touchStart", 0.45);
  await touch("touchStart", 0.45, 0.55);
  for (const spread of [0.1, 0.2, 0.3, 0.4]) await touch("touchMove", 0.45 - spread, 0.55 + spread);
  await touch("touchEnd");
  assert.equal(await elapsed(), before, "two fingers leave the moment");
  await tapAt(0.02);
  await until(async () => (await elapsed()) > 30, "the left end of the zoomed strip", undefined, elapsed);

  // to later times
  await touch("touchStart", 0.6);
  await touch("touchStart", 0.6, 0.9);
  for (const by of [0.2, 0.4, 0.55]) await touch("touchMove", 0.6 - by, 0.9 - by);
  await touch("touchEnd");
  const left = await elapsed();
  await tapAt(0.02);
  await until(async () => (await elapsed()) > left, "a later left end", undefined, elapsed);
  await shoot(page, "strip-pinched");
  assert.deepEqual(problems, []);
});

test("the field has a legend of its layers, and a text", async (t) => {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7");
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  const field = page.getByRole("img", { name: "The field from above" });
  await field.waitFor();
  const text = () =>
    field.evaluate((canvas) => document.getElementById(canvas.getAttribute("aria-describedby")).textContent);
  await until(
    async () => /The ball is at -?\d\.\d, -?\d\.\d m\. 5\/1 at .*; 14\/4 at /.test(await text()),
    "the places",
    undefined,
    text,
  );
  await page.getByRole("button", { name: "Legend" }).click();
  const legend = page.getByRole("list", { name: "Legend" });
  await legend.getByText("where the camera looks").waitFor();
  await page.getByRole("group", { name: "Layers" }).getByRole("button", { name: "view" }).click();
  await legend.getByText("where the camera looks").waitFor({ state: "detached" });
  await shoot(page, "legend");
  await page.reload();
  await legend.waitFor(); // it stays open
  await page.getByRole("button", { name: "Legend" }).click();
  await legend.waitFor({ state: "detached" });
  assert.deepEqual(problems, []);
});
