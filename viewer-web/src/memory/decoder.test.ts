import { expect, test } from "vitest";
import { decoderOf } from "./decoder";
import { kPerceptChannel, percept } from "./test_schema";
import { EnumValue, fieldsOf, listOf, numberOf, textOf, wordOf } from "./value";

const decode = decoderOf(kPerceptChannel);
const decoded = (json?: Parameters<typeof percept>[0]) => decode(percept(json)).fields!;

test("a message of an unknown schema is shown field by field, in the schema's order", () => {
  const fields = decoded({
    seen_ns: "18446744073709551615",
    offset_ns: "-5",
    x: 1.5,
    side: "SIDE_OWN",
    centre: { x: 1, y: -2 },
    outline: [{ x: 3 }, { y: 4 }],
    weights: [0.5, 0.25],
    data: "AQI=",
    note: "hallo",
    radius: 0,
    sides: ["SIDE_OWN", 7],
    counts: { a: 1, b: 2 },
    ["__proto__"]: true,
  });
  expect([...fields.keys()].slice(0, 4)).toEqual(["seen_ns", "x", "side", "centre"]);
  expect(fields.get("seen_ns")).toBe(18446744073709551615n);
  expect(fields.get("offset_ns")).toBe(-5n);
  expect(numberOf(fields, "x")).toBe(1.5);
  expect(wordOf(fields, "side")).toBe("own");
  expect(numberOf(fieldsOf(fields, "centre"), "y")).toBe(-2);
  expect(listOf(fields, "outline").map((point) => [...point.values()])).toEqual([
    [3, 0],
    [0, 4],
  ]);
  expect(fields.get("weights")).toEqual([0.5, 0.25]);
  expect(fields.get("data")).toEqual(Uint8Array.of(1, 2));
  expect(textOf(fields, "note")).toBe("hallo");
  expect(fields.get("radius")).toBe(0);
  expect(fields.get("sides")).toEqual([new EnumValue(1, "SIDE_OWN"), new EnumValue(7, undefined)]);
  expect(fields.get("counts")).toEqual(
    new Map([
      ["a", 1],
      ["b", 2],
    ]),
  );
});

test("in an empty message, optional fields are absent and the others have their defaults", () => {
  const fields = decoded();
  expect(fields.get("radius")).toBeUndefined();
  expect(fields.get("centre")).toBeUndefined();
  expect(fields.get("x")).toBe(0);
  expect(fields.get("side")).toEqual(new EnumValue(0, "SIDE_UNSPECIFIED"));
  expect(fields.get("outline")).toEqual([]);
});

test("no truncated message makes the decoder throw", () => {
  const whole = percept({ seen_ns: "1", centre: { x: 1, y: 2 }, note: "hallo", weights: [1, 2, 3] });
  for (let length = 0; length < whole.length; ++length) {
    const { fields, error } = decode(whole.subarray(0, length));
    expect(fields !== undefined || /does not fit its schema 'htwk.Percept'/.test(error!)).toBe(true);
  }
});

test("an unreadable schema gives a sentence that names it", () => {
  const broken = [
    { ...kPerceptChannel, schema: "not base64!" },
    { ...kPerceptChannel, schema: "CgUKA2FiYw" },
    { ...kPerceptChannel, schema: "" },
    { ...kPerceptChannel, schemaName: "htwk.Other" },
    { ...kPerceptChannel, encoding: "cdr" },
  ];
  for (const channel of broken)
    expect(decoderOf(channel)(Uint8Array.of()).error).toMatch(`The schema '${channel.schemaName}' cannot be read: `);
});

test("any JSON value is shown as it is", () => {
  const json = decoderOf({ encoding: "json", schemaName: "", schema: "" });
  const of = (text: string) => json(new TextEncoder().encode(text));
  expect(of('{"x": 1.5, "at": [1, {"y": true}], "__proto__": "name", "none": null}').fields).toEqual(
    new Map<string, unknown>([
      ["x", 1.5],
      ["at", [1, new Map([["y", true]])]],
      ["__proto__", "name"],
      ["none", undefined],
    ]),
  );
  expect(of("7").fields).toEqual(new Map([["value", 7]]));
  expect(of('{"x": ').error).toMatch(/^This message is no JSON: /);
  expect(json(Uint8Array.of(0xff, 0xfe)).error).toMatch(/^This message is no JSON: /);
  expect(of("[".repeat(1_000_000)).error).toMatch(/^This message is no JSON: /);
});
