// How often the robot's forecasts came true: the object `forecast_score`.
import type { ForecastScore as ScoreMessage, ForecastScore_Entry, Strategy } from "./schema";
import { fieldsOf, listOf, numberOf, textOf, type Fields, type NumberIn, type Value } from "./value";

/** Forecasts with about the same predicted probability. */
export interface Bin {
  forecasts: number;
  /** [0..1] Observed frequency. */
  came: number;
  /** [0..1] Mean predicted probability. */
  foretold: number;
  /** [0..1] one standard error of `came`. */
  error: number;
}

/** One kind of event. */
export interface Scored {
  came: number;
  /** [0..1] Brier score; lower is better. */
  brier: number;
  /** [0..1] Brier score of a forecast that always predicts the observed frequency. */
  brierOfRate: number;
  /** [nats] Mean log loss; lower is better. */
  logLoss: number;
  /** Bins with forecasts, ascending. */
  bins: Bin[];
}

export interface ForecastScore {
  forecasts: number;
  score: Scored;
  concede: Scored;
}

const finite = <M>(fields: Fields<M>, name: NumberIn<M>): number => numberOf(fields, name) || 0;

/** The score's subject: "all", or one strategy and horizon such as "passing, 30 s". */
export interface NamedScore {
  name: string;
  score: ForecastScore;
}

/**
 * Returns the common score, then one per strategy and horizon if there are several. Empty before the first scored
 * forecast.
 */
export function forecastScoresOf(fields: Fields<ScoreMessage>): NamedScore[] {
  const entries = listOf(fields, "entries");
  const all = merge(entries);
  if (!all) return [];
  const each = entries.flatMap((entry) => {
    const score = merge([entry]);
    return score ? [{ name: `${textOf(entry, "strategy")}, ${finite(entry, "horizon")} s`, score }] : [];
  });
  return [{ name: "all", score: all }, ...(each.length > 1 ? each : [])];
}

/** Merges all entries into one score. Undefined if no forecast was scored. */
function merge(entries: Fields<ForecastScore_Entry>[]): ForecastScore | undefined {
  const forecasts = entries.reduce((sum, entry) => sum + finite(entry, "forecasts"), 0);
  if (forecasts === 0) return undefined;
  const merged = (kind: "score" | "concede"): Scored => {
    const events = entries.map((entry) => ({ weight: finite(entry, "forecasts"), event: fieldsOf(entry, kind) }));
    const came = events.reduce((sum, { event }) => sum + finite(event, "came"), 0);
    const mean = (name: "brier" | "log_loss") =>
      events.reduce((sum, { weight, event }) => sum + weight * finite(event, name), 0) / forecasts;
    const bins = Array.from({ length: 10 }, (_, index): Bin => {
      const parts = events.map(({ event }) => listOf(event, "bins")[index] ?? new Map<string, Value>());
      const count = parts.reduce((sum, bin) => sum + finite(bin, "forecasts"), 0);
      const rate = parts.reduce((sum, bin) => sum + finite(bin, "came"), 0) / count;
      const foretold = parts.reduce((sum, bin) => sum + finite(bin, "forecasts") * finite(bin, "foretold"), 0) / count;
      return { forecasts: count, came: rate, foretold, error: Math.sqrt((rate * (1 - rate)) / count) };
    });
    const rate = came / forecasts;
    return {
      came,
      brier: mean("brier"),
      brierOfRate: rate * (1 - rate),
      logLoss: mean("log_loss"),
      bins: bins.filter((bin) => bin.forecasts > 0),
    };
  };
  return { forecasts, score: merged("score"), concede: merged("concede") };
}

/** The strategy in use, such as "passing", and the choice behind it. Undefined if foresight does not report it. */
export function strategyOf(fields: Fields<Strategy>): { name: string; chosen: boolean; captain: number } | undefined {
  const name = textOf(fields, "name");
  return name === "" ? undefined : { name, chosen: fields.get("chosen") === true, captain: finite(fields, "captain") };
}
