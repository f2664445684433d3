import { expect, test } from "vitest";
import type { WholeNumbers } from "../source/whole";
import { Summaries, ViewSummaries, WholeRuns, type FetchNumbers } from "./summaries";

const kRange = { from_ns: 1000n * 10n ** 9n, to_ns: 2200n * 10n ** 9n };
const part = (from: number, to: number) => ({
  from_ns: kRange.from_ns + BigInt(Math.round(from * 1e9)),
  to_ns: kRange.from_ns + BigInt(Math.round(to * 1e9)),
});

/** A server that notes the questions and answers when it is told to. */
function server() {
  const asked: { fields: string[]; from: number; to: number; intervals: number; signal: AbortSignal }[] = [];
  const answers: (() => void)[] = [];
  const fetch: FetchNumbers = (fields, { from_ns, to_ns }, intervals, signal) => {
    asked.push({
      fields,
      from: Number(from_ns - kRange.from_ns) / 1e9,
      to: Number(to_ns - kRange.from_ns) / 1e9,
      intervals,
      signal,
    });
    return new Promise((resolve, reject) =>
      answers.push(() => {
        if (fields.includes("bad")) return reject(new Error("HTTP 400"));
        const step_ns = Number(to_ns - from_ns) / intervals;
        const values = new Float64Array(intervals).fill(1);
        const one = (field: string): WholeNumbers => ({
          field,
          from_ns,
          step_ns,
          least: values,
          most: values,
          mean: values,
          problem: field === "empty" ? "nothing of this name is played" : "",
        });
        resolve(fields.map(one));
      }),
    );
  };
  const answer = async () => {
    for (const one of answers.splice(0)) one();
    for (let i = 0; i < 10; ++i) await Promise.resolve();
  };
  return { asked, answer, fetch };
}

test("the whole of all fields is fetched at once, and once", async () => {
  const { asked, answer, fetch } = server();
  const summaries = new ViewSummaries(new Summaries(kRange, fetch));
  for (let i = 0; i < 3; ++i) summaries.update(["a", "b"], kRange, 800, i);
  expect(asked.map(({ fields, from, to }) => [fields, from, to])).toEqual([[["a", "b"], 0, 1200]]);
  expect([summaries.whole.reading("a"), summaries.of("a")]).toEqual([true, []]);
  await answer();
  expect([summaries.whole.reading("a"), summaries.of("a").length]).toEqual([false, 1]);
  summaries.update(["a", "b"], kRange, 800, 9);
  summaries.update(["a", "b", "c"], kRange, 800, 10);
  expect(asked.slice(1).map(({ fields }) => fields)).toEqual([["c"]]);
});

test("a field without a summary has a reason, and does not cost the others theirs", async () => {
  const { asked, answer, fetch } = server();
  const summaries = new ViewSummaries(new Summaries(kRange, fetch));
  summaries.update(["a", "bad", "empty"], kRange, 800, 0);
  await answer();
  await answer();
  expect([summaries.of("a").length, summaries.whole.problem("a")]).toEqual([1, ""]);
  expect([summaries.of("bad").length, summaries.whole.problem("bad")]).toEqual([0, "HTTP 400"]);
  expect(summaries.whole.problem("empty")).toBe("nothing of this name is played");
  const before = asked.length;
  summaries.update(["a", "bad", "empty"], kRange, 800, 1);
  expect(asked.length).toBe(before);
});

test("a zoomed view gets a part of its own with an interval per pixel, and can move in it", async () => {
  const { asked, answer, fetch } = server();
  const summaries = new ViewSummaries(new Summaries(kRange, fetch));
  summaries.update(["a"], part(600, 630), 800, 0);
  await answer();
  summaries.update(["a"], part(600, 630), 800, 1);
  expect(asked[1]).toMatchObject({ fields: ["a"], from: 570, to: 660, intervals: 2400 });
  await answer();
  expect(summaries.of("a").map(({ step_ns }) => step_ns / 1e9)).toEqual([1200 / 2048, 30 / 800]);
  for (let i = 0; i < 30; ++i) summaries.update(["a"], part(600 + i, 630 + i), 800, 2 + i);
  expect(asked.length).toBe(2);
  summaries.update(["a"], part(631, 661), 800, 40);
  expect(asked[2]).toMatchObject({ from: 601, to: 691 });
});

test("while a view is zoomed the requests are few, and an old one is cancelled", async () => {
  const { asked, answer, fetch } = server();
  const summaries = new ViewSummaries(new Summaries(kRange, fetch));
  summaries.update(["a"], kRange, 800, 0);
  await answer();
  for (let i = 0; i < 60; ++i) {
    const half = 300 / 1.1 ** i;
    summaries.update(["a"], part(600 - half, 600 + half), 800, 1 + i / 60);
  }
  expect(asked.length).toBeLessThanOrEqual(6);
  expect(asked.slice(1, -1).every(({ signal }) => signal.aborted)).toBe(true);
  expect(asked.at(-1)!.signal.aborted).toBe(false);
  summaries.stop();
  expect(asked.at(-1)!.signal.aborted).toBe(true);
});

test("two views share the whole, and each has its own part", async () => {
  const { asked, answer, fetch } = server();
  const whole = new Summaries(kRange, fetch);
  const [one, other] = [new ViewSummaries(whole), new ViewSummaries(whole)];
  for (const view of [one, other]) view.update(["a"], kRange, 800, 0);
  expect(asked.length).toBe(1);
  await answer();
  for (let i = 0; i < 9; ++i) {
    one.update(["a"], part(100, 130), 800, 1 + i);
    other.update(["a"], part(900, 903), 800, 1 + i);
  }
  expect(asked.slice(1).map(({ from, signal }) => [from, signal.aborted])).toEqual([
    [70, false],
    [897, false],
  ]);
  await answer();
  expect([one, other].map((view) => view.of("a")[1]!.step_ns / 1e9)).toEqual([30 / 800, 3 / 800]);
});

test("the whole is never asked for in parts where it is fine enough", async () => {
  const { asked, answer, fetch } = server();
  const summaries = new ViewSummaries(new Summaries(kRange, fetch));
  summaries.update(["a"], kRange, 800, 0);
  await answer();
  summaries.update(["a"], part(0, 600), 800, 1);
  expect(asked.length).toBe(1);
});

test("runs are there once fetched, or a reason", async () => {
  const run = { from_ns: 1n, to_ns: 2n, words: ["walk"] };
  const good = new WholeRuns(() => Promise.resolve([run]));
  const bad = new WholeRuns(() => Promise.reject(new Error("The server does not answer.")));
  expect(good.runs).toBeUndefined();
  await Promise.resolve();
  await Promise.resolve();
  expect([good.runs, bad.runs, bad.problem]).toEqual([[run], undefined, "The server does not answer."]);
});
