// The order of messages.

/** Compares by capture time, for sort(). */
export const byTime = (a: { log_ns: bigint }, b: { log_ns: bigint }): number =>
  a.log_ns < b.log_ns ? -1 : a.log_ns > b.log_ns ? 1 : 0;
