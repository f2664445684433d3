import { expect, test } from "vitest";
import type { PlaybackWish } from "./frames";
import { Wishes } from "./wishes";

function wishes() {
  const sent: { wish: PlaybackWish; request: string }[] = [];
  return { sent, wishes: new Wishes((wish, request) => sent.push({ wish, request }) > 0) };
}
const to = (seek_ns: bigint) => ({ play: false, speed: 1, seek_ns });

test("one wish is under way at a time, and only the last of the waiting ones is sent next", () => {
  const { sent, wishes: mine } = wishes();
  for (const place of [1n, 2n, 3n]) mine.ask(to(place), 0);
  expect(sent.map(({ wish }) => wish.seek_ns)).toEqual([1n]);
  expect(mine.pending).toEqual(to(3n));
  expect(mine.answered("of somebody else", 0.1)).toBe(false);
  expect(mine.answered(sent[0]!.request, 0.1)).toBe(true);
  expect(sent.map(({ wish }) => wish.seek_ns)).toEqual([1n, 3n]);
  expect(mine.answered(sent[1]!.request, 0.2)).toBe(true);
  expect(mine.pending).toBeUndefined();
});

test("a wish to play keeps the place of a waiting seek", () => {
  const { sent, wishes: mine } = wishes();
  mine.ask(to(1n), 0);
  mine.ask(to(2n), 0);
  mine.ask({ play: true, speed: 2 }, 0);
  mine.answered(sent[0]!.request, 0);
  expect(sent[1]!.wish).toEqual({ play: true, speed: 2, seek_ns: 2n });
});

test("an unanswered wish is given up once, and then another one may be sent", () => {
  const { sent, wishes: mine } = wishes();
  mine.ask(to(1n), 0);
  expect(mine.gaveUp(4.9)).toBe(false);
  expect(mine.gaveUp(5.1)).toBe(true);
  expect(mine.gaveUp(9)).toBe(false);
  mine.ask(to(2n), 10);
  expect(sent).toHaveLength(2);
});

test("without a server nothing is pending", () => {
  const mine = new Wishes(() => false);
  mine.ask(to(1n), 0);
  expect(mine.pending).toBeUndefined();
});
