// A simulated game as a live robot: as the independent Foxglove client sees it, and its services.
import assert from "node:assert/strict";
import { test } from "node:test";
import { open, shoot } from "./browser.mjs";
import { foxgloveClient } from "./foxglove.mjs";
import { decode, Live } from "./live.mjs";
import { readStreamed } from "./mcap.mjs";
import { download, run, sessionsOf, start, statusOf, temporaryFolder, until } from "./support.mjs";

const kShort = "spl2012,halves=1,half_duration=1,ready_duration=1,set_duration=1";

const simulate = (t, folder, ...args) => start(t, folder, "foresight-robot", "--body", "sim", ...args);
const simulated = (t, ...args) => simulate(t, temporaryFolder(t), ...args);

test("the Foxglove client sees every robot's objects, decisions 30 times a second, and the truth", async (t) => {
  const server = await simulated(t, "--seed", "7", "--player", "2");
  const { client } = foxgloveClient(t, server);
  const channels = new Map();
  client.on("advertise", (list) => list.forEach((channel) => channels.set(channel.topic, channel)));
  await until(() => channels.has("/sim/state") && channels.has("/5/4/decision"), "the channels");

  for (const team of [14, 5])
    for (const player of [1, 2, 3, 4])
      for (const object of ["ball", "pose", "team", "game", "odometry", "motion_command", "motion_status", "decision"])
        assert.ok(channels.has(`/${team}/${player}/${object}`), `/${team}/${player}/${object}`);
  assert.ok(!channels.has("/14/2/camera_top"), "a simulated robot has no pictures");

  const messages = new Map();
  const topicOf = new Map();
  client.on("message", ({ subscriptionId, timestamp, data }) =>
    messages
      .get(topicOf.get(subscriptionId))
      .push({ log_ns: timestamp, data: Buffer.from(data.buffer, data.byteOffset, data.byteLength) }),
  );
  for (const topic of ["/truth/world", "/5/3/decision", "/14/2/pose", "/sim/state"]) {
    messages.set(topic, []);
    topicOf.set(client.subscribe(channels.get(topic).id), topic);
  }
  await until(
    () => [...messages.values()].every((list) => list.length >= 60),
    "two seconds of them",
    undefined,
    () => [...messages.values()].map((list) => list.length),
  );

  // most of two seconds' times are a tick apart; a busy machine may skip some, for a while
  const even = () => {
    const times = messages
      .get("/truth/world")
      .slice(-60)
      .map(({ log_ns }) => log_ns);
    return (
      times.slice(1).filter((time, i) => time - times[i] >= 33_333_000n && time - times[i] <= 33_334_000n).length /
      (times.length - 1)
    );
  };
  await until(() => even() > 0.8, "four of five times are 1/30 s apart", undefined, even);

  const last = (topic) => {
    const { schemaName, schema } = channels.get(topic);
    return decode(schemaName, Buffer.from(schema, "base64"), messages.get(topic).at(-1).data);
  };
  assert.equal(last("/truth/world").robots.length, 8);
  assert.equal(last("/5/3/decision").strategy, "baseline");
  const state = last("/sim/state");
  assert.deepEqual(
    [state.seed, state.rules, state.home.number, state.away.number, state.field.length],
    ["7", "spl2012", 14, 5, 6],
  );
  assert.deepEqual((await statusOf(server)).robots, ["14/2"]);
});

test("the services control the game, and memory shows it", async (t) => {
  const server = await simulated(
    t,
    "--seed",
    "7",
    "--side",
    "away",
    "--player",
    "3",
    "--team",
    "21",
    "--opponent",
    "9",
  );
  const live = await Live.open(t, server);
  await live.subscribe("/sim/state", "/truth/world", "/21/3/ball");
  const shown = async (what, holds) => {
    const messages = live.messages.get("/sim/state");
    await live.until(() => messages.length > 0 && holds(live.decoded("/sim/state", messages.at(-1))), what);
    return live.decoded("/sim/state", messages.at(-1));
  };

  const paused = await live.call("/sim/pause");
  assert.equal(paused.ok, true);
  assert.deepEqual([paused.home.number, paused.away.number], [9, 21]);
  await shown("that it is paused", ({ paused }) => paused);
  const stepped = await live.call("/sim/step", { ticks: 45 });
  assert.equal(stepped.tick, paused.tick + 45);
  assert.equal((await live.call("/sim/state")).tick, stepped.tick, "nothing plays on its own");

  // one seed, one game: the truth after this number of steps is the same each time
  const after = async (seed) => {
    await live.call("/sim/seed", { seed });
    const { tick } = await live.call("/sim/step", { ticks: 300 });
    await shown("the last step", (state) => Number(state.seed) === seed && state.tick === tick);
    await live.until(
      () => live.messages.get("/truth/world").at(-1).log_ns === live.messages.get("/sim/state").at(-1).log_ns,
      "its truth",
    );
    return live.decoded("/truth/world", live.messages.get("/truth/world").at(-1));
  };
  const first = await after(11);
  assert.notDeepEqual(await after(12), first);
  assert.deepEqual(await after(11), first);

  const situation = {
    ball: { x: 1, y: 0.5 },
    robots: [{ side: "home", player: 2, x: 0.8, y: 0.5 }],
    score: { home: 3, away: 1 },
  };
  const reset = await live.call("/sim/reset", { situation, seed: 5 });
  assert.deepEqual([reset.ok, reset.home.score, reset.away.score, reset.seed], [true, 3, 1, 5]);

  assert.equal((await live.call("/sim/speed", { speed: 20 })).speed, 20);
  assert.equal((await live.call("/sim/resume")).paused, false);
  await shown("that it goes on, fast", ({ tick, speed }) => tick > 200 && speed === 20);

  for (const [service, request, sentence] of [
    ["/sim/step", { ticks: 0 }, "simulation: 'ticks' must be 1 .. 1800, got 0"],
    ["/sim/speed", { speed: "fast" }, "/sim/speed: 'speed' must be a number 0.1 .. 100"],
    ["/sim/seed", { seed: -1 }, "/sim/seed: 'seed' must be a whole number 0 .. 9007199254740991, got -1"],
  ])
    assert.deepEqual(await live.call(service, request), { ok: false, error: sentence });
  const refused = await live.call("/sim/reset", { situation: { ball: { x: 1 } } });
  assert.equal(refused.ok, false);
  assert.match(refused.error, /^\/sim\/reset: situation: .*y/);
});

test("a game stays at its end; in a loop the next seed follows", async (t) => {
  const live = await Live.open(t, await simulated(t, "--rules", kShort, "--seed", "3", "--speed", "100"));
  const state = await until(async () => {
    const answer = await live.call("/sim/state");
    return answer.finished && answer;
  }, "the end");
  assert.match((await live.call("/sim/resume")).error, /the game is over/);
  assert.equal((await live.call("/sim/state")).tick, state.tick);

  const loop = await Live.open(t, await simulated(t, "--rules", kShort, "--seed", "3", "--speed", "100", "--loop"));
  await until(async () => (await loop.call("/sim/state")).seed === 4, "the next game");
});

test("a simulated game is recorded like any robot", async (t) => {
  const server = await simulated(t, "--record", "--speed", "2");
  const live = await Live.open(t, server);
  await until(async () => (await live.call("/sim/state")).tick > 60, "a second of the game");
  assert.equal((await live.call("stop_recording")).ok, true);
  const [session] = await sessionsOf(server);
  const { topics } = readStreamed(await download(server, session.url));
  for (const topic of ["/truth/world", "/sim/state", "/14/2/decision", "/5/1/pose"])
    assert.ok(topics.get(topic)?.messages.length > 20, topic);
});

test("an impossible game gives one sentence and status 2", async () => {
  const refused = async (...args) => {
    const { status, stderr } = await run("foresight-robot", "--body", "sim", "--port", "0", ...args);
    assert.equal(status, 2, args.join(" "));
    return stderr.trim();
  };
  assert.match(await refused("--player", "5"), /in spl2012 'player' must be 1 .. 4, got 5$/);
  assert.match(await refused("--home", "nobody"), /nobody.*there are: .*baseline/);
  assert.match(await refused("--models", "nature"), /nature.*there are: .*match/);
  assert.match(await refused("--rules", "chess"), /chess.*there are: .*spl2012/);
  assert.match(await refused("--opponent", "14"), /the two teams need different numbers, both have 14$/);
  assert.match(await refused("--speed", "101"), /'speed' must be 0.1 .. 100/);
});

test("the page shows the field of a simulated game, and its buttons pause, step and restart it", async (t) => {
  const server = await simulated(t, "--seed", "7", "--speed", "10");
  const live = await Live.open(t, server);
  await until(async () => (await live.call("/sim/state")).seconds > 40, "play");
  const { page, problems } = await open(t, server.http);
  await page.getByRole("region", { name: "Field" }).waitFor();
  const title = "14/2 · field · Foresight"; // the robot's name comes with its first data
  await until(async () => (await page.title()) === title, `the title ${title}`);
  await page.getByRole("button", { name: "Pause game" }).click();
  await page.getByRole("button", { name: "Play game" }).waitFor();
  const { tick } = await live.call("/sim/state");
  await page.getByRole("button", { name: "Step" }).click();
  await until(async () => (await live.call("/sim/state")).tick === tick + 1, "a step");

  // a click on a robot chooses it
  await live.subscribe("/truth/world");
  const truth = live.decoded("/truth/world", await live.newest("/truth/world"));
  const { x, y, player } = truth.robots.find(({ team }) => team === 5); // a removed robot is not there
  const box = await page.locator("main canvas").boundingBox();
  const scale = Math.min(box.width / 7.4, box.height / 5.4);
  await page.mouse.click(box.x + box.width / 2 + scale * x, box.y + box.height / 2 - scale * y);
  await page.waitForURL(new RegExp(`#/5/${player}/field$`));
  await shoot(page, "field");

  await page.getByLabel("Seed").fill("99");
  await page.getByRole("button", { name: "New game" }).click();
  await page.getByText(/seed 99/).waitFor();
  await page.getByLabel("Speed").selectOption("2");
  await until(async () => (await live.call("/sim/state")).speed === 2, "the speed");
  assert.deepEqual(problems, []);
});
