// Events of the game as moments on the timeline: goals, states, penalties, kicks, falls, and errors in the log. A server
// that plays a recording finds them by the same rules (robot/lab/whole/recorded_events.cpp) in all of it.

import type { Entry } from "./history";
import { levelOf } from "./log_history";
import { isKind, type MemoryObject, type RobotName } from "./memory_object";
import type { GameState, LogText, MotionStatus, RobotObject, Simulation } from "./schema";
import { kSimulation } from "./simulation";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "./value";

export const kEventKinds = ["goal", "kick", "fall", "penalty", "state", "error"] as const;
export type EventKind = (typeof kEventKinds)[number];

export interface GameEvent {
  log_ns: bigint;
  kind: EventKind;
  text: string;
  /** The robot that reported it, or "" for none. */
  robot: RobotName;
}

const kMost = 2000;
const kSame_ns = 5_000_000_000n; // equal reports of several robots within this time are one event
const kSameGoal_ns = 20_000_000_000n; // as before: the GameController reports goals up to 15 s late
const kMostPlayers = 20;
/** Movements that are no kicks, by our motions and by the simulator's. */
const kNoKicks = ["", "squat", "stand_up", "sit", "tuck", "get_up"];

type Change = Pick<GameEvent, "kind" | "text">;

/** Returns the events between two consecutive messages of `game`. */
export function changesOfGame(before: Fields<GameState>, after: Fields<GameState>): Change[] {
  const changes: Change[] = [];
  const state = wordOf(after, "state");
  if (state && state !== wordOf(before, "state")) changes.push({ kind: "state", text: state });
  const setPlay = wordOf(after, "set_play");
  if (setPlay && setPlay !== "unspecified" && setPlay !== wordOf(before, "set_play"))
    changes.push({ kind: "state", text: setPlay.replaceAll("_", " ") });
  const phase = wordOf(after, "phase");
  if (phase && !["unspecified", "normal", wordOf(before, "phase")].includes(phase))
    changes.push({ kind: "state", text: phase.replaceAll("_", " ") });
  const [wasHalf, half] = [before, after].map((fields) => numberOf(fields, "half"));
  if (wasHalf! > 0 && half! > 0 && half !== wasHalf) changes.push({ kind: "state", text: `half ${half}` });
  for (const side of ["own", "opponent"] as const) {
    const [was, is] = [fieldsOf(before, side), fieldsOf(after, side)];
    if (numberOf(was, "number") !== numberOf(is, "number")) continue;
    const team = numberOf(is, "number");
    const scored = numberOf(is, "score") - numberOf(was, "score");
    if (scored > 0) changes.push({ kind: "goal", text: `goal of team ${team}` });
    const [wasPenalised, isPenalised] = [was, is].map((fields) =>
      listOf(fields, "players").map((player) => player.get("penalised") === true),
    );
    for (const [i, penalised] of isPenalised!.slice(0, kMostPlayers).entries())
      if (penalised && wasPenalised![i] === false)
        changes.push({ kind: "penalty", text: `${team}/${i + 1} penalised` });
  }
  return changes;
}

/** Returns the events between two consecutive messages of /sim/state. */
export function changesOfSimulation(before: Fields<Simulation>, after: Fields<Simulation>): Change[] {
  if (numberOf(after, "seed") !== numberOf(before, "seed") || numberOf(after, "tick") < numberOf(before, "tick"))
    return [{ kind: "state", text: `new game, seed ${numberOf(after, "seed")}` }];
  return (["home", "away"] as const).flatMap((side) => {
    const [was, is] = [fieldsOf(before, side), fieldsOf(after, side)];
    return numberOf(is, "score") > numberOf(was, "score")
      ? [{ kind: "goal" as const, text: `goal of team ${numberOf(is, "number")}` }]
      : [];
  });
}

/** Returns the events between two consecutive messages of `motion_status`. */
export function changesOfMotion(before: Fields<MotionStatus>, after: Fields<MotionStatus>): Change[] {
  const down = ["falling", "fallen"];
  const changes: Change[] = [];
  const [was, is] = [wordOf(before, "fall"), wordOf(after, "fall")];
  if (down.includes(is) && !down.includes(was))
    changes.push({ kind: "fall", text: `falls ${wordOf(after, "fall_side").replace("unspecified", "")}`.trim() });
  const movement = textOf(after, "running");
  if (movement !== textOf(before, "running") && !kNoKicks.includes(movement))
    changes.push({ kind: "kick", text: `kick ${movement.replaceAll("_", " ")}` });
  return changes;
}

type Changes = (before: Fields, after: Fields) => Change[];
const kChanges = new Map<string, Changes>(
  Object.entries({ game: changesOfGame, motion_status: changesOfMotion } satisfies Partial<
    Record<RobotObject, Changes>
  >),
);

/** Returns the function that finds events in an object's messages, or undefined if they contain none. */
export const changesTold = (name: string): Changes | undefined => kChanges.get(name);

/** Leaves out events of kinds that this page does not know. */
export const knownEvents = (events: (Omit<GameEvent, "kind"> & { kind: string })[]): GameEvent[] =>
  events.filter((event): event is GameEvent => (kEventKinds as readonly string[]).includes(event.kind));

export class GameEvents {
  /** True if these are all events of a recording, also of parts that were not played. */
  complete = false;
  #events: GameEvent[] = [];
  #before = new Map<string, Fields>(); // by topic

  /** Takes all events of a recording, in order of time. Those of messages that arrive add nothing. */
  know(events: GameEvent[]): void {
    this.#events = events;
    this.complete = true;
  }

  clear(): void {
    this.complete = false;
    this.#events = [];
    this.#before.clear();
  }

  /** Handles a seek: differences across it are no events. */
  sought(): void {
    this.#before.clear();
  }

  /** In order of time. */
  all(): readonly GameEvent[] {
    return this.#events;
  }

  arrived(object: MemoryObject, entry: Entry): void {
    if (object.derived || this.complete) return;
    if (isKind(object, "log")) this.#logged(object, entry);
    else if (object.channel.topic === kSimulation) this.#compare(object, entry, changesOfSimulation);
    else {
      const changes = changesTold(object.name);
      if (changes) this.#compare(object, entry, changes);
    }
  }

  /** Adds the events in the earlier messages `entries` of an object. */
  recall(object: MemoryObject, entries: readonly Entry[]): void {
    const earlier = new GameEvents();
    for (const entry of entries) earlier.arrived(object, entry);
    for (const event of earlier.#events) this.#add(event);
  }

  #logged(object: MemoryObject<LogText>, { log_ns, data }: Entry): void {
    const fields = object.decode(data).fields;
    const level = fields && levelOf(fields);
    if (fields && (level === "error" || level === "fatal"))
      this.#add({ log_ns, kind: "error", text: textOf(fields, "text"), robot: object.robot });
  }

  #compare(object: MemoryObject, { log_ns, data }: Entry, changes: Changes): void {
    const fields = object.decode(data).fields;
    if (!fields) return;
    const { topic } = object.channel;
    const before = this.#before.get(topic);
    this.#before.set(topic, fields);
    for (const change of before ? changes(before, fields) : []) this.#add({ log_ns, robot: object.robot, ...change });
  }

  #add(event: GameEvent): void {
    const isSame = ({ kind, text, log_ns, robot }: GameEvent) =>
      kind === event.kind &&
      text === event.text &&
      (!["fall", "kick"].includes(kind) || robot === event.robot) &&
      abs(log_ns - event.log_ns) < (kind === "goal" ? kSameGoal_ns : kSame_ns);
    if (this.#events.some(isSame)) return;
    const after = this.#events.findLastIndex(({ log_ns }) => log_ns <= event.log_ns);
    this.#events.splice(after + 1, 0, event);
    if (this.#events.length > kMost) this.#events.splice(0, this.#events.length - kMost);
  }
}

const abs = (value: bigint): bigint => (value < 0n ? -value : value);
