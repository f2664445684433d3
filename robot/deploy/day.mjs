const two = (number) => String(number).padStart(2, "0");

/** Returns the date of a time [ns since the epoch, as text] in this machine's time zone, such as "2026-11-22". */
export function dayOf(time_ns) {
  const day = new Date(Number(BigInt(time_ns) / 1000000n));
  return `${day.getFullYear()}-${two(day.getMonth() + 1)}-${two(day.getDate())}`;
}
