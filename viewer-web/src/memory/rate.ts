// The rate of a stream, and whether it has stopped. Times are seconds of the page's steady clock.

const kWindow = 10; // [s] earlier arrivals do not describe the present
const kMost = 128; // [arrivals] enough for a second of the fastest sensor

export class Rate {
  #arrivals: number[] = [];

  arrived(now: number): void {
    this.#arrivals.push(now);
    if (this.#arrivals.length > 2 * kMost) this.#arrivals = this.#arrivals.slice(-kMost);
  }

  clear(): void {
    this.#arrivals = [];
  }

  /**
   * [Hz] over the arrivals of the last 10 s. An even stream has exactly its rate. The rate falls once the next arrival
   * is late, and is 0 when it is overdue.
   */
  hz(now: number): number {
    const recent = this.#arrivals.filter((arrival) => arrival > now - kWindow);
    if (recent.length < 2 || this.overdue(now)) return 0;
    const [first, last] = [recent[0]!, recent.at(-1)!];
    const interval = (last - first) / (recent.length - 1);
    const span = Math.max(last, now - interval) - first;
    return span > 0 ? (recent.length - 1) / span : 0;
  }

  /** [s] Mean time between the last arrivals, however long ago. Undefined before the second one. */
  interval(): number | undefined {
    const count = this.#arrivals.length;
    if (count < 2) return undefined;
    return (this.#arrivals[count - 1]! - this.#arrivals[0]!) / (count - 1);
  }

  /** Whether the next arrival is far later than usual, and at least 2 s. Never before the second arrival. */
  overdue(now: number): boolean {
    const interval = this.interval();
    return interval !== undefined && this.silence(now)! > Math.max(2, 5 * interval);
  }

  /** [s] since the last arrival. Undefined before the first one. */
  silence(now: number): number | undefined {
    const last = this.#arrivals.at(-1);
    return last === undefined ? undefined : now - last;
  }
}
