// Recordings as the independent library @mcap/core reads them.
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { require } from "./support.mjs";

const { McapIndexedReader, McapStreamReader, McapWriter } = require("@mcap/core");
const { crc32Final, crc32Init, crc32Update } = require("@foxglove/crc");
const lz4 = require("@foxglove/wasm-lz4").default ?? require("@foxglove/wasm-lz4");
const zstd = require("@foxglove/wasm-zstd");
await Promise.all([lz4.isLoaded, zstd.isLoaded]);

const kLz4Magic = 0x184d2204;

/** Returns the frames of `bytes` without the skippable ones. The library below reads only one frame at a time. */
function lz4Frames(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const frames = [];
  for (let at = 0; at < bytes.length;) {
    const begin = at;
    if (view.getUint32(at, true) !== kLz4Magic) {
      at += 8 + view.getUint32(at + 4, true);
      continue;
    }
    const flags = view.getUint8(at + 4);
    const [blockChecksum, contentSize, contentChecksum, dictionary] = [0x10, 0x08, 0x04, 0x01].map(
      (bit) => (flags & bit) !== 0,
    );
    at += 4 + 2 + (contentSize ? 8 : 0) + (dictionary ? 4 : 0) + 1;
    for (let size = 1; size !== 0;) {
      size = view.getUint32(at, true) & 0x7fffffff;
      at += 4 + size + (blockChecksum && size !== 0 ? 4 : 0);
    }
    at += contentChecksum ? 4 : 0;
    frames.push(bytes.subarray(begin, at));
  }
  return frames;
}

const decompressHandlers = {
  lz4: (bytes, size) => Buffer.concat(lz4Frames(bytes).map((frame) => lz4(frame, Number(size)))),
  zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
};

class Contents {
  /** topic -> {schema, messages}, messages in the order of the file */
  topics = new Map();
  metadata = new Map();
  chunks = [];
  #channels = new Map();
  #schemas = new Map();

  take(record) {
    if (record.type === "Schema") this.#schemas.set(record.id, record);
    if (record.type === "Metadata") this.metadata.set(record.name, Object.fromEntries(record.metadata));
    if (record.type === "Chunk") this.chunks.push({ start: record.messageStartTime, end: record.messageEndTime });
    if (record.type === "Channel" && !this.#channels.has(record.id)) {
      const stream = { schema: this.#schemas.get(record.schemaId), messages: [] };
      this.#channels.set(record.id, stream);
      this.topics.set(record.topic, stream);
    }
    if (record.type === "Message") this.#channels.get(record.channelId).messages.push(plain(record));
  }
}

const plain = ({ sequence, logTime, publishTime, data }) => ({
  sequence,
  logTime,
  publishTime,
  data: Buffer.from(data),
});

/**
 * Reads a whole file from the front, as from a network, and checks every checksum. A file of a killed program has no end, and
 * can be `unfinished` if that is allowed.
 */
export function readStreamed(bytes, { allowUnfinished = false } = {}) {
  const reader = new McapStreamReader({ includeChunks: true, decompressHandlers, validateCrcs: true });
  const contents = new Contents();
  reader.append(bytes);
  for (let record; (record = reader.nextRecord());) contents.take(record);
  contents.unfinished = !reader.done();
  if (contents.unfinished && !allowUnfinished) throw new Error("the MCAP has no end");
  return contents;
}

/**
 * Returns the number of messages of a file, and a checksum over all of them in the order of their log times. Messages of
 * one time are in the order of the file. `tests/support/mcap_files.cpp` returns the same of our reader.
 */
export function sumsOf(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  const messages = [];
  reader.append(bytes);
  for (let record; (record = reader.nextRecord());) if (record.type === "Message") messages.push(record);
  if (!reader.done()) throw new Error("the MCAP has no end");
  messages.sort((left, right) => (left.logTime < right.logTime ? -1 : left.logTime > right.logTime ? 1 : 0));
  let digest = crc32Init();
  const head = Buffer.alloc(22);
  for (const { channelId, sequence, logTime, publishTime, data } of messages) {
    head.writeUInt16LE(channelId, 0);
    head.writeUInt32LE(sequence, 2);
    head.writeBigUInt64LE(logTime, 6);
    head.writeBigUInt64LE(publishTime, 14);
    digest = crc32Update(crc32Update(digest, head), data);
  }
  return { messages: messages.length, digest: crc32Final(digest) };
}

/**
 * Compares what we found in a generated file, a line of `mcap_files read`, with what @mcap/core finds in its bytes.
 * Returns a sentence about a difference, or nothing.
 */
export function difference(ours, bytes) {
  if (ours.error) return ours.error;
  if (ours.shown + ours.left_out !== ours.messages)
    return `expected ${ours.messages} messages in the streams, got ${ours.shown} and ${ours.left_out} left out`;
  if (ours.left_out + ours.unreadable > 0 && ours.sentences.length === 0)
    return "messages are left out without a sentence";
  if (ours.messages !== ours.written) return `expected ${ours.written} messages as written, got ${ours.messages}`;
  if (!ours.valid) return undefined; // @mcap/core refuses damaged records
  const theirs = sumsOf(bytes);
  if (theirs.messages === ours.messages && theirs.digest === ours.digest) return undefined;
  return `expected ${theirs.messages} messages with checksum ${theirs.digest}, got ${ours.messages} with ${ours.digest}`;
}

/** Reads a whole file by its index, as viewers do: messages by topic, in the order of their log times. */
export async function readIndexed(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const messages = new Map([...reader.channelsById.values()].map(({ topic }) => [topic, []]));
  for await (const message of reader.readMessages())
    messages.get(reader.channelsById.get(message.channelId).topic).push(plain(message));
  return messages;
}

/** Reads all streams of a session on the disk, by topic. */
export function readSession(folder) {
  const files = readdirSync(folder).filter((file) => file.endsWith(".mcap"));
  return new Map(files.flatMap((file) => [...readStreamed(readFileSync(join(folder, file))).topics]));
}

/** Returns the first and the last log time [ns] of the messages in `topics`: topic → {messages}. */
export function spanOf(topics) {
  const times = [...topics.values()].flatMap(({ messages }) => messages.map(({ logTime }) => logTime));
  return { first_ns: times.reduce((a, b) => (a < b ? a : b)), last_ns: times.reduce((a, b) => (a > b ? a : b)) };
}

/**
 * A file of many channels as @mcap/core writes it: of `channels` {topic, encoding, schema: {name, encoding, data} or none}
 * each message of `messages` {topic, logTime, data}.
 */
export async function mcapOf(channels, messages, options = {}) {
  const pieces = [];
  let size = 0n;
  const writable = {
    position: () => size,
    write: async (bytes) => {
      pieces.push(Buffer.from(bytes));
      size += BigInt(bytes.length);
    },
  };
  const writer = new McapWriter({ writable, ...options });
  await writer.start({ profile: "", library: "somebody else" });
  const ids = new Map();
  for (const { topic, encoding, schema } of channels) {
    const schemaId = schema ? await writer.registerSchema(schema) : 0;
    ids.set(topic, await writer.registerChannel({ topic, messageEncoding: encoding, schemaId, metadata: new Map() }));
  }
  for (const [sequence, { topic, logTime, data }] of messages.entries())
    await writer.addMessage({ channelId: ids.get(topic), sequence, logTime, publishTime: logTime, data });
  await writer.end();
  return Buffer.concat(pieces);
}

/** Writes a session with one stream, as another program would: `schema` is {name, data}. */
export async function writeSession(folder, { name, topic, schema, messages }) {
  mkdirSync(folder);
  const channel = { topic, encoding: "protobuf", schema: { encoding: "protobuf", ...schema } };
  writeFileSync(
    join(folder, "stream.mcap"),
    await mcapOf(
      [channel],
      messages.map((message) => ({ topic, ...message })),
    ),
  );
  const info = { name, robot: "14/2", team: 14, player: 2, build: "", profile: "full", kept: false, complete: true };
  writeFileSync(join(folder, "session.json"), JSON.stringify({ ...info, start_ns: String(messages[0].logTime) }));
}
