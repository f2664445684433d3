const two = (number) => String(number).padStart(2, "0");

/** "2026-11-22", in this machine's time zone, for a time [ns since the epoch, as text]. */
export function dayOf(time_ns) {
  const day = new Date(Number(BigInt(time_ns) / 1000000n));
  return `${day.getFullYear()}-${two(day.getMonth() + 1)}-${two(day.getDate())}`;
}
