import { expect, test } from "vitest";
import type { Memory } from "../memory/memory";
import { memoryWith } from "../memory/test_memory";
import { EnumValue, type Value } from "../memory/value";
import { sceneOf } from "./scene";
import { kFields } from "./field";
import { originOf, situationOf } from "./situation";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const enumOf = (name: string) => new EnumValue(1, name);

function memoryOf(values: Record<string, Record<string, Value>>): Memory {
  const object = (topic: string) =>
    values[topic] && { shown: { log_ns: 10_000_000_000n }, decoded: () => ({ fields: fields(values[topic]!) }) };
  return memoryWith({ get: object, age: () => 0 });
}
const told = (values: Record<string, Record<string, Value>>, robots: string[] = []) => [
  { memory: memoryOf(values), robots, keyOf: (robot: string) => robot },
];
function saved(values: Record<string, Record<string, Value>>, robots: string[] = []) {
  const all = told(values, robots);
  const made = situationOf(sceneOf(all, 0), all, kFields["spl2012"]!, "a test");
  return "text" in made ? JSON.parse(made.text) : made.missing;
}

const robot = (team: number, player: number, x: number, y: number, heading?: number) =>
  fields({ team, player, x, y, ...(heading !== undefined && { heading }) });
const kTruth = {
  ball: fields({ x: 0.5, y: -1, velocity_x: 0.25, velocity_y: 0 }),
  robots: [robot(5, 1, 4, 0, 3.14159), robot(14, 2, 1.12345678, 0.4, 1.5), robot(14, 1, -4, 0, 0)],
};
const kSimulation = {
  home: fields({ number: 14, strategy: "baseline" }),
  away: fields({ number: 5, strategy: "passing" }),
  rules: "spl2012",
  seed: 7n,
  tick: 936,
};
const players = (...penalised: [number, number][]) =>
  Array.from({ length: 4 }, (_, i) =>
    fields({
      penalised: penalised.some(([player]) => player === i + 1),
      seconds_till_unpenalised: penalised.find(([player]) => player === i + 1)?.[1] ?? 0,
    }),
  );
const kGame = {
  own_team: 14,
  state: enumOf("STATE_PLAYING"),
  set_play: enumOf("SET_PLAY_UNSPECIFIED"),
  half: 2,
  seconds_remaining: 288.5,
  secondary_seconds: 0,
  attacks_positive_x: false,
  own: fields({ score: 2, players: players([3, 12]) }),
  opponent: fields({ score: 1, players: players() }),
};

test("a moment holds the true places, the score, the time and the teams", () => {
  const moment = saved({ "/truth/world": kTruth, "/sim/state": kSimulation, "/14/2/game": kGame }, ["14/2"]);
  expect(moment).toMatchObject({
    about: "a test",
    teams: { home: 14, away: 5 },
    phase: "playing",
    set_play: "none",
    half: 2,
    remaining: 288.5,
    score: { home: 2, away: 1 },
    ball: { x: 0.5, y: -1, velocity_x: 0.25, velocity_y: 0 },
  });
  expect(
    moment.robots.map(({ side, player, x }: { side: string; player: number; x: number }) => [side, player, x]),
  ).toEqual([
    ["home", 1, -4],
    ["home", 2, 1.1235],
    ["home", 3, 1.5],
    ["away", 1, 4],
  ]);
  expect(moment.robots[2]).toMatchObject({ penalised: 12 });
  expect(moment.robots[3].heading).toBeLessThanOrEqual(3.1415);
});

test("the game of an away robot gives the same moment", () => {
  const away = { ...kGame, own_team: 5, own: kGame.opponent, opponent: kGame.own, attacks_positive_x: true };
  expect(saved({ "/truth/world": kTruth, "/sim/state": kSimulation, "/5/1/game": away }, ["5/1"])).toEqual(
    saved({ "/truth/world": kTruth, "/sim/state": kSimulation, "/14/2/game": kGame }, ["14/2"]),
  );
});

test("set plays have the words of the simulator, and other free kicks are kick-ins", () => {
  const setPlay = (game: Record<string, Value>) =>
    saved({ "/truth/world": kTruth, "/sim/state": kSimulation, "/14/2/game": { ...kGame, ...game } }, ["14/2"]);
  expect(setPlay({ set_play: enumOf("SET_PLAY_CORNER_KICK"), kicking_team: 5 })).toMatchObject({
    set_play: "corner_kick",
    kicking: "away",
  });
  expect(setPlay({ set_play: enumOf("SET_PLAY_PUSHING_FREE_KICK"), kicking_team: 14 })).toMatchObject({
    set_play: "kick_in",
    kicking: "home",
  });
  expect(setPlay({ state: enumOf("STATE_SET"), kicking_team: 14 })).toMatchObject({
    phase: "set",
    set_play: "kick_off",
    kicking: "home",
  });
});

test("a home side that attacks towards -x in its first half is turned by half a turn", () => {
  const moment = saved({ "/truth/world": kTruth, "/14/2/game": { ...kGame, half: 1 } }, ["14/2"]);
  expect(moment.ball).toEqual({ x: -0.5, y: 1, velocity_x: -0.25, velocity_y: 0 });
  expect(
    moment.robots.find(({ side, player }: { side: string; player: number }) => side === "home" && player === 2),
  ).toMatchObject({ x: -1.1235, y: -0.4, heading: -1.6416 });
});

test("a robot of unknown heading faces the ball, and a large jersey number gets a free one", () => {
  const truth = { ball: fields({ x: 1, y: 0 }), robots: [robot(1, 11, 0, 0), robot(1, 2, 1, 1), robot(2, 3, 3, 0)] };
  expect(saved({ "/truth/world": truth }).robots).toEqual([
    { side: "home", player: 2, x: 1, y: 1, heading: -1.5708 },
    { side: "home", player: 3, x: 0, y: 0, heading: 0 },
    { side: "away", player: 3, x: 3, y: 0, heading: 3.1415 },
  ]);
});

test("without a truth robots stand where they believe to be, and the ball where the last one saw it", () => {
  const values = { "/14/2/pose": { x: 1, y: 0.5, heading: 0 }, "/14/2/ball": { x: 2, y: 0, seen_ns: 9_500_000_000n } };
  expect(saved(values, ["14/2"])).toMatchObject({
    ball: { x: 3, y: 0.5 },
    robots: [{ side: "home", player: 2, x: 1, y: 0.5, heading: 0 }],
  });
});

test("a moment without ball or robots says so", () => {
  expect(saved({ "/truth/world": { robots: kTruth.robots } })).toBe("The place of the ball is unknown at this moment.");
  expect(saved({ "/truth/world": { ball: kTruth.ball } })).toBe("The place of no robot is known at this moment.");
});

test("its origin names the simulated game, or the moment of the recording", () => {
  expect(originOf(told({ "/sim/state": kSimulation }), "0:31")).toBe(
    "baseline against passing, spl2012, seed 7, moment 31.2",
  );
  expect(originOf(told({}), "0:31")).toBe("the moment 0:31 of a recording");
});
