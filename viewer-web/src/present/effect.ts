// The effect of a change on the futures, in words.

import type { Effect, Futures } from "../memory/change";
import { duration } from "./format";

/** One row of the table: what, without, with, and the 95 % interval of the difference. */
export interface Row {
  what: string;
  without: string;
  with: string;
  interval: string;
  /** The interval tells the change from chance. */
  sure: boolean;
}

const signed = (value: number, digits: number): string => {
  const text = Math.abs(value).toFixed(digits);
  return `${Number(text) === 0 ? "±" : value < 0 ? "−" : "+"}${text}`;
};

export function rowsOf({ scores, concedes, goals, seconds }: Futures): Row[] {
  const row = (what: string, effect: Effect, scale: number, unit: string, digits: number): Row => {
    const amount = (value: number) => `${(scale * value).toFixed(digits)}${unit}`;
    return {
      what,
      without: amount(effect.without),
      with: amount(effect.with),
      interval: `${signed(scale * effect.low, digits)} .. ${signed(scale * effect.high, digits)}`,
      sure: effect.low > 0 || effect.high < 0,
    };
  };
  const within = ` within ${duration(seconds)}`;
  return [
    row(`scores${within}`, scores, 100, " %", 0),
    row(`concedes${within}`, concedes, 100, " %", 0),
    row("goal difference", goals, 1, "", 2),
  ];
}

/** Returns the sentence about the pair with the luck of the game. */
export function partingOf({ parting, different, pairs }: Futures): string {
  const many = `${different} of ${pairs} pairs differ`;
  if (!parting) return different === 0 ? "No future differs" : `${many}; with the luck of this game nothing does`;
  return `${many}; with the luck of this game they part after ${parting.seconds.toFixed(2)} s, first in ${parting.field}`;
}
