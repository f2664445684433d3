import lz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";
import { McapWriter } from "@mcap/core";
import { expect, test } from "vitest";
import { unpackLz4 } from "./lz4";
import { recordedIn } from "./mcap";

await Promise.all([lz4.isLoaded, zstd.isLoaded]);

/** Returns an LZ4 frame of `text`. Repeats of at least four bytes become references to earlier bytes. */
function packed(text: Uint8Array): Uint8Array {
  const block: number[] = [];
  const seen = new Map<number, number>();
  const length = (value: number) => {
    for (value -= 15; value >= 255; value -= 255) block.push(255);
    block.push(value);
  };
  let from = 0;
  const put = (until: number, offset: number, copied: number) => {
    const literals = until - from;
    block.push((Math.min(15, literals) << 4) | (copied > 0 ? Math.min(15, copied - 4) : 0));
    if (literals >= 15) length(literals);
    for (let i = from; i < until; ++i) block.push(text[i]!);
    if (copied === 0) return;
    block.push(offset & 255, offset >> 8);
    if (copied - 4 >= 15) length(copied - 4);
    from = until + copied;
  };
  for (let at = 0; at + 12 < text.length; ++at) {
    const key = text[at]! | (text[at + 1]! << 8) | (text[at + 2]! << 16) | (text[at + 3]! << 24);
    const before = seen.get(key);
    seen.set(key, at);
    if (at < from || before === undefined || at - before > 65535) continue;
    let copied = 4;
    while (at + copied < text.length - 5 && text[before + copied] === text[at + copied]) ++copied;
    put(at, at - before, copied);
  }
  if (text.length > 0) put(text.length, 0, 0);
  const frame = new Uint8Array(7 + (text.length > 0 ? 4 + block.length : 0) + 4);
  const view = new DataView(frame.buffer);
  frame.set([0x04, 0x22, 0x4d, 0x18, 0x60, 0x70, 0x73]);
  if (text.length > 0) view.setUint32(7, block.length, true);
  frame.set(block, text.length > 0 ? 11 : 7);
  return frame;
}

/** Writes a recording with another library. */
async function written(compression: "" | "lz4" | "zstd", count = 200): Promise<Uint8Array> {
  let file = new Uint8Array();
  const write = async (bytes: Uint8Array) => {
    const longer = new Uint8Array(file.length + bytes.length);
    longer.set(file);
    longer.set(bytes, file.length);
    file = longer;
  };
  const packer = { "": undefined, lz4: packed, zstd: (data: Uint8Array) => zstd.compress(data) }[compression];
  const writer = new McapWriter({
    writable: { position: () => BigInt(file.length), write },
    chunkSize: 2000,
    ...(packer && { compressChunk: (data: Uint8Array) => ({ compression, compressedData: packer(data) }) }),
  });
  await writer.start({ profile: "", library: "" });
  const schemaId = await writer.registerSchema({ name: "a.B", encoding: "protobuf", data: Uint8Array.of(1, 2, 3) });
  const channelId = await writer.registerChannel({
    topic: "/14/2/game",
    messageEncoding: "protobuf",
    schemaId,
    metadata: new Map(),
  });
  for (let i = 0; i < count; ++i)
    await writer.addMessage({
      channelId,
      sequence: i,
      logTime: BigInt(i),
      publishTime: 0n,
      data: new Uint8Array(30).fill(i % 7),
    });
  await writer.end();
  return file;
}

test("a recording is read exactly as it was written, with each compression", async () => {
  for (const compression of ["", "lz4", "zstd"] as const) {
    const recorded = recordedIn(await written(compression));
    expect(recorded, compression).toMatchObject({
      topic: "/14/2/game",
      encoding: "protobuf",
      schemaName: "a.B",
      schema: "AQID",
      damage: "",
    });
    expect(recorded.messages.map(({ log_ns }) => Number(log_ns))).toEqual(Array.from({ length: 200 }, (_, i) => i));
    expect(recorded.messages[12]!.data).toEqual(new Uint8Array(30).fill(5));
  }
});

test("the readable beginning of a truncated or damaged file is returned, with a sentence about the damage", async () => {
  const file = await written("lz4", 60);
  for (let length = 0; length < file.length - 8; length += 7) {
    const { messages, damage } = recordedIn(file.slice(0, length));
    expect(messages.length).toBeLessThanOrEqual(60);
    if (messages.length < 60) expect(damage).not.toBe("");
  }
  for (let at = 8; at < file.length; at += 11) {
    const damaged = file.slice();
    damaged[at]! ^= 0xff;
    recordedIn(damaged); // throws never
  }
});

test("LZ4 of repeating and of random bytes gives the same bytes again", () => {
  let random = 1;
  const noise = Uint8Array.from({ length: 70_000 }, () => (random = (random * 48271) % 2147483647) & 255);
  const texts = [
    new Uint8Array(),
    Uint8Array.of(7),
    new Uint8Array(70_000).fill(3),
    noise,
    Uint8Array.from(noise, (_, i) => noise[i % 300]!),
    noise.subarray(0, 100),
  ];
  for (const text of texts) {
    const frame = packed(text);
    const same = (bytes: Uint8Array) => Buffer.compare(bytes, text) === 0;
    if (text.length > 0) expect(same(lz4(frame, text.length))).toBe(true); // another library accepts the frame too
    expect(same(unpackLz4(frame, text.length))).toBe(true);
  }
  expect(packed(texts[2]!).length).toBeLessThan(1000);
  expect(() => unpackLz4(packed(noise), 5)).toThrow();
});
