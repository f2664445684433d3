import { expect, test } from "vitest";
import { Recalls } from "./recent";

const message = (log_ns: bigint) => ({ log_ns, data: new Uint8Array([1]) });
const settled = () => new Promise((resolve) => setTimeout(resolve));

function recalls(answer: (topic: string) => Promise<{ log_ns: bigint; data: Uint8Array }[] | undefined>) {
  const asked: string[] = [];
  const arrived: string[] = [];
  const failed: string[] = [];
  const all = new Recalls(
    (topic) => (asked.push(topic), answer(topic)),
    (topic, messages) => arrived.push(`${topic} ${messages.length}`),
    (sentence) => failed.push(sentence),
  );
  return { all, asked, arrived, failed };
}

test("objects are recalled one after the other, also those that are wanted meanwhile", async () => {
  let atOnce = 0;
  const { all, arrived, failed } = recalls(async () => {
    expect(++atOnce).toBe(1);
    await settled();
    --atOnce;
    return [message(1n), message(2n)];
  });
  all.want("/a");
  all.want("/b");
  all.want("/b");
  await settled();
  all.want("/c");
  for (let i = 0; i < 10; ++i) await settled();
  expect(arrived).toEqual(["/a 2", "/b 2", "/c 2"]);
  all.want("/a");
  for (let i = 0; i < 4; ++i) await settled();
  expect(arrived.at(-1)).toBe("/a 2");
  expect(failed).toEqual([]);
});

test("after a refusal the waiting objects are not asked for", async () => {
  const { all, asked, arrived, failed } = recalls(() => Promise.resolve(undefined));
  for (const topic of ["/a", "/b", "/c"]) all.want(topic);
  for (let i = 0; i < 4; ++i) await settled();
  expect([asked, arrived, failed]).toEqual([["/a"], [], []]);
});

test("a failure is told once, and what comes after stop() is not told", async () => {
  const { all, asked, failed } = recalls(() => Promise.reject(new Error("no way")));
  for (const topic of ["/a", "/b"]) all.want(topic);
  for (let i = 0; i < 4; ++i) await settled();
  expect([asked, failed]).toEqual([["/a"], ["no way"]]);
  all.want("/c");
  all.stop();
  for (let i = 0; i < 4; ++i) await settled();
  expect(failed).toEqual(["no way"]);
});
