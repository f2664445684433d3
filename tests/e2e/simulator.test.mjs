// foresight-sim from outside: its output, its exit status, and its recordings, read by independent libraries.
import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { decode, Live } from "./live.mjs";
import { readIndexed, readStreamed } from "./mcap.mjs";
import { play, run, temporaryFolder } from "./support.mjs";

const sim = (...args) => run("foresight-sim", ...args);
const json = async (...args) => {
  const { status, stdout, stderr } = await sim(...args, "--json");
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
};

// a game of two half minutes has all phases of a whole one
const kShort = ["--rules", "spl2012:2,half_duration=30,ready_duration=10"];

test("a game is reported to people and as JSON", async () => {
  const { status, stdout } = await sim("match", ...kShort, "--seed", "7");
  assert.equal(status, 0);
  for (const word of [
    "home",
    "away",
    "goals",
    "shots",
    "possession",
    "ball seen",
    "walked",
    "packets",
    "half time",
    "end",
  ])
    assert.ok(stdout.includes(word), `'${word}' in ${stdout}`);

  const game = await json("match", ...kShort, "--seed", "7");
  assert.equal(game.finished, true);
  assert.ok(game.seconds >= 60);
  assert.deepEqual(game.score, [game.home.goals, game.away.goals]);
  assert.equal(game.events.filter(({ kind }) => kind === "goal").length, game.home.goals + game.away.goals);
  assert.equal(game.events.at(-1).kind, "end");
  assert.ok(game.events.every(({ tick }, i) => i === 0 || tick >= game.events[i - 1].tick));
  for (const side of [game.home, game.away]) assert.ok(side.ball_seen > 0 && side.ball_seen < 1 && side.walked > 0);
});

test("the same seed gives the same game, another seed another game", async () => {
  const play = (seed) => json("match", ...kShort, "--seed", String(seed));
  const [one, again, other] = await Promise.all([play(7), play(7), play(8)]);
  assert.deepEqual(one, again);
  assert.notDeepEqual(one.events, other.events);
});

test("a line holds a game's report, and the robots' beliefs beside the truth", async () => {
  const lines = async (...args) =>
    (await sim("match", ...kShort, "--lines", "--threads", "2", ...args)).stdout.trim().split("\n").map(JSON.parse);
  const [[first, second], [perfect], report] = await Promise.all([
    lines("--seed", "7", "--games", "2"),
    lines("--seed", "7", "--models", "perfect"),
    json("match", ...kShort, "--seed", "8"),
  ]);
  assert.deepEqual([first.seed, second.seed], [7, 8]);
  for (const key of ["score", "seconds", "in_play_seconds"]) assert.deepEqual(second[key], report[key]);
  for (const side of ["home", "away"]) {
    for (const [key, value] of Object.entries(report[side])) assert.equal(second[side][key], value, key);
    assert.ok(second[side].ball_error > 0 && second[side].pose_error > 0);
    for (const key of ["moving_ball_error", "pose_error", "flipped", "down"]) assert.equal(perfect[side][key], 0, key);
    assert.ok(perfect[side].shifting < 0.3 * second[side].shifting); // a stopping robot finishes its step
  }
  const goal = report.events.find((event) => event.kind === "goal");
  assert.equal(second.first_goal_seconds, goal ? goal.tick / 30 : null);
});

test("a series equals its games", async () => {
  const [series, one] = await Promise.all([
    json("match", ...kShort, "--seed", "7", "--games", "3"),
    json("match", ...kShort, "--seed", "8"),
  ]);
  assert.deepEqual(
    series.scores.map(({ seed }) => seed),
    [7, 8, 9],
  );
  assert.deepEqual([series.scores[1].home, series.scores[1].away], one.score);
  const mean = series.scores.reduce((sum, { home }) => sum + home, 0) / 3;
  assert.ok(Math.abs(series.means.home.goals.mean - mean) < 1e-9);
  assert.equal(series.different_games, 3);
});

test("a series whose games repeat is reported with a warning", async () => {
  const words = ["match", ...kShort, "--models", "perfect", "--games", "4"];
  for (const kind of ["--json", "--lines"]) {
    const { status, stdout, stderr } = await sim(...words, kind);
    assert.equal(status, 0);
    assert.ok(stdout.length > 0);
    assert.equal(
      stderr,
      "foresight-sim: the games repeat: expected 4 different games, got 2; with models 'perfect' a seed changes too little: choose models with noise, or vary the start with --from and --fuzz\n",
    );
  }
});

test("wrong usage and wrong input are one sentence and exit status 2", async (t) => {
  const folder = temporaryFolder(t);
  const situation = join(folder, "situation.json");
  writeFileSync(situation, "{}");
  const program = join(folder, "mine.py");
  writeFileSync(program, "print('{}')\n");
  for (const [args, sentence] of [
    [["match", "--home", "basline"], "foresight-sim: no strategy 'basline'; did you mean 'baseline'?\n"],
    [
      ["match", "--home", "chess"],
      "foresight-sim: no strategy 'chess'; there are: align_first, all_kicks, baseline, high_line, idle, kick_now, learned, passing, foresight\n",
    ],
    [
      ["match", "--away", program],
      `foresight-sim: behaviour '${program}' is a program: use 'pipe:python3 ${program}'\n`,
    ],
    [
      ["match", "--models", "match,walk.forward=9"],
      "foresight-sim: models 'match,walk.forward=9': walk.forward must be 0.01 .. 3 [m/s], got 9\n",
    ],
    [
      ["match", "--rules", "spl2012,half_durtion=60"],
      "foresight-sim: rules 'spl2012,half_durtion=60': half_durtion is unknown; did you mean 'half_duration'?\n",
    ],
    [["skills", "kik"], "foresight-sim: no skill \"kik\"; did you mean 'kick'?\n"],
    [["features", "bal_age"], "foresight-sim: no feature \"bal_age\"; did you mean 'ball_age'?\n"],
    [["match", "--rules", "spl1999"], "foresight-sim: no rules 'spl1999'; there are: hsl2026, spl2012, spl2025\n"],
    [["match", "--mcap", "x", "--games", "2"], "foresight-sim: --mcap records one game, got --games 2\n"],
    [["match", "--lines", "--seconds", "60"], "foresight-sim: --lines and --seconds do not go together\n"],
    [
      ["match", "--save-at", "soon", "x"],
      "foresight-sim: --save-at: a moment must be 0 .. 36000 [s] since the first tick, or half:minutes:seconds on the clock such as 2:05:12, got 'soon'\n",
    ],
    [
      ["match", "--save-at", "5", "x", "--games", "2"],
      "foresight-sim: --save-at is of one game, without --lines, --statistics and --games\n",
    ],
    [["match", "--home-team", "5"], "foresight-sim: the teams must have different numbers, got 5 twice\n"],
    [["situation", situation], `foresight-sim: situation '${situation}': ball is missing\n`],
    [["models", "--show", "mach"], "foresight-sim: no models 'mach'; did you mean 'match'?\n"],
  ]) {
    const { status, stdout, stderr } = await sim(...args);
    assert.deepEqual({ status, stdout, stderr }, { status: 2, stdout: "", stderr: sentence }, args.join(" "));
  }
  for (const args of [
    [],
    ["dance"],
    ["match", "--games", "0"],
    ["match", "--players", "8"],
    ["match", "--seed", "-1"],
    ["situation"],
  ])
    assert.equal((await sim(...args)).status, 2, args.join(" "));
  for (const args of [["--help"], ["match", "--help"], ["--version"]])
    assert.equal((await sim(...args)).status, 0, args.join(" "));
});

test("all skills and features are described, for people and as JSON", async () => {
  for (const [kind, known] of [
    ["skills", "kick"],
    ["features", "ball_distance"],
  ]) {
    const words = await json(kind);
    assert.ok(words.length > 10 && words.some(({ name }) => name === known));
    const { status, stdout } = await sim(kind);
    assert.equal(status, 0);
    for (const { name, about, example } of words)
      for (const part of [name, about, example]) assert.ok(stdout.includes(part), `'${part}' in ${kind}`);
    assert.deepEqual(
      await json(kind, known),
      words.filter(({ name }) => name === known),
    );
  }
  const { arguments: parameters } = (await json("skills", "kick"))[0];
  assert.deepEqual(parameters[1], {
    name: "tolerance",
    about: "angle by which the direction of the ball may miss the aim",
    unit: "rad",
    least: 0.01,
    most: 3,
    default: 0.2,
    example: '"tolerance": "0.2 rad"',
  });
});

test("rules, models and strategies can be listed, shown and played from a file", async (t) => {
  const folder = temporaryFolder(t);
  for (const [kind, option] of [
    ["rules", "--rules"],
    ["models", "--models"],
    ["strategies", "--home"],
  ]) {
    const names = await json(kind);
    assert.ok(names.length > 1);
    for (const name of names) {
      const { status, stdout } = await sim(kind, "--show", name);
      assert.equal(status, 0);
      assert.equal(JSON.parse(stdout).name, name);
    }
    const file = join(folder, `${kind}.json`);
    writeFileSync(file, (await sim(kind, "--show", names[0])).stdout);
    // rules last, so that the game is short
    const rules = kind === "rules" ? ["--rules", `${file},half_duration=10`] : [...kShort, option, file];
    assert.equal((await sim("match", ...rules)).status, 0, kind);
  }
  const varied = JSON.parse((await sim("models", "--show", "match,falls=off")).stdout);
  assert.equal(varied.effects.falls, false);
});

test("a situation is rolled out as often as asked, the same every time", async (t) => {
  const file = join(temporaryFolder(t), "open_goal.json");
  const robots = [{ side: "home", player: 2, x: 1.6, y: 0, heading: 0 }];
  writeFileSync(file, JSON.stringify({ seed: 3, ball: { x: 1.8, y: 0 }, robots }));
  const roll = () => json("situation", file, "--rollouts", "40", "--seconds", "30");
  const [one, again] = await Promise.all([roll(), roll()]);
  assert.deepEqual(one, again);
  assert.equal(one.rollouts, 40);
  assert.equal(
    Object.values(one.home.goals_distribution).reduce((sum, count) => sum + count, 0),
    40,
  );
  assert.ok(one.home.goals.mean > one.away.goals.mean, "without a goalkeeper there are goals");
  assert.ok(one.home.first_goal_seconds.mean > 0 && one.home.first_goal_seconds.mean < 30);
  const { status, stdout } = await sim("situation", file, "--rollouts", "5");
  assert.equal(status, 0);
  assert.match(stdout, /5 rollouts of 60 s/);
});

test("a moment of a game is saved as a situation, from which games are played and compared", async (t) => {
  const folder = temporaryFolder(t);
  const save = async (moment, name) => {
    const file = join(folder, name);
    const { status, stderr } = await sim("match", ...kShort, "--seed", "7", "--save-at", moment, file);
    assert.equal(status, 0, stderr);
    return file;
  };
  const [one, again, clock] = await Promise.all([
    save("32", "one.json"),
    save("32", "again.json"),
    save("2:00:10", "clock.json"),
  ]);
  assert.deepEqual(readFileSync(one), readFileSync(again));
  const { about, half, robots } = JSON.parse(readFileSync(one));
  assert.match(about, /^baseline against baseline, .*seed 7, moment 32$/);
  assert.deepEqual([half, robots.length], [1, 4]);
  const later = JSON.parse(readFileSync(clock));
  assert.ok(later.half === 2 && Math.abs(later.clock - 10) < 0.01, JSON.stringify(later));

  const rolled = await json("situation", one, ...kShort, "--rollouts", "4", "--seconds", "5");
  assert.equal(rolled.rollouts, 4);
  assert.equal((await json("match", "--from", one, ...kShort, "--seconds", "5")).seconds > 0, true);
  const compared = await sim(
    "compare",
    "baseline",
    "kick_now",
    "--from",
    one,
    ...kShort,
    "--seconds",
    "5",
    "--pairs",
    "4",
  );
  assert.notEqual(compared.status, 2, compared.stderr);

  const late = await sim("match", ...kShort, "--save-at", "4000", join(folder, "late.json"));
  assert.equal(late.status, 2);
  assert.match(
    late.stderr,
    /--save-at: expected a moment before the end of the game, which is [\d.]+ s after the first tick, got 4000/,
  );
  assert.equal(existsSync(join(folder, "late.json")), false);
});

test("forecasts are compared with the course of simulated games, the same every time", async () => {
  const ask = () => json("calibration", ...kShort, "--situations", "24", "--rollouts", "8", "--seconds", "5");
  const [one, again] = await Promise.all([ask(), ask()]);
  assert.deepEqual(one, again);
  assert.ok(one.situations > 0 && one.situations + one.untold <= 24);
  for (const { brier, base_rate, base_rate_brier, deciles } of [one.score, one.concede]) {
    const sum = (see) => deciles.reduce((so_far, decile) => so_far + see(decile), 0);
    assert.equal(
      sum(({ cases }) => cases),
      one.situations,
    );
    assert.ok(Math.abs(sum(({ cases, came }) => cases * came) / one.situations - base_rate) < 1e-9);
    assert.ok(Math.abs(base_rate_brier - base_rate * (1 - base_rate)) < 1e-9);
    assert.ok(
      brier >= 0 &&
        brier <= 1 &&
        deciles.every(({ foretold, came }) => foretold >= 0 && foretold <= 1 && came >= 0 && came <= 1),
    );
  }
});

test("a choice between a strategy and its copy gains nothing, and with full knowledge an idle strategy is not chosen", async (t) => {
  const copy = join(temporaryFolder(t), "copy.json");
  writeFileSync(
    copy,
    (await sim("strategies", "--show", "baseline")).stdout.replace('"name": "baseline"', '"name": "copy"'),
  );
  const ask = (strategies, ...words) =>
    json(
      "choosing",
      "--moments",
      "20",
      "--futures",
      "8",
      "--rollouts",
      "16",
      "--horizon",
      "5",
      "--strategies",
      strategies,
      ...words,
    );
  const of = `baseline,${copy},idle`;
  const [one, again, insights, eager] = await Promise.all([
    ask(of),
    ask(of),
    ask(of, "--insights"),
    ask("idle,baseline", "--sure", "0.5"),
  ]);
  assert.deepEqual(one, again);
  assert.deepEqual(
    insights.captains.map(({ knows }) => knows),
    ["what it believes", "and the ball", "and its own side", "and the opponents", "and all of them"],
  );
  assert.deepEqual(
    { ...insights, captains: insights.captains.slice(0, 1) },
    one,
    "the captains with more knowledge do not change it",
  );
  const [same, idle] = one.strategies;
  assert.deepEqual(same.always, { mean: 0, standard_error: 0 });
  assert.equal(same.spread, 0);
  assert.ok(idle.always.mean < 0 && idle.always.mean < one.knowing.mean);
  const [{ changes, gain }] = eager.captains;
  assert.ok(changes > 0.5 && gain.mean > 0, "it changes an idle strategy to one that plays");

  for (const [args, sentence] of [
    [["--sure", "2", "--strategies", "baseline,idle"], /--sure/],
    [["--strategies", "baseline"], /expected at least two, got baseline/],
    [["--strategies", "baseline,nonsense"], /nonsense/],
    [[], /--strategies is required/],
  ]) {
    const { status, stderr } = await sim("choosing", ...args);
    assert.equal(status, 2);
    assert.match(stderr, sentence);
  }
});

test("bench and signature print their figures", async () => {
  const bench = await json("bench", ...kShort, "--games", "3");
  assert.equal(bench.games, 3);
  assert.ok(bench.robot_tick_cycles > 1 && bench.clock_ghz > 0.1 && bench.clock_ghz < 10);
  const { stdout } = await sim("signature");
  assert.match(stdout, /^[0-9a-f]{16}\n$/);
});

test("a recorded game holds the truth and every robot's memory, and is the same for the same seed", async (t) => {
  const folder = temporaryFolder(t);
  const [first, second] = ["first.mcap", "second.mcap"].map((name) => join(folder, name));
  const [game] = await Promise.all(
    [first, second].map((file) => json("match", ...kShort, "--seed", "7", "--mcap", file)),
  );
  const bytes = readFileSync(first);
  assert.ok(bytes.equals(readFileSync(second)), "the same seed, the same bytes");
  assert.deepEqual(game, await json("match", ...kShort, "--seed", "7"), "recording changes nothing");

  // the objects of a live game, and nothing else
  const { topics, metadata, chunks } = readStreamed(bytes);
  const objects = [
    "camera_top_matrix",
    "odometry",
    "vision",
    "ball",
    "pose",
    "team",
    "opponents",
    "game",
    "motion_command",
    "motion_status",
    "decision",
  ];
  const robots = ["14/1", "14/2", "5/1", "5/2"];
  const expected = [
    "/truth/world",
    "/sim/state",
    ...robots.flatMap((robot) => objects.map((object) => `/${robot}/${object}`)),
  ];
  assert.deepEqual([...topics.keys()].sort(), expected.sort());
  assert.equal(metadata.get("foresight.game").seed, "7");
  assert.ok(chunks.length > 10);

  // one message per tick of beliefs; body, truth and state also at the beginning
  const ticks = Math.round(game.seconds * 30);
  const count = (topic) => topics.get(topic).messages.length;
  for (const topic of ["/truth/world", "/sim/state"]) assert.equal(count(topic), ticks + 1, topic);
  for (const robot of robots) {
    for (const object of ["motion_status", "odometry"]) assert.equal(count(`/${robot}/${object}`), ticks + 1, object);
    // a robot beside the field gets no new beliefs
    for (const object of ["pose", "motion_command"]) {
      assert.ok(
        count(`/${robot}/${object}`) > ticks / 20 && count(`/${robot}/${object}`) <= ticks + 1,
        `${object}: ${count(`/${robot}/${object}`)} of ${ticks} ticks`,
      );
    }
    assert.ok(count(`/${robot}/opponents`) > 0, "opponents");
    for (const object of ["ball", "decision"]) assert.ok(count(`/${robot}/${object}`) > ticks / 20, object);
    for (const object of ["team", "game"]) assert.ok(count(`/${robot}/${object}`) > 0, object);
  }

  // times grow, 30 ticks a second from a fixed epoch on, and the index leads to the same messages
  const epoch = 1340020800000000000n;
  const indexed = await readIndexed(bytes);
  for (const [topic, { schema, messages }] of topics) {
    assert.equal(schema.encoding, "protobuf");
    assert.ok(schema.name.startsWith("foresight."), schema.name);
    for (const [i, { logTime, sequence }] of messages.entries()) {
      assert.equal(sequence, i + 1);
      // the beliefs at the kick-off and those of its first image have the same time
      const grows = i === 0 || logTime > messages[i - 1].logTime || (i === 1 && logTime === messages[0].logTime);
      assert.ok(grows, `${topic}, message ${i}`);
    }
    assert.deepEqual(
      indexed.get(topic).map(({ logTime }) => logTime),
      messages.map(({ logTime }) => logTime),
    );
  }
  const truth = topics.get("/truth/world").messages;
  assert.ok(truth.every(({ logTime }, i) => logTime === epoch + (BigInt(i) * 100000000n) / 3n));
});

test("one side of a recorded game moves as recorded while the other plays", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  await json("match", ...kShort, "--seed", "7", "--mcap", file);
  const truthOf = (path) => {
    const { schema, messages } = readStreamed(readFileSync(path)).topics.get("/truth/world");
    return messages.map(({ data }) => decode(schema.name, schema.data, data));
  };
  const places = (truth, team) =>
    Object.fromEntries(
      truth.robots
        .filter((robot) => !team || robot.team === team)
        .map(({ team, player, x, y, heading }) => [`${team}/${player}`, { x, y, heading }]),
    );
  const [from, ticks] = [12, 90];
  const original = truthOf(file).slice(from * 30, from * 30 + ticks + 1);
  const replay = async (side, ...args) => {
    const path = join(folder, `${side}.mcap`);
    const { status, stdout, stderr } = await sim(
      "replay",
      file,
      "--side",
      side,
      "--from",
      String(from),
      "--seconds",
      "3",
      "--mcap",
      path,
      ...args,
    );
    assert.equal(status, 0, stderr);
    return { stdout, truth: truthOf(path) };
  };

  // with both sides as recorded, all positions equal the recording's
  const both = await replay("both");
  assert.equal(both.truth.length, original.length);
  for (const [i, truth] of both.truth.entries()) {
    assert.deepEqual(places(truth), places(original[i]), `tick ${i}`);
    assert.deepEqual([truth.ball.x, truth.ball.y], [original[i].ball.x, original[i].ball.y], `tick ${i}`);
  }
  assert.match(both.stdout, /as recorded from 12 s on: both sides and the ball/);

  const away = await replay("away", "--strategy", "kick_now");
  for (const [i, truth] of away.truth.entries())
    assert.deepEqual(places(truth, 5), places(original[i], 5), `tick ${i}`);
  assert.notDeepEqual(places(away.truth.at(-1), 14), places(original.at(-1), 14));
  assert.match(away.stdout, /home {2}kick_now/);

  const lines = (await sim("replay", file, "--from", String(from), "--seconds", "3", "--games", "3", "--lines")).stdout
    .trim()
    .split("\n")
    .map(JSON.parse);
  assert.deepEqual(
    lines.map(({ seed, recorded, from }) => [seed, recorded, from]),
    [1, 2, 3].map((seed) => [seed, "away", from]),
  );
  assert.equal((await json("replay", file, "--from", String(from), "--seconds", "3")).seconds, 3);

  for (const [args, sentence] of [
    [["replay", join(folder, "none")], /^foresight-sim: session .*none: cannot read /],
    [
      ["replay", file, "--from", "4000"],
      /^foresight-sim: --from: expected a moment before the end of .*game\.mcap, which is [\d.]+ s after its start, got 4000 s\n$/,
    ],
    [["replay", file, "--home-team", "77"], /has no robot of team 77 at 0 s; choose another --from\n$/],
    [["replay", file, "--strategy", "basline"], /^foresight-sim: no strategy 'basline'; did you mean 'baseline'\?\n$/],
    [
      ["replay", file, "--mcap", "x", "--games", "2"],
      /^foresight-sim: --mcap records one replay, without --lines and --games\n$/,
    ],
  ]) {
    const { status, stderr } = await sim(...args);
    assert.equal(status, 2, args.join(" "));
    assert.match(stderr, sentence);
  }
});

test("a replay says which robots had no data", async (t) => {
  const folder = temporaryFolder(t);
  const [file, moment] = [join(folder, "game.mcap"), join(folder, "moment.json")];
  // one robot of each side comes back from a penalty
  const standing = (side, x) =>
    [1, 2, 3].map((player) => ({ side, player, x, y: player - 2, ...(player === 3 && { penalised: 12 }) }));
  writeFileSync(
    moment,
    JSON.stringify({ ball: { x: 0, y: 0.8 }, robots: [...standing("home", -2), ...standing("away", 2)] }),
  );
  await json("match", "--from", moment, "--home", "idle", "--away", "idle", "--seconds", "20", "--mcap", file);

  const played = await json("replay", file, "--strategy", "idle", "--seconds", "19");
  assert.deepEqual(played.not_playing, ["14/3"]);
  const [{ robot, stood_seconds, absent_seconds }, ...others] = played.without_data;
  assert.deepEqual([robot, stood_seconds, others], ["5/3", 0, []]);
  assert.ok(Math.abs(absent_seconds - 12) < 0.5, `${absent_seconds} s`);
  const { stdout } = await sim("replay", file, "--strategy", "idle", "--seconds", "19");
  assert.match(
    stdout,
    /\nno data of 14\/3 at the start: it does not play\nno data of 5\/3: it stands still for 0\.0 s and is absent for 1[12]\.\d s\n$/,
  );
});

test("a recorded game is played with every robot's memory under its topics", async (t) => {
  const folder = temporaryFolder(t);
  const file = join(folder, "game.mcap");
  await json("match", ...kShort, "--seed", "7", "--mcap", file);
  const { topics } = readStreamed(readFileSync(file));

  const live = await Live.open(t, await play(t, folder, file, "--speed", "20"));
  const watched = ["/truth/world", "/14/1/pose", "/5/2/decision"];
  await live.subscribe(...watched);
  await live.until(() => watched.every((topic) => live.messages.get(topic)?.length > 30), "messages of the game");
  for (const topic of watched)
    for (const { data, log_ns } of live.messages.get(topic).slice(0, 30)) {
      // the start and the first tick have one time, so a time may have two messages
      const originals = topics.get(topic).messages.filter(({ logTime }) => logTime === log_ns);
      assert.ok(
        originals.some((original) => Buffer.from(data).equals(original.data)),
        `${topic} at ${log_ns}`,
      );
    }
  assert.equal(live.decoded("/5/2/decision", live.messages.get("/5/2/decision")[0]).strategy, "baseline");
});

test("a recorded game is never overwritten", async (t) => {
  const file = join(temporaryFolder(t), "game.mcap");
  writeFileSync(file, "precious");
  const { status, stderr } = await sim("match", ...kShort, "--mcap", file);
  assert.equal(status, 2);
  assert.ok(stderr.startsWith("foresight-sim: ") && stderr.includes(file), stderr);
  assert.equal(readFileSync(file, "utf8"), "precious");
  const nowhere = join(file, "no", "folder.mcap");
  assert.equal((await sim("match", ...kShort, "--mcap", nowhere)).status, 2);
  assert.ok(!existsSync(nowhere));
});

test("figures of games stand beside those of real games, also from a recording of a game", async (t) => {
  const folder = temporaryFolder(t);
  const long = ["match", "--rules", "spl2012:4,half_duration=200,ready_duration=10", "--seed", "3"];
  const page = join(folder, "real.html");
  const played = await json(...long, "--statistics", "--html", page);
  assert.ok(played.windows >= 1);
  assert.equal(Object.values(played.figures).filter(({ inside }) => inside !== null).length, played.judged);
  assert.equal(readFileSync(page, "utf8").match(/<svg/g).length, Object.keys(played.figures).length);

  const file = join(folder, "game.mcap");
  assert.equal((await sim(...long, "--mcap", file)).status, 0);
  const { status, stdout, stderr } = await run("foresight-lab", "game-statistics", file, "--json");
  assert.equal(status, 0, stderr);
  const recorded = JSON.parse(stdout);
  for (const key of ["ball_speed", "mates", "walked", "nearest"]) {
    const [one, other] = [played, recorded].map((all) => all.figures[key].measured.mean);
    assert.ok(Math.abs(one - other) < 0.2 * one, `${key}: ${one} and ${other}`);
  }
});

test("figures of games that are too short are refused in one sentence", async () => {
  const { status, stderr } = await sim("match", ...kShort, "--statistics");
  assert.equal(status, 2);
  assert.equal(
    stderr,
    "foresight-sim: --statistics needs a game with at least 167 s in play; play more or longer games\n",
  );
});
