// The robot's statistics of its own streams: the object `runtime`, read by field name.

import { isKind, type MemoryObject } from "./memory_object";
import type { RuntimeStatistics, RuntimeStatistics_Consumer, RuntimeStatistics_Stream } from "./schema";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "./value";

/** The robot's counts of one stream, also while this page is not subscribed. */
export interface StreamStatistics {
  rate_hz: number;
  /** Number of written versions: the sequence number of the newest one. */
  sequence: number;
  /** Messages lost inside the robot, in its recording, and on the way to all viewers together. */
  dropped: { inside: number; recording: number; viewers: number };
}

export interface RecordingStatistics {
  /** "off", "recording", "disk_full", or a later robot's word. */
  state: string;
  session: string;
  profile: string;
  size_bytes: number;
  bytes_per_second: number;
  message: string;
}

const none = (): StreamStatistics => ({
  rate_hz: NaN,
  sequence: NaN,
  dropped: { inside: 0, recording: 0, viewers: 0 },
});
const dropped = (fields: Fields<Pick<RuntimeStatistics_Consumer, "dropped">>): number =>
  numberOf(fields, "dropped") || 0;

/**
 * Returns all `runtime` objects, the server's own first. For a played recording this is the lab server's; the robot's
 * own `runtime` then describes the robot at that time.
 */
export const runtimesOf = (objects: MemoryObject[]): Fields<RuntimeStatistics>[] =>
  objects
    .filter((object) => isKind(object, "runtime"))
    .filter(({ derived }) => !derived)
    .sort((a, b) => Number(a.robot !== "") - Number(b.robot !== ""))
    .flatMap((object) => object.decoded()?.fields ?? []);

/** Statistics of all streams by topic. If two report the same stream, the first of `runtimes` counts. */
export const allStreamStatistics = (runtimes: Fields<RuntimeStatistics>[]): Map<string, StreamStatistics> =>
  new Map([...runtimes].reverse().flatMap((runtime) => [...streamStatistics(runtime)]));

export function streamStatistics(runtime: Fields<RuntimeStatistics>): Map<string, StreamStatistics> {
  const streams = new Map<string, StreamStatistics>();
  const of = (fields: Fields<Pick<RuntimeStatistics_Stream, "topic">>): StreamStatistics => {
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

export function recordingStatistics(runtime: Fields<RuntimeStatistics>): RecordingStatistics | undefined {
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

/** The server's process and its use of the machine. NaN for missing values. */
export interface ProcessStatistics {
  /** [cores] 1: one core is fully busy. */
  cpu: number;
  resident_bytes: number;
  disk_free_bytes: number;
  log_dir_bytes: number;
  /** [s] */
  uptime: number;
}

export function processStatistics(runtime: Fields<RuntimeStatistics>): ProcessStatistics | undefined {
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

/** One viewer's connection, over all channels together. */
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

export function clientStatistics(runtime: Fields<RuntimeStatistics>): ClientStatistics[] {
  return listOf(runtime, "clients").map((client) => {
    const channels = listOf(client, "channels");
    const sum = (name: "sent" | "dropped" | "queued_bytes") =>
      channels.reduce((total, channel) => total + (numberOf(channel, name) || 0), 0);
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
  /** An address or a name, as given to the relay. */
  name: string;
  /** Such as "14/2"; "" before the robot has named itself. */
  robot: string;
  /** "connected", "connecting", "refused", or a later relay's word. */
  state: string;
  received: number;
  lost: number;
  connections: number;
  /** [s] by which its clock is ahead of the relay's. NaN if unknown. */
  clock_offset: number;
  /** [s] added to its times. */
  shift: number;
  /** The reason why there is no connection, or "" while there is one. */
  message: string;
}

export function linkStatistics(runtime: Fields<RuntimeStatistics>): LinkStatistics[] {
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
