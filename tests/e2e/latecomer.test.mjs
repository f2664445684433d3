// A page that is opened late: a live robot hands over its last five minutes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { Live } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { download, play, request, start, synthesize, temporaryFolder, until } from "./support.mjs";

const kSecond = 1_000_000_000n;
const json = async (server, path) => JSON.parse((await request(server, path)).body);

/** Starts a simulated game at 20 times the speed of time, and waits for `seconds` of its capture times. */
async function game(t, seconds, ...more) {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7", ...more);
  const live = await Live.open(t, server);
  await live.until(() => live.channels.has("/truth/world"), "the world");
  await live.subscribe("/truth/world");
  await live.until(() => live.messages.get("/truth/world")?.length > 0, "its first message");
  const first_ns = live.messages.get("/truth/world")[0].log_ns;
  await until(
    () => live.messages.get("/truth/world").at(-1).log_ns - first_ns > BigInt(seconds) * kSecond,
    `${seconds} s of the game`,
  );
  return { server, first_ns };
}

test("a page that comes late goes back to a moment before it, and knows its events", async (t) => {
  const { server, first_ns } = await game(t, 8, "--speed", "20", "--rules", "spl2012:2,ready_duration=5");
  const moment_ns = first_ns + 5n * kSecond;
  const { page, problems } = await open(t, `${server.http}/#/14/2/field?at=${moment_ns}`);
  const at = () => BigInt(/at=(\d+)/.exec(page.url())?.[1] ?? 0);
  await page.getByText("nothing is kept here").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Go on" }).waitFor();
  await shoot(page, "latecomer");
  // the kick-off came before the page
  await page.keyboard.press("p");
  await until(() => at() > 0n && at() < moment_ns, "an earlier event");
  assert.ok(at() >= first_ns, `${at()} is before the game`);
  await page.getByText("nothing is kept here").waitFor({ state: "detached" });
  await shoot(page, "latecomer-event");
  assert.deepEqual(problems, []);
});

test("the last minutes are an MCAP file that others read; a played recording has none", async (t) => {
  const { server, first_ns } = await game(t, 6, "--speed", "20");
  const { topics } = readStreamed(await download(server, "/api/recent"));
  const world = topics.get("/truth/world").messages;
  assert.ok(world.length > 5 * 30, `${world.length} messages in 6 s`);
  assert.ok(BigInt(world[0].logTime) - first_ns < kSecond, "from the beginning");
  for (const topic of ["/14/2/pose", "/14/2/ball", "/14/2/game", "/14/2/decision", "/sim/state"])
    assert.ok(topics.get(topic)?.messages.length > 0, topic);
  const one = readStreamed(await download(server, "/api/recent?topics=%2F14%2F2%2Fpose"));
  assert.deepEqual(
    [...one.topics].filter(([, { messages }]) => messages.length > 0).map(([topic]) => topic),
    ["/14/2/pose"],
  );

  const folder = temporaryFolder(t);
  const played = await play(t, folder, await synthesize(folder, { seconds: 2 }));
  assert.equal((await request(played, "/api/recent")).status, 404);
  assert.equal((await json(played, "/api/status")).body, "recording");
});
