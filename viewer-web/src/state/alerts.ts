// Sentences for the person at the screen, until dismissed or withdrawn.

import type { Level } from "../source/texts";

export interface Alert {
  /** The status message's id, or its text, so that an equal sentence is shown once. */
  key: string;
  level: Level;
  text: string;
  times: number;
}

const kMost = 20; // a faulty server must not fill the page

/** Adds a sentence. It replaces the one with the same key, else it comes first. */
export function withAlert(alerts: Alert[], level: Level, text: string, key: string = text): Alert[] {
  const before = alerts.find((alert) => alert.key === key);
  const alert = { key, level, text, times: (before?.times ?? 0) + 1 };
  return before ? alerts.map((other) => (other === before ? alert : other)) : [alert, ...alerts].slice(0, kMost);
}

export const withoutAlerts = (alerts: Alert[], keys: string[]): Alert[] =>
  alerts.filter(({ key }) => !keys.includes(key));

const kHidden = 300; // [s]

/** The sentences that a person has dismissed. A warning that comes again and again then stays away for a while. */
export class Dismissed {
  #since = new Map<string, number>(); // [s] by key

  add(key: string, now: number): void {
    this.#since.set(key, now);
  }

  hides(level: Level, key: string, now: number): boolean {
    return level === "warning" && now - (this.#since.get(key) ?? -Infinity) < kHidden;
  }
}
