import { expect, test } from "vitest";
import { readFrame, writePlaybackWish, writeServiceCall } from "./frames";

const bytes = (hex: string) => Uint8Array.from(hex.match(/../g) ?? [], (pair) => parseInt(pair, 16));
const hex = (data: Uint8Array) => Array.from(data, (byte) => byte.toString(16).padStart(2, "0")).join("");
const text = (data: Uint8Array) => new TextDecoder().decode(data);

// Test vectors from the Foxglove SDK.
const kTime = "02d202964900000000";
const kResponse = "030a0000000c000000040000006a736f6e7b226b6579223a202276616c7565227d";
const kMessage = "0107000000" + "15cd853dfe9c9717" + "08012a";
const kPlayback = "050039300000000000000000803f0100000000";
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

test("a service call has the same bytes as from the Foxglove SDK", () => {
  const data = new TextEncoder().encode('{"key": "value"}');
  expect(hex(writeServiceCall(10, 12, "json", data))).toBe(kServiceCall);
});

test("a playback state holds time, speed and the request that it answers", () => {
  const state = { status: "playing", time_ns: 12345n, speed: 1, didSeek: true, request: "" };
  expect(readFrame(bytes(kPlayback).buffer)).toEqual({ kind: "playback", state });
  const answer = bytes(`${kPlayback.slice(0, -8)}02000000${hex(new TextEncoder().encode("r7"))}`);
  expect(readFrame(answer.buffer)).toMatchObject({ state: { request: "r7" } });
  answer[1] = 4;
  expect(readFrame(answer.buffer)).toMatchObject({ kind: "malformed", why: expect.stringContaining("got 4") });
});

test("a playback wish has the same bytes as from the Foxglove SDK", () => {
  const of = (wish: Parameters<typeof writePlaybackWish>[0]) => hex(writePlaybackWish(wish, "some-id"));
  expect(of({ play: true, speed: 1 })).toBe("03000000803f00000000000000000007000000736f6d652d6964");
  expect(of({ play: false, speed: 1 })).toBe("03010000803f00000000000000000007000000736f6d652d6964");
  expect(of({ play: true, speed: 1, seek_ns: 123456789n })).toBe(
    "03000000803f0115cd5b070000000007000000736f6d652d6964",
  );
});

test("every truncated frame is malformed or has a shorter payload, and never throws", () => {
  for (const whole of [kTime, kResponse, kMessage, kPlayback].map(bytes)) {
    const least = { 1: 13, 2: 9, 3: 17, 5: 19 }[whole[0]!]!;
    for (let length = 0; length < whole.length; ++length) {
      const frame = readFrame(whole.slice(0, length).buffer);
      expect(frame.kind === "malformed", `opcode ${whole[0]}, ${length} bytes`).toBe(length < least);
    }
  }
});

test("an encoding that is longer than the frame is malformed", () => {
  const frame = bytes(kResponse);
  frame.fill(0xff, 9, 13);
  expect(readFrame(frame.buffer)).toMatchObject({ kind: "malformed" });
});

test("the opcode of an asset is unknown, but no error", () => {
  expect(readFrame(bytes("040a000000000000000064617461").buffer).kind).toBe("unknown");
});
