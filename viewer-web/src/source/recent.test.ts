import { expect, test } from "vitest";
import { Recalls, type Remembered } from "./recent";

const settled = () => new Promise((resolve) => setTimeout(resolve));
const remembered = (topic: string): Remembered => ({ topic, messages: [{ log_ns: 1n, data: new Uint8Array([1]) }] });

function recalls(answer: (topics: string[]) => Promise<Remembered[] | undefined>) {
  const asked: string[] = [];
  const arrived: string[] = [];
  const failed: string[] = [];
  const all = new Recalls(
    (topics) => (asked.push(topics.join()), answer(topics)),
    ({ topic }) => arrived.push(topic),
    (sentence) => failed.push(sentence),
  );
  return { all, asked, arrived, failed };
}

test("a few objects are recalled at a time, also those that are wanted meanwhile", async () => {
  let atOnce = 0;
  const { all, asked, arrived, failed } = recalls(async (topics) => {
    expect(++atOnce).toBe(1);
    await settled();
    --atOnce;
    return topics.map(remembered);
  });
  const topics = Array.from({ length: 10 }, (_, i) => `/${i}`);
  for (const topic of [...topics, "/0", "/9"]) all.want(topic);
  await settled();
  expect([asked, all.busy]).toEqual([[], true]); // not before it begins
  all.begin();
  await settled();
  all.want("/late");
  for (let i = 0; i < 10; ++i) await settled();
  expect(arrived).toEqual([...topics, "/late"]);
  expect(asked[0]).toBe("/0,/1,/2,/3,/4,/5,/6,/7");
  expect(all.busy).toBe(false);
  all.want("/0");
  for (let i = 0; i < 4; ++i) await settled();
  expect(arrived.at(-1)).toBe("/0");
  expect(failed).toEqual([]);
});

test("after a refusal the waiting objects are not asked for", async () => {
  const { all, asked, arrived, failed } = recalls(() => Promise.resolve(undefined));
  for (let i = 0; i < 20; ++i) all.want(`/${i}`);
  all.begin();
  for (let i = 0; i < 4; ++i) await settled();
  expect([asked.length, arrived, failed, all.busy]).toEqual([1, [], [], false]);
});

test("a failure is told once, and what comes after stop() is not told", async () => {
  const { all, asked, failed } = recalls(() => Promise.reject(new Error("no way")));
  for (let i = 0; i < 20; ++i) all.want(`/${i}`);
  all.begin();
  for (let i = 0; i < 4; ++i) await settled();
  expect([asked.length, failed]).toEqual([1, ["no way"]]);
  all.want("/c");
  all.stop();
  all.want("/d");
  for (let i = 0; i < 4; ++i) await settled();
  expect(failed).toEqual(["no way"]);
  expect(all.busy).toBe(false);
});
