import { expect, test } from "vitest";
import { Memory } from "./memory";
import { valueOf } from "./memory_object";
import type { Ball, GameState } from "./schema";
import {
  EnumValue,
  fieldsOf,
  listOf,
  numberOf,
  textOf,
  wordOf,
  type FieldPath,
  type Fields,
  type Value,
} from "./value";

const message = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const kBall: Fields<Ball> = message({ x: 1.5, seen_ns: 7n, visible: true });
const kGame: Fields<GameState> = message({
  state: new EnumValue(5, "STATE_PLAYING"),
  own: message({ score: 2, players: [message({ penalised: true })] }),
});

test("fields are read by name; a missing one or one of another kind is empty", () => {
  expect([numberOf(kBall, "x"), numberOf(kBall, "seen_ns"), numberOf(kBall, "y")]).toEqual([1.5, 7, NaN]);
  expect(numberOf(fieldsOf(kGame, "own"), "score")).toBe(2);
  expect(fieldsOf(kGame, "opponent").size).toBe(0);
  expect(listOf(fieldsOf(kGame, "own"), "players").map((player) => player.get("penalised"))).toEqual([true]);
  expect(listOf(message({ players: 5 }), "players")).toEqual([]);
  expect([textOf(message({ note: "a" }), "note"), textOf(message({ note: 1 }), "note")]).toEqual(["a", ""]);
});

test("a word is an enum's value or a text, in lower case and without the field's name", () => {
  expect(wordOf(kGame, "state")).toBe("playing");
  expect(wordOf(message({ colour: new EnumValue(9, undefined) }), "colour")).toBe("");
  expect(wordOf(message({ side: "SIDE_OWN" }), "side")).toBe("own");
});

test("a name that no .proto has is a type error", () => {
  const memory = new Memory();
  // @ts-expect-error no object of a robot
  expect(memory.of("14/2", "bal")).toBeUndefined();
  // @ts-expect-error no object without a robot
  expect(memory.world("/truth/word")).toBeUndefined();
  // @ts-expect-error no field of Ball
  expect(numberOf(valueOf(memory.of("14/2", "ball")), "z")).toBe(NaN);
  // @ts-expect-error no number
  expect(numberOf(kBall, "visible")).toBe(NaN);
  // @ts-expect-error no message
  expect(fieldsOf(kGame, "state").size).toBe(0);
  // @ts-expect-error no field of PlayerState
  expect(listOf(fieldsOf(kGame, "own"), "players")[0]!.get("penalized")).toBeUndefined();
  // @ts-expect-error no value of the enum
  expect(wordOf(kGame, "state") === "plying").toBe(false);
  // @ts-expect-error no path to a field
  expect("ball.z" satisfies FieldPath).toBe("ball.z");
});
