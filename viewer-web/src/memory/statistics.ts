// What the robot says about its own streams: the object `runtime`, read by field name.

import type { MemoryObject } from "./memory_object";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "./value";

/** One stream as the robot counts it, also while nobody here is subscribed. */
export interface StreamStatistics {
  rate_hz: number;
  /** How many versions were written: the sequence number of the newest one. */
  sequence: number;
  /** Messages that were lost within the robot, in its recording, and on the way to viewers (to all of them). */
  dropped: { inside: number; recording: number; viewers: number };
}

export interface RecordingStatistics {
  /** "off", "recording", "disk_full", or what a later robot may say. */
  state: string;
  session: string;
  profile: string;
  size_bytes: number;
  bytes_per_second: number;
  message: string;
}

const none = (): StreamStatistics => ({ rate_hz: NaN, sequence: NaN, dropped: { inside: 0, recording: 0, viewers: 0 } });
const dropped = (fields: Fields): number => numberOf(fields, "dropped") || 0;

/**
 * What is known of the server's doings, by whom: first what the server says of itself. When a recording is played that
 * is the lab's server; the robot's own `runtime` then tells how it was on the robot.
 */
export const runtimesOf = (objects: MemoryObject[]): Fields[] =>
  objects
    .filter(({ kind, derived }) => kind === "runtime" && !derived)
    .sort((a, b) => Number(a.robot !== "") - Number(b.robot !== ""))
    .flatMap((object) => object.decoded()?.fields ?? []);

/** Of all streams, by topic; where two tell of the same one, the first of `runtimes` counts. */
export const allStreamStatistics = (runtimes: Fields[]): Map<string, StreamStatistics> =>
  new Map([...runtimes].reverse().flatMap((runtime) => [...streamStatistics(runtime)]));

export function streamStatistics(runtime: Fields): Map<string, StreamStatistics> {
  const streams = new Map<string, StreamStatistics>();
  const of = (fields: Fields): StreamStatistics => {
    const topic = textOf(fields, "topic");
    if (!streams.has(topic)) streams.set(topic, none());
    return streams.get(topic)!;
  };

  for (const stream of listOf(runtime, "streams")) {
    const found = of(stream);
    found.rate_hz = numberOf(stream, "rate_hz");
    found.sequence = numberOf(stream, "count");
    for (const consumer of listOf(stream, "consumers")) found.dropped.inside += dropped(consumer);
  }
  for (const logger of listOf(runtime, "loggers")) of(logger).dropped.recording += dropped(logger);
  for (const client of listOf(runtime, "clients"))
    for (const channel of listOf(client, "channels")) of(channel).dropped.viewers += dropped(channel);
  return streams;
}

export function recordingStatistics(runtime: Fields): RecordingStatistics | undefined {
  const recording = fieldsOf(runtime, "recording");
  if (recording.size === 0) return undefined;
  return {
    state: wordOf(recording, "state"),
    session: textOf(recording, "session"),
    profile: textOf(recording, "profile"),
    size_bytes: numberOf(recording, "size_bytes"),
    bytes_per_second: numberOf(recording, "bytes_per_second"),
    message: textOf(recording, "message"),
  };
}

/** The server's process: what it takes of its machine. NaN for what it does not tell. */
export interface ProcessStatistics {
  /** [cores] 1: one core fully busy. */
  cpu: number;
  resident_bytes: number;
  disk_free_bytes: number;
  log_dir_bytes: number;
  /** [s] */
  uptime: number;
}

export function processStatistics(runtime: Fields): ProcessStatistics | undefined {
  const process = fieldsOf(runtime, "process");
  if (process.size === 0) return undefined;
  return {
    cpu: numberOf(process, "cpu"),
    resident_bytes: numberOf(process, "resident_bytes"),
    disk_free_bytes: numberOf(process, "disk_free_bytes"),
    log_dir_bytes: numberOf(process, "log_dir_bytes"),
    uptime: numberOf(process, "uptime_ns") / 1e9,
  };
}

/** One who watches, over all channels together. */
export interface ClientStatistics {
  id: number;
  address: string;
  agent: string;
  lossless: boolean;
  /** [s]; NaN before the first answer. */
  round_trip: number;
  channels: number;
  sent: number;
  dropped: number;
  queued_bytes: number;
}

export function clientStatistics(runtime: Fields): ClientStatistics[] {
  return listOf(runtime, "clients").map((client) => {
    const channels = listOf(client, "channels");
    const sum = (name: string) => channels.reduce((total, channel) => total + (numberOf(channel, name) || 0), 0);
    return {
      id: numberOf(client, "id"),
      address: textOf(client, "address"),
      agent: textOf(client, "user_agent"),
      lossless: client.get("lossless") === true,
      round_trip: numberOf(client, "round_trip_ns") / 1e9,
      channels: channels.length,
      sent: sum("sent"),
      dropped: sum("dropped"),
      queued_bytes: sum("queued_bytes"),
    };
  });
}

/** One robot that the server relays. */
export interface LinkStatistics {
  /** As the relay was told: an address or a name. */
  name: string;
  /** "14/2"; "" before it said so. */
  robot: string;
  /** "connected", "connecting", "refused", or what a later relay may say. */
  state: string;
  received: number;
  lost: number;
  connections: number;
  /** [s] how far its clock is ahead of the relay's; NaN where that is not known. */
  clock_offset: number;
  /** [s] added to its times. */
  shift: number;
  /** Why there is no connection; "" while there is one. */
  message: string;
}

export function linkStatistics(runtime: Fields): LinkStatistics[] {
  return listOf(runtime, "links").map((link) => ({
    name: textOf(link, "name"),
    robot: textOf(link, "robot"),
    state: wordOf(link, "state"),
    received: numberOf(link, "received"),
    lost: numberOf(link, "lost"),
    connections: numberOf(link, "connections"),
    clock_offset: numberOf(link, "clock_offset_ns") / 1e9,
    shift: numberOf(link, "shift_ns") / 1e9,
    message: textOf(link, "message"),
  }));
}
