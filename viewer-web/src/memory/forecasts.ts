// All forecasts of a robot that are kept, each read once.

import { forecastOf, type Forecast } from "./forecast";
import type { MemoryObject } from "./memory_object";

/** One of them, in short. */
export interface Told {
  /** The message's number: while the time stands there may be several of one moment. */
  index: number;
  /** [ns] capture time of the moment that was played on from. */
  log_ns: bigint;
  askedBy: string;
  advice: Forecast["advice"];
  choice: string;
}

export class Forecasts {
  #told = new Map<number, Told>(); // by the message's number
  #generation = 0;
  #shown: { data: Uint8Array; forecast: Forecast | undefined } | undefined;

  constructor(readonly object: MemoryObject) {}

  /** Newest first, those after the moment shown included. */
  list(most: number): Told[] {
    const { history } = this.object;
    if (this.#generation !== history.generation) this.#told.clear();
    this.#generation = history.generation;
    for (const index of this.#told.keys()) if (index < history.begin) this.#told.delete(index);
    const list: Told[] = [];
    for (let index = history.end - 1; index >= history.begin && list.length < most; --index) {
      const told = this.#told.get(index) ?? this.#read(index);
      if (!told) continue;
      this.#told.set(index, told);
      list.push(told);
    }
    return list;
  }

  #read(index: number): Told | undefined {
    const entry = this.object.history.get(index);
    const fields = entry && this.object.decode(entry.data).fields;
    if (!fields) return undefined;
    const { askedBy, advice, choice } = forecastOf(fields);
    return { index, log_ns: entry.log_ns, askedBy, advice, choice };
  }

  /** The number of the one that held at the moment that is shown; -1 where none did. */
  shownIndex(): number {
    const { history, shown } = this.object;
    return shown ? history.indexAt(shown.log_ns) : -1;
  }

  /** The one that held at the moment that is shown; the same object until another one does. */
  shown(): Forecast | undefined {
    const entry = this.object.shown;
    if (!entry) return (this.#shown = undefined);
    if (this.#shown?.data !== entry.data) {
      const fields = this.object.decoded()?.fields;
      this.#shown = { data: entry.data, forecast: fields && forecastOf(fields) };
    }
    return this.#shown.forecast;
  }
}
