// Half of an NTP-like exchange with the server, over and over: what we measure goes back with the next call and is
// recorded there as a clock sample, so that recordings of several machines can be put side by side.

import type { Answer } from "./calls";

const kPeriodMs = 10000;

export interface Measured {
  /** [ns] to add to the server's time to get ours. */
  offset_ns: bigint;
  round_trip_ns: bigint;
}

/** What an answer tells that came back at `returned_ns` for a question sent at `sent_ns` (both our time). */
export function measured(sent_ns: bigint, received_ns: bigint, returned_ns: bigint): Measured {
  // the server heard us half-way between: that is the best guess, wrong by half the round trip at most
  return { offset_ns: (sent_ns + returned_ns) / 2n - received_ns, round_trip_ns: returned_ns - sent_ns };
}

/** Our time [ns since the epoch]: steady while the page is open. */
export const pageNow = (): bigint => BigInt(Math.round((performance.timeOrigin + performance.now()) * 1000)) * 1000n;

export class ClockExchange {
  #timer: ReturnType<typeof setInterval> | undefined;
  #last: Measured | undefined;

  constructor(
    readonly call: (request: object) => Promise<Answer>,
    readonly now: () => bigint = pageNow,
  ) {}

  /** Asks now and every ten seconds until stop(). */
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

  /** One exchange. A server that does not answer, or with nonsense, is asked again later. */
  async ask(): Promise<void> {
    const sent_ns = this.now();
    const known = this.#last && { offset_ns: String(this.#last.offset_ns), round_trip_ns: String(this.#last.round_trip_ns) };
    try {
      const answer = await this.call({ sent_ns: String(sent_ns), ...known });
      this.#last = measured(sent_ns, BigInt(answer["received_ns"] as string), this.now());
    } catch {
      this.#last = undefined;
    }
  }
}
