// For tests: a line of a plot.

import type { Line } from "./plot";

/** Values at an even rate, from the time 0. */
export function line(values: number[], hz = 30, more: Partial<Line> = {}): Line {
  return {
    times: Float64Array.from(values, (_, i) => i / hz),
    values: Float64Array.from(values),
    length: values.length,
    offset: 0,
    colour: "#000",
    dash: [],
    axis: "m",
    ...more,
  };
}
