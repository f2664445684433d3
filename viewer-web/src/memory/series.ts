// One number over time, read from an object's history a few milliseconds at a time, so that a long past does not block
// the page.

import type { Entry } from "./history";
import type { MemoryObject } from "./memory_object";
import type { Fields } from "./value";

const kFirst = 1024; // [points] initial capacity; doubled when full

export class Series {
  /** Capture times [s] after `origin_ns`, and values. Only the first `length` entries count. */
  times = new Float64Array(kFirst);
  values = new Float64Array(kFirst);
  length = 0;
  origin_ns = 0n;
  /** Whether there was any number so far. */
  tellsNumbers = false;
  #next = 0; // number of the next message to read
  #generation = -1;

  constructor(
    readonly object: MemoryObject,
    readonly read: (fields: Fields, entry: Entry) => number,
  ) {}

  /**
   * Reads on for at most `milliseconds`. Returns true when everything is read. Also drops the points that the history
   * has dropped.
   */
  update(milliseconds: number, clock: () => number = () => performance.now()): boolean {
    const { history } = this.object;
    if (history.generation !== this.#generation) this.#restart();
    this.#forgetBefore(history.first_ns);
    this.#next = Math.max(this.#next, history.begin);
    const end = clock() + milliseconds;
    for (let read = 0; this.#next < history.end; ++this.#next) {
      if (++read % 16 === 0 && clock() > end) return false;
      const entry = history.get(this.#next)!;
      const { fields } = this.object.decode(entry.data);
      this.#add(entry.log_ns, fields ? this.read(fields, entry) : NaN);
    }
    return true;
  }

  /** Index of the last point at `time` [s after origin] or before, or -1 if there is none. */
  indexAt(time: number): number {
    let [low, high] = [0, this.length];
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.times[middle]! <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  #restart(): void {
    const { history } = this.object;
    this.#generation = history.generation;
    this.#next = history.begin;
    this.length = 0;
    this.tellsNumbers = false;
    this.origin_ns = history.first_ns ?? 0n;
  }

  #add(log_ns: bigint, value: number): void {
    if (this.length === 0) this.origin_ns = log_ns;
    if (this.length === this.times.length) {
      this.times = grown(this.times);
      this.values = grown(this.values);
    }
    this.times[this.length] = Number(log_ns - this.origin_ns) / 1e9;
    this.values[this.length++] = value;
    if (!Number.isNaN(value)) this.tellsNumbers = true;
  }

  #forgetBefore(first_ns: bigint | undefined): void {
    if (first_ns === undefined || this.length === 0) return;
    const gone = this.indexAt(Number(first_ns - this.origin_ns) / 1e9 - 1e-9) + 1;
    if (gone < kFirst && gone < this.length) return; // rarely, many at once
    this.times.copyWithin(0, gone, this.length);
    this.values.copyWithin(0, gone, this.length);
    this.length -= gone;
  }
}

function grown(array: Float64Array<ArrayBuffer>): Float64Array<ArrayBuffer> {
  const larger = new Float64Array(2 * array.length);
  larger.set(array);
  return larger;
}
