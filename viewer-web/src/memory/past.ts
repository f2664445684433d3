// Limits of the kept past, shared by all objects of all servers.

import type { Entry, History } from "./history";

/** [bytes] for all objects except images, and for images. */
export interface Caps {
  values: number;
  pictures: number;
}

/** About twenty minutes of four robots on a laptop. A phone has less memory. */
export const capsFor = (small: boolean): Caps =>
  small ? { values: 48e6, pictures: 24e6 } : { values: 160e6, pictures: 96e6 };

const kLargePicture = 100_000; // [bytes] larger images are raw, without compression
const kSpacing = { small: 0.09, large: 0.5 }; // [s] between kept images: ten and two a second

export class Past {
  #groups = { values: new Set<History>(), pictures: new Set<History>() };

  constructor(readonly caps: Caps = capsFor(false)) {}

  get size_bytes(): number {
    return sizeOf(this.#groups.values) + sizeOf(this.#groups.pictures);
  }

  forget(history: History): void {
    this.#groups.values.delete(history);
    this.#groups.pictures.delete(history);
  }

  /** Stores a message. The rate of stored images is limited, so that some minutes fit. */
  keep(history: History, entry: Entry, isPicture: boolean): void {
    if (isPicture && tooSoon(history, entry)) return;
    const kind = isPicture ? "pictures" : "values";
    const before = history.size_bytes;
    history.add(entry);
    this.#groups[kind].add(history);
    if (history.size_bytes > before) fit(this.#groups[kind], this.caps[kind]);
  }

  /** Stores earlier messages of an object that is no image. */
  recall(history: History, entries: readonly Entry[]): void {
    history.recall(entries);
    this.#groups.values.add(history);
    fit(this.#groups.values, this.caps.values);
  }
}

function tooSoon(history: History, { log_ns, data }: Entry): boolean {
  const last_ns = history.last_ns;
  if (last_ns === undefined || log_ns < last_ns) return false;
  return Number(log_ns - last_ns) / 1e9 < (data.length > kLargePicture ? kSpacing.large : kSpacing.small);
}

const sizeOf = (histories: Set<History>): number => [...histories].reduce((sum, { size_bytes }) => sum + size_bytes, 0);

/** Drops the oldest arrivals until the rest fits. */
function fit(histories: Set<History>, most_bytes: number): void {
  for (let total = sizeOf(histories); total > most_bytes;) {
    let oldest: History | undefined;
    for (const history of histories)
      if ((history.oldestArrival() ?? Infinity) < (oldest?.oldestArrival() ?? Infinity)) oldest = history;
    if (!oldest) return;
    const before = oldest.size_bytes;
    oldest.dropOldest();
    total -= before - oldest.size_bytes;
  }
}
