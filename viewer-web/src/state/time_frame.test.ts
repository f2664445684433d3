import { expect, test } from "vitest";
import { advances, inPhase, kSecond, live, recording, robot, stands } from "./test_time";
import { frame, obeyAddress, type AskedFacts, type FrameFacts } from "./time_frame";
import type { Facts, TimeState } from "./time_state";

const inFrame = (facts: Facts, more: Partial<FrameFacts> = {}): FrameFacts => ({
  ...facts,
  passed: 0.5,
  steps: false,
  addressAt: "",
  ...more,
});
const asked = (facts: Facts, more: Partial<AskedFacts> = {}): AskedFacts => ({
  ...facts,
  playsAnother: false,
  recalls: false,
  ...more,
});
const loop = { first_ns: 2n * kSecond, last_ns: 6n * kSecond };
/** The phase after a frame, without its other results. */
const phaseOf = (state: TimeState, facts: FrameFacts) => frame(state, facts).state.phase;

test("a page without data waits; one that has lost them is live again", () => {
  const nothing = inFrame(robot({ range: undefined }));
  expect(frame(live, nothing)).toEqual({ state: live, effects: [] });
  expect(frame(stands(5), nothing).state.phase).toEqual({ is: "live" });
  expect(frame(stands(5), nothing).effects).toContainEqual({ do: "release" });
});

test("an early pause is made when the first data are there", () => {
  const early = inPhase({ is: "early" });
  expect(phaseOf(early, inFrame(recording({ known: false })))).toEqual({ is: "early" });
  expect(frame(early, inFrame(recording())).effects[0]).toMatchObject({ do: "ask", play: false });
  expect(phaseOf(early, inFrame(robot()))).toEqual({ is: "stands", at_ns: 100n * kSecond });
});

test("the page's clock moves on by the speed, and back", () => {
  expect(phaseOf(advances(5, { speed: 2 }), inFrame(robot()))).toEqual({ is: "runs", at_ns: 6n * kSecond });
  expect(phaseOf(advances(5, { speed: -2 }), inFrame(recording()))).toEqual({ is: "runs", at_ns: 4n * kSecond });
  expect(frame(advances(5), inFrame(robot())).effects).toContainEqual({ do: "show" });
});

test("two half frames go as far as one whole frame", () => {
  const half = inFrame(robot(), { passed: 0.25 });
  expect(phaseOf({ ...advances(5), phase: phaseOf(advances(5), half) }, half)).toEqual(
    phaseOf(advances(5), inFrame(robot())),
  );
});

test("an advance ends at now for a robot, and stands at the oldest moment", () => {
  expect(phaseOf(inPhase({ is: "runs", at_ns: 99_900_000_000n }), inFrame(robot()))).toEqual({ is: "live" });
  expect(phaseOf(inPhase({ is: "runs", at_ns: 100_000_000n }, { speed: -1 }), inFrame(recording()))).toEqual({
    is: "stands",
    at_ns: 0n,
  });
});

test("a loop returns to its other end in either direction", () => {
  expect(phaseOf(inPhase({ is: "runs", at_ns: 5_900_000_000n }, { loop }), inFrame(robot()))).toEqual({
    is: "runs",
    at_ns: loop.first_ns,
  });
  expect(phaseOf(inPhase({ is: "runs", at_ns: 2_100_000_000n }, { loop, speed: -1 }), inFrame(recording()))).toEqual({
    is: "runs",
    at_ns: loop.last_ns - 1n,
  });
});

test("the server of a recording is asked to repeat a loop, once", () => {
  const beyond = recording({ place_ns: 7n * kSecond, speed: 2 });
  const wish = { do: "ask", play: true, speed: 2, seek_ns: loop.first_ns };
  expect(frame({ ...live, loop }, inFrame(beyond)).effects).toContainEqual(wish);
  expect(frame({ ...live, loop }, inFrame({ ...beyond, pending: true })).effects).not.toContainEqual(wish);
  expect(frame({ ...live, loop }, inFrame({ ...beyond, place_ns: 3n * kSecond })).effects).not.toContainEqual(wish);
  expect(frame({ ...live, loop }, inFrame({ ...beyond, plays: false })).effects).not.toContainEqual(wish);
});

test("a loop in the past of a robot is played by the page's clock", () => {
  expect(phaseOf({ ...live, loop }, inFrame(robot()))).toEqual({ is: "runs", at_ns: loop.first_ns });
});

test("a moment that was dropped from memory becomes the oldest one", () => {
  const later = inFrame(robot({ range: { first_ns: 8n * kSecond, last_ns: 100n * kSecond } }));
  expect(phaseOf(stands(5), later)).toEqual({ is: "stands", at_ns: 8n * kSecond });
});

test("a paused moment is written into the address now and then, and not during steps", () => {
  const note = { do: "note", at: "5000000000" };
  const { state, effects } = frame(stands(5), inFrame(recording({ now: 1 })));
  expect(effects).toContainEqual(note);
  expect(frame(state, inFrame(recording({ now: 1.2 }))).effects).not.toContainEqual(note);
  expect(frame(state, inFrame(recording({ now: 1.4 }))).effects).toContainEqual(note);
  expect(frame(stands(5), inFrame(recording(), { steps: true })).effects).not.toContainEqual(note);
  expect(frame(live, inFrame(recording({ plays: false }))).effects).toEqual([{ do: "note", at: "10000000000" }]);
});

test("a recording that plays leaves the address without a moment; the live robot leaves it alone", () => {
  expect(frame(live, inFrame(recording(), { addressAt: "7" })).effects).toEqual([{ do: "note", at: "" }]);
  expect(frame(live, inFrame(recording())).effects).toEqual([]);
  expect(frame(live, inFrame(robot(), { addressAt: "7" })).effects).toEqual([]);
});

test("the moment of a link is shown as soon as it is there", () => {
  const linked = { ...live, asked_ns: 5n * kSecond };
  for (const facts of [
    asked(recording({ known: false })),
    asked(recording({ range: undefined })),
    asked(recording(), { playsAnother: true }),
    asked(robot({ range: { first_ns: 0n, last_ns: 4n * kSecond } })),
    asked(robot({ range: { first_ns: 8n * kSecond, last_ns: 9n * kSecond } }), { recalls: true }),
  ])
    expect(obeyAddress(linked, facts)).toEqual({ state: linked, effects: [] });
  expect(obeyAddress(linked, asked(recording()))).toEqual({ state: stands(5), effects: [{ do: "show" }] });
  expect(obeyAddress(live, asked(recording()))).toEqual({ state: live, effects: [] });
});

test("a moment that is gone is told once", () => {
  const linked = { ...live, asked_ns: 500n * kSecond };
  const { state, effects } = obeyAddress(linked, asked(recording()));
  expect(state).toEqual(live);
  expect(effects).toEqual([
    { do: "note", at: "" },
    { do: "say", text: "The moment of this link is not within this recording." },
  ]);
  const old = obeyAddress({ ...live, asked_ns: 1n }, asked(robot({ range: { first_ns: 8n, last_ns: 9n } })));
  expect(old.effects).toContainEqual({
    do: "say",
    text: "The moment of this link is older than the data of this page; a recording on the robot may hold it.",
  });
});
