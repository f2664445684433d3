// The language of Find and Plot, typed by a person: completion, marked mistakes, belief against truth, any robot.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { kPhone, open, shoot } from "./browser.mjs";
import { decode } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { play, run, temporaryFolder, until } from "./support.mjs";

/** Serves a short recorded game. `topics`: its messages. */
async function game(t) {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const rules = "spl2012:2,half_duration=30,ready_duration=5";
  const { status, stderr } = await run("foresight-sim", "match", "--seed", "7", "--rules", rules, "--mcap", file);
  assert.equal(status, 0, stderr);
  const { topics } = readStreamed(readFileSync(file));
  return { server: await play(t, folder, file), topics };
}

/** Returns the capture times at which `holds` becomes true. It gets the newest message of each topic, or undefined. */
function beginsOf(topics, names, holds) {
  const messages = names.flatMap((name) => {
    const { schema, messages } = topics.get(name);
    return messages.map(({ logTime, data }) => ({ name, logTime, fields: decode(schema.name, schema.data, data) }));
  });
  messages.sort((a, b) => (a.logTime < b.logTime ? -1 : a.logTime > b.logTime ? 1 : 0));
  const newest = {};
  const begins = [];
  let held = false;
  for (const [i, { name, logTime, fields }] of messages.entries()) {
    newest[name] = fields;
    if (messages[i + 1]?.logTime === logTime) continue;
    const holding = holds(...names.map((one) => newest[one]));
    if (holding && !held) begins.push(logTime);
    held = holding;
  }
  return begins;
}

const at = (page) => BigInt(/[?&]at=(\d+)/.exec(page.url())?.[1] ?? 0);
const query = (page) => page.getByLabel("Find when");
const option = (page, name) => page.getByRole("option").filter({ has: page.getByText(name, { exact: true }) });
const setting = (page, name) => new URLSearchParams(page.url().split("#")[1].split("?")[1]).get(name);

test("a person types a condition with completion, and finds when a belief was wrong", async (t) => {
  const { server, topics } = await game(t);
  const names = ["/14/2/ball", "/14/2/pose", "/14/2/game", "/truth/world"];
  const begins = beginsOf(topics, names, (ball, pose, state, world) => {
    const truth = world?.ball;
    if (!ball || !pose || !truth) return false;
    const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
    const sign = state?.attacks_positive_x === false ? -1 : 1;
    const x = sign * (pose.x + cos * ball.x - sin * ball.y) - truth.x;
    const y = sign * (pose.y + sin * ball.x + cos * ball.y) - truth.y;
    return Math.hypot(x, y) > 0.5;
  });
  assert.ok(begins.length > 3, `${begins.length} wrong beliefs are no test`);

  const first = topics.get("/truth/world").messages[0].logTime;
  const { page, problems } = await open(t, `${server.http}/#/14/2/field?at=${first}`);
  await page.getByRole("button", { name: "Go on" }).waitFor();
  await page.keyboard.press("w");
  await query(page).pressSequentially("dis");
  await option(page, "distance(a, b)").waitFor();
  await query(page).press("Tab");
  await until(async () => (await query(page).inputValue()) === "distance(", "the function");
  await query(page).pressSequentially("ba");
  await option(page, "ball").waitFor();
  await shoot(page, "language-completion");
  await option(page, "ball").click();
  await until(async () => (await query(page).inputValue()) === "distance(ball", "the object");
  await query(page).pressSequentially(", truth.b");
  await option(page, "ball").waitFor();
  await query(page).press("ArrowDown");
  await query(page).press("Enter");
  await until(async () => (await query(page).inputValue()) === "distance(ball, truth.ball", "the field");
  await page.getByText("A bracket is not closed.").waitFor();
  await query(page).pressSequentially(") > 0.5");
  await page.getByText(`${begins.length} times in the whole recording`).waitFor();
  await shoot(page, "language-found");
  await page.keyboard.press("Escape");
  for (const begin of begins.slice(0, 3)) {
    await page.keyboard.press("Shift+N");
    await until(() => at(page) === begin, `the wrong belief at ${begin}, not ${at(page)}`);
  }

  // a breakpoint: time stops where the belief becomes wrong again
  await page.getByLabel("stop there").check();
  await page.waitForURL(/stop=yes/);
  await page.locator("footer").getByRole("button", { name: "Go on" }).click();
  await until(() => at(page) === begins[3], `time to stop at ${begins[3]}, not ${at(page)}`);
  await page.getByRole("button", { name: "Go on" }).waitFor();
  await shoot(page, "language-stopped");
  await page.getByLabel("stop there").uncheck();

  // any robot, and a word of an enum
  const robots = [...topics.keys()].filter((name) => /^\/\d+\/\d+\/ball$/.test(name));
  assert.ok(robots.length > 2);
  const far = beginsOf(topics, robots, (...balls) => balls.some((ball) => ball?.x > 2));
  await query(page).fill("any ball.x > 2");
  await page.getByText(`${far.length} times in the whole recording`).waitFor();
  const all = beginsOf(topics, ["/14/2/game"], (state) => state?.state === "STATE_PLAYING");
  await query(page).fill("game.state == ");
  await query(page).press("End");
  await option(page, "playing").click();
  await until(async () => (await query(page).inputValue()) === "game.state == playing", "the value's name");
  await page.getByText(`${all.length} times in the whole recording`).waitFor();
  assert.deepEqual(problems, []);
});

test("keys that come faster than the page draws complete the word that was typed", async (t) => {
  const { server } = await game(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await until(async () => (await page.title()).includes("14/2"), "the robot");
  await page.keyboard.press("w");
  await query(page).focus();
  // all keys within one task, so that nothing is drawn between them
  const typed = await page.evaluate(() => {
    const input = document.querySelector(".expression input");
    const type = (text) => [...text].forEach((one) => document.execCommand("insertText", false, one));
    const tab = () => input.dispatchEvent(new KeyboardEvent("keydown", { key: "Tab", bubbles: true }));
    type("dis");
    tab();
    type("bal");
    tab();
    type(", truth.b");
    tab();
    type(") > 0.5");
    return input.value;
  });
  assert.equal(typed, "distance(ball, truth.ball) > 0.5");
  await page.getByText(/times in the whole recording/).waitFor();
  assert.deepEqual(problems, []);
});

test("a mistake is marked under its place in the text, also on a phone", async (t) => {
  const { server } = await game(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await until(async () => (await page.title()).includes("14/2"), "the robot");
  await page.keyboard.press("w");
  await query(page).waitFor();
  const mark = page.locator(".expression .mark");
  const cases = [
    ["ball.x > 2 && ball.z < 1", "z", "“ball” has no field “z”"],
    ["distance(ball, 3) > 1", "3", "distance() needs a place here"],
    ["game.state == plaing", "plaing", "is none of its values: unspecified, initial"],
    ["1 < 2 < ball.x", "<", "Comparisons make no chain"],
  ];
  const width = await page.evaluate(() => {
    const input = document.querySelector(".expression input");
    const pen = document.createElement("canvas").getContext("2d");
    pen.font = getComputedStyle(input).font;
    return pen.measureText("0".repeat(100)).width / 100;
  });
  for (const [text, part, sentence] of cases) {
    await query(page).fill(text);
    await page.getByRole("status").filter({ hasText: sentence }).waitFor();
    const [line, box] = [await query(page).boundingBox(), await mark.boundingBox()];
    const place = (box.x - line.x) / width;
    const expected = text.lastIndexOf(part) + 9 / width;
    assert.ok(Math.abs(place - expected) < 0.5, `${text}: the mark is at ${place}, not ${expected}`);
    assert.ok(Math.abs(box.width / width - part.length) < 0.3, `${text}: the mark is ${box.width / width} wide`);
  }
  await query(page).fill("ball.x > 2 && ball.z < 1");
  await page.emulateMedia({ colorScheme: "dark" });
  await shoot(page, "language-mistake-dark");
  await page.emulateMedia({ colorScheme: "light" });
  await shoot(page, "language-mistake-light");
  await page.setViewportSize({ width: 820, height: 1180 });
  await shoot(page, "language-mistake-tablet");
  await page.setViewportSize(kPhone);
  await shoot(page, "language-mistake-phone");
  await query(page).fill("pose.");
  await option(page, "heading").waitFor();
  await shoot(page, "language-completion-phone");
  assert.deepEqual(problems, []);
});

test("an expression is a curve of the plot, names stand for joints and enum values, and old links work", async (t) => {
  const { server } = await game(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/plot?plot=/14/2/ball.x%20/14/2/pose~truth`);
  const lines = page.getByRole("list", { name: "Lines" });
  await lines.getByText("/14/2/pose~truth").waitFor();
  const valueOf = (title) =>
    lines
      .locator("li")
      .filter({ has: page.getByText(title, { exact: true }) })
      .locator(".number")
      .textContent();

  const input = page.getByLabel("Add a number");
  await input.fill("distance(ball, truth.ball)");
  await input.press("Enter");
  await until(() => setting(page, "plot").endsWith(" distance(ball,truth.ball)"), "the curve in the address");
  await until(async () => /^\d+(\.\d+)? m$/.test((await valueOf("distance(ball, truth.ball)")).trim()), "its value");
  await input.fill("game.state");
  await option(page, "/14/2/game.state").first().click();
  await until(async () => /^(initial|ready|set|playing)$/.test(await valueOf("/14/2/game.state")), "the state's name");
  await input.fill("any ball.x > 2");
  await option(page, "any(ball.x>2)").click();
  await until(async () => /^(true|false)$/.test(await valueOf("any(ball.x > 2)")), "true or false");
  await input.fill("ball.x - ");
  await page.getByText("The text ends where a value is expected.").waitFor();
  await input.fill("distance(");
  await option(page, "ball").waitFor();
  await shoot(page, "language-plot");
  await input.press("Escape");
  await input.fill("");

  // the same page from its address
  const colleague = await open(t, page.url());
  const theirs = colleague.page.getByRole("list", { name: "Lines" });
  await theirs.getByText("distance(ball, truth.ball)", { exact: true }).waitFor();
  await theirs.getByText("any(ball.x > 2)", { exact: true }).waitFor();
  await colleague.page.emulateMedia({ colorScheme: "dark" });
  await until(async () => (await colleague.page.getByText("no value yet").count()) === 0, "values");
  await shoot(colleague.page, "language-plot-dark");
  await colleague.page.keyboard.press("?");
  await colleague.page.getByRole("heading", { name: "expressions" }).scrollIntoViewIfNeeded();
  await shoot(colleague.page, "language-help-dark");
  assert.deepEqual([...problems, ...colleague.problems], []);
});
