import { expect, test } from "vitest";
import { livenessOf, type Flow } from "./liveness";

const kFlow: Flow = { connected: true, known: true, arrived: 100, paused: false };
const words = (flow: Partial<Flow>, now = 101) => livenessOf({ ...kFlow, ...flow }, now).words;

test("only a flow of recent data is live", () => {
  expect(livenessOf(kFlow, 101)).toEqual({ isLive: true, isStale: false, words: "live" });
  for (const flow of [{ known: false }, { paused: true }, { arrived: undefined }, { arrived: 10 }])
    expect(livenessOf({ ...kFlow, ...flow }, 101).isLive).toBe(false);
});

test("each reason has its words, and only a pause is no fault", () => {
  expect(words({ known: false, connected: false, arrived: undefined })).toBe("never connected");
  expect(words({ connected: false, arrived: undefined })).toBe("not connected");
  expect(words({ arrived: undefined })).toBe("no data yet");
  expect(words({}, 112)).toBe("no data for 12 s");
  expect(words({ connected: false }, 112)).toBe("no data for 12 s");
  expect(words({}, 400)).toBe("no data for 5 min");
  expect(words({ paused: true }, 112)).toBe("game paused");
  expect(words({ paused: true, connected: false }, 112)).toBe("no data for 12 s");
  expect(
    [{ paused: true }, { arrived: undefined }, { arrived: 10 }, { known: false }].map(
      (flow) => livenessOf({ ...kFlow, ...flow }, 101).isStale,
    ),
  ).toEqual([false, true, true, true]);
});
