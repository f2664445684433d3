// The state of a simulated game, from the object /sim/state.

import type { Entry } from "./history";
import type { Memory } from "./memory";
import type { SimulatedTeam as TeamMessage, WorldObject } from "./schema";
import { fieldsOf, numberOf, textOf, type Fields } from "./value";

export const kSimulation = "/sim/state" satisfies WorldObject;

export interface SimulatedTeam {
  number: number;
  strategy: string;
  /** [goals] */
  score: number;
}

export interface Simulation {
  paused: boolean;
  finished: boolean;
  /** [game seconds per second] */
  speed: number;
  seed: number;
  /** [1/30 s] of game time since the beginning. */
  tick: number;
  /** [s] likewise. */
  seconds: number;
  rules: string;
  home: SimulatedTeam;
  away: SimulatedTeam;
}

/** Returns undefined if there is no simulation. */
export function simulationOf(memory: Memory): Simulation | undefined {
  const fields = memory.world(kSimulation)?.decoded()?.fields;
  return (
    fields && {
      paused: fields.get("paused") === true,
      finished: fields.get("finished") === true,
      speed: numberOf(fields, "speed"),
      seed: numberOf(fields, "seed"),
      tick: numberOf(fields, "tick"),
      seconds: numberOf(fields, "tick") / 30,
      rules: textOf(fields, "rules"),
      home: teamOf(fieldsOf(fields, "home")),
      away: teamOf(fieldsOf(fields, "away")),
    }
  );
}

/**
 * Returns the tick of the game at a capture time, or undefined if that is not kept. A busy page does not get the state of
 * every tick: then it is between those of its neighbours, in proportion to the time.
 */
export function tickAt(memory: Memory, at_ns: bigint): number | undefined {
  const state = memory.world(kSimulation);
  if (!state) return undefined;
  const { history } = state;
  const tickOf = (message: Entry | undefined) => {
    const fields = message && state.decode(message.data).fields;
    return fields && numberOf(fields, "tick");
  };
  const index = history.indexAt(at_ns);
  const [before, after] = [history.get(index), history.get(index + 1)];
  const [tick, next] = [tickOf(before), tickOf(after)];
  if (tick === undefined || next === undefined) return tick;
  const share = Number(at_ns - before!.log_ns) / Number(after!.log_ns - before!.log_ns);
  return Math.round(tick + share * (next - tick));
}

const teamOf = (fields: Fields<TeamMessage>): SimulatedTeam => ({
  number: numberOf(fields, "number"),
  strategy: textOf(fields, "strategy"),
  score: numberOf(fields, "score"),
});
