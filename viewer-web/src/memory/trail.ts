// The places of something during the last seconds, from an object's history, each decoded once.

import type { MemoryObject } from "./memory_object";
import type { Fields, Unknown } from "./value";

const kHz = 10; // [1/s] points of a trail
const kMost = 400; // [points] kept decoded

/** `M` as for Fields. */
export class Trail<T, M = Unknown> {
  #points = new Map<number, T | undefined>(); // by the message's number
  #generation = 0;

  constructor(
    readonly object: MemoryObject<M>,
    readonly read: (fields: Fields<M>, log_ns: bigint) => T | undefined,
  ) {}

  /** Returns the points of the last `duration` [s] up to the shown message, oldest first. */
  points(duration: number): T[] {
    const { history, shown } = this.object;
    if (!shown) return [];
    if (this.#generation !== history.generation) this.#points.clear();
    this.#generation = history.generation;

    const last = history.indexAt(shown.log_ns);
    const first = Math.max(history.begin, history.indexAt(shown.log_ns - BigInt(Math.round(duration * 1e9))) + 1);
    // always the same messages, so that a trail does not flicker, plus the newest
    const every = Math.max(1, Math.round((last - first + 1) / (duration * kHz)));
    const indices = [];
    for (let index = Math.ceil(first / every) * every; index < last; index += every) indices.push(index);
    if (last >= first) indices.push(last);
    if (this.#points.size > kMost) this.#points.clear();
    return indices.flatMap((index) => this.#at(index) ?? []);
  }

  #at(index: number): T | undefined {
    if (!this.#points.has(index)) {
      const entry = this.object.history.get(index);
      const fields = entry && this.object.decode(entry.data).fields;
      this.#points.set(index, fields && this.read(fields, entry.log_ns));
    }
    return this.#points.get(index);
  }
}
