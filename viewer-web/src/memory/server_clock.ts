// The server's clock as seen from here.

const kWindow = 30; // [s] long enough to meet a fast frame, short enough to follow a drift

/**
 * Learns from Time frames how far the server's clock is from ours. The frame that travelled fastest is the most
 * truthful one, so the least difference within the window counts (a minimum filter). Ages are therefore too small by
 * the least travelling time, a few ms.
 */
export class ServerClock {
  #origin_ns: bigint | undefined; // differences to it fit a double without loss
  #last_ns = 0n;

  /** What the server said last; undefined until the first Time frame. */
  get last_ns(): bigint | undefined {
    return this.#origin_ns === undefined ? undefined : this.#last_ns;
  }

  /** What its clock shows now; undefined until the first Time frame. */
  now_ns(now: number): bigint | undefined {
    const least = this.#differences[0];
    return least && this.#origin_ns! + BigInt(Math.round(1e9 * (now - least.difference)));
  }

  // Candidates for the minimum, oldest first, growing: one that is older and not less can never become it.
  #differences: { at: number; difference: number }[] = [];

  clear(): void {
    this.#origin_ns = undefined;
    this.#differences = [];
  }

  /** A Time frame came; `now` is our own steady clock in seconds. A server time that goes back is a seek: it starts anew. */
  heard(server_ns: bigint, now: number): void {
    if (server_ns < this.#last_ns) this.clear();
    this.#last_ns = server_ns;
    this.#origin_ns ??= server_ns;

    const difference = now - this.#seconds(server_ns);
    while (this.#differences.length > 0 && this.#differences.at(-1)!.difference >= difference) this.#differences.pop();
    this.#differences.push({ at: now, difference });
    while (this.#differences[0]!.at < now - kWindow) this.#differences.shift();
  }

  /** [s] since `capture_ns`, never negative; undefined until the first Time frame. */
  age(capture_ns: bigint, now: number): number | undefined {
    const least = this.#differences[0];
    if (!least) return undefined;
    return Math.max(0, now - least.difference - this.#seconds(capture_ns));
  }

  #seconds(time_ns: bigint): number {
    return Number(time_ns - this.#origin_ns!) / 1e9;
  }
}
