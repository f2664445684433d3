import { expect, test } from "vitest";
import { advances, inPhase, kSecond, live, range, recording, robot, stands } from "./test_time";
import {
  followServer,
  goToNow,
  hold,
  pause,
  play,
  repeat,
  seek,
  setEdge,
  setLoop,
  setSpeed,
  toggle,
} from "./time_moves";
import { atOf, moves, opening, runs } from "./time_state";

const early = inPhase({ is: "early" });
const loopOf = (first: number, last: number) => ({
  first_ns: BigInt(first) * kSecond,
  last_ns: BigInt(last) * kSecond,
});

test("a page opens live, with the moment and the loop of its address; anything else in it is ignored", () => {
  expect(opening("7", "1-5")).toMatchObject({
    phase: { is: "live" },
    asked_ns: 7n,
    loop: { first_ns: 1n, last_ns: 5n },
  });
  for (const text of ["", "x", "-1", "1e9", "99999999999999999999", "1-", "-5", "a-b"])
    expect(opening(text, text)).toMatchObject({ asked_ns: undefined, loop: undefined });
});

test("the shown moment is the playhead of a recording, the newest data of a robot, or the chosen moment", () => {
  expect(atOf(live, recording())).toBe(10n * kSecond);
  expect(atOf(live, robot())).toBe(100n * kSecond);
  expect(atOf(live, robot({ range: undefined }))).toBe(0n);
  for (const state of [stands(5), advances(5)]) expect(atOf(state, recording())).toBe(5n * kSecond);
});

test("time runs while new data are shown and expected, or by the page's clock, but never for an early pause", () => {
  expect([runs(live, robot()), runs(live, recording()), runs(live, recording({ plays: false }))]).toEqual([
    true,
    true,
    false,
  ]);
  expect([runs(stands(5), recording()), runs(advances(5), recording()), runs(early, robot())]).toEqual([
    false,
    true,
    false,
  ]);
  expect([moves(advances(5), recording()), moves(early, robot())]).toEqual([false, true]);
});

test("a pause of a recording is a wish to its server, which keeps the speed; a paused one stays as it is", () => {
  const { state, effects } = pause(live, recording({ speed: 2 }));
  expect(state.phase).toEqual({ is: "live" });
  expect(effects).toEqual([{ do: "ask", play: false, speed: 2, seek_ns: undefined }]);
  expect(pause(live, recording({ plays: false })).effects).toEqual([]);
});

test("a pause of a robot stands at the newest data", () => {
  const { state, effects } = pause(live, robot());
  expect(state.phase).toEqual({ is: "stands", at_ns: 100n * kSecond });
  expect(effects).toEqual([{ do: "show" }]);
});

test("a pause ends an advance by the page's clock where it is", () => {
  for (const facts of [robot(), recording({ plays: false })])
    expect(pause(advances(5), facts)).toEqual({ state: stands(5), effects: [] });
});

test("a pause before the first data waits for them, and play takes it back", () => {
  for (const facts of [robot({ range: undefined }), recording({ known: false })]) {
    const paused = pause(live, facts).state;
    expect(paused.phase).toEqual({ is: "early" });
    expect(toggle(paused, facts).state.phase).toEqual({ is: "live" });
  }
  // a moment that was chosen meanwhile stays
  expect(pause(stands(5), robot({ range: undefined })).state).toEqual(stands(5));
});

test("play goes on from the moment: a recording by its server, a robot by the page's clock", () => {
  expect(play(stands(5), recording({ plays: false }))).toEqual({
    state: live,
    effects: [{ do: "ask", play: true, speed: 1, seek_ns: 5n * kSecond }],
  });
  expect(play(live, recording({ plays: false })).effects).toEqual([
    { do: "ask", play: true, speed: 1, seek_ns: undefined },
  ]);
  expect(play(stands(5), robot())).toEqual({ state: advances(5), effects: [] });
});

test("a recording goes backwards by the page's clock, while its server stands", () => {
  const backwards = { ...live, speed: -2 };
  const { state, effects } = play(backwards, recording());
  expect(state.phase).toEqual({ is: "runs", at_ns: 10n * kSecond });
  expect(effects).toEqual([{ do: "ask", play: false, speed: 1, seek_ns: undefined }]);
});

test("toggle pauses what runs and plays what stands", () => {
  expect(toggle(advances(5), robot()).state).toEqual(stands(5));
  expect(toggle(stands(5), robot()).state).toEqual(advances(5));
});

test("a seek stands at the nearest moment of the range, and an advance goes on from there", () => {
  expect(seek(live, recording(), 5n * kSecond)).toEqual({ state: stands(5), effects: [{ do: "show" }] });
  expect(seek(live, recording(), -5n).state).toEqual(stands(0));
  expect(seek(stands(5), recording(), 500n * kSecond).state).toEqual(stands(100));
  expect(seek(advances(5), robot(), 6n * kSecond).state).toEqual(advances(6));
  expect(seek({ ...live, asked_ns: 7n }, recording(), 0n).state.asked_ns).toBeUndefined();
  expect(seek(live, recording({ range: undefined }), 5n)).toEqual({ state: live, effects: [] });
});

test("an advance is held where it is; nothing else changes", () => {
  expect(hold(advances(5))).toEqual(stands(5));
  for (const state of [live, early, stands(5)]) expect(hold(state)).toBe(state);
});

test("now is the newest data of a robot, without a loop, and the end of a recording", () => {
  const { state, effects } = goToNow(stands(5, { loop: loopOf(1, 6) }), robot({ now: 3 }));
  expect(state).toEqual({ ...live, loop: undefined, noted: 3 });
  expect(effects).toEqual([{ do: "release" }, { do: "note", at: "" }]);
  expect(goToNow(stands(5), recording()).state).toEqual(stands(100));
});

test("another viewer's move shows the recording where its server is", () => {
  for (const state of [stands(5), advances(5)])
    expect(followServer(state)).toEqual({ state: live, effects: [{ do: "release" }] });
  for (const state of [live, early]) expect(followServer(state)).toEqual({ state, effects: [] });
});

test("a speed is a wish to a recording's server, which goes on or stands as before", () => {
  expect(setSpeed(live, recording(), 5).effects).toEqual([{ do: "ask", play: true, speed: 5, seek_ns: undefined }]);
  expect(setSpeed(stands(5), recording({ plays: false }), 5)).toEqual({
    state: { ...live, speed: 5 },
    effects: [{ do: "ask", play: false, speed: 5, seek_ns: 5n * kSecond }],
  });
  expect(setSpeed(stands(5), recording({ plays: false }), -1)).toEqual({
    state: stands(5, { speed: -1 }),
    effects: [],
  });
  expect(setSpeed(live, recording(), -1).state.phase.is).toBe("runs");
  expect(setSpeed(stands(5), robot(), 0.5)).toEqual({ state: stands(5, { speed: 0.5 }), effects: [] });
});

test("a loop has two ends in either order; a click is none", () => {
  expect(setLoop(live, 6n * kSecond, 2n * kSecond).loop).toEqual(loopOf(2, 6));
  expect(setLoop({ ...live, loop: loopOf(2, 6) }, 5n, 6n).loop).toBeUndefined();
});

test("a repeated range plays from its begin, forwards", () => {
  const { state, effects } = repeat(stands(50, { speed: -1 }), recording({ plays: false }), 2n * kSecond, 6n * kSecond);
  expect(state).toEqual({ ...live, speed: 1, loop: loopOf(2, 6) });
  expect(effects).toEqual([{ do: "show" }, { do: "ask", play: true, speed: 1, seek_ns: 2n * kSecond }]);
  expect(repeat(stands(50), robot(), 2n * kSecond, 6n * kSecond).state).toEqual(advances(2, { loop: loopOf(2, 6) }));
  expect(repeat(stands(50), robot(), 2n, 3n)).toEqual({ state: stands(50), effects: [] });
});

test("an edge of the loop is the shown moment; the other one stays, or is the range's end", () => {
  expect(setEdge(stands(5), recording(), "begin").loop).toEqual({ first_ns: 5n * kSecond, last_ns: range.last_ns });
  expect(setEdge(stands(5), recording(), "end").loop).toEqual({ first_ns: 0n, last_ns: 5n * kSecond });
  expect(setEdge(stands(4, { loop: loopOf(2, 6) }), recording(), "begin").loop).toEqual(loopOf(4, 6));
  expect(setEdge(stands(8, { loop: loopOf(2, 6) }), recording(), "begin").loop).toEqual(loopOf(8, 100));
  expect(setEdge(stands(1, { loop: loopOf(2, 6) }), recording(), "end").loop).toEqual(loopOf(0, 1));
  expect(setEdge(live, recording({ range: undefined }), "end").loop).toBeUndefined();
});
