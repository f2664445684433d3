import { expect, test } from "vitest";
import { leftIn, textOfLeft } from "./left";

const left = {
  play: true,
  speed: 0.01,
  at_ns: 1_700_000_000_123_456_789n,
  start_ns: 1n,
  end_ns: 2n ** 64n - 1n,
  session: "a long name",
};

test("a playhead that was left is read again as it was", () => {
  for (const one of [left, { ...left, play: false, speed: 1000, session: "" }])
    expect(leftIn(textOfLeft(one))).toEqual(one);
});

test("any other text is none", () => {
  const text = textOfLeft(left);
  for (let length = 0; length < text.indexOf(" 1 ") + 2; ++length)
    expect(leftIn(text.slice(0, length))).toBeUndefined();
  for (const wrong of ["", "plays 0 1 2 3 a", "plays e 1 2 3 a", "plays 1 x 2 3 a", "plays 1 1 2 3", "runs 1 1 2 3 a"])
    expect(leftIn(wrong)).toBeUndefined();
});
