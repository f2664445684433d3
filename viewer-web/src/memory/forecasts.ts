// All kept forecasts of a robot, each read once.

import { forecastOf, type Forecast, type ForecastAnswer } from "./forecast";
import type { MemoryObject } from "./memory_object";

/** A short form of one forecast. */
export interface Told {
  /** The message's number. While the time stands still, several forecasts may have the same moment. */
  index: number;
  /** [ns] Capture time of the moment that the rollouts start from. */
  log_ns: bigint;
  askedBy: string;
  advice: Forecast["advice"];
  choice: string;
}

export class Forecasts {
  #told = new Map<number, Told>(); // by the message's number
  #generation = 0;
  #shown: { data: Uint8Array; forecast: Forecast | undefined } | undefined;

  constructor(readonly object: MemoryObject<ForecastAnswer>) {}

  /** The forecasts, newest first. Includes those after the shown moment. */
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

  /** The number of the forecast that was valid at the shown moment, or -1 if there is none. */
  shownIndex(): number {
    const { history, shown } = this.object;
    return shown ? history.indexAt(shown.log_ns) : -1;
  }

  /** The forecast that was valid at the shown moment. The same object until another one is valid. */
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
