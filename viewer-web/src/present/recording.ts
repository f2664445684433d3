// Recordings as the session list shows them.

import type { Session } from "../source/http";
import { clockLength } from "./format";

/** The recording's begin by the time of day, in the reader's time zone and language: "21 Nov 2026, 14:02:11". */
export function startOf(
  { start_ns, behind_ns }: Pick<Session, "start_ns" | "behind_ns">,
  locale?: string,
  timeZone?: string,
): string {
  if (start_ns === undefined) return "–";
  const format = new Intl.DateTimeFormat(locale, {
    dateStyle: "medium",
    timeStyle: "medium",
    ...(timeZone && { timeZone }),
  });
  return format.format(new Date(Number((start_ns + behind_ns) / 1_000_000n)));
}

/** A sentence about a clock that was set while the program ran. Empty if it was not. */
export function clockOf({ behind_ns }: Pick<Session, "behind_ns">): string {
  if (behind_ns === 0n) return "";
  const apart = clockLength(Math.abs(Number(behind_ns)) / 1e9);
  const side = behind_ns > 0n ? "behind" : "ahead of";
  return `The clock was set while the program ran: the recorded times are ${apart} ${side} the time of day.`;
}

/** "10:00"; "–" for an empty recording. */
export function lengthOf({ start_ns, end_ns }: Pick<Session, "start_ns" | "end_ns">): string {
  if (start_ns === undefined || end_ns === undefined || end_ns < start_ns) return "–";
  return clockLength(Number(end_ns - start_ns) / 1e9);
}

/** The meaning of each state. */
export const kStateSentence: Record<Session["state"], string> = {
  recording: "Still being recorded; a download holds everything up to now.",
  complete: "",
  recovered: "The robot stopped while recording; everything up to its last second was recovered.",
  damaged: "Part of it cannot be read.",
  unknown: "This viewer does not know its state.",
};

const kNamedObjects = 6;

/** A sentence about the chosen objects of a recording, so that nobody takes the others for lost. Empty without a choice. */
export function choiceOf({ only }: Pick<Session, "only">): string {
  if (only.length === 0) return "";
  const more = only.length - kNamedObjects;
  const named = more > 1 ? [...only.slice(0, kNamedObjects), `${more} more`] : only;
  return `Only chosen objects were recorded: ${named.join(", ").replace(/, ([^,]*)$/, " and $1")}.`;
}

/** The use of a download with ?foxglove. */
export const kDrawnHint =
  "For Foxglove, Lichtblick and Rerun: holds also the field, the robots, the frames and the pictures in the schemas that " +
  "they draw. This viewer needs only the plain download.";

export interface OtherViewer {
  name: string;
  url: string;
  hint: string;
}

/**
 * Returns links that open `file_url` in other viewers. Their https pages may load only from this computer or over
 * https; otherwise the link opens their desktop application.
 */
export function otherViewers(file_url: string): OtherViewer[] {
  const { hostname, protocol } = new URL(file_url);
  const reachable = protocol === "https:" || /^(localhost|127\.\d+\.\d+\.\d+|\[::1\])$/.test(hostname);
  const query = new URLSearchParams({ ds: "remote-file", "ds.url": file_url }).toString();
  const hint = reachable
    ? "opens the web version"
    : "needs the desktop application: their web page may not read from a robot";
  return [
    {
      name: "Lichtblick",
      url: reachable ? `https://lichtblick-suite.github.io/lichtblick/?${query}` : `lichtblick://open?${query}`,
      hint,
    },
    {
      name: "Foxglove",
      url: `https://app.foxglove.dev/~/view?${query}${reachable ? "" : "&openIn=desktop"}`,
      hint,
    },
  ];
}

/** Parses "1:05", "65", "1:05.5", "1:00:00" to seconds. Returns undefined for other texts. */
export function secondsOf(text: string): number | undefined {
  const found = /^(?:(?:(\d+):)?(\d+):)?(\d+(?:\.\d+)?)$/.exec(text.trim());
  return found ? 3600 * Number(found[1] ?? 0) + 60 * Number(found[2] ?? 0) + Number(found[3]) : undefined;
}

/** Returns the address of a part of a recording. `from` and `to` count from its begin; "" means its ends. */
export function partOf(
  { url, start_ns, end_ns }: Pick<Session, "url" | "start_ns" | "end_ns">,
  from: string,
  to: string,
): { url: string } | { error: string } {
  const [first, last] = [from, to].map((text) => (text.trim() === "" ? null : secondsOf(text)));
  if (first === undefined || last === undefined)
    return { error: `Expected minutes and seconds such as 1:05, got '${(first === undefined ? from : to).trim()}'.` };
  if (first !== null && last !== null && first! >= last!) return { error: "The part must end after it begins." };
  const after = (seconds: number) => (start_ns ?? 0n) + BigInt(Math.round(seconds * 1e9));
  if (first !== null && end_ns !== undefined && after(first!) > end_ns)
    return { error: "The recording is shorter than that." };
  const query = new URLSearchParams({
    ...(first !== null && { from: String(after(first!)) }),
    ...(last !== null && { to: String(after(last!)) }),
  }).toString();
  return { url: query ? `${url}?${query}` : url };
}
