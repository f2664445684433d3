// A moment that is changed, and what would come of it: over the network, and in the viewer's workspace Debug.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot, shootEach } from "./browser.mjs";
import { Live } from "./live.mjs";
import { play, run, sessionsOf, start, temporaryFolder, until } from "./support.mjs";

const kWide = { width: 1600, height: 950 };

/** A game that is paused while 14/2 plays. */
async function pausedInPlay(t) {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--player", "2", "--seed", "7");
  const live = await Live.open(t, server);
  await live.call("/sim/pause");
  await live.call("/sim/seed", { seed: 7 }); // from its first tick
  await live.call("/sim/step", { ticks: 1800 }); // through ready and set
  await live.call("/sim/step", { ticks: 300 });
  return { server, live };
}

const rowOf = (debug, name) =>
  debug.getByRole("table", { name: "Effect of the change" }).getByRole("row").filter({ hasText: name });

test("a change is compared with the game as it is, and the game stays as it was", async (t) => {
  const { live } = await pausedInPlay(t);
  await live.subscribe("/truth/world");
  const truth = async () => live.decoded("/truth/world", await live.newest("/truth/world"));
  const before = await truth();
  const request = { robot: "14/2", edits: ["set ball 2.5 0"], pairs: 40, seconds: 10 };
  const answer = await live.call("/decision/futures", request);
  assert.equal(answer.ok, true, answer.error);
  assert.ok(Math.abs(answer.before.ball.x - before.ball.x) < 1e-6);
  assert.equal(answer.after.ball.x, 2.5);
  const { futures } = answer;
  assert.equal(futures.different, 40);
  assert.equal(futures.paths.with.length, futures.paths.without.length);
  for (const effect of [futures.scores, futures.concedes, futures.goals])
    assert.ok(effect.low <= effect.with - effect.without && effect.with - effect.without <= effect.high);
  assert.deepEqual(await live.call("/decision/futures", request), answer, "the same question has the same answer");
  assert.deepEqual(await truth(), before);
});

test("in the workspace Debug a person changes the moment, sees both futures, and plays on with the change", async (t) => {
  const { server, live } = await pausedInPlay(t);
  const before = await live.call("/sim/state");
  await live.subscribe("/truth/world");
  const { page, problems } = await open(t, `${server.http}/#/14/2/debug`, { viewport: kWide });
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  await debug.getByRole("button", { name: "change…" }).click();
  const panel = debug.getByRole("region", { name: "Change and run again" });
  await panel.getByText("the game at 1:10, as 14/2 plays it").waitFor();

  // an edit with a typo is refused, and stays to be mended
  const line = panel.getByLabel("An edit");
  await line.fill("strategy passin");
  await page.keyboard.press("Enter");
  await panel.getByRole("alert").filter({ hasText: "did you mean 'passing'?" }).waitFor();
  assert.equal(await line.inputValue(), "strategy passin");
  await line.fill("strategy passing");
  await page.keyboard.press("Enter");
  const edits = panel.getByRole("list", { name: "Edits" });
  await edits.getByText("strategy passing").waitFor();
  assert.equal(await line.inputValue(), "");

  // a thing is dragged
  const carpet = panel.getByRole("img", { name: "The moment from above" });
  const words = async () => carpet.evaluate((canvas) => canvas.nextElementSibling.textContent);
  const placed = /The ball is at (-?[\d.]+), (-?[\d.]+) m/.exec(await words());
  assert.ok(placed, await words());
  const box = await carpet.boundingBox();
  const { field } = await live
    .call("/sim/state")
    .then(async () => live.subscribe("/sim/state"))
    .then(async () => live.decoded("/sim/state", await live.newest("/sim/state")));
  const scale = Math.min(box.width / (field.length + 2 * field.border), box.height / (field.width + 2 * field.border));
  const at = ([x, y]) => [box.x + box.width / 2 + scale * x, box.y + box.height / 2 - scale * y];
  await page.mouse.move(...at([Number(placed[1]), Number(placed[2])]));
  await page.mouse.down();
  await page.mouse.move(...at([1, 1]), { steps: 4 });
  await page.mouse.up();
  await panel.getByRole("group", { name: "Moved" }).getByRole("button", { name: /^ball/ }).waitFor();

  // a running game keeps its trees, but their futures can be compared
  assert.ok(await panel.getByRole("button", { name: "Play on with it" }).isDisabled());
  await panel.getByRole("combobox", { name: "pairs" }).selectOption("50");
  await panel.getByRole("button", { name: "Run futures" }).click();
  await rowOf(panel, "scores within 30.0 s").waitFor();
  assert.match(await rowOf(panel, "scores within 30.0 s").textContent(), /\d+ %.*→ \d+ %.*[+−±]\d+ \.\. [+−±]\d+/);
  const parting = panel.getByRole("status", { name: "Where they part" });
  assert.match(
    await parting.textContent(),
    /^\s*\d+ of 50 pairs differ; with the luck of this game they part after 0\.\d\d s/,
  );
  await shoot(page, "change-wide");
  await panel.getByRole("group", { name: "Which futures" }).getByRole("button", { name: "1", exact: true }).click();
  await shoot(page, "change-wide-pair");
  await shootEach(page, "change");
  await page.setViewportSize(kWide);

  await edits.getByRole("button", { name: "Take back: strategy passing" }).click();
  await panel.getByText("Edited since.").waitFor();
  await panel.getByRole("button", { name: "Play on with it" }).click();
  await panel.getByText("The game was changed, and waits.").waitFor();
  const { paused, tick } = await live.call("/sim/state");
  assert.deepEqual([paused, tick], [true, before.tick - 1], "where the shown decision was made");
  await until(async () => {
    const { ball } = live.decoded("/truth/world", await live.newest("/truth/world"));
    return Math.hypot(ball.x - 1, ball.y - 1) < 0.15 || Math.hypot(ball.x + 1, ball.y + 1) < 0.15;
  }, "the ball at its new place");
  assert.deepEqual(problems, []);
});

test("the answer to why not is tried out", async (t) => {
  const { server } = await pausedInPlay(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/debug`, { viewport: kWide });
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  const boxes = debug
    .getByRole("group", { name: "Decision tree" })
    .getByRole("button", { name: /asked in vain|not asked/ });
  const panel = debug.getByRole("region", { name: "Change and run again" });
  const tries = debug.getByRole("region", { name: "Why not" }).getByRole("button", { name: "try it" });
  await boxes.first().waitFor();
  // the first part that a threshold leads to
  const answer = debug.getByRole("region", { name: "Why not" });
  for (let i = 0; i < (await boxes.count()) && (await tries.count()) === 0; ++i) {
    await boxes.nth(i).click();
    await answer.getByRole("status").filter({ hasNotText: "Searching…" }).waitFor();
    if ((await tries.count()) === 0) await answer.getByRole("button", { name: "Close the answer" }).click();
  }
  await tries.first().click();
  await panel
    .getByRole("list", { name: "Edits" })
    .getByText(/^set threshold \d+ /)
    .waitFor();
  await panel.getByRole("button", { name: "Run futures" }).click();
  await rowOf(panel, "goal difference").waitFor();
  assert.deepEqual(problems, []);
});

/** Opens a recording in Debug, `back` [s] before its end, and the change of that moment, which the panel calls `expected`. */
async function openChange(t, server, expected, back = 0) {
  const { page, problems } = await open(t, `${server.http}/#/14/2/debug`);
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  await page.getByText("a recording", { exact: true }).waitFor();
  await page.keyboard.press("Space");
  const jump = async () => {
    await page.keyboard.press("End");
    for (let second = 0; second < back; ++second) await page.keyboard.press("ArrowLeft");
  };
  await jump();
  await debug.getByRole("button", { name: "change…" }).click();
  const panel = debug.getByRole("region", { name: "Change and run again" });
  // a page that was just opened may not know the end of the recording yet, or still show the moment before the jump
  const taken = async () => {
    if (await panel.getByText(expected).isVisible()) return true;
    await jump();
    await panel.getByRole("button", { name: "take this moment" }).click();
    await page.waitForTimeout(500);
    return false;
  };
  await until(taken, "the moment", undefined, () => panel.textContent());
  return { page, problems, panel };
}

test("a recorded moment is changed from what the robot believed", async (t) => {
  const folder = temporaryFolder(t);
  const server = await start(t, folder, "foresight-robot", "--body", "sim", "--player", "2", "--seed", "7", "--record");
  const live = await Live.open(t, server);
  const seed = 77; // tells the new game's ticks from those of the old one
  await live.call("/sim/reset", { situation: "blocked", seed }); // no seed alone leads there
  await live.call("/sim/speed", { speed: 20 });
  const played = ({ seed: now, tick }) => now === seed && tick > 2000;
  await until(async () => played(await live.call("/sim/state")), "a minute of the game");
  await live.call("stop_recording");
  const [session] = await sessionsOf(server);
  const player = await start(t, folder, "foresight-lab", "play", join(folder, "logs", session.session));
  const { page, problems, panel } = await openChange(t, player, "what 14/2 believed: it attacks to the right");
  await panel.getByLabel("An edit").fill("set 14/2 believes ball 0.3 0");
  await page.keyboard.press("Enter");
  await panel.getByRole("button", { name: "Run futures" }).click();
  await rowOf(panel, "goal difference").waitFor();
  assert.equal(await panel.getByRole("button", { name: "Play on with it" }).count(), 0);
  assert.deepEqual(problems, []);
});

test("a moment of a recorded game is changed from the game itself, which is played again", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  const made = await run(
    "foresight-sim",
    "match",
    "--seed",
    "7",
    "--rules",
    "spl2025:5,halves=1,half_duration=60",
    "--mcap",
    file,
  );
  assert.equal(made.status, 0, made.stderr);
  const moment = /^the game at 1:3\d, as 14\/2 plays it/;
  const { problems, panel } = await openChange(t, await play(t, folder, file), moment, 5);
  assert.equal(await panel.getByRole("button", { name: "Play on with it" }).count(), 0, "nobody plays it");
  assert.deepEqual(problems, []);
});
