// Debugging with a recording in Chromium: breakpoints on the strip of time, and decisions of another tree beside the recorded
// ones. Beliefs become the start of simulated games.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot, shootEach } from "./browser.mjs";
import { decode, Live } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { play, run, start, temporaryFolder, until } from "./support.mjs";

const kShort = ["--rules", "spl2025:5,halves=1,half_duration=60"];
const kWide = { width: 1600, height: 950 };

const done = async (program, ...args) => {
  const { status, stdout, stderr } = await run(program, ...args);
  assert.equal(status, 0, stderr);
  return stdout;
};
const at = (page) => BigInt(new URLSearchParams(page.url().split("?")[1]).get("at") ?? 0);

/** Records a game in `folder`, and returns its file. */
async function recorded(folder) {
  const file = join(folder, "game.mcap");
  await done("foresight-sim", "match", "--seed", "7", ...kShort, "--mcap", file);
  return file;
}

/** Opens the page of a recording that plays, and stops it there. */
async function openStopped(t, url) {
  const opened = await open(t, url, { viewport: kWide });
  await opened.page.getByLabel("Elapsed").filter({ hasText: "/ 1:38" }).waitFor();
  await until(async () => !/^0:00/.test(await opened.page.getByLabel("Elapsed").textContent()), "the play");
  await opened.page.getByRole("button", { name: "Freeze view" }).click();
  await opened.page.getByRole("button", { name: "Go on" }).waitFor();
  return opened;
}

test("breakpoints stop time, stand on the strip and in the address, and can be turned off", async (t) => {
  const folder = temporaryFolder(t);
  const file = await recorded(folder);
  const { schema, messages } = readStreamed(readFileSync(file)).topics.get("/14/2/decision");
  const decisions = messages.map(({ logTime, data }) => ({ logTime, ...decode(schema.name, schema.data, data) }));
  const begins = decisions
    .filter(({ skill }, i) => skill === "walk_to_ball" && i > 0 && decisions[i - 1].skill !== skill)
    .map(({ logTime }) => logTime);
  assert.ok(begins.length >= 2, `${begins.length} walks to the ball`);

  const server = await play(t, folder, file);
  const { page, problems } = await openStopped(t, `${server.http}/#/14/2/debug`);
  await page.keyboard.press("w");
  await page.getByLabel("Find when").fill("decision.skill == walk_to_ball");
  await page.getByText("in the whole recording").waitFor();
  await page.getByRole("button", { name: "Break there" }).click();
  const list = page.getByRole("list", { name: "Breakpoints" });
  await list.getByText(`${begins.length} times`).waitFor();
  await list.getByRole("button", { name: "decision.skill == walk_to_ball", pressed: true }).waitFor();
  await shoot(page, "breakpoints");
  await shootEach(page, "breakpoints");
  await page.setViewportSize(kWide);

  // forward and back
  await page.keyboard.press("Escape");
  await page.keyboard.press("Home");
  for (const begin of begins.slice(0, 2)) {
    await page.keyboard.press("Shift+N");
    await until(() => at(page) === begin, `the walk at ${begin}, not ${at(page)}`);
  }
  await list.getByRole("button", { name: "The breakpoint before" }).click();
  await until(() => at(page) === begins[0], "back to the first one");

  // it stops while the recording plays, and the address keeps it
  const again = await openStopped(t, `${page.url().split("?")[0]}?breaks=decision.skill+%3D%3D+walk_to_ball`);
  await again.page.keyboard.press("Escape"); // keys go to the search, which is open
  await again.page.keyboard.press("Home");
  await until(() => at(again.page) < begins[0], "the beginning");
  await again.page.getByText(`${begins.length} times`).waitFor();
  await again.page.getByLabel("Pace").selectOption({ label: "5 ×" });
  await again.page.getByRole("button", { name: "Go on" }).click();
  await until(
    () => at(again.page) === begins[0],
    "the stop at the first walk",
    undefined,
    () => again.page.url(),
  );

  // off, it stops nothing
  await again.page.getByRole("button", { name: "decision.skill == walk_to_ball", pressed: true }).click();
  await again.page.waitForURL(/breaks=off/);
  await again.page.getByRole("button", { name: "Go on" }).click();
  await again.page.getByRole("button", { name: "Freeze view" }).waitFor();
  const first = await again.page.getByLabel("Elapsed").textContent();
  await until(async () => (await again.page.getByLabel("Elapsed").textContent()) !== first, "time runs on");

  await again.page.getByRole("button", { name: "Remove the breakpoint" }).click();
  await again.page.getByRole("list", { name: "Breakpoints" }).waitFor({ state: "detached" });
  assert.deepEqual([...problems, ...again.problems], []);
});

test("the decisions of another tree are a second band below the recorded ones", async (t) => {
  const folder = temporaryFolder(t);
  const [file, copy] = [await recorded(folder), join(folder, "redecided")];
  await done("foresight-lab", "redecide", file, "--robot", "14/2", "--strategy", "kick_now", "--session", copy);
  const server = await play(t, folder, copy);
  const { page, problems } = await openStopped(t, `${server.http}/#/14/2/decision`);
  await page.getByRole("img", { name: "and below them those of the other tree" }).waitFor();
  const other = page.getByLabel("The other tree");
  // a moment of play; dead time has no decisions
  await page.keyboard.press("w");
  await page.getByLabel("Find when").fill("redecision.skill == walk_to_ball");
  await page.getByText(/ times in the whole recording/).waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+N");
  await other.filter({ hasText: /^kick_now decides (?!the same)/ }).waitFor();
  await shoot(page, "redecided");
  await shootEach(page, "redecided");
  assert.deepEqual(problems, []);
});

test("what a robot believed at the shown decision is saved, and games begin there", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await recorded(folder));
  const { page, problems } = await openStopped(t, `${server.http}/#/14/2/debug`);
  await page.keyboard.press("w");
  await page.getByLabel("Find when").fill("decision.skill == walk_to_ball");
  await page.getByText(/in the whole recording/).waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+N");
  await page.getByRole("status", { name: "Why" }).filter({ hasText: "14/2 plays walk_to_ball" }).waitFor();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "save beliefs" }).click(),
  ]);
  const path = await download.path();
  const moment = JSON.parse(readFileSync(path, "utf8"));
  assert.deepEqual(moment.teams, { home: 14, away: 5 });
  for (const robot of moment.robots) assert.ok(robot.deviation >= 0, JSON.stringify(robot));
  const games = await done("foresight-sim", "match", "--from", path, ...kShort, "--fuzz", "--games", "3", "--json");
  assert.ok(JSON.parse(games));
  assert.deepEqual(problems, []);
});

test("a breakpoint stops a simulated game too, at the tick of the match", async (t) => {
  const game = ["--body", "sim", "--player", "2", "--seed", "7"];
  const server = await start(t, temporaryFolder(t), "foresight-robot", ...game);
  const live = await Live.open(t, server);
  await live.subscribe("/14/2/decision");
  await live.call("/sim/step", { ticks: 1800 });
  const { page, problems } = await open(t, `${server.http}/#/14/2/debug?breaks=decision.skill+%3D%3D+walk_to_ball`, {
    viewport: kWide,
  });
  await page.getByRole("status", { name: "Why" }).waitFor();
  const begun = (await live.call("/sim/resume")).tick;
  await until(async () => (await live.call("/sim/state")).paused, "the game to be paused");
  await page.getByText("game paused").waitFor();
  const skill = async () => live.decoded("/14/2/decision", await live.newest("/14/2/decision")).skill;
  await until(async () => (await skill()) === "walk_to_ball", "the game to go back to the match");
  // the game stands at the begin of the match: a decision before it was another one
  const { tick } = await live.call("/sim/state");
  assert.ok(tick >= begun, `${tick}, begun at ${begun}`);
  await live.call("/sim/back", { ticks: 1 });
  await until(async () => (await skill()) !== "walk_to_ball", "another skill before");
  assert.deepEqual(problems, []);
});
