// Finds when a condition held, from the histories of all objects that it reads, a few milliseconds at a time.

import type { Condition } from "./condition";
import type { Entry, History } from "./history";
import type { Decoded } from "./decoder";
import type { Fields } from "./value";

/** The past of one topic. */
export interface Source {
  readonly history: History;
  decode(data: Uint8Array): Decoded;
}

/** The condition held between these capture times [ns]. `to_ns` of the newest match grows while the condition holds. */
export interface Match {
  from_ns: bigint;
  to_ns: bigint;
}

const kMostMatches = 5000;
const kLate_ns = 500_000_000n; // a message this much later than the others is still sorted in

interface Reading {
  topic: string;
  source: Source;
  next: number;
  generation: number;
  fields: Fields | undefined;
}

export class Finder {
  /** In order of time. */
  matches: Match[] = [];
  #readings: Reading[] = [];
  #open: Match | undefined; // the match that still lasts

  /** `recorded`: matches stay when another part of the recording is read, or the same part again. */
  constructor(
    readonly condition: Condition,
    sources: ReadonlyMap<string, Source>,
    readonly recorded = false,
  ) {
    for (const topic of condition.topics) {
      const source = sources.get(topic);
      if (source) this.#readings.push({ topic, source, next: 0, generation: -1, fields: undefined });
    }
    this.#restart();
  }

  /** Reads on for at most `milliseconds`. Returns true when everything is read. */
  update(milliseconds: number, clock: () => number = () => performance.now()): boolean {
    if (this.#readings.some(({ source, generation }) => source.history.generation !== generation)) this.#restart();
    const until_ns = this.#orderedUntil();
    const end = clock() + milliseconds;
    for (let read = 0; ; ++read) {
      if (read % 16 === 15 && clock() > end) return false;
      const reading = this.#earliest();
      const entry = reading?.source.history.get(reading.next);
      if (!reading || !entry || entry.log_ns > until_ns) return true;
      ++reading.next;
      reading.fields = reading.source.decode(entry.data).fields;
      // a moment is judged when all objects have their values of it
      const after = this.#earliest();
      if (after?.source.history.get(after.next)?.log_ns !== entry.log_ns) this.#note(entry);
    }
  }

  #restart(): void {
    if (!this.recorded) this.matches = [];
    this.#open = undefined;
    for (const reading of this.#readings) {
      reading.generation = reading.source.history.generation;
      reading.next = reading.source.history.begin;
      reading.fields = undefined;
    }
  }

  /** The capture time up to which no more earlier messages are expected. */
  #orderedUntil(): bigint {
    let [first, last]: [bigint | undefined, bigint] = [undefined, 0n];
    for (const { source } of this.#readings) {
      const last_ns = source.history.last_ns ?? 0n;
      if (first === undefined || last_ns < first) first = last_ns;
      if (last_ns > last) last = last_ns;
    }
    const least = last - kLate_ns;
    return first !== undefined && first > least ? first : least;
  }

  #earliest(): Reading | undefined {
    let [found, time]: [Reading | undefined, bigint] = [undefined, 0n];
    for (const reading of this.#readings) {
      const { history } = reading.source;
      reading.next = Math.max(reading.next, history.begin);
      const log_ns = history.timeOf(reading.next);
      if (log_ns !== undefined && (!found || log_ns < time)) [found, time] = [reading, log_ns];
    }
    return found;
  }

  #note({ log_ns }: Entry): void {
    const holds = this.condition.holds((topic) => this.#readings.find((reading) => reading.topic === topic)?.fields);
    if (this.#open && log_ns > this.#open.to_ns) this.#open.to_ns = log_ns;
    if (!holds) this.#open = undefined;
    else this.#open ??= this.#begin(log_ns);
    if (this.matches.length > kMostMatches) this.matches.splice(0, kMostMatches / 10);
  }

  /** Returns the match that begins now, or an earlier one that holds at this time. */
  #begin(log_ns: bigint): Match {
    const last = this.matches.findLastIndex(({ from_ns }) => from_ns <= log_ns);
    const known = this.matches[last];
    if (known && known.to_ns >= log_ns) return known;
    const match = { from_ns: log_ns, to_ns: log_ns };
    this.matches.splice(last + 1, 0, match);
    return match;
  }
}
