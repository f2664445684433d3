import { expect, test } from "vitest";
import { memoryWith } from "../memory/test_memory";
import type { Value } from "../memory/value";
import { kFields } from "./field";
import { kAssumed, knownField } from "./known_field";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const told = (values: Record<string, Record<string, Value>>, robots = ["14/2"]) => {
  const get = (topic: string) => values[topic] && { decoded: () => ({ fields: fields(values[topic]!) }) };
  return { memory: memoryWith({ get }), robots, keyOf: (robot: string) => robot };
};
const kSimulated = {
  "/sim/state": {
    field: fields({
      length: 9,
      width: 6,
      border: 0.7,
      line_width: 0.05,
      penalty_area_length: 1.65,
      penalty_area_width: 4,
    }),
  },
};

test("a reported field has precedence over a chosen one, and that over the assumption", () => {
  expect(knownField([told({}), told(kSimulated)], "spl2012")).toMatchObject({
    from: "reported",
    field: { length: 9, width: 6, penaltyAreaWidth: 4 },
  });
  expect(knownField([told({})], "spl2012")).toEqual({ from: "chosen", field: kFields["spl2012"] });
  for (const nothing of ["", "spl1999"])
    expect(knownField([told({})], nothing)).toEqual({ from: "assumed", field: kFields[kAssumed] });
  expect(knownField([], "")).toEqual({ from: "assumed", field: kFields[kAssumed] });
});

test("a forecast reports the rules by which the robot foresees", () => {
  expect(knownField([told({ "/14/2/forecast": { rules: "spl2012:4,half_duration=60" } })], "hsl2026")).toEqual({
    from: "reported",
    field: kFields["spl2012"],
  });
  expect(knownField([told({ "/14/2/forecast": { rules: "" } })], "").from).toBe("assumed");
});

test("a server reports the rules of the game that it records or plays, which a simulation and a forecast precede", () => {
  const server = (rules: string, values = {}) => ({ ...told(values), rules });
  expect(knownField([server("spl2012:5")], "hsl2026")).toEqual({ from: "reported", field: kFields["spl2012"] });
  expect(knownField([server("spl2012", kSimulated)], "")).toMatchObject({ from: "reported", field: { length: 9 } });
  expect(knownField([server("spl2012", { "/14/2/forecast": { rules: "hsl2026" } })], "").field).toEqual(
    kFields["hsl2026"],
  );
  for (const unknown of ["", "spl1999"]) expect(knownField([server(unknown)], "").from).toBe("assumed");
});

test("a field without a size is not reported", () => {
  for (const field of [{}, { length: 9, width: 0 }, { length: NaN, width: 6 }])
    expect(knownField([told({ "/sim/state": { field: fields(field) } })], "").from).toBe("assumed");
});
