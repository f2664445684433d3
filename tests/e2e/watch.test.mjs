// Watching, filtering and sharing recordings from the view Sessions, as a person does it in Chromium.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { open, shootEach } from "./browser.mjs";
import { getJson, needsNetwork, own, play, robot, run, synthesize, temporaryFolder, until } from "./support.mjs";

/** Two sessions in one folder: "first" of robot 14/2, and "second" of robot 14/3. */
async function twoSessions(folder) {
  const first = await synthesize(folder, { name: "first", seconds: 4 });
  const { status, stderr } = await run(
    "foresight-lab",
    "synthesize",
    join(folder, "second"),
    "--seconds",
    "4",
    "--robot",
    "14/3",
  );
  assert.equal(status, 0, stderr);
  return first;
}
/** The robot whose session is played; "" while the server changes to another one. */
const playedBy = (server) =>
  getJson(server, "/api/status").then(
    ({ robots }) => robots.join(),
    () => "",
  );
const card = (page, name) => page.getByRole("article").filter({ hasText: `robot ${name}` });
const copied = (page) => page.evaluate(() => navigator.clipboard.readText());

test("foresight-lab plays another session of the folder, and a link leads to a session and its moment", async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await twoSessions(folder), "--loop");
  const { page, context } = await open(t, `${server.http}/#/sessions`, { breaksConnections: true });
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin: server.http });
  await card(page, "14/2").getByText("● Watching").waitFor();
  await shootEach(page, "watch-sessions");

  // a search in the streams
  await page.setViewportSize({ width: 1280, height: 800 });
  await card(page, "14/3")
    .getByText(/^\d+ streams$/)
    .click();
  const streams = card(page, "14/3").locator("details li");
  assert.ok((await streams.count()) > 8);
  await card(page, "14/3").getByLabel("Search streams").fill("camera top");
  await until(async () => (await streams.count()) < 8, "fewer streams");
  for (const name of await streams.allInnerTexts()) assert.match(name, /camera_top/);
  await shootEach(page, "watch-streams");
  await card(page, "14/3").getByLabel("Search streams").fill("nothing");
  await page.getByText("No stream contains “nothing”.").waitFor();

  // watch the other one
  await page.setViewportSize({ width: 1280, height: 800 });
  await card(page, "14/3").getByRole("button", { name: "Watch" }).click();
  await until(
    async () => (await playedBy(server)) === "14/3",
    "the other session",
    undefined,
    () => playedBy(server),
  );
  await page.getByRole("button", { name: "Pause" }).or(page.getByText("Robot 14/3")).first().waitFor();
  assert.match(page.url(), /session=second/);

  // a link to this session at a moment; the view Camera would go from it to its image
  await page.getByText("Robot 14/3").first().waitFor();
  await page.getByRole("link", { name: "objects", exact: true }).click();
  await page.keyboard.press("Space");
  await until(
    () => /at=\d+/.test(page.url()),
    "the moment in the address",
    undefined,
    () => page.url(),
  );
  await page.getByRole("button", { name: "Layout" }).click();
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.getByText("It leads to this computer only").waitFor();
  await shootEach(page, "watch-link");
  const link = await copied(page);
  assert.match(link, /session=second/);
  const at = /at=(\d+)/.exec(link)[1];

  // meanwhile somebody watches the first one again; the link offers its session
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.goto(`${server.http}/#/sessions`);
  await page.reload();
  await card(page, "14/2").getByRole("button", { name: "Watch" }).click();
  await until(
    async () => (await playedBy(server)) === "14/2",
    "the first session",
    undefined,
    () => playedBy(server),
  );
  const { page: other } = await open(t, link, { breaksConnections: true });
  await other.getByText("This link is about the session second. The server plays first.").waitFor();
  await shootEach(other, "watch-notice");
  await other.getByRole("button", { name: "Watch it" }).click();
  await until(
    async () => (await playedBy(server)) === "14/3",
    "the session of the link",
    undefined,
    () => playedBy(server),
  );
  await other.getByText("This link is about").waitFor({ state: "detached" });
  await other.getByText("Robot 14/3").first().waitFor();
  await until(
    () => new RegExp(`at=${at}`).test(other.url()),
    `the moment ${at} of the link`,
    undefined,
    () => other.url(),
  );
});

test("a robot says how its recordings are watched, and links to one in the list", async (t) => {
  const folder = temporaryFolder(t);
  const server = await robot(t, folder, await synthesize(folder), "--loop", "--record");
  await until(async () => (await getJson(server, "/api/sessions")).sessions.length > 0, "a session");
  const { page, context, problems } = await open(t, `${server.http}/#/sessions`);
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin: server.http });
  const first = page.getByRole("article").first();
  await first.getByText("Watch", { exact: true }).click();
  await first.getByText(/^foresight-lab play .*\.mcap$/).waitFor();
  await shootEach(page, "watch-robot");
  await page.setViewportSize({ width: 1280, height: 800 });
  await first.getByRole("button", { name: "Copy link" }).click();
  await first.getByText("Copied.").waitFor();
  await page.goto(await copied(page));
  await page.locator("article.linked").waitFor();
  assert.deepEqual(problems, []);
});

test("watching another session needs the token", needsNetwork, async (t) => {
  const folder = temporaryFolder(t);
  const server = await play(t, folder, await twoSessions(folder), "--loop", "--bind", "0.0.0.0");
  const { page } = await open(t, `http://${own}:${server.port}/#/sessions`);
  await card(page, "14/3").getByRole("button", { name: "Watch" }).click();
  await page.getByLabel(`Token of ${own}:${server.port}`).waitFor();
  assert.equal(await playedBy(server), "14/2");
});
