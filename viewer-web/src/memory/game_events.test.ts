import { expect, test } from "vitest";
import { GameEvents, changesOfGame, changesOfMotion, changesOfSimulation, knownEvents } from "./game_events";
import type { MemoryObject } from "./memory_object";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const team = (number: number, score: number, ...penalised: boolean[]) =>
  fields({ number, score, players: penalised.map((is) => fields({ penalised: is })) });
const game = (state: string, own: Fields, opponent: Fields) =>
  fields({ state: new EnumValue(0, `STATE_${state}`), own, opponent });
const texts = (changes: { text: string }[]) => changes.map(({ text }) => text);

test("a goal, another state and a penalty are reported once, when they happen", () => {
  const before = game("SET", team(14, 0, false, false), team(5, 1, false));
  expect(changesOfGame(before, before)).toEqual([]);
  expect(texts(changesOfGame(before, game("PLAYING", team(14, 1, false, true), team(5, 1, false))))).toEqual([
    "playing",
    "goal of team 14",
    "14/2 penalised",
  ]);
  // the return to the field and a score that the referee corrects are no events
  expect(
    changesOfGame(game("SET", team(14, 1, true), team(5, 0)), game("SET", team(14, 0, false), team(5, 0))),
  ).toEqual([]);
});

test("a simulated game reports goals and new games", () => {
  const state = (seed: number, tick: number, score: number) =>
    fields({ seed: BigInt(seed), tick, home: team(14, score), away: team(5, 0) });
  expect(texts(changesOfSimulation(state(7, 10, 0), state(7, 11, 1)))).toEqual(["goal of team 14"]);
  expect(texts(changesOfSimulation(state(7, 10, 1), state(8, 0, 0)))).toEqual(["new game, seed 8"]);
});

test("an event that all robots report happened once, and a senseless message gives no event", () => {
  const events = new GameEvents();
  const states = [game("READY", team(14, 0), team(5, 0)), game("SET", team(14, 0), team(5, 0))];
  const object = (robot: string) =>
    ({
      name: "game",
      kind: "game",
      derived: false,
      robot,
      channel: { topic: `/${robot}/game` },
      decode: (data: Uint8Array) => ({ fields: states[data[0]!] }),
    }) as unknown as MemoryObject;
  for (const robot of ["14/1", "14/2"])
    for (const i of [0, 1, 9])
      events.arrived(object(robot), { log_ns: BigInt(i) * 10n ** 9n, data: Uint8Array.of(i), arrived: i });
  expect(events.all()).toEqual([{ log_ns: 10n ** 9n, kind: "state", text: "set", robot: "14/1" }]);
  events.clear();
  expect(events.all()).toEqual([]);
});

test("events in recalled messages come before the later ones, each once", () => {
  const events = new GameEvents();
  const states = ["INITIAL", "READY", "SET", "PLAYING"].map((state) => game(state, team(14, 0), team(5, 0)));
  const object = {
    name: "game",
    kind: "game",
    derived: false,
    robot: "14/1",
    channel: { topic: "/14/1/game" },
    decode: (data: Uint8Array) => ({ fields: states[data[0]!] }),
  } as unknown as MemoryObject;
  const entryOf = (i: number) => ({ log_ns: BigInt(i) * 10n ** 10n, data: Uint8Array.of(i), arrived: i });
  for (const i of [2, 3]) events.arrived(object, entryOf(i));
  events.recall(object, [0, 1, 2].map(entryOf));
  expect(events.all().map(({ text }) => text)).toEqual(["ready", "set", "playing"]);
  events.recall(object, [0, 1, 2, 3].map(entryOf));
  expect(events.all()).toHaveLength(3);
});

test("a fall is reported once until the robot has stood up again", () => {
  const motion = (fall: string, side = "UNSPECIFIED"): Fields =>
    new Map<string, Value>([
      ["fall", new EnumValue(0, `FALL_${fall}`)],
      ["fall_side", new EnumValue(0, `FALL_SIDE_${side}`)],
    ]);
  const told = (before: Fields, after: Fields) => changesOfMotion(before, after).map(({ text }) => text);
  expect(told(motion("UPRIGHT"), motion("FALLING", "FRONT"))).toEqual(["falls front"]);
  expect(told(motion("FALLING"), motion("FALLEN"))).toEqual([]);
  expect(told(motion("GETTING_UP"), motion("UPRIGHT"))).toEqual([]);
  expect(told(motion("UPRIGHT"), motion("FALLEN"))).toEqual(["falls"]);
});

test("a kick is reported once, when it begins, and other movements are none", () => {
  const moves = (running: string): Fields => fields({ running });
  const told = (before: string, after: string) => texts(changesOfMotion(moves(before), moves(after)));
  expect(told("", "walk_forward")).toEqual(["kick walk forward"]);
  expect(told("walk_forward", "walk_forward")).toEqual([]);
  expect(told("walk_forward", "")).toEqual([]);
  for (const movement of ["squat", "stand_up", "sit", "tuck"]) expect(told("", movement)).toEqual([]);
});

test("a later half and a special phase of the game are reported", () => {
  const told = (before: Record<string, Value>, after: Record<string, Value>) =>
    texts(changesOfGame(fields(before), fields(after)));
  const phase = (name: string) => ({ phase: new EnumValue(0, `PHASE_${name}`) });
  expect(told({ half: 1 }, { half: 2 })).toEqual(["half 2"]);
  expect(told({ half: 0 }, { half: 1 })).toEqual([]); // the first packet
  expect(told(phase("NORMAL"), phase("PENALTY_SHOOT_OUT"))).toEqual(["penalty shoot out"]);
  expect(told(phase("TIMEOUT"), phase("NORMAL"))).toEqual([]);
});

test("all events of a recording replace those that were seen, until everything is forgotten", () => {
  const events = new GameEvents();
  const goal = { log_ns: 7n, kind: "goal", text: "goal of team 14", robot: "" };
  events.know(knownEvents([goal, { ...goal, kind: "of a later version" }]));
  expect([events.complete, events.all()]).toEqual([true, [goal]]);
  const log = {
    name: "log",
    kind: "log",
    derived: false,
    robot: "14/2",
    channel: { topic: "/14/2/log" },
    decode: () => ({ fields: fields({ level: new EnumValue(4, "LEVEL_ERROR"), text: "hot" }) }),
  } as unknown as MemoryObject;
  const message = { log_ns: 8n, data: new Uint8Array(), arrived: 0 };
  events.arrived(log, message);
  expect(events.all()).toEqual([goal]);
  events.clear();
  events.arrived(log, message);
  expect([events.complete, texts([...events.all()])]).toEqual([false, ["hot"]]);
});
