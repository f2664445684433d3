// The distance of detections from the true positions of a synthetic sensor's scene, over the last seconds.

import type { Truth, TrueThing } from "./truth";

const kReach = 0.5; // [m] a detection farther from every true position belongs to none
const kSpan_ns = 3_000_000_000n;

export interface Pair {
  found: TrueThing;
  real: TrueThing;
  /** [m] */
  away: number;
}

/** Pairs detections with true positions, the nearest first. Each belongs to at most one pair. */
export function pairsOf(found: TrueThing[], real: TrueThing[]): Pair[] {
  const all = found.flatMap((one) =>
    real.map((other) => ({ found: one, real: other, away: Math.hypot(one.x - other.x, one.y - other.y) })),
  );
  const pairs: Pair[] = [];
  for (const pair of all.filter(({ away }) => away < kReach).sort((a, b) => a.away - b.away))
    if (!pairs.some((other) => other.found === pair.found || other.real === pair.real)) pairs.push(pair);
  return pairs;
}

/** [m] Means over the last seconds; NaN without a pair. */
export interface MeanErrors {
  robots: number;
  ball: number;
}

/** Collects the errors of one truth after the other. */
export class TruthErrors {
  #samples: { at_ns: bigint; robots: number[]; ball: number[] }[] = [];

  /** Adds what was found and what is real at a capture time. A time before the last one begins anew. */
  add(at_ns: bigint, found: Truth, real: Truth): void {
    const last_ns = this.#samples.at(-1)?.at_ns;
    if (at_ns === last_ns) return;
    if (last_ns !== undefined && at_ns < last_ns) this.#samples = [];
    const away = (some: (TrueThing | undefined)[], others: (TrueThing | undefined)[]) =>
      pairsOf(
        some.flatMap((thing) => thing ?? []),
        others.flatMap((thing) => thing ?? []),
      ).map((pair) => pair.away);
    this.#samples.push({ at_ns, robots: away(found.robots, real.robots), ball: away([found.ball], [real.ball]) });
    this.#samples = this.#samples.filter((sample) => at_ns - sample.at_ns <= kSpan_ns);
  }

  get means(): MeanErrors {
    const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
    return {
      robots: mean(this.#samples.flatMap(({ robots }) => robots)),
      ball: mean(this.#samples.flatMap(({ ball }) => ball)),
    };
  }
}
