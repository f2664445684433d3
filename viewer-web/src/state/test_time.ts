// Facts for the tests of time: a recording of 100 s, and a live robot.

import { opening, type Facts, type Phase, type TimeState } from "./time_state";

export const kSecond = 1_000_000_000n;
export const range = { first_ns: 0n, last_ns: 100n * kSecond };

export const recording = (more: Partial<Facts> = {}): Facts => ({
  now: 1,
  range,
  recorded: true,
  known: true,
  plays: true,
  place_ns: 10n * kSecond,
  speed: 1,
  pending: false,
  ...more,
});

export const robot = (more: Partial<Facts> = {}): Facts => recording({ recorded: false, known: false, ...more });

export const live: TimeState = opening("", "");
export const inPhase = (phase: Phase, more: Partial<TimeState> = {}): TimeState => ({ ...live, phase, ...more });
export const stands = (at: number, more: Partial<TimeState> = {}): TimeState =>
  inPhase({ is: "stands", at_ns: BigInt(at) * kSecond }, more);
export const advances = (at: number, more: Partial<TimeState> = {}): TimeState =>
  inPhase({ is: "runs", at_ns: BigInt(at) * kSecond }, more);
