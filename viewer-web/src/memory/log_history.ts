// The recent log sentences of the robots. Unlike with other objects, the older messages matter too.

import { byTime } from "../source/by_time";
import type { Entry } from "./history";
import type { MemoryObject, RobotName } from "./memory_object";
import type { LogText } from "./schema";
import { numberOf, textOf, wordOf, type Fields } from "./value";

const kMost = 2000; // [sentences] as many as a person would search

export type LogLevel = "debug" | "info" | "warning" | "error" | "fatal";
export const kLogLevels: LogLevel[] = ["debug", "info", "warning", "error", "fatal"];

/** Returns undefined for a level that this page does not know. */
export const levelOf = (fields: Fields<LogText>): LogLevel | undefined => {
  const word = wordOf(fields, "level");
  return kLogLevels.find((level) => level === word);
};

export interface LogEntry {
  id: number;
  log_ns: bigint;
  robot: RobotName;
  level: LogLevel;
  text: string;
  source: string;
  /** [times] the same sentence was suppressed before this one. */
  suppressed: number;
}

export class LogHistory {
  #entries: LogEntry[] = [];
  #next = 0;

  clear(): void {
    this.#entries = [];
  }

  /** Forgets the sentences after `at_ns`: the recording continues there and will send them again. */
  sought(at_ns: bigint): void {
    this.#entries = this.#entries.filter(({ log_ns }) => log_ns < at_ns);
  }

  arrived(object: MemoryObject<LogText>, entry: Entry): void {
    this.#entries.push(this.#read(object, entry));
    if (this.#entries.length > kMost) this.#entries.splice(0, this.#entries.length - kMost);
  }

  /** Puts the earlier sentences `entries` of an object in place of all from the first of them to the last. */
  recall(object: MemoryObject<LogText>, entries: readonly Entry[]): void {
    const [first_ns, last_ns] = [entries[0]?.log_ns, entries.at(-1)?.log_ns];
    if (first_ns === undefined || last_ns === undefined) return;
    this.#entries = this.#entries
      .filter(({ robot, log_ns }) => robot !== object.robot || log_ns < first_ns || log_ns > last_ns)
      .concat(entries.map((entry) => this.#read(object, entry)))
      .sort(byTime)
      .slice(-kMost);
  }

  #read(object: MemoryObject<LogText>, { log_ns, data }: Entry): LogEntry {
    const { fields, error } = object.decode(data);
    const level = fields ? levelOf(fields) : "error";
    return {
      id: this.#next++,
      log_ns,
      robot: object.robot,
      level: level ?? "info",
      text: fields ? textOf(fields, "text") : error,
      source: fields ? textOf(fields, "source") : "viewer",
      suppressed: fields ? numberOf(fields, "suppressed") || 0 : 0,
    };
  }

  /** Returns the sentences of this robot and of its server up to `until_ns`, newest last. */
  entries(robot: RobotName, least: LogLevel, until_ns?: bigint): LogEntry[] {
    return this.all(least, until_ns).filter((entry) => entry.robot === robot || entry.robot === "");
  }

  /** Returns the sentences of all robots of the server. */
  all(least: LogLevel, until_ns?: bigint): LogEntry[] {
    const from = kLogLevels.indexOf(least);
    return this.#entries.filter(
      ({ level, log_ns }) => kLogLevels.indexOf(level) >= from && (until_ns === undefined || log_ns <= until_ns),
    );
  }
}
