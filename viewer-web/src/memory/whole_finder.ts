// Finds when a condition held in the whole recording that a server plays. Its objects are fetched and searched part by
// part, also parts that this page has not shown.

import { byTime } from "../source/by_time";
import type { Condition } from "./condition";
import type { Decoded } from "./decoder";
import type { Match } from "./finder";
import type { Fields } from "./value";

export interface RecordedMessage {
  log_ns: bigint;
  data: Uint8Array;
}

/** Fetches the messages of a topic between two capture times [ns], both included. Rejects with a sentence. */
export type FetchPart = (topic: string, from_ns: bigint, to_ns: bigint) => Promise<RecordedMessage[]>;

const kMostMatches = 5000;
const kParts = 40; // of the whole recording
const kLeast_ns = 2_000_000_000n; // of a part: a shorter one is not worth a request
const kDelayMs = 300; // no request while a person still types

type Message = RecordedMessage & { topic: string };

export class WholeFinder {
  /** The matches so far, in order of time. */
  matches: Match[] = [];
  /** The reason why the search failed, or "". */
  problem = "";
  #next_ns: bigint; // the next part begins here
  readonly #part_ns: bigint;
  #fetching = false;
  #messages: Message[] = []; // of the fetched part, by time
  #read = 0; // number of messages already read
  #newest = new Map<string, Fields | undefined>();
  #open: Match | undefined; // the match that still lasts
  #since: number | undefined;

  constructor(
    readonly condition: Condition,
    readonly decoders: ReadonlyMap<string, (data: Uint8Array) => Decoded>,
    readonly range: { start_ns: bigint; end_ns: bigint },
    readonly fetch: FetchPart,
  ) {
    this.#next_ns = range.start_ns;
    const part_ns = (range.end_ns - range.start_ns) / BigInt(kParts) + 1n;
    this.#part_ns = part_ns > kLeast_ns ? part_ns : kLeast_ns;
  }

  /** True when everything is searched or the maximum number of matches is reached. */
  get done(): boolean {
    return (
      this.full ||
      this.problem !== "" ||
      (!this.#fetching && this.#read === this.#messages.length && this.#next_ns > this.range.end_ns)
    );
  }

  get full(): boolean {
    return this.matches.length >= kMostMatches;
  }

  /** Searched share: 0 .. 1. */
  get share(): number {
    const whole = Number(this.range.end_ns - this.range.start_ns);
    return this.done || whole === 0
      ? 1
      : Math.max(0, Math.min(1, Number(this.#next_ns - this.#part_ns - this.range.start_ns) / whole));
  }

  /** Continues for at most `milliseconds`. Call it repeatedly until it is done. */
  update(milliseconds: number, clock: () => number = () => performance.now()): void {
    const now = clock();
    this.#since ??= now;
    if (this.done || now - this.#since < kDelayMs) return;
    for (let read = 0; this.#read < this.#messages.length && !this.full; ++read) {
      if (read % 16 === 15 && clock() > now + milliseconds) return;
      this.#take(this.#messages[this.#read++]!);
    }
    if (!this.#fetching && this.#next_ns <= this.range.end_ns) void this.#fetchPart();
  }

  async #fetchPart(): Promise<void> {
    this.#fetching = true;
    const from_ns = this.#next_ns;
    const to_ns = from_ns + this.#part_ns - 1n;
    this.#next_ns = to_ns + 1n;
    try {
      const parts = await Promise.all(
        this.condition.topics.map(async (topic) =>
          (await this.fetch(topic, from_ns, to_ns)).map((message) => ({ ...message, topic })),
        ),
      );
      this.#messages = parts.flat().sort(byTime);
      this.#read = 0;
    } catch (error) {
      this.problem = (error as Error).message;
    }
    this.#fetching = false;
  }

  #take({ topic, log_ns, data }: Message): void {
    this.#newest.set(topic, this.decoders.get(topic)?.(data).fields);
    // a moment is judged when all objects have their values of it
    if (this.#messages[this.#read]?.log_ns === log_ns) return;
    const holds = this.condition.holds((wanted) => this.#newest.get(wanted));
    if (this.#open) this.#open.to_ns = log_ns;
    if (!holds) this.#open = undefined;
    else if (!this.#open) this.matches.push((this.#open = { from_ns: log_ns, to_ns: log_ns }));
  }
}
