// The states of the page's time, as plain values. Transitions are pure functions in time_moves.ts and time_frame.ts;
// time.svelte.ts keeps the state and carries out the effects.

/** A range of capture times [ns since the epoch]. */
export interface TimeRange {
  first_ns: bigint;
  last_ns: bigint;
}

export type Phase =
  /** New data are shown as they arrive: of a robot the newest, of a recording the server's playhead. */
  | { is: "live" }
  /** As live, but a person paused before the first data: they are shown, and then it stands. */
  | { is: "early" }
  /** Paused at a moment, which this page chose. */
  | { is: "stands"; at_ns: bigint }
  /** Advances from a moment by the page's clock: the past of a robot, or a recording backwards. */
  | { is: "runs"; at_ns: bigint };

export interface TimeState {
  phase: Phase;
  /** 1 is real time, negative is backwards. A recording has its server's speed unless this one is negative. */
  speed: number;
  /** The repeated range. */
  loop: TimeRange | undefined;
  /** The moment that the address asks for, until it is shown. */
  asked_ns: bigint | undefined;
  /** [s] Time of the last change of the address. */
  noted: number;
}

/** The world that a transition sees. `now` is the page's steady clock. */
export interface Facts {
  now: number;
  /** Undefined without data. */
  range: TimeRange | undefined;
  /** Whether the reference plays a recording. The next four belong to it. */
  recorded: boolean;
  /** Whether its playhead is known. */
  known: boolean;
  /** Whether it plays. */
  plays: boolean;
  /** The playhead, or the place of a pending wish. */
  place_ns: bigint;
  /** Its speed, or that of a pending wish. */
  speed: number;
  /** Whether a wish is pending. */
  pending: boolean;
}

export type Effect =
  /** All servers that play recordings get a wish; the others show their newest data. */
  | { do: "ask"; play: boolean; speed: number; seek_ns: bigint | undefined }
  /** All servers show the moment of the phase. */
  | { do: "show" }
  /** All servers show their newest data. */
  | { do: "release" }
  /** The address gets this moment; "" removes it. */
  | { do: "note"; at: string }
  | { do: "say"; text: string };

/** The result of a transition. */
export interface Change {
  state: TimeState;
  effects: Effect[];
}

/** Returns the state of a page that opens: live, with the moment and the loop of its address. */
export function opening(at: string, loop: string): TimeState {
  const [first, last] = loop.split("-").map(momentOf);
  return {
    phase: { is: "live" },
    speed: 1,
    loop: first !== undefined && last !== undefined ? { first_ns: first, last_ns: last } : undefined,
    asked_ns: momentOf(at),
    noted: 0,
  };
}

const momentOf = (text: string): bigint | undefined => (/^\d{1,19}$/.test(text) ? BigInt(text) : undefined);

export const isLive = ({ phase }: TimeState): boolean => phase.is === "live" || phase.is === "early";

/** Whether there are data and the playhead of a recording is known. */
export const isThere = ({ range, recorded, known }: Facts): boolean => range !== undefined && (!recorded || known);

/** The shown moment. */
export function atOf(state: TimeState, { recorded, place_ns, range }: Facts): bigint {
  const { phase } = state;
  if (phase.is === "stands" || phase.is === "runs") return phase.at_ns;
  return recorded ? place_ns : (range?.last_ns ?? 0n);
}

/** Whether new data are shown as they arrive and more are expected. */
export const moves = (state: TimeState, { recorded, plays }: Facts): boolean => isLive(state) && (!recorded || plays);

/** Whether time advances, in either way. */
export const runs = (state: TimeState, facts: Facts): boolean =>
  state.phase.is !== "early" && (moves(state, facts) || state.phase.is === "runs");

export const within = (at_ns: bigint, { first_ns, last_ns }: TimeRange): bigint =>
  at_ns < first_ns ? first_ns : at_ns > last_ns ? last_ns : at_ns;
