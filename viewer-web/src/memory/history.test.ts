import { expect, test } from "vitest";
import { History } from "./history";
import { Past } from "./past";

const bytes = (value: number, size = 4) => new Uint8Array(size).fill(value);
const entry = (second: number, value = second, size = 4) => ({
  log_ns: BigInt(Math.round(second * 1e9)),
  data: bytes(value, size),
  arrived: second,
});
const filled = (count: number, size = 4) => {
  const history = new History();
  for (let i = 0; i < count; ++i) history.add(entry(i, i % 256, size));
  return history;
};

test("the newest message at a moment is the last one captured up to then", () => {
  const history = filled(1000);
  expect(history.at(-1n)).toBeUndefined();
  for (let i = 0; i < 1000; i += 7) {
    expect(history.at(BigInt(i) * 1_000_000_000n)!.data).toEqual(bytes(i % 256));
    expect(history.at(BigInt(i) * 1_000_000_000n + 999_999_999n)!.arrived).toBe(i);
  }
  expect(history.at(10n ** 18n)!.log_ns).toBe(999_000_000_000n);
  expect(history.hzAt(500_000_000_000n)).toBe(1);
});

test("message numbers stay the same when old messages are dropped", () => {
  const history = filled(2000);
  const seen = history.get(1500)!.data;
  while (history.oldestArrival()! < 1000) history.dropOldest();
  expect(history.begin).toBeGreaterThan(700);
  expect(history.end).toBe(2000);
  expect(history.get(history.begin - 1)).toBeUndefined();
  expect(history.get(1500)!.data).toEqual(seen);
  expect(history.indexAt(0n)).toBe(history.begin - 1);
});

test("messages of any size are returned unchanged, and share no bytes with the input", () => {
  const history = new History();
  const sizes = [0, 1, 100, 16383, 16384, 16385, 40000, 70000, 3];
  const data = sizes.map((size, i) => bytes(i + 1, size));
  data.forEach((bytes, i) => history.add({ log_ns: BigInt(i), data: bytes, arrived: i }));
  data.forEach((bytes) => bytes.fill(99));
  sizes.forEach((size, i) => expect(history.get(i)!.data).toEqual(bytes(i + 1, size)));
});

test("slight disorder keeps the order, and a seek back starts another past", () => {
  const history = new History();
  for (const second of [10, 11, 10.5, 12]) history.add(entry(second));
  expect(history.end - history.begin).toBe(4);
  expect(history.timeOf(2)).toBe(11_000_000_000n);
  expect(history.generation).toBe(0);
  history.add(entry(3));
  expect([history.end - history.begin, history.generation, history.get(history.begin)!.arrived]).toEqual([1, 1, 3]);
});

test("the past stays below its cap, and the messages that arrived first are dropped first", () => {
  const past = new Past({ values: 1e6, pictures: 1e6 });
  const [often, seldom] = [new History(), new History()];
  for (let i = 0; i < 60000; ++i) {
    past.keep(often, entry(i / 30, 1, 100), false);
    if (i % 30 === 0) past.keep(seldom, entry(i / 30, 2, 300), false);
    expect(past.size_bytes).toBeLessThanOrEqual(1e6);
  }
  expect(past.size_bytes).toBeGreaterThan(0.8e6);
  // both reach back about equally far
  expect(Math.abs(Number(often.first_ns! - seldom.first_ns!)) / 1e9).toBeLessThan(130);
  past.forget(often);
  expect(past.size_bytes).toBeLessThan(0.2e6);
});

test("only a few images are kept, raw ones fewest", () => {
  const count = (size: number) => {
    const history = new History();
    const past = new Past({ values: 0, pictures: 1e9 });
    for (let i = 0; i < 300; ++i) past.keep(history, entry(i / 30, 0, size), true);
    return history.end;
  };
  expect(count(40_000)).toBe(100);
  expect(count(614_400)).toBe(20);
});

test("the message nearest to a moment is found, unless it is too far away", () => {
  const history = new History();
  for (const log_ns of [100n, 200n, 210n]) history.add({ log_ns, data: Uint8Array.of(1), arrived: 0 });
  const near = (log_ns: bigint) => history.near(log_ns, 20n)?.log_ns;
  expect([near(80n), near(79n), near(120n), near(150n), near(204n), near(206n), near(231n)]).toEqual([
    100n,
    undefined,
    100n,
    undefined,
    200n,
    210n,
    undefined,
  ]);
});

test("recalled messages take the place of those of their time, and the others stay", () => {
  const history = filled(100);
  const { generation } = history;
  const seconds = () => {
    const found = [];
    for (let index = history.begin; index < history.end; ++index) found.push(Number(history.timeOf(index)) / 1e9);
    return found;
  };
  history.recall([]);
  expect(history.generation).toBe(generation);
  const [begin, end] = [-300, 20];
  history.recall(Array.from({ length: 2 * (end - begin) + 1 }, (_, i) => entry(begin + i / 2, 7)));
  expect(history.generation).not.toBe(generation);
  const half = Array.from({ length: 2 * (end - begin) + 1 }, (_, i) => begin + i / 2);
  expect(seconds()).toEqual([...half, ...Array.from({ length: 79 }, (_, i) => 21 + i)]);
  expect(history.at(10_000_000_000n)!.data).toEqual(bytes(7));
  expect(history.at(50_000_000_000n)!.data).toEqual(bytes(50));
});
