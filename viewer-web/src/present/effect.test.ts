import { expect, test } from "vitest";
import type { Futures } from "../memory/change";
import { partingOf, rowsOf } from "./effect";

const kSame = { without: 0.1, with: 0.1, low: 0, high: 0 };
const kFutures: Futures = {
  pairs: 200,
  different: 150,
  seconds: 30,
  scores: { without: 0.12, with: 0.31, low: 0.11, high: 0.27 },
  concedes: { without: 0.2, with: 0.1, low: -0.21, high: 0.01 },
  goals: kSame,
  parting: { seconds: 0.5, field: "world.ball.position.x" },
  without: [],
  with: [],
};

test("an effect is told with its interval, and whether that tells it from chance", () => {
  expect(rowsOf(kFutures)).toEqual([
    { what: "scores within 30.0 s", without: "12 %", with: "31 %", interval: "+11 .. +27", sure: true },
    { what: "concedes within 30.0 s", without: "20 %", with: "10 %", interval: "−21 .. +1", sure: false },
    { what: "goal difference", without: "0.10", with: "0.10", interval: "±0.00 .. ±0.00", sure: false },
  ]);
});

test("the parting of the pair with the luck of the game is a sentence", () => {
  expect(partingOf(kFutures)).toBe(
    "150 of 200 pairs differ; with the luck of this game they part after 0.50 s, first in world.ball.position.x",
  );
  expect(partingOf({ ...kFutures, parting: undefined })).toBe(
    "150 of 200 pairs differ; with the luck of this game nothing does",
  );
  expect(partingOf({ ...kFutures, parting: undefined, different: 0 })).toBe("No future differs");
});
