// The offsets between the clocks of several servers, so that all show one moment.

import type { Server } from "./server.svelte";

/** The part of a server that the offsets use. */
export type Clocked = Pick<Server, "memory" | "played">;

/** Clocks that differ by less count as equal. Over wireless, the page measures no better than the robots do. */
const kAgree_ns = 250_000_000n;

const abs = (value: bigint): bigint => (value < 0n ? -value : value);

export class ClockShifts {
  #kept = new Map<Clocked, bigint>(); // [ns] when the page left the live time

  /** [ns] To add to the time of `reference` to get that of `server`, `live` or at a chosen moment. */
  of(server: Clocked, reference: Clocked, live: boolean, now: number): bigint {
    if (server === reference) return 0n;
    if (reference.played && server.played) return shiftBetween(reference.played, server.played);
    if (!live) return this.#kept.get(server) ?? 0n;
    const [own, other] = [reference, server].map(({ memory, played }) =>
      played ? played.at(now) : memory.clock.now_ns(now),
    );
    if (own === undefined || other === undefined) return 0n;
    return abs(other - own) < kAgree_ns ? 0n : other - own;
  }

  /** Keeps the offsets of the live time: from now on a chosen moment is shown. */
  keep(servers: readonly Clocked[], reference: Clocked, now: number): void {
    this.#kept = new Map(servers.map((server) => [server, this.of(server, reference, true, now)]));
  }
}

/** [ns] 0 between recordings of one game, whose clocks agree; otherwise the shift that aligns their begins. */
function shiftBetween(one: { start_ns: bigint; end_ns: bigint }, other: { start_ns: bigint; end_ns: bigint }): bigint {
  const overlap = one.start_ns <= other.end_ns && other.start_ns <= one.end_ns;
  return overlap ? 0n : other.start_ns - one.start_ns;
}
