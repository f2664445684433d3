// The transitions of the page's time that a person or another viewer makes.

import {
  atOf,
  isLive,
  isThere,
  moves,
  runs,
  within,
  type Change,
  type Facts,
  type TimeRange,
  type TimeState,
} from "./time_state";

const kLeastLoop_ns = 20_000_000n; // a shorter one is a click, not a range

const unchanged = (state: TimeState): Change => ({ state, effects: [] });

/** Makes another transition after `first`. */
function after(first: Change, then: (state: TimeState) => Change): Change {
  const { state, effects } = then(first.state);
  return { state, effects: [...first.effects, ...effects] };
}

/** Sends a wish to the servers of recordings, and shows their playheads from then on. */
const ask = (state: TimeState, { speed }: Facts, play: boolean, seek_ns?: bigint): Change => ({
  state: { ...state, phase: { is: "live" } },
  effects: [{ do: "ask", play, speed, seek_ns }],
});

/** Advances by the page's clock from the shown moment. */
const runFrom = (state: TimeState, facts: Facts): TimeState => ({
  ...state,
  phase: { is: "runs", at_ns: atOf(state, facts) },
});

/** Ends an advance by the page's clock. */
export const hold = (state: TimeState): TimeState =>
  state.phase.is === "runs" ? { ...state, phase: { is: "stands", at_ns: state.phase.at_ns } } : state;

/** Goes to a moment, or to the nearest one of the range. A page that advances by its own clock goes on from there. */
export function seek(state: TimeState, { range }: Facts, at_ns: bigint): Change {
  if (!range) return unchanged(state);
  const is = state.phase.is === "runs" ? "runs" : "stands";
  return {
    state: { ...state, phase: { is, at_ns: within(at_ns, range) }, asked_ns: undefined },
    effects: [{ do: "show" }],
  };
}

/** Before the first data: pauses as soon as they arrive. */
export function pause(state: TimeState, facts: Facts): Change {
  if (!isThere(facts)) return unchanged(isLive(state) ? { ...state, phase: { is: "early" } } : hold(state));
  const { phase } = state;
  const held: TimeState = phase.is === "early" ? { ...state, phase: { is: "live" } } : hold(state);
  if (facts.recorded) return moves(held, facts) ? ask(held, facts, false) : unchanged(held);
  return isLive(held) ? seek(held, facts, atOf(held, facts)) : unchanged(held);
}

export function play(state: TimeState, facts: Facts): Change {
  const begun: TimeState = state.phase.is === "early" ? { ...state, phase: { is: "live" } } : state;
  if (!facts.range) return unchanged(begun);
  if (facts.recorded && state.speed > 0) return ask(begun, facts, true, isLive(begun) ? undefined : atOf(begun, facts));
  return after(pause(begun, facts), (paused) => unchanged(runFrom(paused, facts)));
}

export const toggle = (state: TimeState, facts: Facts): Change =>
  runs(state, facts) ? pause(state, facts) : play(state, facts);

/** Goes to now, or to a recording's end. */
export function goToNow(state: TimeState, facts: Facts): Change {
  if (facts.recorded && facts.range) return seek(state, facts, facts.range.last_ns);
  return {
    state: {
      ...state,
      phase: { is: state.phase.is === "early" ? "early" : "live" },
      loop: undefined,
      noted: facts.now,
    },
    effects: [{ do: "release" }, { do: "note", at: "" }],
  };
}

/** Shows a recording where its server plays it; another viewer may have moved it. */
export const followServer = (state: TimeState): Change =>
  isLive(state) ? unchanged(state) : { state: { ...state, phase: { is: "live" } }, effects: [{ do: "release" }] };

/**
 * Changes the speed. A recording that plays goes on with it, backwards by the page's clock. Before its playhead is known
 * the speed is only kept.
 */
export function setSpeed(state: TimeState, facts: Facts, speed: number): Change {
  const changed = { ...state, speed };
  if (!facts.recorded || !isThere(facts)) return unchanged(changed);
  if (speed < 0) return runs(state, facts) ? play(changed, facts) : unchanged(changed);
  return ask(changed, { ...facts, speed }, runs(state, facts), isLive(state) ? undefined : atOf(state, facts));
}

// the repeated range

/** Sets the loop between two moments, in either order. A very short range ends it. */
export function setLoop(state: TimeState, one_ns: bigint, other_ns: bigint): TimeState {
  const [first_ns, last_ns] = one_ns < other_ns ? [one_ns, other_ns] : [other_ns, one_ns];
  return { ...state, loop: last_ns - first_ns < kLeastLoop_ns ? undefined : { first_ns, last_ns } };
}

/** Plays the range between two moments again and again. */
export function repeat(state: TimeState, facts: Facts, one_ns: bigint, other_ns: bigint): Change {
  const looped = setLoop(state, one_ns, other_ns);
  if (!looped.loop) return unchanged(looped);
  const forward = looped.speed < 0 ? { ...looped, speed: 1 } : looped;
  return after(seek(forward, facts, looped.loop.first_ns), (there) => play(there, facts));
}

/** Sets the loop's begin or end to the shown moment. */
export function setEdge(state: TimeState, facts: Facts, which: "begin" | "end"): TimeState {
  const { range } = facts;
  if (!range) return state;
  const at_ns = atOf(state, facts);
  const { first_ns, last_ns } = state.loop ?? range;
  const loop: TimeRange =
    which === "begin"
      ? { first_ns: at_ns, last_ns: last_ns > at_ns ? last_ns : range.last_ns }
      : { first_ns: first_ns < at_ns ? first_ns : range.first_ns, last_ns: at_ns };
  return { ...state, loop };
}
