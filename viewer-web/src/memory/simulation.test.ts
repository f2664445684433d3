import { expect, test } from "vitest";
import type { Memory } from "./memory";
import { simulationOf } from "./simulation";

test("a simulation reports its state, and without one the state is undefined", () => {
  const team = (number: number, score: number) =>
    new Map<string, unknown>([
      ["number", number],
      ["strategy", "baseline"],
      ["score", score],
    ]);
  const fields = new Map<string, unknown>([
    ["paused", true],
    ["finished", false],
    ["speed", 0.5],
    ["seed", 7n],
    ["tick", 45],
    ["rules", "spl2012"],
    ["home", team(14, 2)],
    ["away", team(5, 1)],
  ]);
  const memory = {
    world: (topic: string) => (topic === "/sim/state" ? { decoded: () => ({ fields }) } : undefined),
  } as unknown as Memory;
  expect(simulationOf(memory)).toEqual({
    paused: true,
    finished: false,
    speed: 0.5,
    seed: 7,
    tick: 45,
    seconds: 1.5,
    rules: "spl2012",
    home: { number: 14, strategy: "baseline", score: 2 },
    away: { number: 5, strategy: "baseline", score: 1 },
  });
  expect(simulationOf({ world: () => undefined } as unknown as Memory)).toBeUndefined();
});
