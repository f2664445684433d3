import { expect, test } from "vitest";
import { readFrame, writeServiceCall } from "./frames";

const bytes = (hex: string) => Uint8Array.from(hex.match(/../g) ?? [], (pair) => parseInt(pair, 16));
const hex = (data: Uint8Array) => Array.from(data, (byte) => byte.toString(16).padStart(2, "0")).join("");
const text = (data: Uint8Array) => new TextDecoder().decode(data);

// Vectors of the Foxglove SDK's own tests.
const kTime = "02d202964900000000";
const kResponse = "030a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d";
const kMessage = "0107000000" + "15cd853dfe9c9717" + "08012a";
const kServiceCall = "020a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d";

test("a Time frame carries the server's clock", () => {
  expect(readFrame(bytes(kTime).buffer)).toEqual({ kind: "time", now_ns: 1234567890n });
});

test("a message carries subscription, capture time and payload", () => {
  const frame = readFrame(bytes(kMessage).buffer);
  expect(frame).toMatchObject({ kind: "message", subscription: 7, log_ns: 1700000000123456789n });
  expect(frame.kind === "message" && hex(frame.data)).toBe("08012a");
});

test("a service response carries call, encoding and payload", () => {
  const frame = readFrame(bytes(kResponse).buffer);
  expect(frame).toMatchObject({ kind: "response", service: 10, call: 12, encoding: "json" });
  expect(frame.kind === "response" && text(frame.data)).toBe('{"key": "value"}');
});

test("a service call is written as the SDK writes it", () => {
  const data = new TextEncoder().encode('{"key": "value"}');
  expect(hex(writeServiceCall(10, 12, "json", data))).toBe(kServiceCall);
});

test("every truncation of a frame is malformed or has less payload, and never throws", () => {
  for (const whole of [kTime, kResponse, kMessage].map(bytes)) {
    const least = { 1: 13, 2: 9, 3: 17 }[whole[0]!]!;
    for (let length = 0; length < whole.length; ++length) {
      const frame = readFrame(whole.slice(0, length).buffer);
      expect(frame.kind === "malformed", `opcode ${whole[0]}, ${length} bytes`).toBe(length < least);
    }
  }
});

test("an encoding longer than the frame is malformed", () => {
  const frame = bytes(kResponse);
  frame.fill(0xff, 9, 13);
  expect(readFrame(frame.buffer)).toMatchObject({ kind: "malformed" });
});

test("opcodes of asset and playback frames are unknown to us, not errors", () => {
  for (const frame of ["040a000000000000000064617461", "050039300000000000000000803f0000000000"])
    expect(readFrame(bytes(frame).buffer).kind).toBe("unknown");
});
