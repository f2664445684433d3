// The robot's HTTP interface to its recordings. Nothing in the answers is trusted.

import { isObject, listOf, textOf, type Json } from "./json";

export interface Stream {
  /** Empty if the file does not contain it. */
  topic: string;
  file: string;
  url: string;
  messages: number;
  size_bytes: number;
}

export type SessionState = "recording" | "complete" | "recovered" | "damaged" | "unknown";

/** One recording on the robot. Times are undefined if the recording is empty. */
export interface Session {
  session: string;
  name: string;
  robot: string;
  profile: string;
  build: string;
  start_ns: bigint | undefined;
  end_ns: bigint | undefined;
  /** [ns] of these times behind the time of day, because the robot's clock was set while its program ran. */
  behind_ns: bigint;
  size_bytes: number;
  state: SessionState;
  message: string;
  kept: boolean;
  /** The names of the objects that a person chose to record. Empty: all. */
  only: string[];
  url: string;
  /** The address of the download with what other viewers draw. Empty if this server makes none. */
  foxglove_url: string;
  streams: Stream[];
}

const objects = (value: unknown): Json[] => listOf(value).filter(isObject);
const texts = (value: unknown): string[] => listOf(value).map(textOf).filter(Boolean);
const amount = (value: unknown): number => (typeof value === "number" ? value : Number(textOf(value) || NaN));
const time = (value: unknown): bigint | undefined =>
  /^[1-9]\d{0,19}$/.test(textOf(value)) ? BigInt(textOf(value)) : undefined;
/** Accepts only paths on the robot itself: a link must not lead to `javascript:` or to another host. */
const path = (value: unknown): string => (/^\/(?![/\\])/.test(textOf(value)) ? textOf(value) : "");

const kStates: SessionState[] = ["recording", "complete", "recovered", "damaged"];

/** Reads the answer of /api/sessions, newest first. Returns undefined if it has the wrong form. */
export function sessionsOf(answer: unknown): Session[] | undefined {
  if (!isObject(answer) || !Array.isArray(answer["sessions"])) return undefined;
  return objects(answer["sessions"])
    .filter((entry) => textOf(entry["session"]) !== "")
    .map((entry) => ({
      session: textOf(entry["session"]),
      name: textOf(entry["name"]),
      robot: textOf(entry["robot"]),
      profile: textOf(entry["profile"]),
      build: textOf(entry["build"]),
      start_ns: time(entry["start_ns"]),
      end_ns: time(entry["end_ns"]),
      behind_ns: /^-?[1-9]\d{0,18}$/.test(textOf(entry["behind_ns"])) ? BigInt(textOf(entry["behind_ns"])) : 0n,
      size_bytes: amount(entry["size_bytes"]),
      state: kStates.find((state) => state === entry["state"]) ?? "unknown",
      message: textOf(entry["message"]),
      kept: entry["kept"] === true,
      only: texts(entry["only"]),
      url: path(entry["url"]),
      foxglove_url: path(entry["foxglove_url"]),
      streams: objects(entry["streams"]).map((stream) => ({
        topic: textOf(stream["topic"]),
        file: textOf(stream["file"]),
        url: path(stream["url"]),
        messages: amount(stream["messages"]),
        size_bytes: amount(stream["size_bytes"]),
      })),
    }))
    .sort((a, b) => Number((b.start_ns ?? 0n) - (a.start_ns ?? 0n)) || b.session.localeCompare(a.session));
}

/** The recordings of a server, and the names of the reports that lie beside them. */
export interface Recordings {
  sessions: Session[];
  reports: string[];
}

/** Reads the names of the reports in the answer of /api/sessions. */
export const reportsOf = (answer: unknown): string[] =>
  isObject(answer) ? texts(answer["reports"]).filter((name) => /^[\w-][\w.-]*\.html$/.test(name)) : [];

/** Fetches the robot's list of recordings. Rejects with a sentence. */
export async function fetchRecordings(): Promise<Recordings> {
  let response: Response;
  try {
    response = await fetch("/api/sessions", {
      headers: { Accept: "application/json" },
      signal: AbortSignal.timeout(10000),
    });
  } catch {
    throw new Error("The robot does not answer.");
  }
  if (!response.ok) throw new Error(`The robot refuses to list its recordings (HTTP ${response.status}).`);
  const answer: unknown = await response.json().catch(() => undefined);
  const sessions = sessionsOf(answer);
  if (!sessions) throw new Error("The robot's list of recordings cannot be read.");
  return { sessions, reports: reportsOf(answer) };
}

/** Asks the page's own robot whether a real game is in progress. False without an answer. */
export async function matchModeOf(): Promise<boolean> {
  const response = await fetch("/api/status", { signal: AbortSignal.timeout(5000) }).catch(() => undefined);
  const status: unknown = response?.ok ? await response.json().catch(() => undefined) : undefined;
  return isObject(status) && isObject(status["game"]) && status["game"]["match_mode"] === true;
}
