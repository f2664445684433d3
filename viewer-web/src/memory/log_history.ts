// The sentences the robots said lately. Unlike other objects, the older ones matter too.

import type { Entry } from "./history";
import type { MemoryObject, RobotName } from "./memory_object";
import { numberOf, textOf, wordOf } from "./value";

const kMost = 2000; // [sentences] what a person would search through

export type LogLevel = "debug" | "info" | "warning" | "error" | "fatal";
export const kLogLevels: LogLevel[] = ["debug", "info", "warning", "error", "fatal"];

export interface LogEntry {
  id: number;
  log_ns: bigint;
  robot: RobotName;
  level: LogLevel;
  text: string;
  source: string;
  /** [times] the same was not said in between. */
  suppressed: number;
}

export class LogHistory {
  #entries: LogEntry[] = [];
  #next = 0;

  clear(): void {
    this.#entries = [];
  }

  /** A recording goes on at `at_ns`: what was said later will be said again. */
  sought(at_ns: bigint): void {
    this.#entries = this.#entries.filter(({ log_ns }) => log_ns < at_ns);
  }

  arrived(object: MemoryObject, { log_ns, data }: Entry): void {
    const { fields, error } = object.decode(data);
    const level = fields ? (wordOf(fields, "level") as LogLevel) : "error";
    this.#entries.push({
      id: this.#next++,
      log_ns,
      robot: object.robot,
      level: kLogLevels.includes(level) ? level : "info",
      text: fields ? textOf(fields, "text") : error,
      source: fields ? textOf(fields, "source") : "viewer",
      suppressed: fields ? numberOf(fields, "suppressed") || 0 : 0,
    });
    if (this.#entries.length > kMost) this.#entries.splice(0, this.#entries.length - kMost);
  }

  /** What this robot said up to `until_ns`, and what the server of no robot did. Newest last. */
  entries(robot: RobotName, least: LogLevel, until_ns?: bigint): LogEntry[] {
    return this.all(least, until_ns).filter((entry) => entry.robot === robot || entry.robot === "");
  }

  /** What all robots of the server said. */
  all(least: LogLevel, until_ns?: bigint): LogEntry[] {
    const from = kLogLevels.indexOf(least);
    return this.#entries.filter(({ level, log_ns }) => kLogLevels.indexOf(level) >= from && (until_ns === undefined || log_ns <= until_ns));
  }
}
