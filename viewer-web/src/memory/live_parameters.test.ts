import { expect, test } from "vitest";
import { liveParametersOf } from "./live_parameters";
import { EnumValue, type Fields, type Value } from "./value";

const message = (fields: Record<string, Value>): Fields => new Map(Object.entries(fields));
const height = {
  name: "walk.height",
  type: new EnumValue(1, "TYPE_NUMBER"),
  number: 0.03,
  initial_number: 0.02,
  min: 0,
  max: 0.05,
  unit: "m",
  description: "Height of a foot.",
  choice: [],
  gone: false,
};

test("a message is read", () => {
  const { parameters, problems } = liveParametersOf(
    message({
      parameter: [
        message(height),
        message({
          ...height,
          name: "walk.arms",
          type: new EnumValue(3, "TYPE_YES_NO"),
          number: 1,
          min: 0,
          max: 0,
          gone: true,
        }),
        message({
          name: "a.b.c",
          type: new EnumValue(5, "TYPE_CHOICE"),
          text: "x",
          initial_text: "y",
          choice: ["x", "y"],
        }),
        message({ ...height, type: new EnumValue(9, undefined) }),
      ],
      problem: ["kick: no", 3],
    }),
  );
  expect(problems).toEqual(["kick: no"]);
  expect(parameters).toMatchObject([
    {
      name: "walk.height",
      process: "walk",
      type: "number",
      value: 0.03,
      initial: 0.02,
      min: 0,
      max: 0.05,
      gone: false,
    },
    { name: "walk.arms", type: "yes_no", value: true, initial: false, min: -Infinity, max: Infinity, gone: true },
    { name: "a.b.c", process: "a", type: "choice", value: "x", initial: "y", choices: ["x", "y"] },
  ]);
});

test("any other message is empty", () => {
  expect(liveParametersOf(message({}))).toEqual({ parameters: [], problems: [] });
  expect(liveParametersOf(message({ parameter: "x", problem: 1 }))).toEqual({ parameters: [], problems: [] });
});
