// Sentences for the person at the screen, until dismissed or taken back.

import type { Level } from "../source/texts";

export interface Alert {
  /** Of the status message; the text where it has none, so that the same sentence stands once. */
  key: string;
  level: Level;
  text: string;
  times: number;
}

const kMost = 20; // a server gone wild must not fill the page

/** With a new sentence: it replaces the one with the same key, else it comes first. */
export function withAlert(alerts: Alert[], level: Level, text: string, key: string = text): Alert[] {
  const before = alerts.find((alert) => alert.key === key);
  const alert = { key, level, text, times: (before?.times ?? 0) + 1 };
  return before ? alerts.map((other) => (other === before ? alert : other)) : [alert, ...alerts].slice(0, kMost);
}

export const withoutAlerts = (alerts: Alert[], keys: string[]): Alert[] => alerts.filter(({ key }) => !keys.includes(key));
