import { expect, test } from "vitest";
import { recordingStatistics, streamStatistics } from "./statistics";
import { EnumValue, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));

test("losses of a stream are told apart by where they happened, and summed over consumers and viewers", () => {
  const viewer = (dropped: bigint) => fields({ channels: [fields({ topic: "/14/2/ball", dropped })] });
  const runtime = fields({
    streams: [
      fields({
        topic: "/14/2/ball",
        rate_hz: 30,
        count: 900n,
        consumers: [fields({ name: "net", dropped: 1n }), fields({ name: "logger", dropped: 2n })],
      }),
    ],
    loggers: [fields({ topic: "/14/2/ball", dropped: 4n })],
    clients: [viewer(10n), viewer(20n)],
  });
  expect(streamStatistics(runtime).get("/14/2/ball")).toEqual({
    rate_hz: 30,
    sequence: 900,
    dropped: { inside: 3, recording: 4, viewers: 30 },
  });
});

test("the recording's state is the word without the enum's prefix", () => {
  const recording = fields({ state: new EnumValue(3, "STATE_DISK_FULL"), message: "Full." });
  expect(recordingStatistics(fields({ recording }))).toMatchObject({ state: "disk_full", message: "Full." });
  expect(recordingStatistics(fields({}))).toBeUndefined();
});

test("a runtime object of quite another shape is no statistics, not an error", () => {
  for (const odd of [5, "text", [1, 2], undefined])
    expect(streamStatistics(fields({ streams: odd, loggers: odd, clients: odd })).size).toBe(0);
});
