// Test games, the token and the choice of recorded objects, as a person sees them in Chromium.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot, shootEach } from "./browser.mjs";
import {
  getJson,
  needsNetwork,
  own,
  robot,
  run,
  sessionsOf,
  start,
  statusOf,
  synthesize,
  temporaryFolder,
  until,
} from "./support.mjs";

const kViews = ["field", "camera", "objects", "plot", "decision", "what-if", "health", "log", "sessions", "parameters"];
const practice = (page) => page.getByRole("status").filter({ hasText: "Not for a match" });

test("with --practice each view says that the wireless network stays open", async (t) => {
  const folder = temporaryFolder(t);
  const server = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "attached",
    "--door",
    join(folder, "door"),
    "--practice",
  );
  assert.equal((await statusOf(server)).game.practice, true);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  for (const view of kViews) {
    await page.getByRole("navigation", { name: "Views" }).getByRole("link", { name: view, exact: true }).click();
    await practice(page).waitFor();
  }
  await shootEach(page, "practice");
  assert.deepEqual(problems, []);
});

test("a token that was refused is typed on the page", needsNetwork, async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder), "--loop", "--bind", "0.0.0.0");
  const token = readFileSync(join(folder, "state/token"), "utf8").trim();
  const { page, problems } = await open(t, `http://${own}:${server.port}/#/sessions`);
  const entry = page.getByLabel(`Token of ${own}:${server.port}`);
  const record = page.getByRole("button", { name: "Start recording" });
  for (const [typed, words] of [
    ["0123456789abcdef", "asks for its token"],
    [token, "refused this token"],
  ]) {
    await record.click();
    await entry.waitFor();
    await page.getByText(words).waitFor();
    await shoot(page, `token-${words.split(" ")[0]}`);
    await entry.fill(typed);
    await page.getByRole("button", { name: "Use it" }).click();
    await entry.waitFor({ state: "detached" });
  }
  await record.click();
  await until(async () => (await statusOf(server)).recording.state === "recording", "the recording");
  assert.ok(!page.url().includes(token), "the address hides the token");
  assert.deepEqual(problems, []);
});

test("a recording contains the objects with a tick", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder), "--loop", "--only", "joints,inertial,clock");
  const { page, problems } = await open(t, `${server.http}/#/sessions`);
  await page.getByText(/^3 of \d+ objects$/).click();
  const ticks = page.getByRole("group", { name: "Objects to record" });
  assert.equal(await ticks.getByLabel("joints", { exact: true }).isChecked(), true);
  assert.equal(await ticks.getByLabel("ball", { exact: true }).isChecked(), false);
  await ticks.getByLabel("clock", { exact: true }).uncheck();
  await shootEach(page, "objects");
  await page.getByRole("button", { name: "Start recording" }).click();
  const files = async () =>
    (await sessionsOf(server))
      .find(({ state }) => state === "recording")
      ?.streams.map(({ topic }) => topic)
      .sort() ?? [];
  await until(async () => (await files()).join() === "/14/2/inertial,/14/2/joints", "the two files", undefined, files);
  assert.equal((await getJson(server, "/api/status")).recording.dropped, 0);

  // the card says what was left out by choice
  const card = page.getByRole("article").filter({ hasText: "recording" });
  await card.getByText("Only chosen objects were recorded: inertial and joints.").waitFor();
  await shootEach(page, "chosen");
  assert.equal(await page.getByRole("link", { name: "Download with scenes" }).count(), 0, "a robot makes none");
  assert.deepEqual(problems, []);
});

test("an unknown object ends the program with one sentence", async (t) => {
  const folder = temporaryFolder(t);
  const { status, stderr } = await run(
    "foresight-robot",
    "--body",
    "replay",
    "--session",
    await synthesize(folder),
    "--port",
    "0",
    "--log-dir",
    folder,
    "--record",
    "--only",
    "ball,jonts",
  );
  assert.deepEqual([status, stderr], [2, "foresight-robot: --only: no object 'jonts'; did you mean 'joints'?\n"]);
});
