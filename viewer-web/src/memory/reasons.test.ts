import { expect, test } from "vitest";
import { History } from "./history";
import { alternativeOf, knownThen, reasonsOf, requestOf } from "./reasons";
import { memoryWith } from "./test_memory";

const kNow = 5_000_000_000n;

/** An object with messages of one byte at these times [ms] after kNow. */
function objectAt(...times: number[]) {
  const history = new History();
  times.forEach((ms, i) =>
    history.add({ log_ns: kNow + BigInt(ms) * 1_000_000n, data: new Uint8Array([i + 1]), arrived: 0 }),
  );
  return { history, shown: history.get(history.end - 1) };
}
function requestFrom(objects: Record<string, ReturnType<typeof objectAt>>) {
  const known = knownThen(memoryWith({ get: (topic) => objects[topic] }), "14/2");
  return known && requestOf(known);
}

test("a question holds the newest message of each object at the decision, and the truth", () => {
  const request = requestFrom({
    "/14/2/decision": objectAt(0),
    "/14/2/ball": objectAt(-300, -20, 40),
    "/14/3/ball": objectAt(0),
    "/truth/world": objectAt(0),
  });
  expect(request).toEqual({
    robot: "14/2",
    at_ns: "5000000000",
    objects: {
      decision: { capture_ns: "5000000000", data: "AQ==" },
      ball: { capture_ns: "4980000000", data: "Ag==" },
      truth: { capture_ns: "5000000000", data: "AQ==" },
    },
  });
});

test("of an object that is only known since a moment later, that message is taken, but no later one", () => {
  const request = requestFrom({
    "/14/2/decision": objectAt(0),
    "/14/2/team": objectAt(90),
    "/14/2/pose": objectAt(110),
  });
  expect(Object.keys(request!.objects)).toEqual(["team", "decision"]);
});

test("without a decision there is no question", () => {
  expect(requestFrom({ "/14/2/ball": objectAt(0) })).toBeUndefined();
});

const kAnswer = {
  ok: true,
  agrees: true,
  has_truth: true,
  reasons: {
    sentence: "14/2 plays kick because ball_distance < 0.5",
    skill: "kick",
    role: "chaser",
    strategy: "mine",
    plays: true,
    parts: [
      { path: "mine", name: "mine", depth: 0, skill: null, taken: true },
      { path: "mine/near/kick", name: "near", depth: 1, skill: "kick", taken: true },
    ],
    comparisons: [
      { node: 7, part: 1, condition: "ball_distance < 0.5", result: true, value: "0.4 m", threshold: "0.5 m" },
    ],
    path: [
      {
        node: 7,
        truth: "0.6 m",
        misled: true,
        margin: "0.1 m",
        flip: "0.5 m",
        other: { skill: "walk_to_ball", leaf: "mine/far" },
        sources: [
          { text: "ball seen 0.3 s ago", age: 0.3, error: 0.2 },
          { text: "memory", age: null, error: null },
        ],
      },
    ],
    narrowest: 0,
  },
};
const kAsked = { robot: "14/2", at_ns: kNow };

test("the answer's path refers to its comparisons", () => {
  const reasons = reasonsOf(kAnswer, kAsked);
  expect(reasons.at_ns).toBe(kNow);
  expect(reasons.parts.map(({ skill }) => skill)).toEqual([undefined, "kick"]);
  expect(reasons.path[0]!.comparison).toBe(reasons.comparisons[0]);
  expect(reasons.path[0]).toMatchObject({ truth: "0.6 m", misled: true, margin: "0.1 m", flip: "0.5 m" });
  expect(reasons.path[0]!.other).toEqual({ skill: "walk_to_ball", leaf: "mine/far" });
  expect(reasons.path[0]!.sources.map(({ error }) => error)).toEqual([0.2, undefined]);
  expect(reasons.narrowest).toBe(reasons.path[0]);
});

test("an answer with missing or wrong parts is read without an exception", () => {
  for (const reasons of [undefined, null, 7, {}, { parts: 1, path: [{ node: 99 }, null], comparisons: [null] }]) {
    const read = reasonsOf({ reasons }, kAsked);
    expect([read.skill, read.path, read.narrowest, read.agrees]).toEqual(["", [], undefined, false]);
  }
  expect(alternativeOf({})).toEqual({
    kind: "unsure",
    leaf: undefined,
    features: [],
    thresholds: undefined,
    beliefs: undefined,
  });
});

test("an alternative tells features, thresholds and beliefs", () => {
  const alternative = {
    kind: "changed",
    leaf: "mine/far",
    features: [{ name: "ball_distance", before: "0.4 m", after: "0.5 m", text: "at least 0.5 m" }],
    thresholds: [{ node: 7, condition: "ball_distance < 0.5", before: "0.5 m", after: "0.4 m" }],
    beliefs: { changes: ["ball 0.1 m farther"], leaf: "mine/far" },
  };
  expect(alternativeOf({ alternative })).toEqual({
    kind: "changed",
    leaf: "mine/far",
    features: [{ name: "ball_distance", before: "0.4 m", text: "at least 0.5 m" }],
    thresholds: [{ node: 7, condition: "ball_distance < 0.5", before: "0.5 m", after: "0.4 m" }],
    beliefs: ["ball 0.1 m farther"],
  });
});
