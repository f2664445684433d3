import { expect, test } from "vitest";
import type { Memory } from "./memory";
import { History } from "./history";
import { simulationOf, tickAt } from "./simulation";

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

test("the tick at a time is that of the state then, or between its neighbours", () => {
  const history = new History();
  for (const ns of [5, 6, 16]) history.add({ log_ns: BigInt(ns), data: new Uint8Array([ns]), arrived: 0 });
  const decode = (data: Uint8Array) => ({ fields: new Map([["tick", 100 + data[0]!]]) });
  const memory = { world: () => ({ history, decode }) } as unknown as Memory;
  expect([5n, 6n, 9n, 15n, 16n, 99n].map((at_ns) => tickAt(memory, at_ns))).toEqual([105, 106, 109, 115, 116, 116]);
  expect(tickAt(memory, 3n)).toBeUndefined();
  expect(tickAt({ world: () => undefined } as unknown as Memory, 7n)).toBeUndefined();
});
