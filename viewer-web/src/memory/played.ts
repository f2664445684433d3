// The server's playhead in the recording that it plays, extrapolated by the page.

import type { PlaybackState } from "../source/frames";

/** Times are capture times of the recording [ns since the epoch]. `now` is the page's steady clock [s]. */
export class Played {
  status: PlaybackState["status"] = "playing";
  /** 1 is real time. */
  speed = 1;
  #from_ns: bigint; // the playhead...
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

  /** Whether the server has reported the playhead yet. */
  get known(): boolean {
    return this.#told;
  }

  told({ status, time_ns, speed }: Pick<PlaybackState, "status" | "time_ns" | "speed">, now: number): void {
    this.status = status;
    this.speed = speed;
    this.heard(time_ns, now);
  }

  /** Handles a Time frame, which corrects the extrapolation. */
  heard(time_ns: bigint, now: number): void {
    this.#from_ns = time_ns;
    this.#since = now;
    this.#told = true;
  }

  /** The playhead now, never beyond the recording's ends. */
  at(now: number): bigint {
    const passed_ns = this.runs ? BigInt(Math.round((now - this.#since) * this.speed * 1e9)) : 0n;
    return this.within(this.#from_ns + passed_ns);
  }

  /** Clamps `at_ns` to the recording. */
  within(at_ns: bigint): bigint {
    if (at_ns < this.start_ns) return this.start_ns;
    return at_ns > this.end_ns ? this.end_ns : at_ns;
  }
}
