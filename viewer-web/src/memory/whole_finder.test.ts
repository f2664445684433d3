import { expect, test } from "vitest";
import { conditionOf, type Condition } from "./condition";
import { decoderOf } from "./decoder";
import { kPerceptChannel, percept } from "./test_schema";
import { topicsOnly } from "./test_vocabulary";
import { WholeFinder, type RecordedMessage } from "./whole_finder";

const kSecond = 1_000_000_000n;
const kTopics = ["/14/2/a", "/14/2/b"];

/** Returns a recording of 1000 s with 10 messages a second per topic, and a finder in it. */
function setUp(text: string, x: (topic: string, i: number) => number, fetched: string[] = []) {
  const decode = decoderOf(kPerceptChannel);
  const at = (i: number) => 5n * kSecond + (BigInt(i) * kSecond) / 10n;
  const fetch = async (topic: string, from_ns: bigint, to_ns: bigint) => {
    fetched.push(topic);
    const messages: RecordedMessage[] = [];
    for (let i = 0; i < 10_000; ++i)
      if (at(i) >= from_ns && at(i) <= to_ns) messages.push({ log_ns: at(i), data: percept({ x: x(topic, i) }) });
    return messages;
  };
  const condition = conditionOf(text, topicsOnly("14/2", kTopics)) as Condition;
  const finder = new WholeFinder(
    condition,
    new Map(kTopics.map((topic) => [topic, decode])),
    { start_ns: at(0), end_ns: at(9999) },
    fetch,
  );
  let time = 0;
  const run = async () => {
    for (let turn = 0; !finder.done && turn < 10_000; ++turn) {
      finder.update(4, () => (time += 0.5));
      await Promise.resolve();
    }
  };
  const spans = () =>
    finder.matches.map(({ from_ns, to_ns }) => [
      Number((from_ns - at(0)) / 100_000_000n),
      Number((to_ns - at(0)) / 100_000_000n),
    ]);
  return { finder, run, spans, fetched };
}

test("all matches of the whole recording are found, also one that spans two parts", async () => {
  // 1000 s in 40 parts of 25 s: 250 messages each
  const { finder, run, spans } = setUp("a.x > 2", (_, i) => (i === 3 || (i >= 240 && i < 520) || i === 9999 ? 3 : 0));
  expect(finder.share).toBe(0);
  await run();
  expect(finder.share).toBe(1);
  expect(spans()).toEqual([
    [3, 4],
    [240, 520],
    [9999, 9999],
  ]);
});

test("objects are read together in order of time, and only those of the condition are fetched", async () => {
  const { run, spans, fetched } = setUp("a.x == 1 && b.x == 1", (topic, i) =>
    topic === "/14/2/a" ? Number(i >= 100 && i < 300) : Number(i >= 200 && i < 400),
  );
  await run();
  expect(spans()).toEqual([[200, 300]]);
  expect(fetched).toHaveLength(80);
  const one = setUp("a.x == 1", () => 0);
  await one.run();
  expect(one.spans()).toEqual([]);
  expect(new Set(one.fetched)).toEqual(new Set(["/14/2/a"]));
});

test("nothing is fetched while a person types, and a server's failure is shown", async () => {
  const { finder, fetched } = setUp("a.x > 2", () => 0);
  finder.update(4, () => 1000);
  finder.update(4, () => 1200);
  expect(fetched).toEqual([]);
  const failing = new WholeFinder(finder.condition, finder.decoders, finder.range, () =>
    Promise.reject(new Error("No.")),
  );
  for (let time = 0; !failing.done && time < 10_000; time += 10) {
    failing.update(4, () => time);
    await Promise.resolve();
  }
  expect(failing.problem).toBe("No.");
});

test("the search ends at the maximum number of matches", async () => {
  const { finder, run } = setUp("a.x == 1", (_, i) => i % 2);
  await run();
  expect(finder.matches).toHaveLength(5000);
  expect(finder.full).toBe(true);
});

test("a moment is judged when all objects have their values of it", async () => {
  const { finder, run } = setUp("a.x - b.x != 0", (_, i) => i % 7);
  await run();
  expect(finder.matches).toEqual([]);
});
