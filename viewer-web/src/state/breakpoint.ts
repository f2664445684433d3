// Stops time at the next moment when a condition begins to hold.

import { earliest } from "./earliest";

const kLate_ns = 1_000_000_000n; // a match may be found this much after its moment was shown
// A step of the shown moment that is longer than time could have run is a seek, which no match stops. This is the slack of
// a playback that catches up.
const kJump_ns = 3_000_000_000n;

export class Breakpoint {
  #passed_ns: bigint | undefined; // matches up to here stop nothing
  #shown_ns = 0n;
  #ran = false; // at the last call: a playback that pauses has run up to its moment
  #could_ns = 0n; // by which time can have run since the shown moment last changed

  /**
   * Call it for each frame with the shown moment and the begins of all matches, in any order [ns]. `elapsed_ns` is the time
   * since the last call, at the pace of the playback. A picture may be late, and then show a much later moment. Returns
   * the moment to stop at, or undefined.
   */
  stopAt(at_ns: bigint, runs: boolean, begins: readonly bigint[], elapsed_ns: bigint): bigint | undefined {
    const step_ns = at_ns - this.#shown_ns;
    this.#shown_ns = at_ns;
    this.#could_ns += elapsed_ns;
    const isSeek = step_ns < 0n || step_ns > this.#could_ns + kJump_ns;
    if (step_ns !== 0n || !runs) this.#could_ns = 0n;
    const ran = runs || this.#ran;
    this.#ran = runs;
    if (this.#passed_ns === undefined || !ran || isSeek) {
      this.#passed_ns = at_ns;
      return undefined;
    }
    const passed_ns = this.#passed_ns;
    const found_ns = earliest(begins.filter((begin_ns) => begin_ns > passed_ns && begin_ns <= at_ns));
    if (found_ns !== undefined) {
      this.#passed_ns = this.#shown_ns = found_ns;
      this.#ran = false;
    } else if (at_ns - passed_ns > kLate_ns) this.#passed_ns = at_ns - kLate_ns;
    return found_ns;
  }

  /** Forgets the past: only matches from now on stop. */
  clear(): void {
    this.#passed_ns = undefined;
  }
}
