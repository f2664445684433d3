// Whether the page shows a robot as it is now. A field that looks alive while nothing comes misleads.

const kQuiet = 3; // [s] the slowest objects of a playing robot come twice a second

export interface Flow {
  /** Whether a connection stands, and whether one ever stood. */
  connected: boolean;
  known: boolean;
  /** [s] of the newest message of a robot or its world. Undefined before the first. */
  arrived: number | undefined;
  /** Whether a person has paused the simulated game. */
  paused: boolean;
}

export interface Liveness {
  /** Whether the shown values are those of now. */
  isLive: boolean;
  /** Whether the shown values are old without a good reason. */
  isStale: boolean;
  words: string;
}

export function livenessOf({ connected, known, arrived, paused }: Flow, now: number): Liveness {
  const told = (words: string, isStale: boolean): Liveness => ({ isLive: false, isStale, words });
  if (!known) return told("never connected", true);
  const silence = arrived === undefined ? undefined : now - arrived;
  if (connected && paused) return told("game paused", false);
  if (silence === undefined) return told(connected ? "no data yet" : "not connected", true);
  if (silence > kQuiet)
    return told(`no data for ${silence < 120 ? `${Math.floor(silence)} s` : `${Math.floor(silence / 60)} min`}`, true);
  return { isLive: true, isStale: false, words: "live" };
}
