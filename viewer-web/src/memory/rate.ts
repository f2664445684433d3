// How often something comes, and whether it has stopped. Times are seconds of this computer's own steady clock.

const kWindow = 10; // [s] what came earlier says nothing about now
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
   * [Hz] over the last arrivals, at most 10 s of them. What comes evenly has exactly its rate; once the next one is
   * late the rate falls, and is 0 when it is overdue.
   */
  hz(now: number): number {
    const recent = this.#arrivals.filter((arrival) => arrival > now - kWindow);
    if (recent.length < 2 || this.overdue(now)) return 0;
    const [first, last] = [recent[0]!, recent.at(-1)!];
    const interval = (last - first) / (recent.length - 1);
    const span = Math.max(last, now - interval) - first;
    return span > 0 ? (recent.length - 1) / span : 0;
  }

  /** [s] mean time between the last arrivals, however long ago; undefined before the second one. */
  interval(): number | undefined {
    const count = this.#arrivals.length;
    if (count < 2) return undefined;
    return (this.#arrivals[count - 1]! - this.#arrivals[0]!) / (count - 1);
  }

  /** Whether the next one takes far longer than it used to, and at least 2 s; never before the second one. */
  overdue(now: number): boolean {
    const interval = this.interval();
    return interval !== undefined && this.silence(now)! > Math.max(2, 5 * interval);
  }

  /** [s] since the last arrival; undefined before the first one. */
  silence(now: number): number | undefined {
    const last = this.#arrivals.at(-1);
    return last === undefined ? undefined : now - last;
  }
}
