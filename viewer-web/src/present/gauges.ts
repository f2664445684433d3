// Numbers of forecasts as bars, intervals and words, on an axis that contains zero.

import { kUntils, type Forecast, type Measure } from "../memory/forecast";
import { clockLength } from "./format";

export interface Axis {
  low: number;
  high: number;
}

const kLeastSpan: Record<Measure, number> = { goal_difference: 0.1, score_next: 0.05, concede: 0.05 };

/** Returns an axis that contains all values and zero, with a margin. */
export function axisOf(values: number[], least: number): Axis {
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  const span = Math.max(high - low, least);
  const spare = (span - (high - low)) / 2 + 0.06 * span;
  return { low: low - spare, high: high + spare };
}

/** [%] from the axis' left end, clamped to its ends. */
export const shareOf = ({ low, high }: Axis, value: number): number =>
  100 * Math.min(1, Math.max(0, (value - low) / (high - low)));

/** Returns one axis for all means and one for all gains. */
export function axesOf({ strategies, measure }: Forecast): { mean: Axis; gain: Axis } {
  const played = strategies.filter(({ rollouts }) => rollouts > 0);
  return {
    mean: axisOf(
      played.flatMap(({ mean, error }) => [mean - error, mean + error]),
      kLeastSpan[measure],
    ),
    gain: axisOf(
      played.flatMap(({ gain, gainLow, gainHigh }) => [gain, gainLow, gainHigh]),
      kLeastSpan[measure],
    ),
  };
}

const signed = (value: number, digits: number): string => {
  const text = Math.abs(value).toFixed(digits);
  return Number(text) === 0 ? text : `${value < 0 ? "−" : "+"}${text}`;
};

/** The unit of a measure, unless the number already contains it. */
export const unit = (measure: Measure): string => (measure === "goal_difference" ? " goals" : "");

/** "+0.125" goals, "−3.4 %" probability. */
export const amount = (measure: Measure, value: number): string =>
  measure === "goal_difference" ? signed(value, 3) : `${signed(100 * value, 1)} %`;

/** "0.052", "1.2 %" */
export const size = (measure: Measure, value: number): string => amount(measure, Math.abs(value)).replace("+", "");

/** Whether a gain and its interval would be written as zeros. */
export const isNothing = (measure: Measure, { gain, gainLow, gainHigh }: Gain): boolean =>
  [gain, gainLow, gainHigh].every((value) => amount(measure, value) === amount(measure, 0));
type Gain = Pick<Forecast["strategies"][number], "gain" | "gainLow" | "gainHigh">;

/** "62 %"; a forecast is not more precise than one per cent. */
export const percent = (share: number): string =>
  share > 0 && share < 0.005 ? "< 1 %" : `${Math.round(100 * share)} %`;

/** "30 s", "12.5 s", "9:02" */
export const span = (seconds: number): string =>
  seconds < 99.95 ? `${Number(seconds.toFixed(1))} s` : clockLength(seconds);

/** "30 s ahead", "to the next goal, 30 s at most", "to the end of the half, 9:02" */
export function reach({ until, horizon }: Pick<Forecast, "until" | "horizon">): string {
  if (until === "horizon") return `${span(horizon)} ahead`;
  return `${kUntils[until]}, ${span(horizon)}${until === "next_goal" ? " at most" : ""}`;
}

/** The advice in words that are true for any played strategy: only the played one can be kept. `plays`: "" if unknown. */
export function headline(
  { advice, choice, strategies }: Pick<Forecast, "advice" | "choice" | "strategies">,
  plays: string,
): string {
  const first = strategies[0]?.name ?? choice;
  if (advice === "none") return "No advice";
  if (plays === "" || plays === first) return advice === "keep" ? `Keep ${first}` : `Change to ${choice}`;
  return advice === "keep" ? `Nothing clearly beats ${first}` : `${choice} beats ${first}`;
}
