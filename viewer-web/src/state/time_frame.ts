// The transitions of the page's time that happen by themselves, before each drawing.

import { goToNow, hold, pause, seek } from "./time_moves";
import {
  atOf,
  isLive,
  isThere,
  moves,
  runs,
  within,
  type Change,
  type Effect,
  type Facts,
  type TimeRange,
  type TimeState,
} from "./time_state";

const kNoteEvery = 0.3; // [s] between two changes of the address

/** The facts of a frame. */
export interface FrameFacts extends Facts {
  /** [s] since the last frame. */
  passed: number;
  /** Whether steps by frames are under way. */
  steps: boolean;
  /** The moment in the address, or "". */
  addressAt: string;
}

/** The facts about a moment that the address asks for. */
export interface AskedFacts extends Facts {
  /** Whether the server plays another session than that of the link: a person may watch that one. */
  playsAnother: boolean;
  /** Whether earlier messages are on their way. */
  recalls: boolean;
}

const nanoseconds = (duration: number): bigint => BigInt(Math.round(duration * 1e9));

/** Shows the moment of a link as soon as it is available, or reports that it is gone. */
export function obeyAddress(state: TimeState, facts: AskedFacts): Change {
  const { asked_ns } = state;
  const { range, recorded } = facts;
  const nothing = { state, effects: [] };
  if (asked_ns === undefined || facts.playsAnother || !range || !isThere(facts)) return nothing;
  if (asked_ns > range.last_ns && !recorded) return nothing;
  if (asked_ns < range.first_ns && facts.recalls) return nothing;
  const obeyed = { ...state, asked_ns: undefined };
  if (asked_ns >= range.first_ns && asked_ns <= range.last_ns) return seek(obeyed, facts, asked_ns);
  const text = recorded
    ? "The moment of this link is not within this recording."
    : "The moment of this link is older than the data of this page; a recording on the robot may hold it.";
  return {
    state: obeyed,
    effects: [
      { do: "note", at: "" },
      { do: "say", text },
    ],
  };
}

/** Returns the state and the effects of a frame. */
export function frame(state: TimeState, facts: FrameFacts): Change {
  const { range } = facts;
  if (!range) return isLive(state) ? { state, effects: [] } : goToNow(state, facts);
  const effects: Effect[] = [];
  const take = ({ state: next, effects: more }: Change): void => {
    state = next;
    effects.push(...more);
  };
  if (state.phase.is === "early" && isThere(facts)) take(pause(state, facts));
  if (state.phase.is === "runs") take(advanced(state, facts, range));
  else if (moves(state, facts)) take(repeated(state, facts));
  // the shown moment may have been dropped from memory
  const { phase } = state;
  if ((phase.is === "stands" || phase.is === "runs") && phase.at_ns < range.first_ns)
    state = { ...state, phase: { ...phase, at_ns: range.first_ns } };
  if (!isLive(state)) effects.push({ do: "show" });
  take(noted(state, facts));
  return { state, effects };
}

/** Moves on by the page's clock, to the other end of the loop at its border. At the oldest moment it stands. */
function advanced(state: TimeState, facts: FrameFacts, range: TimeRange): Change {
  const by_ns = nanoseconds(facts.passed * state.speed);
  let at_ns = atOf(state, facts) + by_ns;
  const { loop } = state;
  if (loop && (at_ns >= loop.last_ns || at_ns < loop.first_ns)) at_ns = by_ns < 0n ? loop.last_ns - 1n : loop.first_ns;
  if (at_ns >= range.last_ns && !facts.recorded) return goToNow(state, facts);
  const there: TimeState = { ...state, phase: { is: "runs", at_ns: at_ns < range.first_ns ? range.first_ns : at_ns } };
  return { state: at_ns > range.first_ns ? there : hold(there), effects: [] };
}

/** Returns to the loop's begin when its end is reached. */
function repeated(state: TimeState, facts: Facts): Change {
  const { loop } = state;
  const at_ns = atOf(state, facts);
  const nothing = { state, effects: [] };
  if (!loop || facts.pending || (at_ns < loop.last_ns && at_ns >= loop.first_ns)) return nothing;
  if (facts.recorded)
    return { state, effects: [{ do: "ask", play: true, speed: facts.speed, seek_ns: loop.first_ns }] };
  const first_ns = facts.range ? within(loop.first_ns, facts.range) : loop.first_ns;
  return {
    state: { ...state, phase: { is: "runs", at_ns: first_ns }, asked_ns: undefined },
    effects: [{ do: "show" }],
  };
}

/** Writes a paused moment into the address, now and then, and removes it while a recording plays. */
function noted(state: TimeState, facts: FrameFacts): Change {
  const { now, recorded, steps } = facts;
  const stands = !runs(state, facts) && state.phase.is !== "early" && !steps && (!isLive(state) || recorded);
  const note = (at: string): Change => ({ state: { ...state, noted: now }, effects: [{ do: "note", at }] });
  if (stands && now - state.noted > kNoteEvery) return note(String(atOf(state, facts)));
  if (moves(state, facts) && facts.addressAt && recorded) return note("");
  return { state, effects: [] };
}
