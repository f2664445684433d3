// Reasons of decisions over the network: a live game explains itself, at this moment and at one that a client sends.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { open, shoot, shootEach } from "./browser.mjs";
import { Live } from "./live.mjs";
import { sessionsOf, start, temporaryFolder, until } from "./support.mjs";

const kObjects = ["ball", "pose", "team", "opponents", "game", "motion_status", "decision"];
const kWide = { width: 1600, height: 950 };
const kTopics = [...kObjects.map((name) => `/14/2/${name}`), "/truth/world"];

/**
 * A game that is paused while 14/2 plays, and a client that has its objects. Without foresight: the captain's choice comes
 * by the clock on the wall, and a game that goes back and on again would be another one.
 */
async function pausedInPlay(t, topics = kTopics) {
  const options = ["--body", "sim", "--player", "2", "--seed", "7", "--no-foresight"];
  const server = await start(t, temporaryFolder(t), "foresight-robot", ...options);
  const live = await Live.open(t, server);
  for (const topic of topics) await live.subscribe(topic);
  await live.call("/sim/pause");
  await live.call("/sim/seed", { seed: 7 }); // from its first tick
  await live.call("/sim/step", { ticks: 1800 }); // through ready and set
  await live.call("/sim/step", { ticks: 300 });
  return { server, live };
}

/** The newest object of each topic, as a request sends them. */
async function sent(live) {
  const objects = {};
  let at_ns;
  for (const topic of kTopics) {
    const { data, log_ns } = await live.newest(topic);
    const name = topic === "/truth/world" ? "truth" : topic.slice("/14/2/".length);
    objects[name] = {
      capture_ns: String(log_ns),
      data: Buffer.from(data).toString("base64"),
    };
    if (name === "decision") at_ns = String(log_ns);
  }
  return { robot: "14/2", at_ns, objects };
}

test("why explains the newest decision, with truth and margins, and the same objects give the same reasons", async (t) => {
  const { live } = await pausedInPlay(t);
  const newest = await live.call("/decision/why", { robot: "14/2" });
  assert.equal(newest.ok, true, newest.error);
  const { reasons } = newest;
  assert.equal(newest.has_truth, true);
  assert.equal(newest.agrees, true);
  assert.match(reasons.sentence, new RegExp(`^14/2 plays ${reasons.skill} because `));
  const decision = live.decoded("/14/2/decision", await live.newest("/14/2/decision"));
  assert.equal(reasons.skill, decision.skill);
  const nodes = new Map(reasons.comparisons.map((comparison) => [comparison.node, comparison]));
  // each comparison that the robot told is one of the path, with the same answer
  const told = decision.visited.filter(({ kind }) => kind === "KIND_CONDITION");
  for (const { condition, result } of told)
    assert.ok(
      reasons.path.some(({ node }) => nodes.get(node).condition === condition && nodes.get(node).result === result),
      condition,
    );
  assert.deepEqual(
    reasons.parts.filter(({ skill, taken }) => skill && taken).map(({ path }) => path),
    [decision.visited.at(-1).path],
  );
  for (const { truth, sources } of reasons.path) {
    assert.equal(typeof truth, "string");
    for (const { text } of sources) assert.equal(typeof text, "string");
  }

  assert.deepEqual(await live.call("/decision/why", await sent(live)), newest);
});

test("why not names a change, and refuses an unknown skill with a similar one", async (t) => {
  const { live } = await pausedInPlay(t);
  const request = await sent(live);
  const answer = await live.call("/decision/why_not", {
    ...request,
    what: "search_ball",
  });
  assert.equal(answer.ok, true, answer.error);
  assert.equal(answer.alternative.kind, "changed");
  assert.ok(answer.alternative.features.length >= 1);
  assert.ok(answer.alternative.leaf.endsWith("search_ball"));
  assert.match((await live.call("/decision/why_not", { ...request, what: "serch_ball" })).error, /search_ball/);
});

test("wrong requests get one sentence", async (t) => {
  const { live } = await pausedInPlay(t);
  const good = await sent(live);
  const { ball, decision, game } = good.objects;
  const wrong = [
    [{}, /'robot' must be a text/],
    [{ robot: "99/1" }, /robot '99\/1' has not decided anything/],
    [{ ...good, at_ns: 5 }, /'at_ns' must be a time in nanoseconds as a text/],
    [{ ...good, objects: [] }, /'objects' must be an object/],
    [{ ...good, objects: { ball: { ...ball, data: "?" } } }, /objects\.ball must be/],
    [{ ...good, objects: { decision: { ...decision, data: "////" } } }, /objects\.decision\.data is no message/],
    [{ ...good, objects: {} }, /there is no object decision/],
    [{ ...good, objects: { decision } }, /there is no object game/],
    [{ ...good, objects: { decision, game } }, /there is no object pose/],
  ];
  for (const [request, sentence] of wrong) {
    const { ok, error } = await live.call("/decision/why", request);
    assert.equal(ok, false, JSON.stringify(request).slice(0, 200));
    assert.match(error, sentence);
    assert.ok(error.startsWith("/decision/why: "), error);
  }
});

test("the workspace Debug draws the tree, explains each decision, answers why not, and goes back", async (t) => {
  const { server, live } = await pausedInPlay(t, ["/14/2/decision"]);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`, { viewport: kWide });
  await page.keyboard.press("D");
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  const sentence = debug.getByRole("status", { name: "Why" });
  await sentence.filter({ hasText: /^14\/2 plays \w+ because / }).waitFor();

  // the tree has the parts that the robot's own trace names, and lights them
  const { reasons } = await live.call("/decision/why", { robot: "14/2" });
  assert.equal(await sentence.textContent(), `${reasons.sentence}.`);
  const tree = debug.getByRole("group", { name: "Decision tree" });
  assert.equal(await tree.getByRole("button").count(), reasons.parts.length - 1, "all but the whole tree");
  assert.equal(
    await tree.getByRole("button", { name: ": taken" }).count(),
    reasons.parts.filter((part) => part.taken).length - 1,
  );
  const table = debug.getByRole("table", { name: "Comparisons on the path" });
  assert.equal(await table.locator("tbody tr").count(), reasons.path.length);
  assert.match(await table.locator("tbody tr").first().textContent(), /not ball_known/);

  // only the path, and the whole again
  await debug.getByLabel("whole tree").uncheck();
  assert.ok((await tree.getByRole("button").count()) < reasons.parts.length);
  await debug.getByLabel("whole tree").check();

  // why not another part?
  await tree.getByRole("button", { name: /^not ball known/ }).click();
  const answer = debug.getByRole("region", { name: "Why not" });
  await answer.getByText("One value would have to be different:").waitFor();
  assert.match(await answer.textContent(), /ball known/);
  await shoot(page, "debug-wide");
  await shootEach(page, "debug");
  await page.setViewportSize(kWide);
  await answer.getByRole("button", { name: "Close the answer" }).click();
  await answer.waitFor({ state: "detached" });

  // back by a decision and on again: the same decision
  const decision = async () => live.decoded("/14/2/decision", await live.newest("/14/2/decision"));
  const decided = await decision();
  const place = async () => (await live.call("/sim/state")).tick;
  const before = await place();
  await debug.getByRole("button", { name: "−1 s" }).click();
  await until(async () => (await place()) === before - 30, "a second back");
  await debug.getByRole("button", { name: "Back", exact: true }).click();
  await until(async () => (await place()) === before - 31, "a decision back");
  await live.call("/sim/step", { ticks: 31 });
  await until(
    async () => isDeepStrictEqual(await decision(), decided),
    "the same decision",
    undefined,
    async () =>
      JSON.stringify([decided, await decision()], (_, value) => (typeof value === "bigint" ? `${value}` : value)),
  );
  await sentence.filter({ hasText: `14/2 plays ${reasons.skill} because ` }).waitFor();
  assert.deepEqual(problems, []);
});

test("a recording explains its decisions at each moment, with the page's own playhead", async (t) => {
  const folder = temporaryFolder(t);
  const robot = await start(t, folder, "foresight-robot", "--body", "sim", "--player", "2", "--seed", "7", "--record");
  const live = await Live.open(t, robot);
  await live.call("/sim/speed", { speed: 10 });
  await until(async () => (await live.call("/sim/state")).tick > 3600, "two minutes of the game");
  await live.call("stop_recording");
  const [session] = await sessionsOf(robot);
  const player = await start(t, folder, "foresight-lab", "play", join(folder, "logs", session.session));
  const { page, problems } = await open(t, `${player.http}/#/14/2/debug`);
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  await debug.waitFor();
  await page.keyboard.press("Space");
  await page.keyboard.press("Home");
  // in steps of a second through the whole recording, whose game ran faster
  const seen = new Set();
  for (let i = 0; i < 60 && seen.size < 2; ++i) {
    await page.keyboard.press("ArrowRight");
    await debug
      .getByRole("status", { name: "Why" })
      .filter({ hasText: /^14\/2 plays \w+ because \w+ (is|<|>)/ })
      .waitFor({ timeout: 1000 })
      .then(async () => seen.add(await debug.getByRole("status", { name: "Why" }).textContent()))
      .catch(() => {});
  }
  assert.ok(seen.size >= 2, [...seen, `at last: ${await debug.textContent()}`].join("\n"));
  assert.deepEqual(problems, []);
});
