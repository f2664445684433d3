// Stops time at the next moment when a condition begins to hold.

const kLate_ns = 1_000_000_000n; // a match may be found this much after its moment was shown
const kJump_ns = 3_000_000_000n; // a longer step of the shown moment is a seek, which no match stops

export class Breakpoint {
  #passed_ns: bigint | undefined; // matches up to here stop nothing
  #shown_ns = 0n;

  /**
   * Call it for each frame with the shown moment and the begins of all matches, in order [ns]. Returns the moment to
   * stop at, or undefined.
   */
  stopAt(at_ns: bigint, runs: boolean, begins: readonly bigint[]): bigint | undefined {
    const step_ns = at_ns - this.#shown_ns;
    this.#shown_ns = at_ns;
    if (this.#passed_ns === undefined || !runs || step_ns < 0n || step_ns > kJump_ns) {
      this.#passed_ns = at_ns;
      return undefined;
    }
    const passed_ns = this.#passed_ns;
    const found_ns = begins.find((begin_ns) => begin_ns > passed_ns && begin_ns <= at_ns);
    if (found_ns !== undefined) this.#passed_ns = this.#shown_ns = found_ns;
    else if (at_ns - passed_ns > kLate_ns) this.#passed_ns = at_ns - kLate_ns;
    return found_ns;
  }

  /** Forgets the past: only matches from now on stop. */
  clear(): void {
    this.#passed_ns = undefined;
  }
}
