// How far a server is in the recording that it plays, as seen from here.

import type { PlaybackState } from "../source/frames";

/** Times are capture times of the recording [ns since the epoch]; `now` is our own steady clock [s]. */
export class Played {
  status: PlaybackState["status"] = "playing";
  /** 1 is real time. */
  speed = 1;
  #from_ns: bigint; // where it was...
  #since = 0; // [s] ...at this time
  #told = false;

  constructor(
    readonly start_ns: bigint,
    readonly end_ns: bigint,
  ) {
    this.#from_ns = start_ns;
  }

  get runs(): boolean {
    return this.status === "playing";
  }

  /** Whether anything has told yet where it is. */
  get known(): boolean {
    return this.#told;
  }

  told({ status, time_ns, speed }: Pick<PlaybackState, "status" | "time_ns" | "speed">, now: number): void {
    this.status = status;
    this.speed = speed;
    this.heard(time_ns, now);
  }

  /** A Time frame came: it corrects what was reckoned. */
  heard(time_ns: bigint, now: number): void {
    this.#from_ns = time_ns;
    this.#since = now;
    this.#told = true;
  }

  /** Where it is now, never beyond the recording's ends. */
  at(now: number): bigint {
    const passed_ns = this.runs ? BigInt(Math.round((now - this.#since) * this.speed * 1e9)) : 0n;
    return this.within(this.#from_ns + passed_ns);
  }

  /** The moment of the recording that is nearest to `at_ns`. */
  within(at_ns: bigint): bigint {
    if (at_ns < this.start_ns) return this.start_ns;
    return at_ns > this.end_ns ? this.end_ns : at_ns;
  }
}
