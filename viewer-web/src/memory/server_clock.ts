// The server's clock, estimated by the page.

const kWindow = 30; // [s] long enough to contain a fast frame, short enough to follow a drift

/**
 * Estimates the offset of the server's clock from its Time frames. The fastest frame is the most accurate one, so the
 * least difference in the window counts (a minimum filter). Ages are therefore too small by the least travel time, a
 * few ms.
 */
export class ServerClock {
  #origin_ns: bigint | undefined; // differences to it fit into a double without loss
  #last_ns = 0n;

  /** The server's last reported time. Undefined before the first Time frame. */
  get last_ns(): bigint | undefined {
    return this.#origin_ns === undefined ? undefined : this.#last_ns;
  }

  /** The server's time now. Undefined before the first Time frame. */
  now_ns(now: number): bigint | undefined {
    const least = this.#differences[0];
    return least && this.#origin_ns! + BigInt(Math.round(1e9 * (now - least.difference)));
  }

  // Candidates for the minimum, oldest and smallest first. An older difference that is not smaller can never become the
  // minimum.
  #differences: { at: number; difference: number }[] = [];

  clear(): void {
    this.#origin_ns = undefined;
    this.#differences = [];
  }

  /**
   * Handles a Time frame. `now`: the page's steady clock [s]. A server time that goes back is a seek and resets the
   * estimate.
   */
  heard(server_ns: bigint, now: number): void {
    if (server_ns < this.#last_ns) this.clear();
    this.#last_ns = server_ns;
    this.#origin_ns ??= server_ns;

    const difference = now - this.#seconds(server_ns);
    while (this.#differences.length > 0 && this.#differences.at(-1)!.difference >= difference) this.#differences.pop();
    this.#differences.push({ at: now, difference });
    while (this.#differences[0]!.at < now - kWindow) this.#differences.shift();
  }

  /** [s] since `capture_ns`, never negative. Undefined before the first Time frame. */
  age(capture_ns: bigint, now: number): number | undefined {
    const least = this.#differences[0];
    if (!least) return undefined;
    return Math.max(0, now - least.difference - this.#seconds(capture_ns));
  }

  #seconds(time_ns: bigint): number {
    return Number(time_ns - this.#origin_ns!) / 1e9;
  }
}
