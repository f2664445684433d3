import { expect, test } from "vitest";
import type { ClientStatistics, RecordingStatistics } from "../memory/statistics";
import { clientSentence, clockFigure, pageFigures, processFigures } from "./health";

const kWell = { cpu: 0.2, resident_bytes: 20e6, disk_free_bytes: 4e9, log_dir_bytes: 1e9, uptime: 90 };
const kRecording: RecordingStatistics = {
  state: "recording",
  session: "",
  profile: "game",
  size_bytes: 0,
  bytes_per_second: 170e3,
  message: "",
};
const wrong = (process = kWell, recording?: RecordingStatistics) =>
  processFigures(process, recording).flatMap(({ name, wrong }) => (wrong ? [name] : []));

test("only a figure with a problem has a sentence", () => {
  expect(wrong()).toEqual([]);
  expect(wrong({ ...kWell, cpu: 1.3 })).toEqual(["CPU"]);
  expect(wrong({ ...kWell, disk_free_bytes: 50e6 })).toEqual(["Disk free"]);
  expect(wrong({ ...kWell, disk_free_bytes: 1e9 }, kRecording)).toEqual([]);
  expect(wrong({ ...kWell, disk_free_bytes: 1e9 }, { ...kRecording, bytes_per_second: 40e6 })).toEqual(["Disk free"]);
  expect(processFigures(kWell, { ...kRecording, state: "disk_full", message: "Full." })[2]!.wrong).toBe("Full.");
  expect(processFigures(undefined, undefined)).toEqual([]);
});

test("clocks that differ by more than a frame are reported with the difference", () => {
  expect(clockFigure(0.0001)).toMatchObject({ value: "agrees", wrong: "" });
  expect(clockFigure(0.01)).toMatchObject({ value: "10 ms ahead", wrong: "" });
  expect(clockFigure(-3.2)).toMatchObject({
    value: "3.20 s behind",
    wrong: expect.stringContaining("differ by 3.20 s"),
  });
  expect(clockFigure(undefined).wrong).toBe("");
});

test("a viewer that cannot keep up is reported, and so is a page that draws rarely", () => {
  const client: ClientStatistics = {
    id: 1,
    address: "a:1",
    agent: "",
    lossless: false,
    round_trip: 0.01,
    channels: 3,
    sent: 9,
    dropped: 0,
    queued_bytes: 0,
  };
  expect(clientSentence(client, 0)).toBe("");
  expect(clientSentence({ ...client, queued_bytes: 2e6 }, 0)).toContain("2.0 MB wait");
  expect(clientSentence({ ...client, round_trip: 0.5 }, 0)).toContain("500 ms");
  expect(clientSentence({ ...client, round_trip: NaN }, 2.5)).toContain("2.5 a second");
  expect(pageFigures({ framesPerSecond: 12, kept_bytes: 1e6, kept: 60 })[0]!.wrong).not.toBe("");
  expect(pageFigures({ framesPerSecond: 60, kept_bytes: 1e6, kept: 60 })[1]!.value).toBe("60.0 s · 1.0 MB");
});
