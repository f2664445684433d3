// The What-if view in Chromium: questions to a simulated robot and to a recording, the situation edited, refusals shown.
// A forecast depends on random numbers and on the processor's share; no test here depends on its figures.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { kPhone, open, shoot } from "./browser.mjs";
import { Live, pausedGame } from "./live.mjs";
import { atEnd, playGame, root, run, start, temporaryFolder, until } from "./support.mjs";

const kService = "/foresight/what_if";
const kUsual = "ask=in:200/for:10";

/** Collects the questions that the page sends. */
function questionsOf(page) {
  const questions = [];
  page.on("websocket", (socket) =>
    socket.on("framesent", ({ payload }) => {
      const text = Buffer.from(payload).toString("latin1");
      const at = text.indexOf('{"robot"');
      if (at >= 0 && text.includes('"budget_ms"'))
        questions.push(JSON.parse(Buffer.from(payload).subarray(at).toString()));
    }),
  );
  return questions;
}

/** Opens the view; `questions` holds all questions of the page from the beginning. */
async function ask(t, server, address = "#/14/2/what-if", options = {}) {
  const opened = await open(t, "about:blank", options);
  const questions = questionsOf(opened.page);
  await opened.page.goto(`${server.http}/${address}${address.includes("?") ? "" : `?${kUsual}`}`);
  // the button, or the reason why there is none
  await opened.page
    .getByRole("button", { name: "▶ Ask" })
    .or(opened.page.getByText("offers no service"))
    .first()
    .waitFor();
  return { ...opened, questions };
}

/** A team's own process whose robot plays and knows its pose, but not the ball. */
const kTeamWithoutBall = `
import sys, time
from foresight import Writer, float_field, now_ns, uint_field
pose, game = Writer("pose", "foresight.Pose", door=sys.argv[1]), Writer("game", "foresight.GameState", door=sys.argv[1])
told = {5: 14, 6: 2, 7: 5, 9: 1, 10: 1, 14: 5, 15: 1}  # player 2 of team 14; playing, normal, first half
while True:
    pose.write(now_ns(), *[float_field(number, value) for number, value in enumerate([-1, 0.5, 0, 0.1, 0.1, 0.1], 1)])
    game.write(now_ns(), *[uint_field(number, value) for number, value in told.items()], float_field(11, 300))
    time.sleep(0.1)
`;

const strategies = (page) => page.getByRole("list", { name: "Strategies" });
const advice = (page) => page.getByRole("status", { name: "Advice" });
const row = (page, name) =>
  strategies(page)
    .getByRole("listitem")
    .filter({ has: page.locator(".name").getByText(name, { exact: true }) });
const situation = (page) => page.getByLabel("The situation from above");
const settled = (page) => page.getByRole("button", { name: "▶ Ask" }).waitFor();

/** Where a place of the field [m] is on the screen: the whole carpet of 2012 fits into the canvas, with all robots beyond it. */
async function onScreen(page, things, { x, y }) {
  const box = await situation(page).boundingBox();
  const border = Math.min(
    2,
    Math.max(0.71, ...things.map((robot) => Math.max(Math.abs(robot.x) - 3, Math.abs(robot.y) - 2) + 0.3)),
  );
  const [length, width] = [6 + 2 * border, 4 + 2 * border];
  const upright = box.height > 1.15 * box.width;
  const scale = upright
    ? Math.min(box.height / length, box.width / width)
    : Math.min(box.width / length, box.height / width);
  const [right, up] = upright ? [-y, x] : [x, y];
  return { x: box.x + box.width / 2 + scale * right, y: box.y + box.height / 2 - scale * up };
}

async function drag(page, things, from, to) {
  const [one, other] = [await onScreen(page, things, from), await onScreen(page, things, to)];
  await page.mouse.move(one.x, one.y);
  await page.mouse.down();
  await page.mouse.move(other.x, other.y, { steps: 6 });
  await page.mouse.up();
}

/** Taps "Ask". A busy browser may take a tap for a long press, which asks nothing; then it taps again. */
async function tapToAsk(page, questions) {
  const before = questions.length;
  await until(async () => {
    await page.getByRole("button", { name: "▶ Ask" }).tap();
    return until(() => questions.length > before, "the question of this tap", 3000).catch(() => false);
  }, "the question");
  await settled(page);
}

const near = (a, b, most = 0.12) => Math.hypot(a.x - b.x, a.y - b.y) < most;

test("Enter asks; the answer has advice and a row for each strategy; arrow keys choose one, and the address keeps it", async (t) => {
  const { server, live } = await pausedGame(t);
  const { page, problems, questions } = await ask(t, server, undefined, { colorScheme: "dark" });
  await page.keyboard.press("Enter");
  await page.getByRole("progressbar", { name: "Time to the answer" }).waitFor();
  await page.getByText("Your question").waitFor();
  await advice(page)
    .getByText(/^(Keep|Change to|No advice)/)
    .waitFor();
  const { forecast } = await live.call(kService, { budget_ms: 10 });
  const names = forecast.strategies.map(({ strategy }) => strategy);
  assert.equal(await strategies(page).getByRole("listitem").count(), names.length);
  assert.deepEqual(questions, [
    {
      robot: "14/2",
      measure: "goal_difference",
      until: "horizon",
      horizon: 10,
      budget_ms: 200,
      ...(questions[0].strategies && { strategies: questions[0].strategies }),
    },
  ]);
  assert.equal(await strategies(page).getByText("plays now").count(), 1);
  assert.equal(await row(page, names[0]).getByText("compared with").count(), 1);

  const pressed = strategies(page).locator("button[aria-pressed=true] .name");
  for (let i = 0; i < names.length; ++i) await page.keyboard.press("ArrowUp");
  await until(async () => (await pressed.textContent()) === names[0], "the first");
  await page.keyboard.press("ArrowDown");
  await until(async () => (await pressed.textContent()) === names[1], "the second");
  await page.waitForURL(new RegExp(`pick=${names[1]}`));
  await shoot(page, "what-if-dark");

  // fewer strategies, another measure, a longer horizon
  await page.getByRole("group", { name: "Strategies to try" }).getByRole("button", { name: names[2] }).click();
  await page.getByLabel("Better by").selectOption("concede");
  await page.getByLabel("Looks ahead").selectOption("half");
  await page.getByRole("button", { name: "▶ Ask" }).click();
  await until(() => questions.length === 2, "the second question");
  assert.deepEqual(
    { ...questions[1] },
    {
      robot: "14/2",
      strategies: names.filter((name) => name !== names[2]),
      measure: "concede",
      until: "half",
      horizon: 10,
      budget_ms: 200,
    },
  );
  await settled(page);
  await until(
    async () => (await strategies(page).getByRole("listitem").count()) === names.length - 1,
    "one strategy less",
  );
  await page.waitForURL(/by:concede\/until:half/);
  await page.getByText(/left: to the end of the half, [\d:]+.*, by not conceding next/).waitFor();
  await page.keyboard.press("Escape");
  await page.getByText("Forecast of 14/2").waitFor();
  assert.deepEqual(problems, []);
});

test("the team's strategy comes from memory for every comparison; the advice compares with it", async (t) => {
  const { server, live } = await pausedGame(t);
  await live.subscribe("/14/2/strategy");
  const { name: plays } = live.decoded("/14/2/strategy", await live.newest("/14/2/strategy"));
  const other = ["passing", "baseline"].find((name) => name !== plays);
  const { page, problems, questions } = await ask(t, server, `#/14/2/what-if?ask=play:${other},${plays}/in:200/for:10`);
  await page.keyboard.press("Enter");
  await page.getByText("Your question").waitFor();
  await row(page, plays).getByText("plays now").waitFor();
  assert.deepEqual(questions[0].strategies, [other, plays]);
  assert.equal(await row(page, other).getByText("plays now").count(), 0);
  assert.equal(await row(page, other).getByText("compared with").count(), 1);
  await advice(page)
    .getByText(/^(Nothing clearly beats|No advice)|beats/)
    .first()
    .waitFor();
  assert.equal(
    await advice(page)
      .getByText(/^(Keep|Change to)/)
      .count(),
    0,
  );

  // an edited score or time makes the answer's rollouts stale
  const stale = page.getByText("as foreseen before the edit");
  for (const [label, value] of [
    ["Own goals", "3"],
    ["Their goals", "2"],
    ["Seconds left of the half", "20"],
  ]) {
    assert.equal(await stale.count(), 0, label);
    await page.getByLabel(label).fill(value);
    await stale.waitFor();
    await page.getByText("· edited since").waitFor();
    await page.getByLabel(label).fill("");
    await stale.waitFor({ state: "detached" });
  }
  assert.deepEqual(problems, []);
});

test("before any answer the situation is the robot's own belief, and can be edited", async (t) => {
  const { server, live } = await pausedGame(t);
  await live.subscribe("/14/2/pose");
  const { page, problems, questions } = await ask(t, server);
  await page.getByText("to ask for a forecast of each strategy").waitFor();
  const things = page.getByLabel("Ball or robot to place");
  await until(async () => (await things.locator("option").allTextContents()).includes("own 2"), "the robot itself");
  await things.selectOption("own 2");
  const { x } = live.decoded("/14/2/pose", await live.newest("/14/2/pose"));
  assert.ok(Math.abs(Number(await page.getByLabel("x, m").inputValue()) - x) < 0.01, "its believed place");

  // newer beliefs of the robot do not overwrite typed text, and hovering does not redirect it
  await page.getByLabel("x, m").fill("-2.5");
  await live.call("/sim/step", { ticks: 30 });
  await page.mouse.move(100, 300);
  await page.waitForTimeout(500); // neither of them changes the text
  assert.equal(await page.getByLabel("x, m").inputValue(), "-2.5");
  await page.getByLabel("x, m").blur();
  await page.getByRole("group", { name: "Edited" }).getByRole("button", { name: "own 2" }).click();
  await things.selectOption("ball");
  await page.getByLabel("y, m").fill("1");
  await page.getByLabel("y, m").blur();
  await page.getByRole("button", { name: "▶ Ask" }).click();
  await until(() => questions.length === 1, "the question");
  assert.equal(questions[0].edit.ball.y, 1);
  assert.equal(questions[0].edit.robots, undefined);
  assert.deepEqual(problems, []);
});

test("a robot that does not know the ball refuses, until the question says where the ball is", async (t) => {
  const folder = temporaryFolder(t);
  const door = join(folder, "door");
  const server = await start(t, folder, "foresight-robot", "--body", "attached", "--door", door);
  const team = spawn("python3", ["-c", kTeamWithoutBall, door], {
    env: { ...process.env, PYTHONPATH: join(root, "robot/client"), PYTHONDONTWRITEBYTECODE: "1" },
  });
  atEnd(t, () => team.kill());
  const { page, problems, questions } = await ask(t, server);
  const things = page.getByLabel("Ball or robot to place");
  await until(async () => (await things.locator("option").allTextContents()).includes("own 2"), "the robot itself");
  await page.keyboard.press("Enter");
  await page.getByRole("alert").filter({ hasText: "cannot tell, because nobody has seen the ball yet" }).waitFor();
  await page.waitForTimeout(500); // the memory object repeats the sentence a little later, the page does not
  assert.equal(await page.getByText(/nobody has seen the ball yet/).count(), 1, "said once");
  await shoot(page, "what-if-no-ball");
  await page.getByRole("button", { name: "Place it" }).click();
  await page.getByRole("group", { name: "Edited" }).getByRole("button", { name: "ball" }).waitFor();
  await page.getByRole("button", { name: "▶ Ask" }).click();
  await page.getByText("Your question").waitFor();
  assert.deepEqual(questions[1].edit, { ball: { x: 0, y: 0 } });
  await advice(page).waitFor();
  await shoot(page, "what-if-placed");

  // after the edit is undone, the ball is unknown again
  await page.getByRole("group", { name: "Edited" }).getByRole("button", { name: "ball" }).click();
  await page.getByRole("button", { name: "Place it" }).waitFor();
  assert.deepEqual(problems, []);
});

test("ball and robots can be dragged, turned and put back; changes go into the question and the address", async (t) => {
  const { server, live } = await pausedGame(t);
  const { page, problems, questions } = await ask(t, server);
  await page.keyboard.press("Enter");
  await page.getByText("Your question").waitFor();
  const { forecast } = await live.call(kService, { budget_ms: 10 });
  const { ball, robots } = forecast.situation;
  assert.equal(questions[0].edit, undefined);

  await drag(page, [ball, ...robots], ball, { x: -1.5, y: 1.2 });
  const moved = page.getByRole("group", { name: "Edited" });
  await moved.getByRole("button", { name: "ball" }).waitFor();
  await page.keyboard.press("Enter");
  await until(() => questions.length === 2, "the question with the ball elsewhere");
  assert.ok(near(questions[1].edit.ball, { x: -1.5, y: 1.2 }), JSON.stringify(questions[1].edit));
  assert.equal(questions[1].edit.robots, undefined);
  await page.waitForURL(/ball:-1\.\d+,1\.\d+/);
  await settled(page);

  // an opponent, by numbers to a free place, and turned by the wheel
  const opponent = robots.find(({ side }) => side === "opponent");
  const free = [-1.5, 0, 1.5]
    .flatMap((y) => [2, 1, 0, -1].map((x) => ({ x, y })))
    .find((place) => robots.every((one) => !near(one, place, 0.6)));
  await page.getByLabel("Ball or robot to place").selectOption(`opponent ${opponent.player}`);
  await page.getByLabel("x, m").fill(String(free.x));
  await page.getByLabel("x, m").blur();
  await page.getByLabel("y, m").fill(String(free.y));
  await page.getByLabel("y, m").blur();
  const at = await onScreen(page, [ball, ...robots], free);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, 400);
  await page.getByLabel("Own goals").fill("1");
  await page.getByLabel("Seconds left of the half").fill("90");
  await page.getByRole("button", { name: "▶ Ask" }).click();
  await until(() => questions.length === 3, "the third question");
  const { edit } = questions[2];
  assert.deepEqual([edit.own_score, edit.seconds_remaining, edit.robots.length], [1, 90, 1]);
  assert.deepEqual(
    [edit.robots[0].side, edit.robots[0].player, edit.robots[0].x, edit.robots[0].y],
    ["opponent", opponent.player, free.x, free.y],
  );
  assert.notEqual(edit.robots[0].heading, Math.round(1000 * opponent.heading) / 1000);
  await settled(page);
  await shoot(page, "what-if-edited");

  // a colleague's link holds the same question
  const colleague = await ask(t, server, page.url().slice(page.url().indexOf("#")));
  await colleague.page.getByRole("group", { name: "Edited" }).getByRole("button", { name: "ball" }).waitFor();
  await colleague.page.keyboard.press("Enter");
  await until(() => colleague.questions.length === 1, "the colleague's question");
  assert.deepEqual(colleague.questions[0].edit, edit);

  await moved.getByRole("button", { name: "ball" }).click();
  await moved.getByRole("button", { name: "ball" }).waitFor({ state: "detached" });
  await page.locator("body").press("r");
  await moved.getByRole("button", { name: "Reset all" }).waitFor({ state: "detached" });
  await page.waitForURL((url) => !url.hash.includes("opponent"));
  assert.deepEqual([...problems, ...colleague.problems], []);
});

test("the page shows the sentence of a refusal, and a strategy that the robot does not offer can be removed", async (t) => {
  const { server } = await pausedGame(t);
  const { page, problems, questions } = await ask(
    t,
    server,
    "#/14/2/what-if?ask=play:%253Cimg%2520src%253Dx%253E,baseline/in:100",
  );
  await page.keyboard.press("Enter");
  await page
    .getByRole("alert")
    .getByText(/^⚠ no strategy "<img src=x>"/)
    .waitFor();
  assert.equal(await page.locator("section img").count(), 0);
  await shoot(page, "what-if-refused");

  // the strategies that the robot offers can be chosen
  const tried = page.getByRole("group", { name: "Strategies to try" });
  await page.getByLabel("Compare with").selectOption("passing");
  await tried.getByRole("button", { name: "<img src=x>" }).click();
  await tried.getByRole("button", { name: "<img src=x>" }).waitFor({ state: "detached" });
  await page.getByRole("button", { name: "▶ Ask" }).click();
  await page.getByText("Your question").waitFor();
  await row(page, "passing").getByText("compared with").waitFor();
  assert.deepEqual(questions.at(-1).strategies, ["passing", "baseline"]);
  assert.deepEqual(problems, []);
});

test("a recording is asked at the moment that the page shows", async (t) => {
  const server = await playGame(t);
  const { page, problems, questions } = await ask(t, server, "#/14/2/what-if", { colorScheme: "light" });
  await page.locator("footer").getByRole("button", { name: "Freeze view" }).waitFor();
  await page.keyboard.press("Home");
  await page.waitForURL(/at=\d+/);
  const answered = page.getByText("Your question");
  const refused = page.getByRole("alert").filter({ hasText: "cannot tell, because" });
  // from one moment to the next, until the robot knows enough; the page shows the moment of the question
  let asked = 0;
  await until(async () => {
    await page.keyboard.press("Shift+ArrowRight");
    await page.keyboard.press("Enter");
    await until(() => questions.length > asked, "the question");
    asked = questions.length;
    await settled(page);
    await answered.or(refused).waitFor();
    return answered.isVisible();
  }, "a moment at which the robot knows enough");
  const [, minutes, seconds] = /(\d+):(\d\d)/.exec(await page.getByTitle("Go to this moment").first().textContent());
  assert.equal(60 * Number(minutes) + Number(seconds), 10 * asked, "asked about the shown moment");
  await advice(page).waitFor();
  await shoot(page, "what-if-recording");

  // another robot of the recording
  await page.keyboard.press("j");
  await page.waitForURL((url) => !url.hash.startsWith("#/14/2/"));
  await answered.waitFor({ state: "detached" });
  await page.keyboard.press("Enter");
  await until(() => questions.length > asked, "its question");
  assert.notEqual(questions.at(-1).robot, "14/2");
  assert.deepEqual(problems, []);
});

test("forecasts are listed and follow the page's time; the field can show them as a layer", async (t) => {
  const { server, live } = await pausedGame(t);
  const { page, problems } = await ask(t, server);
  await page.keyboard.press("Enter");
  await page.getByText("Your question").waitFor();
  await live.call("/sim/resume");
  const { tick } = await live.call("/sim/state");
  await until(async () => (await live.call("/sim/state")).tick > tick + 30, "a second of the game");
  await settled(page);
  const history = page.getByRole("listitem").filter({ has: page.getByTitle("Go to this moment") });
  const byPeople = history.filter({ hasText: "people" });
  const before = await byPeople.count();
  assert.ok(before > 0);
  await page.keyboard.press("Enter");
  await until(async () => (await byPeople.count()) > before, "another forecast");
  await settled(page);
  const newest = await byPeople.first().elementHandle();
  const isMarked = () => newest.evaluate((row) => row.getAttribute("aria-current") === "true");
  // the game goes on, and new forecasts move the rows: a click by place may meet another one
  await byPeople.last().getByRole("button").dispatchEvent("click");
  await page.waitForURL(/at=\d+/);
  await page.getByText("Forecast of 14/2").waitFor();
  await page.getByText("The robot answers from now, not from the moment that is shown.").waitFor();
  await until(
    async () => !(await isMarked()) && (await page.locator("li[aria-current]").count()) === 1,
    "another one held then",
    undefined,
    async () => [
      await isMarked(),
      await history.allTextContents(),
      await page.locator("li[aria-current]").count(),
      page.url(),
    ],
  );

  await page.getByRole("link", { name: "field", exact: true }).click();
  const layer = page.getByRole("group", { name: "Layers" }).getByRole("button", { name: "forecast" });
  assert.equal(await layer.getAttribute("aria-pressed"), "false");
  await layer.click();
  await page.waitForURL(/layers=[^&]*forecast/);
  await shoot(page, "what-if-layer");
  assert.deepEqual(problems, []);
});

test("on a phone the situation is upright and can be moved by finger; the page scrolls beside it", async (t) => {
  const { server, live } = await pausedGame(t);
  for (const colorScheme of ["dark", "light"]) {
    const { page, problems, questions } = await ask(t, server, undefined, {
      viewport: kPhone,
      hasTouch: true,
      isMobile: true,
      deviceScaleFactor: 2,
      colorScheme,
    });
    await tapToAsk(page, questions);
    await page.getByText("Your question").waitFor();
    const { ball, robots } = (await live.call(kService, { budget_ms: 10 })).forecast.situation;
    await situation(page).evaluate((canvas) => canvas.scrollIntoView({ block: "start" }));
    await drag(page, [ball, ...robots], ball, { x: 0.5, y: -1 });
    await page.getByRole("group", { name: "Edited" }).getByRole("button", { name: "ball" }).waitFor();
    await tapToAsk(page, questions);
    assert.ok(near(questions.at(-1).edit.ball, { x: 0.5, y: -1 }), JSON.stringify(questions.at(-1).edit));
    await page.mouse.move(5, 5);
    await shoot(page, `what-if-phone-${colorScheme}`);
    await advice(page).scrollIntoViewIfNeeded();
    await shoot(page, `what-if-phone-${colorScheme}-answer`);
    assert.deepEqual(problems, []);
  }
});

test("the page reports why a robot cannot foresee", async (t) => {
  const folder = temporaryFolder(t);
  // the game begins after that second
  const { status, stderr } = await run("foresight-lab", "synthesize", join(folder, "session"), "--seconds", "1");
  assert.equal(status, 0, stderr);
  const server = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "replay",
    "--session",
    join(folder, "session"),
    "--loop",
  );
  const { page, problems } = await ask(t, server, "#/14/2/what-if");
  await page.getByRole("button", { name: "▶ Ask" }).waitFor(); // the page learns of the services after it is connected
  await page.keyboard.press("Enter");
  await page.getByRole("alert").filter({ hasText: "cannot tell, because the game has not begun" }).waitFor();
  await shoot(page, "what-if-none");
  assert.deepEqual(problems, []);
});
