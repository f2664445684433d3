// Foresight through the independent Foxglove client: it asks a robot, memory holds the answer, nonsense has no effect.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { createSocket } from "node:dgram";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { foxgloveClient } from "./foxglove.mjs";
import { Live, pausedGame, playbackControl } from "./live.mjs";
import { atEnd, needsNetwork, own, root, run, start, statusOf, temporaryFolder, until } from "./support.mjs";

const kService = "/foresight/what_if";
const kStrategies = ["baseline", "passing", "kick_now", "high_line"];

/** Foxglove's own client: returns a function that calls a service with a text and resolves to its answer. */
async function independentClient(t, server) {
  const { client } = foxgloveClient(t, server);
  const services = new Map();
  const answers = new Map();
  client.on("advertiseServices", (list) => list.forEach(({ id, name }) => services.set(name, id)));
  client.on("serviceCallResponse", ({ callId, data }) =>
    answers.set(callId, JSON.parse(Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString())),
  );
  await until(() => services.has(kService), "the services");
  let callId = 0;
  return (name, text) => {
    const call = ++callId;
    client.sendServiceCallRequest({
      serviceId: services.get(name),
      callId: call,
      encoding: "json",
      data: new TextEncoder().encode(text),
    });
    return until(() => answers.get(call), `the answer of ${name}`);
  };
}

test("the Foxglove client asks and is answered, and memory holds the same", async (t) => {
  const { server, live } = await pausedGame(t);
  await live.subscribe("/14/2/forecast");

  const call = await independentClient(t, server);
  const answer = await call(
    kService,
    JSON.stringify({ strategies: ["baseline", "kick_now"], budget_ms: 300, horizon: 10 }),
  );
  assert.equal(answer.ok, true, answer.error);
  assert.equal(answer.robot, "14/2");
  const { forecast } = answer;
  assert.deepEqual(
    forecast.strategies.map(({ strategy }) => strategy),
    ["baseline", "kick_now"],
  );
  assert.deepEqual([forecast.question.strategies, forecast.question.asked_by], [["baseline", "kick_now"], "people"]);
  assert.ok(forecast.situation.seconds_remaining > 0 && forecast.situation.seconds_remaining <= 600);
  assert.ok(["none", "keep", "change"].includes(forecast.advice));
  assert.ok(forecast.answered_ms >= 300);
  assert.ok(forecast.computed_ms <= forecast.answered_ms);
  assert.ok(forecast.situation.robots.length >= 6, "both teams");
  for (const { rollouts, heat, heat_columns, best } of forecast.strategies) {
    assert.equal(heat.length % heat_columns, 0);
    assert.ok(best >= 0 && best <= 1);
    assert.equal(rollouts, forecast.strategies[0].rollouts, "two strategies race to the end");
  }

  const { data: message, log_ns } = await live.newest("/14/2/forecast");
  const held = live.decoded("/14/2/forecast", { data: message });
  assert.equal(held.reason, forecast.reason);
  assert.equal(held.asked_ns, forecast.asked_ns);
  assert.equal(String(log_ns), forecast.asked_ns, "its time is the moment that it is about");
});

test("questions can be about any robot, and about edited situations", async (t) => {
  const { live } = await pausedGame(t);
  const other = await live.call(kService, { robot: "5/3", budget_ms: 50 });
  assert.equal(other.robot ?? other.error, "5/3");
  assert.deepEqual(
    other.forecast.strategies.map(({ strategy }) => strategy),
    kStrategies,
  );

  const edit = {
    ball: { x: 1.5, y: -1 },
    robots: [{ side: "own", player: 3, x: 1, y: -1, heading: 0.5 }],
    own_score: 2,
    seconds_remaining: 60,
  };
  const { forecast } = await live.call(kService, { budget_ms: 50, edit });
  assert.deepEqual(forecast.situation.ball, { x: 1.5, y: -1, deviation: 0, elsewhere: 0 });
  assert.deepEqual([forecast.situation.own_score, Math.round(forecast.situation.seconds_remaining)], [2, 60]);
  assert.deepEqual(
    forecast.situation.robots.find(({ side, player }) => side === "own" && player === 3),
    { side: "own", player: 3, x: 1, y: -1, heading: 0.5, deviation: 0 },
  );
});

test("nonsense gets one sentence and has no other effect", async (t) => {
  const { live } = await pausedGame(t);
  await live.subscribe("/14/2/forecast");
  const sentences = [
    [{ strategies: ["tiki_taka"] }, `no strategy "tiki_taka"; there are: ${kStrategies.join(", ")}`],
    [{ strategies: ["../../etc/passwd"] }, `no strategy "../../etc/passwd"; there are: ${kStrategies.join(", ")}`],
    [{ rollouts: 1e9 }, "'rollouts' is no member of a question"],
    [{ budget_ms: 1e9 }, "'budget_ms' must be 10 .. 10000 [ms], got 1000000000"],
    [{ horizon: null }, "'horizon' must be a number, got null"],
    [{ horizon: 1e300 }, "'horizon' must be 1 .. 1200 [s], got 1e+300"],
    [{ edit: { ball: { x: 3, y: 0.7 } } }, "the ball at 3, 0.7 is in a goalpost"],
    [{ edit: { ball: { x: "NaN", y: 0 } } }, `'edit.ball.x' must be a number, got "NaN"`],
    [
      {
        edit: {
          robots: [
            { side: "own", player: 2, x: 0, y: 0 },
            { side: "own", player: 3, x: 0.1, y: 0 },
          ],
        },
      },
      "own player 3 stands in another robot",
    ],
    [{ edit: { seconds_remaining: 1e6 } }, "'seconds_remaining' must be 0 .. 600 [s], got 1e+06"],
    [{ robot: "99/9" }, "there is no robot '99/9'"],
    [{ strategies: Array(5000).fill("baseline") }, /^'strategies' must be a list of names, got \[.*…$/],
  ];
  for (const [question, sentence] of sentences) {
    const { ok, error } = await live.call(kService, question);
    assert.equal(ok, false, JSON.stringify(question).slice(0, 80));
    assert.ok(error.startsWith(`${kService}: `), error);
    const told = error.slice(kService.length + 2);
    sentence instanceof RegExp ? assert.match(told, sentence) : assert.equal(told, sentence);
  }
  assert.equal(live.messages.get("/14/2/forecast").length, 0, "there is no forecast");
});

test("a question nested a hundred thousand deep gets one sentence, in every service", async (t) => {
  const { server, live } = await pausedGame(t);
  const deep = (inner) => `{"horizon":${"[".repeat(100000)}${inner}${"]".repeat(100000)}}`;
  const sentence = "expected JSON nested at most 64 deep, got deeper nesting";

  const call = await independentClient(t, server);
  for (const name of [kService, "/sim/reset", "/sim/step", "start_recording", "clock_sync"])
    assert.deepEqual(await call(name, deep("1")), { ok: false, error: `${name}: ${sentence}` });
  live.send(`{"op":"setParameters","parameters":[{"name":"foresight","value":${deep("1")}}]}`);
  await live.until(
    () => live.statuses.some(({ message }) => message === `request: ${sentence}`),
    "the sentence about a parameter",
  );
  assert.equal((await live.call(kService, { budget_ms: 50 })).ok, true, "it still answers");
});

test("the captain asks by itself, and foresight can be switched on and off", async (t) => {
  const server = await start(
    t,
    temporaryFolder(t),
    "foresight-robot",
    "--body",
    "sim",
    "--speed",
    "10",
    "--player",
    "2",
  );
  const live = await Live.open(t, server);
  await live.subscribe("/14/2/forecast");
  live.send({
    op: "setParameters",
    parameters: [
      { name: "foresight_budget_ms", value: 50 },
      { name: "foresight_horizon", value: 5 },
    ],
  });
  const { data } = await live.newest("/14/2/forecast");
  const forecast = live.decoded("/14/2/forecast", { data });
  assert.match(forecast.question.asked_by, /^captain: /);
  assert.deepEqual(forecast.question.strategies, kStrategies);

  live.send({ op: "setParameters", parameters: [{ name: "foresight", value: false }], id: "off" });
  await live.until(
    () =>
      live.values.some(({ parameters }) =>
        parameters?.some(({ name, value }) => name === "foresight" && value === false),
      ),
    "that it is off",
  );
});

test("forecasts are scored live, and the recording gives the same scores", async (t) => {
  const folder = temporaryFolder(t);
  const server = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "sim",
    "--strategies",
    "baseline,kick_now",
    "--record",
    "--name",
    "scored",
  );
  const live = await Live.open(t, server);
  await live.subscribe("/14/2/forecast_score");
  const wishes = { foresight_budget_ms: 100, foresight_horizon: 1, foresight_period: 2 };
  live.send({ op: "setParameters", parameters: Object.entries(wishes).map(([name, value]) => ({ name, value })) });
  const scored = () => live.messages.get("/14/2/forecast_score").length;
  await until(() => scored() >= 3, "three forecasts whose time has passed", 120000); // on a busy machine there are few rollouts
  await server.stop();

  const [session] = readdirSync(join(folder, "logs")).filter((name) => name.includes("scored"));
  const { stdout: text } = await run("foresight-lab", "info", join(folder, "logs", session));
  assert.match(
    text,
    /forecasts of 14\/2:\n(baseline|kick_now), \d+ of 1 s +came +foretold +Brier +of the rate +log-loss\n {2}own goal .*\n/,
  );
  const { stdout } = await run("foresight-lab", "info", join(folder, "logs", session), "--json");
  const { entries } = JSON.parse(stdout).forecasts["14/2"];
  assert.ok(entries.reduce((sum, { forecasts }) => sum + forecasts, 0) >= 2);
  for (const { horizon, score, concede } of entries) {
    assert.equal(horizon, 1);
    for (const { log_loss, bins } of [score, concede]) assert.ok(log_loss >= 0 && bins.length === 10);
  }
});

test("a parameter is set while a question runs", async (t) => {
  const { live } = await pausedGame(t);
  let answered = false;
  const answer = live.call(kService, { budget_ms: 4000 }).then((told) => ((answered = true), told));
  live.send({ op: "setParameters", parameters: [{ name: "foresight_period", value: 60 }], id: "now" });
  await live.until(() => live.values.some(({ id }) => id === "now"), "that it is set");
  assert.equal(answered, false, "the question still runs");
  assert.equal((await answer).ok, true);
});

test("one question runs and one waits; the next is refused, and a disconnected client is not waited for", async (t) => {
  const { server, live } = await pausedGame(t);
  await live.subscribe("/14/2/forecast");
  const others = [await Live.open(t, server), await Live.open(t, server)];
  let answered = false;
  const first = live.call(kService, { budget_ms: 6000 }).finally(() => (answered = true));
  await live.call("/sim/state"); // earlier messages have arrived by then
  const gone = others[0].call(kService, { budget_ms: 10000 }).catch(() => "gone");
  await others[0].call("/sim/state");
  assert.equal(
    (await others[1].call(kService, { budget_ms: 10000 })).error,
    `${kService}: another question is running and one more waits: ask again when they are answered`,
  );
  assert.ok(!answered, "the refusal comes at once, before any answer");
  others[0].socket.terminate();
  assert.equal(await gone, "gone");
  await until(async () => (await others[1].call(kService, { budget_ms: 100 })).ok, "that there is room");
  assert.equal((await first).ok, true);
  const budgets = () =>
    live.messages.get("/14/2/forecast").map((message) => live.decoded("/14/2/forecast", message).question.budget_ms);
  await live.until(() => budgets().length >= 2, "two forecasts in memory");
  assert.deepEqual(budgets(), [6000, 100], "the question of a disconnected client is not played");
});

test("during a game people and the team's own code are answered", async (t) => {
  const folder = temporaryFolder(t);
  const door = join(folder, "door");
  const server = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "attached",
    "--team",
    "14",
    "--player",
    "2",
    "--door",
    door,
    "--game-controller",
    "--game-port",
    "0",
  );
  const port = Number(
    (await until(() => /the GameController on port (\d+)/.exec(server.output), "the port of the GameController"))[1],
  );

  const game = createSocket("udp4");
  let state = 0,
    packet = 0; // INITIAL; in the format of the GameController of 2024
  const timer = setInterval(() => {
    const bytes = Buffer.alloc(118);
    bytes.write("RGme");
    bytes.set([18, packet++ & 255, 5, 0, 0, 0, state, 0, 1, 14], 4);
    bytes.writeInt16LE(600, 14);
    for (const [at, team] of [
      [18, 14],
      [68, 5],
    ])
      bytes[at] = team;
    game.send(bytes, port, "127.0.0.1");
  }, 100);
  atEnd(t, () => (clearInterval(timer), game.close()));

  const live = await Live.open(t, server);
  await live.subscribe("/14/2/game");
  await live.newest("/14/2/game");
  const unknown = `${kService}: cannot tell, because the robot does not know where it is: there is no object pose yet`;
  const answers = async (sentence) =>
    until(async () => (await live.call(kService, { budget_ms: 50 })).error === sentence, sentence);
  await answers(unknown);
  state = 3; // PLAYING
  const inGame = async () => (await statusOf(server)).game.match_mode;
  await until(inGame, "match mode");
  await answers(unknown);

  const asks =
    "import foresight; advice = None\nwhile not advice: advice = foresight.Adviser().what_if(['baseline', 'passing'], budget_ms=50)\nprint(advice.reason)";
  const environment = { ...process.env, FORESIGHT_DOOR: door, PYTHONPATH: join(root, "robot/client") };
  const { stdout } = await promisify(execFile)("python3", ["-c", asks], { env: environment, timeout: 60000 });
  assert.match(stdout, /^cannot tell, because the robot does not know where it is/);
  await live.subscribe("/14/2/forecast");
  const asker = async () => live.decoded("/14/2/forecast", await live.newest("/14/2/forecast")).question.asked_by;
  await until(async () => (await asker()) === "the team's code", "the asker's name");
  assert.equal(await inGame(), true);
});

test("from another machine it needs the token", needsNetwork, async (t) => {
  const folder = temporaryFolder(t);
  const server = await start(t, folder, "foresight-robot", "--body", "sim", "--bind", "0.0.0.0");
  const token = readFileSync(join(folder, "state/token"), "utf8").trim();
  const guest = await Live.open(t, server, { address: own });
  const { ok, error } = await guest.call(kService, { budget_ms: 50 });
  assert.equal(ok, false);
  assert.match(error, /control token.*\?token=/);
  const trusted = await Live.open(t, server, { address: own, path: `/?token=${token}` });
  assert.equal(
    (await trusted.call(kService, { budget_ms: 1 })).error,
    `${kService}: 'budget_ms' must be 10 .. 10000 [ms], got 1`,
  );
});

test("the commands of the lab and of the simulator use the same names and print the same table", async (t) => {
  const folder = temporaryFolder(t);
  const [game, moment] = [join(folder, "game.mcap"), join(folder, "moment.json")];
  await run("foresight-sim", "match", "--seed", "5", "--rules", "spl2012,halves=1,half_duration=60", "--mcap", game);
  writeFileSync(
    moment,
    JSON.stringify({ seed: 3, ball: { x: 1, y: 0 }, robots: [{ side: "home", player: 2, x: 0.5, y: 0, heading: 0 }] }),
  );
  const lab = [
    "what-if",
    game,
    "--robot",
    "14/3",
    "--at",
    "50",
    "--budget-ms",
    "100",
    "--strategies",
    "baseline,passing",
  ];
  const sim = ["situation", moment, "--rollouts", "10", "--seconds", "5", "--strategies", "baseline,passing"];
  const told = async (program, words) => {
    const { status, stdout, stderr } = await run(program, ...words);
    assert.equal(status, 0, stderr);
    return stdout;
  };
  const [byLab, bySim] = [
    JSON.parse(await told("foresight-lab", [...lab, "--json"])),
    JSON.parse(await told("foresight-sim", [...sim, "--json"])),
  ];
  const missing = (here, there) => Object.keys(here).filter((name) => !(name in there));
  assert.deepEqual(missing(bySim, byLab), []);
  assert.deepEqual(missing(bySim.strategies[0], byLab.strategies[0]), []);
  const { measure, until } = byLab.question;
  assert.deepEqual({ measure, until }, bySim.question);

  const table = async (program, words) => (await told(program, words)).split("\n").slice(0, 3);
  const [labs, sims] = [await table("foresight-lab", lab), await table("foresight-sim", sim)];
  assert.equal(labs[0], sims[0]);
  assert.deepEqual(
    labs.map((line) => line.length),
    sims.map((line) => line.length),
  );
});

test("the service and the command find the best strategy for a moment of a recording", async (t) => {
  const folder = temporaryFolder(t);
  const game = join(folder, "game.mcap");
  await run("foresight-sim", "match", "--seed", "5", "--rules", "spl2012,halves=1,half_duration=120", "--mcap", game);
  const { stdout } = await run(
    "foresight-lab",
    "what-if",
    game,
    "--robot",
    "14/3",
    "--at",
    "90",
    "--budget-ms",
    "200",
    "--strategies",
    "baseline,passing",
    "--json",
  );
  const told = JSON.parse(stdout);
  assert.deepEqual(
    told.strategies.map(({ strategy }) => strategy),
    ["baseline", "passing"],
  );

  for (const [args, sentence] of [
    [["--at", "9000"], /--at: the session is .* s long, got 9000/],
    [["--at", "90", "--robot", "77/1"], /there is no robot '77\/1'/],
    [["--at", "90", "--question", "{"], /--question: expected JSON, got something else/],
    [["--at", "90", "--question", '{"budget": 1}'], /'budget' is no member of a question/],
  ]) {
    const { status, stderr } = await run("foresight-lab", "what-if", game, ...args);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
  }

  const server = await start(t, folder, "foresight-lab", "play", game);
  const live = await Live.open(t, server, { path: "/?playback" });
  await live.subscribe("/14/3/pose", "/14/3/game", "/14/3/ball");
  await live.newest("/14/3/ball");
  const answer = await until(async () => {
    const asked = await live.call(kService, { robot: "14/3", budget_ms: 50 });
    return asked.ok ? asked : undefined;
  }, "an answer");
  assert.deepEqual(
    answer.forecast.strategies.map(({ strategy }) => strategy),
    kStrategies,
  );

  // the moment is that of the recording, not the position of the playing streams
  const end_ns = BigInt(live.infos[0].dataEndTime.sec) * 1000000000n + BigInt(live.infos[0].dataEndTime.nsec);
  const asked = async (to_ns) => {
    live.send(playbackControl({ play: false, to_ns, id: "there" }));
    const { ok, error, forecast } = await live.call(kService, { robot: "14/3", budget_ms: 10 });
    assert.equal(ok, true, error);
    assert.equal(forecast.asked_ns, String(to_ns));
    return forecast.situation;
  };
  const moments = [60n, 50n, 40n, 30n].map((seconds) => end_ns - seconds * 1000000000n);
  const situations = new Map();
  for (let round = 0; round < 8; ++round)
    for (const moment of moments) {
      const situation = await asked(moment);
      if (situations.has(moment)) assert.deepEqual(situation, situations.get(moment));
      else situations.set(moment, situation);
    }
  assert.equal(new Set([...situations.values()].map((situation) => JSON.stringify(situation))).size, moments.length);

  // ending the program does not wait for a question
  live.call(kService, { robot: "14/3", budget_ms: 10000 }).catch(() => {});
  await live.call("clock_sync", { sent_ns: "1" });
  await server.stop();
});
