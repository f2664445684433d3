// State of server, connection and page as figures, each with a sentence if something is wrong.

import type { ClientStatistics, ProcessStatistics, RecordingStatistics } from "../memory/statistics";
import { bytes, duration } from "./format";

export interface Figure {
  name: string;
  value: string;
  /** "" while all is well. */
  wrong: string;
  /** The figure's meaning. */
  about: string;
}

const kBusy = 0.8; // [cores] above this the robot's other threads lack time
const kLeastDisk = 200e6; // [bytes]
const kLeastMinutes = 10; // of recording: one half of a game
const kClocks = 0.05; // [s] more than a frame: recordings of both clocks cannot be aligned
const kQueue = 500e3; // [bytes] queued for one viewer: half a second at 8 Mbit/s
const kRoundTrip = 0.2; // [s]
const kFrames = 30; // [1/s] a lower rate looks jerky

export function processFigures(
  process: ProcessStatistics | undefined,
  recording: RecordingStatistics | undefined,
): Figure[] {
  if (!process) return [];
  const { cpu, resident_bytes, disk_free_bytes, log_dir_bytes, uptime } = process;
  const minutes =
    recording && recording.bytes_per_second > 0 ? disk_free_bytes / recording.bytes_per_second / 60 : Infinity;
  return [
    {
      name: "CPU",
      value: Number.isFinite(cpu) ? `${Math.round(100 * cpu)} %` : "–",
      wrong:
        cpu > kBusy
          ? `The runtime keeps ${cpu.toFixed(1)} cores busy: other threads of the robot may come late. Fewer viewers or smaller pictures help.`
          : "",
      about: "of one core",
    },
    { name: "Memory", value: bytes(resident_bytes), wrong: "", about: "resident, of the server's process" },
    {
      name: "Disk free",
      value: bytes(disk_free_bytes),
      wrong: diskSentence(disk_free_bytes, minutes, recording),
      about: "where recordings go",
    },
    { name: "Recordings", value: bytes(log_dir_bytes), wrong: "", about: "on the robot's disk, all together" },
    { name: "Running for", value: duration(uptime), wrong: "", about: "since the process started" },
  ];
}

function diskSentence(free_bytes: number, minutes: number, recording: RecordingStatistics | undefined): string {
  if (recording?.state === "disk_full")
    return recording.message || "The disk is full: nothing is recorded until there is room.";
  if (minutes < kLeastMinutes)
    return `The disk is full in ${Math.max(0, Math.floor(minutes))} min at this rate of recording: delete recordings, or choose a smaller profile.`;
  return free_bytes < kLeastDisk ? `Only ${bytes(free_bytes)} are free: a recording will end early.` : "";
}

/** `offset` [s]: lead of the server's clock over this computer's. Undefined if the server does not show the present. */
export function clockFigure(offset: number | undefined): Figure {
  const about = "the server's clock against this computer's, less the travelling time";
  if (offset === undefined)
    return { name: "Clock", value: "–", wrong: "", about: "the time of a recording says nothing about clocks" };
  const apart = Math.abs(offset);
  const value = apart < 0.0005 ? "agrees" : `${duration(apart)} ${offset > 0 ? "ahead" : "behind"}`;
  return {
    name: "Clock",
    value,
    wrong:
      apart > kClocks
        ? `The clocks differ by ${duration(apart)}: recordings of both machines are shifted by that. Set them by the same time server.`
        : "",
    about,
  };
}

/** Figures of this page itself. */
export function pageFigures({
  framesPerSecond,
  kept_bytes,
  kept,
}: {
  framesPerSecond: number;
  kept_bytes: number;
  kept: number;
}): Figure[] {
  return [
    {
      name: "Page draws",
      value: Number.isFinite(framesPerSecond) ? `${Math.round(framesPerSecond)} frames/s` : "–",
      wrong:
        framesPerSecond < kFrames
          ? "This computer or browser is too slow to draw everything: fewer lines, layers or pictures help."
          : "",
      about: "how often this page is drawn",
    },
    {
      name: "Page keeps",
      value: `${duration(kept)} · ${bytes(kept_bytes)}`,
      wrong: "",
      about: "how far back this page can go, and what that takes",
    },
  ];
}

/** Returns the problem of one viewer, or "". `dropping`: [messages/s] recently. */
export function clientSentence({ queued_bytes, round_trip, lossless }: ClientStatistics, dropping: number): string {
  if (queued_bytes > kQueue) return `${bytes(queued_bytes)} wait to be sent: its network is too slow for what it asks.`;
  if (round_trip > kRoundTrip) return `An answer takes ${duration(round_trip)}: a slow or crowded network.`;
  if (dropping > 0)
    return `${lossless ? "It loses" : "Newer messages replace waiting ones:"} ${dropping.toFixed(dropping < 10 ? 1 : 0)} a second.`;
  return "";
}
