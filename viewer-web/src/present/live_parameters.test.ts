import { describe, expect, test } from "vitest";
import type { LiveParameter } from "../memory/live_parameters";
import {
  hasSlider,
  isChanged,
  isFound,
  numberWord,
  pressesWords,
  rangeWords,
  refusalOf,
  stepOf,
  textOfValues,
  valuesOf,
  valueWords,
} from "./live_parameters";

const parameter = (parts: Partial<LiveParameter> = {}): LiveParameter => ({
  name: "walk.height",
  process: "walk",
  type: "number",
  value: 0.02,
  initial: 0.02,
  min: 0,
  max: 0.05,
  unit: "m",
  description: "Height of a foot over the ground.",
  choices: [],
  gone: false,
  ...parts,
});
const gait = parameter({
  name: "walk.gait",
  type: "choice",
  value: "slow",
  initial: "slow",
  choices: ["slow", "fast"],
});
const arms = parameter({ name: "walk.arms", type: "yes_no", value: true, initial: false });
const steps = parameter({ name: "walk.steps", type: "whole", value: 3, initial: 3, min: 1, max: 10, unit: "" });
const push = parameter({ name: "lab.push", type: "button", value: 3, initial: 0, min: 0, max: 2 ** 53, unit: "" });
const name = parameter({ name: "walk.name", type: "text", value: "a", initial: "a", unit: "" });

test("a search finds all of its words in name, description and unit", () => {
  for (const search of ["", "walk", "HEIGHT foot", "  ground m "]) expect(isFound(parameter(), search)).toBe(true);
  for (const search of ["knee", "height knee"]) expect(isFound(parameter(), search)).toBe(false);
});

test("values and ranges in words", () => {
  expect(valueWords(parameter(), 0.1 + 0.2)).toBe("0.3 m");
  expect(valueWords(arms, true)).toBe("yes");
  expect(valueWords(gait, "fast")).toBe("fast");
  expect(valueWords(name, "")).toBe("“”");
  expect(numberWord(1e-9)).toBe("1e-9");
  expect(rangeWords(parameter())).toBe("0 to 0.05 m");
  expect(rangeWords(parameter({ max: Infinity }))).toBe("at least 0 m");
  expect(rangeWords(parameter({ min: -Infinity, max: 1 }))).toBe("at most 1 m");
  expect(rangeWords(parameter({ min: -Infinity, max: Infinity }))).toBe("");
  expect(rangeWords({ ...steps, min: -(2 ** 31), max: 2 ** 31 - 1 })).toBe("");
  expect([isChanged(parameter()), isChanged(arms), isChanged(push)]).toEqual([false, true, false]);
  expect([0, 1, 2, 3].map(pressesWords)).toEqual([
    "not pressed yet",
    "pressed once",
    "pressed twice",
    "pressed 3 times",
  ]);
});

test("a slider has round steps, at least a hundred of them", () => {
  expect(stepOf(parameter())).toBeCloseTo(0.0005, 12);
  expect(stepOf(steps)).toBe(1);
  for (const max of [1e-6, 0.3, 1, 2, 7, 1234]) {
    const step = stepOf(parameter({ max }));
    expect(max / step).toBeGreaterThan(99.9);
    expect(max / step).toBeLessThan(501);
    expect(step.toExponential()).toMatch(/^[125](\.0+\d?)?e/);
  }
  expect([hasSlider(parameter()), hasSlider(steps), hasSlider(arms), hasSlider(name)]).toEqual([
    true,
    true,
    false,
    false,
  ]);
  expect(hasSlider(parameter({ max: Infinity }))).toBe(false);
  expect(hasSlider({ ...steps, max: 2 ** 31 - 1 })).toBe(false);
});

describe("a wrong value gets one sentence", () => {
  test.each([
    [parameter(), 0.06, "walk.height: expected 0 to 0.05 m, got 0.06."],
    [parameter(), NaN, "walk.height: expected a number, got NaN."],
    [parameter(), "1", 'walk.height: expected a number, got "1".'],
    [parameter(), null, "walk.height: expected a number, got null."],
    [steps, 1.5, "walk.steps: expected a whole number, got 1.5."],
    [steps, 11, "walk.steps: expected 1 to 10, got 11."],
    [push, -1, "lab.push: expected at least 0, got -1."],
    [push, 0.5, "lab.push: expected a whole number, got 0.5."],
    [arms, "yes", 'walk.arms: expected true or false, got "yes".'],
    [gait, "faster", 'walk.gait: expected one of slow, fast, got "faster".'],
    [name, 1, "walk.name: expected a text, got 1."],
    [name, "ä".repeat(101), "walk.name: expected a text of at most 200 bytes."],
    [name, ["a".repeat(100)], `walk.name: expected a text, got ["${"a".repeat(58)}….`],
  ])("%s", (one, value, sentence) => expect(refusalOf(one as LiveParameter, value)).toBe(sentence));

  test("a right one gets none", () => {
    for (const [one, value] of [
      [parameter(), 0],
      [parameter(), 0.05],
      [steps, 10],
      [arms, false],
      [gait, "fast"],
      [name, "ä".repeat(100)],
      [push, 4],
    ] as const)
      expect(refusalOf(one, value)).toBe("");
  });
});

describe("the file", () => {
  const all = [parameter(), gait, arms, steps, name, push];

  test("round trip: what was saved changes nothing, and brings later changes back", () => {
    const text = textOfValues(all);
    expect(valuesOf(text, all)).toEqual({ changes: new Map(), problems: [] });
    const later = [parameter({ value: 0.04 }), { ...gait, value: "fast" }, arms, steps, { ...name, value: "b" }, push];
    expect(valuesOf(text, later)).toEqual({
      changes: new Map<string, unknown>([
        ["walk.height", 0.02],
        ["walk.gait", "slow"],
        ["walk.name", "a"],
      ]),
      problems: [],
    });
  });

  test("each value that does not fit is named, the others are loaded", () => {
    const values = { "walk.height": 1, "walk.steps": 4, "walk.knee": 1, "kick.force": 2, "lab.push": 4 };
    const kick = parameter({ name: "kick.force", process: "kick", gone: true });
    expect(valuesOf(JSON.stringify({ foresight_parameters: 1, values }), [...all, kick])).toEqual({
      changes: new Map([["walk.steps", 4]]),
      problems: [
        "walk.height: expected 0 to 0.05 m, got 1.",
        '"walk.knee": no process announces this parameter.',
        "kick.force: its process has disconnected.",
        "lab.push: a file presses no button.",
      ],
    });
  });

  test.each([
    ["{", "it is not JSON"],
    ["[]", "expected an object"],
    ["{}", "expected 'foresight_parameters' to be 1, got nothing"],
    ['{"foresight_parameters":2}', "expected 'foresight_parameters' to be 1, got 2"],
    ['{"foresight_parameters":1,"values":[]}', "'values' is no object"],
  ])("%s is none", (text, why) =>
    expect(valuesOf(text, all)).toEqual({ error: `This is no file of parameters: ${why}.` }),
  );

  test("no truncation is accepted", () => {
    const text = textOfValues(all).trimEnd();
    for (let n = 0; n < text.length; ++n) expect(valuesOf(text.slice(0, n), all)).toHaveProperty("error");
  });
});
