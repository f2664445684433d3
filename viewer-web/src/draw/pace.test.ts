import { expect, test } from "vitest";
import { Pace } from "./pace";

/** The pace of a machine with this speed, which needs 2 ms more for each drawing. */
function after(seconds: number, pointsPerSecond: number): Pace {
  const pace = new Pace();
  for (let i = 0; i < 30 * seconds; ++i) pace.drew(0.002 + (640 * 480) / pace.stride ** 2 / pointsPerSecond);
  return pace;
}

test("a quick machine draws all points", () => expect(after(10, 1e8).stride).toBe(1));

test("a slow machine soon draws as many as it can in time", () => {
  for (const speed of [3e6, 1e6, 4e5]) {
    const { stride } = after(1, speed);
    expect((640 * 480) / stride ** 2 / speed).toBeLessThan(0.034);
    expect(stride).toBeLessThan(8);
  }
});

test("single slow drawings change nothing", () => {
  const pace = new Pace();
  for (let i = 0; i < 300; ++i) pace.drew(i % 10 === 0 ? 0.1 : 0.01);
  expect(pace.stride).toBe(1);
});

test("when a machine becomes quick again, all points return", () => {
  const pace = after(1, 1e6);
  for (let i = 0; i < 10_000; ++i) pace.drew(0.004);
  expect(pace.stride).toBe(1);
});
