import { expect, test } from "vitest";
import { MemoryObject } from "./memory_object";
import { allStreamStatistics, linkStatistics, recordingStatistics, runtimesOf, streamStatistics } from "./statistics";
import { kPerceptChannel, percept } from "./test_schema";
import { EnumValue, textOf, type Fields, type Value } from "./value";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));

test("losses of a stream are listed by place, and summed over consumers and viewers", () => {
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

test("the recording's state is the enum's word without its prefix", () => {
  const recording = fields({ state: new EnumValue(3, "STATE_DISK_FULL"), message: "Full." });
  expect(recordingStatistics(fields({ recording }))).toMatchObject({ state: "disk_full", message: "Full." });
  expect(recordingStatistics(fields({}))).toBeUndefined();
});

test("a runtime object of another form gives no statistics and no error", () => {
  for (const odd of [5, "text", [1, 2], undefined])
    expect(streamStatistics(fields({ streams: odd, loggers: odd, clients: odd })).size).toBe(0);
});

test("every object `runtime` counts, the server's own before the robot's", () => {
  const objects = ["/14/2/ball", "/14/2/runtime", "/lab/1/runtime", "/lab/1/clock", "/5/1/runtime"].map((topic) => {
    const object = new MemoryObject({ ...kPerceptChannel, topic });
    if (!topic.startsWith("/5")) object.arrived(1n, percept({ note: topic }), 0); // one of them has no message yet
    return object;
  });
  expect(runtimesOf(objects).map((runtime: Fields) => textOf(runtime, "note"))).toEqual([
    "/lab/1/runtime",
    "/14/2/runtime",
  ]);
  expect(runtimesOf([])).toEqual([]);
});

test("if two report the same stream the first one counts, and streams of only one are known too", () => {
  const runtime = (counts: Record<string, number>) =>
    fields({ streams: Object.entries(counts).map(([topic, count]) => fields({ topic, count })) });
  const all = allStreamStatistics([runtime({ "/14/2/ball": 5 }), runtime({ "/14/2/ball": 900, "/14/2/pose": 7 })]);
  expect([...all].map(([topic, { sequence }]) => `${topic} ${sequence}`).sort()).toEqual([
    "/14/2/ball 5",
    "/14/2/pose 7",
  ]);
});

test("a relay reports each robot, and unknown values are NaN", () => {
  const link = fields({
    state: new EnumValue(2, "STATE_CONNECTED"),
    name: "tim",
    robot: "14/2",
    received: 7n,
    lost: 2n,
    connections: 3,
    clock_offset_ns: 350_000_000n,
    shift_ns: -350_000_000n,
    message: "",
  });
  const gone = fields({ state: new EnumValue(1, "STATE_CONNECTING"), name: "lea", message: "Connection refused" });
  const [tim, lea] = linkStatistics(fields({ links: [link, gone] }));
  expect(tim).toEqual({
    name: "tim",
    robot: "14/2",
    state: "connected",
    received: 7,
    lost: 2,
    connections: 3,
    clock_offset: 0.35,
    shift: -0.35,
    message: "",
  });
  expect(lea).toMatchObject({
    name: "lea",
    robot: "",
    state: "connecting",
    clock_offset: NaN,
    message: "Connection refused",
  });
  expect(linkStatistics(fields({}))).toEqual([]);
});
