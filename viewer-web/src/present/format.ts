// Numbers as text. All widths are bounded, so columns do not jump.

const kThinSpace = "\u2009";

/** "33 ms", "1.25 s", "3 min", "2 h", "5 days"; "–" if unknown. */
export function duration(seconds: number | undefined): string {
  if (seconds === undefined || !Number.isFinite(seconds)) return "–";
  const amount = Math.abs(seconds);
  if (amount < 0.9995) return `${Math.round(1000 * seconds)} ms`;
  if (amount < 9.995) return `${seconds.toFixed(2)} s`;
  if (amount < 99.95) return `${seconds.toFixed(1)} s`;
  if (amount < 5400) return `${Math.round(seconds / 60)} min`;
  if (amount < 172800) return `${Math.round(seconds / 3600)} h`;
  return `${Math.round(seconds / 86400)} days`;
}

/** "just now", "12 s ago", "3 min ago": coarse, so that it does not flicker. */
export function ago(seconds: number): string {
  if (seconds < 1) return "just now";
  if (seconds < 60) return `${Math.floor(seconds)} s ago`;
  return `${seconds < 5400 ? `${Math.floor(seconds / 60)} min` : duration(seconds)} ago`;
}

/** "0:07", "10:00", "1:02:03": length of a recording. */
export function clockLength(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds < 0) return "–";
  const whole = Math.round(seconds);
  const two = (value: number) => String(value).padStart(2, "0");
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/** The time of day of a capture time, where the page is: "02:35:48". */
export function clockTime(at_ns: bigint): string {
  const at = new Date(Number(at_ns / 1_000_000n));
  return [at.getHours(), at.getMinutes(), at.getSeconds()].map((value) => String(value).padStart(2, "0")).join(":");
}

/** Decimal units, as file managers and disks use them: "614 kB", "1.2 MB". */
export function bytes(count: number): string {
  if (!Number.isFinite(count)) return "–";
  const units = ["B", "kB", "MB", "GB", "TB"];
  let unit = 0;
  while (count >= 999.5 && unit < units.length - 1) {
    count /= 1000;
    ++unit;
  }
  return `${unit > 0 && count < 9.95 ? count.toFixed(1) : Math.round(count)} ${units[unit]}`;
}

/** "30.0", "0.5", "0"; "–" if unknown. */
export function hertz(rate: number): string {
  if (!Number.isFinite(rate)) return "–";
  return rate === 0 ? "0" : rate < 99.95 ? rate.toFixed(1) : rate.toFixed(0);
}

/** A whole count with thin spaces between thousands: "1 234 567". */
export function count(value: number): string {
  if (!Number.isFinite(value)) return "–";
  return String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, kThinSpace);
}

/** Seven significant digits, the precision of a float: no 1.10000002384. Whole numbers stay whole. */
export function number(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "not a number" : value > 0 ? "∞" : "−∞";
  if (Object.is(value, -0)) return "0";
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return String(value);
  return String(Number(value.toPrecision(7)));
}

/**
 * The digits that matter on an axis of the length `span`: steps of at most a five-hundredth of it, always as many, so that
 * the text does not jump. Whole numbers stay whole.
 */
export function numberWithin(value: number, span: number): string {
  if (!(span > 0) || !Number.isFinite(value) || Number.isInteger(value)) return number(value);
  const decimals = Math.min(12, Math.max(0, Math.ceil(Math.log10(500 / span))));
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

const twoHex = (byte: number): string => byte.toString(16).padStart(2, "0");

/** The first `most` bytes in hex. */
export const hex = (data: Uint8Array, most: number): string =>
  Array.from(data.subarray(0, most), twoHex).join(" ") + (data.length > most ? " …" : "");

/** A name as words: "walk to ball" for "walk_to_ball". */
export const words = (name: string): string => name.replaceAll("_", " ");
