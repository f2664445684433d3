// The button "save moment" in Chromium: the shown moment becomes a situation that foresight-sim plays and checks.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { decode } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { play, run, start, temporaryFolder, until } from "./support.mjs";

const kShort = ["--rules", "spl2012:2,half_duration=30,ready_duration=10"];
const button = (page) => page.getByRole("button", { name: "save moment" });

/** Presses the button and returns the file's text. */
async function save(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), button(page).click()]);
  assert.equal(download.suggestedFilename(), "moment.json");
  return readFileSync(await download.path(), "utf8");
}

const simulator = async (...args) => {
  const { status, stdout, stderr } = await run("foresight-sim", ...args);
  assert.equal(status, 0, stderr);
  return stdout;
};

test("the moment of a recorded game at the playhead is saved, played from and checked", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  await simulator("match", ...kShort, "--seed", "7", "--mcap", file);
  const { schema, messages } = readStreamed(readFileSync(file)).topics.get("/truth/world");
  const truths = messages.map(({ data }) => decode(schema.name, schema.data, data));

  const server = await play(t, folder, file);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await page.getByRole("status", { name: "Score" }).waitFor();
  // some seconds of play, then the moment stands still
  await until(async () => /^0:2\d/.test(await page.getByLabel("Elapsed").textContent()), "the play");
  await page.getByRole("button", { name: "Freeze view" }).click();
  await page.getByRole("button", { name: "Go on" }).waitFor();
  await shoot(page, "save_moment");
  const fits = await button(page).evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth);
  assert.ok(fits, "its words fit");
  let text = "";
  await until(async () => text === (text = await save(page)), "a page that shows one moment");

  // the file holds one tick of the recording
  const moment = JSON.parse(text);
  assert.deepEqual([moment.teams, moment.half], [{ home: 14, away: 5 }, 1]);
  assert.ok(["ready", "set", "playing"].includes(moment.phase), moment.phase);
  assert.match(moment.about, /^baseline against baseline, spl2012.*, seed 7, moment \d/);
  const near = (one, other) => Math.abs(one - other) < 1e-3;
  const isAt = ({ ball, robots }) =>
    near(ball.x, moment.ball.x) &&
    near(ball.y, moment.ball.y) &&
    robots.every(({ team, player, x, y }) =>
      moment.robots.some(
        (robot) =>
          robot.side === (team === 14 ? "home" : "away") &&
          robot.player === player &&
          near(robot.x, x) &&
          near(robot.y, y),
      ),
    );
  assert.ok(truths.some(isAt), text);

  // foresight-sim plays from it, and checks it once it has a metric
  const saved = join(folder, "moment.json");
  writeFileSync(saved, text);
  const game = JSON.parse(await simulator("match", "--from", saved, ...kShort, "--seconds", "5", "--json"));
  assert.deepEqual(game.score, [moment.score.home, moment.score.away]);
  await simulator("situation", saved, ...kShort, "--rollouts", "4", "--seconds", "5");
  const check = {
    rules: kShort[1],
    seconds: 5,
    seeds: 4,
    metrics: { touch: "our touch" },
    events: ["at 1 s: penalise 5/2"],
  };
  writeFileSync(saved, JSON.stringify({ ...moment, check }));
  assert.match(await simulator("check", saved), /touch/);
  assert.deepEqual(problems, []);
});

test("the moment of a live simulated game is saved", async (t) => {
  const folder = temporaryFolder(t);
  const server = await start(t, folder, "foresight-robot", "--body", "sim", "--rules", "spl2012:2");
  const { page, problems } = await open(t, `${server.http}/#/field`);
  await page.getByRole("status", { name: "Score" }).waitFor();
  await until(async () => JSON.parse(await save(page)).robots.length === 4, "all robots");
  const moment = JSON.parse(await save(page));
  const saved = join(folder, "moment.json");
  writeFileSync(saved, JSON.stringify(moment));
  await simulator("match", "--from", saved, "--rules", "spl2012:2", "--seconds", "2");
  assert.deepEqual(problems, []);
});
