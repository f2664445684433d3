// The messages of one memory object during the last minutes, packed into few buffers, so that a page can go back in
// time.

/** One received message. `log_ns` is its capture time; `arrived` [s] is on the page's steady clock. */
export interface Entry {
  log_ns: bigint;
  data: Uint8Array;
  arrived: number;
}

const kBlockBytes = 32768; // a small message costs its own bytes plus 20
const kPerMessage = 20; // [bytes] of times and places in the blocks' own arrays
const kMostPerBlock = 256; // [messages]
const kSeek_ns = 1_000_000_000n; // a capture time this much before the last one is a seek: another past begins

/** Consecutive messages. A block is filled once and dropped as a whole. */
interface Block {
  data: Uint8Array;
  used: number; // [bytes]
  count: number;
  times: BigInt64Array; // [ns] capture times, never decreasing
  arrivals: Float64Array; // [s]
  ends: Uint32Array; // [bytes] where each message ends
}

function newBlock(least_bytes: number): Block {
  const large = least_bytes > kBlockBytes / 2;
  const most = large ? 1 : kMostPerBlock;
  return {
    data: new Uint8Array(large ? least_bytes : kBlockBytes),
    used: 0,
    count: 0,
    times: new BigInt64Array(most),
    arrivals: new Float64Array(most),
    ends: new Uint32Array(most),
  };
}

const sizeOf = ({ data, times }: Block): number => data.length + kPerMessage * times.length;

/**
 * Messages in order of capture time, numbered from the first one ever. Numbers stay when old messages are dropped, so
 * a reader that continues from a number misses nothing that is still kept. A message slightly older than the one
 * before it gets that one's time. A much older one means a seek: everything before it is forgotten.
 */
export class History {
  #blocks: Block[] = [];
  #starts: number[] = []; // number of each block's first message
  #end = 0;
  /** Counts how often the past was forgotten. Numbers from an earlier generation are invalid. */
  generation = 0;
  size_bytes = 0;
  /** [ns] Capture time up to which messages were dropped to save memory. */
  given_up_ns: bigint | undefined;

  /** Number of the oldest kept message. */
  get begin(): number {
    return this.#starts[0] ?? this.#end;
  }
  /** Number of the newest message plus one. */
  get end(): number {
    return this.#end;
  }
  get first_ns(): bigint | undefined {
    return this.#blocks[0]?.times[0];
  }
  get last_ns(): bigint | undefined {
    const last = this.#blocks.at(-1);
    return last?.times[last.count - 1];
  }

  clear(): void {
    this.#blocks = [];
    this.#starts = [];
    this.size_bytes = 0;
    this.given_up_ns = undefined;
    ++this.generation;
  }

  /** Whether a message with this capture time would end the kept past. */
  goesBack(log_ns: bigint): boolean {
    const last_ns = this.last_ns;
    return last_ns !== undefined && log_ns < last_ns - kSeek_ns;
  }

  /** Stores a copy. */
  add({ log_ns, data, arrived }: Entry): void {
    if (this.goesBack(log_ns)) this.clear();
    const last_ns = this.last_ns ?? log_ns;
    let block = this.#blocks.at(-1);
    if (!block || block.count === block.times.length || block.used + data.length > block.data.length) {
      block = newBlock(data.length);
      this.#blocks.push(block);
      this.#starts.push(this.#end);
      this.size_bytes += sizeOf(block);
    }
    block.data.set(data, block.used);
    block.used += data.length;
    block.times[block.count] = log_ns > last_ns ? log_ns : last_ns;
    block.arrivals[block.count] = arrived;
    block.ends[block.count++] = block.used;
    ++this.#end;
  }

  /**
   * Puts `entries`, in order of capture time, in place of all messages from the first of them to the last. All messages
   * get new numbers: another generation begins.
   */
  recall(entries: readonly Entry[]): void {
    const [first_ns, last_ns] = [entries[0]?.log_ns, entries.at(-1)?.log_ns];
    if (first_ns === undefined || last_ns === undefined) return;
    const kept: Entry[] = [];
    for (let index = this.begin; index < this.#end; ++index) kept.push(this.get(index)!);
    const given_up_ns = this.given_up_ns;
    this.clear();
    for (const entry of kept) if (entry.log_ns < first_ns) this.add(entry);
    for (const entry of entries) this.add(entry);
    for (const entry of kept) if (entry.log_ns > last_ns) this.add(entry);
    // the server still had what the page dropped to save memory
    if (given_up_ns !== undefined && given_up_ns < first_ns) this.given_up_ns = given_up_ns;
  }

  /** Returns the message with this number, or undefined if it was dropped or has not arrived. */
  get(index: number): Entry | undefined {
    const at = this.#place(index);
    if (!at) return undefined;
    const { block, i } = at;
    return {
      log_ns: block.times[i]!,
      data: block.data.subarray(i === 0 ? 0 : block.ends[i - 1], block.ends[i]),
      arrived: block.arrivals[i]!,
    };
  }

  /**
   * [ns] Capture time of the oldest kept message that was no retained value: one that came as much later as `isLate` says.
   * Only the first message of a subscription can be one.
   */
  movesSince(isLate: (entry: Entry) => boolean): bigint | undefined {
    const first = this.get(this.begin);
    return first && isLate(first) ? this.timeOf(this.begin + 1) : first?.log_ns;
  }

  timeOf(index: number): bigint | undefined {
    const at = this.#place(index);
    return at && at.block.times[at.i];
  }

  /** Number of the newest message captured at `log_ns` or before, or `begin` - 1 if there is none. */
  indexAt(log_ns: bigint): number {
    let [low, high] = [this.begin, this.#end];
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.timeOf(middle)! <= log_ns) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** Returns the newest message at `log_ns`. */
  at(log_ns: bigint): Entry | undefined {
    return this.get(this.indexAt(log_ns));
  }

  /** Returns the message captured nearest to `log_ns`, or undefined if none is within `most_ns`. */
  near(log_ns: bigint, most_ns: bigint): Entry | undefined {
    const index = this.indexAt(log_ns);
    const away = (entry: Entry) => (entry.log_ns > log_ns ? entry.log_ns - log_ns : log_ns - entry.log_ns);
    const [before, after] = [this.get(index), this.get(index + 1)];
    const nearest = before && (!after || away(before) <= away(after)) ? before : after;
    return nearest && away(nearest) <= most_ns ? nearest : undefined;
  }

  /** [Hz] over the two seconds up to `log_ns`. */
  hzAt(log_ns: bigint): number {
    return (this.indexAt(log_ns) - this.indexAt(log_ns - 2_000_000_000n)) / 2;
  }

  /**
   * [s] Arrival of the newest message in the oldest block. Undefined if only one block is left, which is never
   * dropped.
   */
  oldestArrival(): number | undefined {
    const [oldest, next] = this.#blocks;
    return next && oldest!.arrivals[oldest!.count - 1];
  }

  /** Drops the oldest block. */
  dropOldest(): void {
    const block = this.#blocks.shift();
    if (!block) return;
    this.#starts.shift();
    this.size_bytes -= sizeOf(block);
    this.given_up_ns = this.first_ns ?? block.times[block.count - 1];
  }

  #place(index: number): { block: Block; i: number } | undefined {
    if (index < this.begin || index >= this.#end) return undefined;
    let [low, high] = [0, this.#starts.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >>> 1;
      if (this.#starts[middle]! <= index) low = middle;
      else high = middle - 1;
    }
    return { block: this.#blocks[low]!, i: index - this.#starts[low]! };
  }
}
