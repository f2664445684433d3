import { expect, test } from "vitest";
import { Memory } from "../memory/memory";
import { Played } from "../memory/played";
import { ClockShifts, type Clocked } from "./clock_shifts";

const kSecond = 1_000_000_000n;
const recording = (start: bigint, end: bigint): Clocked => ({
  memory: new Memory(),
  played: new Played(start * kSecond, end * kSecond),
});
/** A robot whose clock shows `now_ns` at the page's time 0. */
function robot(now_ns: bigint): Clocked {
  const memory = new Memory();
  memory.clock.heard(now_ns, 0);
  return { memory, played: undefined };
}

test("a server has no offset to itself, nor clocks that agree", () => {
  const shifts = new ClockShifts();
  const one = robot(100n * kSecond);
  expect(shifts.of(one, one, true, 0)).toBe(0n);
  expect(shifts.of(robot(100n * kSecond + 200_000_000n), one, true, 0)).toBe(0n);
});

test("clocks of robots are compared while the page is live, and keep their offset at a chosen moment", () => {
  const shifts = new ClockShifts();
  const [one, other] = [robot(100n * kSecond), robot(400n * kSecond)];
  expect(shifts.of(other, one, false, 0)).toBe(0n);
  expect(shifts.of(other, one, true, 0)).toBe(300n * kSecond);
  shifts.keep([one, other], one, 0);
  other.memory.clock.heard(900n * kSecond, 1);
  expect(shifts.of(other, one, false, 1)).toBe(300n * kSecond);
});

test("recordings of one game agree, and others begin together", () => {
  const shifts = new ClockShifts();
  expect(shifts.of(recording(5n, 15n), recording(0n, 10n), true, 0)).toBe(0n);
  expect(shifts.of(recording(50n, 60n), recording(0n, 10n), false, 0)).toBe(50n * kSecond);
});
