import { expect, test } from "vitest";
import { EnumValue, type Value } from "../memory/value";
import { pictureOf } from "./picture";

const message = (entries: Record<string, Value>) => pictureOf(new Map(Object.entries(entries)));
const kYuyv = { encoding: new EnumValue(1, "ENCODING_YUYV"), width: 4, height: 2, data: new Uint8Array(16) };

test("our images and Foxglove's are pictures alike", () => {
  expect(message(kYuyv)).toMatchObject({ kind: "yuyv", width: 4, height: 2 });
  expect(message({ ...kYuyv, encoding: "yuyv", step: 8 })).toMatchObject({ kind: "yuyv" });
  expect(message({ ...kYuyv, encoding: new EnumValue(2, "ENCODING_JPEG") })).toMatchObject({ kind: "jpeg" });
  expect(message({ format: "jpeg", data: new Uint8Array(3) })).toMatchObject({ kind: "jpeg" });
});

test("an image that cannot be drawn gives the reason", () => {
  const cases: [Record<string, Value>, string][] = [
    [{ ...kYuyv, data: new Uint8Array(15) }, "takes 16 bytes, the message has 15"],
    [{ ...kYuyv, width: 3, data: new Uint8Array(12) }, "width must be even"],
    [{ ...kYuyv, width: 0, data: new Uint8Array() }, "0 x 2"],
    [{ ...kYuyv, width: 2 ** 31, height: 2 ** 31 }, "at most 16 million pixels"],
    [{ ...kYuyv, encoding: new EnumValue(0, "ENCODING_UNSPECIFIED") }, "'unspecified'"],
    [{ ...kYuyv, data: "text" }, "no field 'data'"],
    [{ format: "jpeg", data: new Uint8Array() }, "empty"],
  ];
  for (const [entries, why] of cases)
    expect(message(entries)).toMatchObject({ kind: "none", why: expect.stringContaining(why) });
});
