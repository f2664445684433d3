import { expect, test } from "vitest";
import { fieldsOfJson } from "../memory/forecast";
import { History } from "../memory/history";
import { memoryWith } from "../memory/test_memory";
import { foreseenBy } from "./newest_forecast";

test("a forecast from before half-time stays at its place after the teams changed sides", () => {
  const forecast = {
    strategies: [{ strategy: "a", paths: [{ spacing: 1, ball: [1, 2], robots: [{ player: 2, points: [3, -1] }] }] }],
  };
  const history = new History();
  for (const half of [1, 2]) history.add({ log_ns: BigInt(100 * half), data: Uint8Array.of(half), arrived: 0 });
  const ofHalf = (data: Uint8Array) => ({ fields: fieldsOfJson({ attacks_positive_x: data[0] === 1 }) });
  const game = { history, decode: ofHalf, decoded: () => ofHalf(Uint8Array.of(2)) };
  const seen = (at_ns: bigint) => {
    const object = {
      shown: { log_ns: at_ns, data: new Uint8Array(1) },
      decoded: () => ({ fields: fieldsOfJson(forecast) }),
    };
    const memory = memoryWith({ get: (topic) => (topic === "/14/2/forecast" ? object : game) });
    return foreseenBy([{ memory, robots: ["14/2"], keyOf: (robot: string) => robot }], [], "14/2")!.paths[0]!;
  };
  expect(seen(150n)).toMatchObject({ ball: [{ x: 1, y: 2 }], robots: [{ points: [{ x: 3, y: -1 }] }] });
  expect(seen(250n)).toMatchObject({ ball: [{ x: -1, y: -2 }], robots: [{ points: [{ x: -3, y: 1 }] }] });
  expect(seen(50n).ball).toEqual([{ x: -1, y: -2 }]); // the sides of that moment are not kept any more: those of now count
});
