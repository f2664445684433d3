// The client's half of an NTP-like exchange with the server. Each call also reports the last measurement. The server
// records it as a clock sample, so that recordings of several machines can be aligned.

import type { Answer } from "./calls";

const kPeriodMs = 10000;

export interface Measured {
  /** [ns] to add to the server's time to get the page's time. */
  offset_ns: bigint;
  round_trip_ns: bigint;
}

/**
 * Computes offset and round trip from one answer. `sent_ns` and `returned_ns` are the page's time, `received_ns` is
 * the server's.
 */
export function measured(sent_ns: bigint, received_ns: bigint, returned_ns: bigint): Measured {
  // best guess: the server received it half-way; the error is at most half the round trip
  return { offset_ns: (sent_ns + returned_ns) / 2n - received_ns, round_trip_ns: returned_ns - sent_ns };
}

/** The page's time [ns since the epoch]. It never steps while the page is open. */
export const pageNow = (): bigint => BigInt(Math.round((performance.timeOrigin + performance.now()) * 1000)) * 1000n;

export class ClockExchange {
  #timer: ReturnType<typeof setInterval> | undefined;
  #last: Measured | undefined;

  constructor(
    readonly call: (request: object) => Promise<Answer>,
    readonly now: () => bigint = pageNow,
  ) {}

  /** Asks now and then every ten seconds until stop(). */
  start(): void {
    if (this.#timer !== undefined) return;
    this.#timer = setInterval(() => void this.ask(), kPeriodMs);
    void this.ask();
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#last = undefined;
  }

  /** Makes one exchange. After a missing or senseless answer the next one follows as usual. */
  async ask(): Promise<void> {
    const sent_ns = this.now();
    const known = this.#last && {
      offset_ns: String(this.#last.offset_ns),
      round_trip_ns: String(this.#last.round_trip_ns),
    };
    try {
      const answer = await this.call({ sent_ns: String(sent_ns), ...known });
      this.#last = measured(sent_ns, BigInt(answer["received_ns"] as string), this.now());
    } catch {
      this.#last = undefined;
    }
  }
}
