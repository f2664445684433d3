import { expect, test } from "vitest";
import { conditionOf, type Condition } from "./condition";
import { decoderOf } from "./decoder";
import { Finder } from "./finder";
import { History } from "./history";
import { kPerceptChannel, percept } from "./test_schema";
import { topicsOnly } from "./test_vocabulary";

const kMs = 1_000_000n;
function setUp() {
  const decode = decoderOf(kPerceptChannel);
  const sources = new Map(["/14/2/a", "/14/2/b"].map((topic) => [topic, { history: new History(), decode }]));
  const add = (name: string, ms: bigint, x: number) =>
    sources.get(`/14/2/${name}`)!.history.add({ log_ns: ms * kMs, data: percept({ x }), arrived: 0 });
  const find = (text: string, recorded = false) =>
    new Finder(conditionOf(text, topicsOnly("14/2", sources.keys())) as Condition, sources, recorded);
  const spans = ({ matches }: Finder) =>
    matches.map(({ from_ns, to_ns }) => [Number(from_ns / kMs), Number(to_ns / kMs)]);
  return { add, find, spans, sources };
}

test("a match lasts from the message that makes the condition true to the one that makes it false", () => {
  const { add, find, spans } = setUp();
  [0, 1, 3, 4, 0, 5, 0].forEach((x, i) => add("a", BigInt(100 * i), x));
  const finder = find("a.x > 2");
  expect(finder.update(1000)).toBe(true);
  expect(spans(finder)).toEqual([
    [200, 400],
    [500, 600],
  ]);
});

test("messages of all objects are read in order of capture time, whichever arrived first", () => {
  const { add, find, spans } = setUp();
  for (const [ms, x] of [
    [0n, 1],
    [300n, 0],
    [1000n, 0],
  ] as const)
    add("a", ms, x);
  for (const [ms, x] of [
    [100n, 1],
    [200n, 0],
    [1000n, 0],
  ] as const)
    add("b", ms, x);
  const finder = find("a.x == 1 && b.x == 1");
  finder.update(1000);
  expect(spans(finder)).toEqual([[100, 200]]);
});

test("a moment is judged when all objects have their values of it", () => {
  const { add, find, spans } = setUp();
  [1, 2, 3, 3].forEach((x, i) => {
    add("a", BigInt(100 * i), x);
    add("b", BigInt(100 * i), i < 3 ? x : 0);
  });
  const finder = find("a.x - b.x != 0");
  finder.update(1000);
  expect(spans(finder)).toEqual([[300, 300]]);
});

test("the finder reads new messages within its time limit, and restarts after the past was forgotten", () => {
  const { add, find, spans, sources } = setUp();
  for (let i = 0; i < 100; ++i) add("a", BigInt(10 * i), i % 20 < 10 ? 1 : 0);
  const finder = find("a.x == 1");
  let time = 0;
  const clock = () => (time += 1);
  expect(finder.update(1, clock)).toBe(false);
  expect(finder.matches.length).toBeLessThan(5);
  while (!finder.update(1, clock));
  expect(finder.matches).toHaveLength(5);
  add("a", 1000n, 1);
  finder.update(1000);
  expect(finder.matches).toHaveLength(6);
  sources.get("/14/2/a")!.history.clear();
  add("a", 5n, 1);
  finder.update(1000);
  expect(spans(finder)).toEqual([[5, 5]]);
});

test("a silent object does not block the others for ever", () => {
  const { add, find, spans } = setUp();
  add("b", 0n, 1);
  for (let i = 0; i < 30; ++i) add("a", BigInt(100 * i), i === 5 ? 9 : 0);
  const finder = find("a.x > 5 && b.x == 1");
  finder.update(1000);
  expect(spans(finder)).toEqual([[500, 600]]);
});

test("matches of a recording stay in order, and a part that is read again gives no second match", () => {
  const { add, find, spans, sources } = setUp();
  const finder = find("a.x == 1", true);
  const part = (from: bigint, ...values: number[]) => {
    sources.get("/14/2/a")!.history.clear();
    values.forEach((x, i) => add("a", from + 100n * BigInt(i), x));
    finder.update(1000);
  };
  part(5000n, 0, 1, 1, 0);
  part(1000n, 0, 1, 0);
  part(5200n, 1, 0, 1, 0);
  expect(spans(finder)).toEqual([
    [1100, 1200],
    [5100, 5300],
    [5400, 5500],
  ]);
});
