// Recordings as the session list shows them.

import type { Session } from "../source/http";
import { clockLength } from "./format";

/** When it began, in the reader's time zone and language: "21 Nov 2026, 14:02:11". */
export function startOf({ start_ns }: Pick<Session, "start_ns">, locale?: string, timeZone?: string): string {
  if (start_ns === undefined) return "–";
  const format = new Intl.DateTimeFormat(locale, { dateStyle: "medium", timeStyle: "medium", ...(timeZone && { timeZone }) });
  return format.format(new Date(Number(start_ns / 1_000_000n)));
}

/** "10:00"; "–" for a recording that holds nothing. */
export function lengthOf({ start_ns, end_ns }: Pick<Session, "start_ns" | "end_ns">): string {
  if (start_ns === undefined || end_ns === undefined || end_ns < start_ns) return "–";
  return clockLength(Number(end_ns - start_ns) / 1e9);
}

/** What a state means for the person who wants the recording. */
export const kStateSentence: Record<Session["state"], string> = {
  recording: "Still being recorded; a download holds everything up to now.",
  complete: "",
  recovered: "The robot went off while recording; everything up to its last second was recovered.",
  damaged: "Part of it cannot be read.",
  unknown: "This viewer does not know its state.",
};

export interface OtherViewer {
  name: string;
  url: string;
  hint: string;
}

/**
 * Links that open `file_url` in other viewers. Their web pages come over https and may only load from this very
 * computer or over https; elsewhere the link goes to their desktop applications.
 */
export function otherViewers(file_url: string): OtherViewer[] {
  const { hostname, protocol } = new URL(file_url);
  const reachable = protocol === "https:" || /^(localhost|127\.\d+\.\d+\.\d+|\[::1\])$/.test(hostname);
  const query = new URLSearchParams({ ds: "remote-file", "ds.url": file_url }).toString();
  const hint = reachable ? "opens the web version" : "needs the desktop application: their web page may not read from a robot";
  return [
    {
      name: "Lichtblick",
      url: reachable ? `https://lichtblick-suite.github.io/lichtblick/?${query}` : `lichtblick://open?${query}`,
      hint,
    },
    {
      name: "Foxglove",
      url: `https://app.foxglove.dev/?${query}${reachable ? "" : "&openIn=desktop"}`,
      hint,
    },
  ];
}
