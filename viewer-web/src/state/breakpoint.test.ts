import { expect, test } from "vitest";
import { Breakpoint } from "./breakpoint";

const kSecond = 1_000_000_000n;
const at = (seconds: number) => BigInt(Math.round(seconds * 10)) * (kSecond / 10n);

/** Shows moments from `from` to `to` [s] in steps of 0.1 s, and returns those at which it stopped; then time goes on. */
function run(breakpoint: Breakpoint, from: number, to: number, begins: (shown: number) => number[]): bigint[] {
  const stops: bigint[] = [];
  for (let shown = from; shown <= to + 1e-9; shown += 0.1) {
    const stop = breakpoint.stopAt(at(shown), true, begins(shown).map(at), kSecond / 10n);
    if (stop === undefined) continue;
    stops.push(stop);
    breakpoint.stopAt(stop, false, begins(shown).map(at), 0n); // it stands there
  }
  return stops;
}

test("time stops at the begin of each match once, not at those before", () => {
  expect(run(new Breakpoint(), 5, 20, () => [1, 5, 8.1, 8.4, 15])).toEqual([8.1, 8.4, 15].map(at));
});

test("a match that is found a little later stops too", () => {
  expect(run(new Breakpoint(), 0, 20, (shown) => (shown > 8.6 ? [8.1] : []))).toEqual([at(8.1)]);
});

test("neither a seek nor a pause passes over a match and stops at it", () => {
  const breakpoint = new Breakpoint();
  const begins = [at(30), at(50)];
  expect(run(breakpoint, 0, 10, () => [])).toEqual([]);
  expect(breakpoint.stopAt(at(40), true, begins, kSecond)).toBeUndefined(); // forwards, over 30 s
  expect(breakpoint.stopAt(at(20), true, begins, kSecond)).toBeUndefined(); // back
  expect(breakpoint.stopAt(at(31), false, begins, kSecond)).toBeUndefined(); // a person looks at another moment
  expect(run(breakpoint, 31.1, 60, () => [30, 50])).toEqual([at(50)]);
});

test("a page that stands still for some seconds passes over no match, at any pace", () => {
  const breakpoint = new Breakpoint();
  expect(breakpoint.stopAt(at(0), true, [at(40)], 0n)).toBeUndefined();
  for (let frame = 0; frame < 10; ++frame)
    expect(breakpoint.stopAt(at(0), true, [at(40)], 5n * kSecond)).toBeUndefined();
  expect(breakpoint.stopAt(at(45), true, [at(40)], 0n)).toBe(at(40));
});

test("a playback that pauses by itself just behind a match stops at it", () => {
  const breakpoint = new Breakpoint();
  expect(breakpoint.stopAt(at(39), true, [at(40)], 0n)).toBeUndefined();
  expect(breakpoint.stopAt(at(40.5), false, [at(40)], kSecond)).toBe(at(40)); // its server waits for data
  expect(breakpoint.stopAt(at(41.5), false, [at(40), at(41)], kSecond)).toBeUndefined(); // a person skips a second
});
