// Reads the recording of one object: an MCAP file as the robot serves it. https://mcap.dev/spec

import { decompress as unpackZstd } from "fzstd";
import { base64Encode } from "@bufbuild/protobuf/wire";
import { unpackLz4 } from "./lz4";

export interface Recorded {
  topic: string;
  encoding: string;
  schemaName: string;
  /** The schema's bytes, encoded as in a live channel. */
  schema: string;
  messages: { log_ns: bigint; data: Uint8Array }[];
  /** One sentence about the unreadable part, or "" if all was read. */
  damage: string;
}

const kMagic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const kOp = { schema: 3, channel: 4, message: 5, chunk: 6, dataEnd: 15 };
const kMostBytes = 64e6; // [bytes] of a chunk; ours have 256 kB

const kNothing: Recorded = { topic: "", encoding: "", schemaName: "", schema: "", messages: [], damage: "" };

/**
 * Returns the first channel of a file and its messages in file order. Never throws: `damage` describes an unreadable
 * part.
 */
export function recordedIn(file: Uint8Array): Recorded {
  const { channels, damage } = channelsIn(file);
  return { ...(channels[0] ?? kNothing), damage };
}

/** Returns all channels of a file, likewise. */
export function channelsIn(file: Uint8Array): { channels: Recorded[]; damage: string } {
  if (!kMagic.every((byte, i) => file[i] === byte)) return { channels: [], damage: "it is no MCAP file" };
  const reader = new Reader();
  let damage = "";
  try {
    reader.records(file.subarray(kMagic.length));
  } catch (error) {
    damage = (error as Error).message;
  }
  return { channels: [...reader.channels.values()], damage };
}

class Reader {
  readonly channels = new Map<number, Recorded>();
  #schemas = new Map<number, { name: string; data: Uint8Array }>();

  /** Reads records until the data end. */
  records(bytes: Uint8Array): void {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at < bytes.length;) {
      if (at + 9 > bytes.length) throw new Error("it is cut short");
      const [op, length] = [view.getUint8(at), Number(view.getBigUint64(at + 1, true))];
      if (op === kOp.dataEnd) return;
      if (at + 9 + length > bytes.length) throw new Error("it is cut short");
      this.#record(op, bytes.subarray(at + 9, at + 9 + length));
      at += 9 + length;
    }
  }

  #record(op: number, body: Uint8Array): void {
    const fields = new Fields(body);
    if (op === kOp.schema) {
      const id = fields.u16();
      const name = fields.text();
      fields.text(); // the schema's encoding is not used; the channel has it too
      this.#schemas.set(id, { name, data: fields.bytes() });
    } else if (op === kOp.channel) {
      const id = fields.u16();
      const schema = this.#schemas.get(fields.u16());
      const known = this.channels.get(id); // a chunk may repeat it
      this.channels.set(id, {
        ...kNothing,
        topic: fields.text(),
        encoding: fields.text(),
        schemaName: schema?.name ?? "",
        schema: base64Encode(schema?.data ?? new Uint8Array()),
        messages: known?.messages ?? [],
      });
    } else if (op === kOp.message) {
      const channel = this.channels.get(fields.u16());
      fields.skip(4);
      const log_ns = fields.u64();
      fields.skip(8);
      channel?.messages.push({ log_ns, data: fields.rest() });
    } else if (op === kOp.chunk) this.#chunk(fields);
  }

  #chunk(fields: Fields): void {
    fields.skip(16);
    const size = Number(fields.u64());
    fields.skip(4);
    const compression = fields.text();
    if (size > kMostBytes) throw new Error(`a chunk says that it holds ${size} bytes`);
    const packed = fields.bytes(Number(fields.u64()));
    if (compression === "") this.records(packed);
    else if (compression === "lz4") this.records(unpackLz4(packed, size));
    else if (compression === "zstd") this.records(unpackZstd(packed, new Uint8Array(size)));
    else throw new Error(`a chunk is compressed with '${compression}'`);
  }
}

/** Reads one field after the other. Throws if bytes are missing. */
class Fields {
  #at = 0;
  #view: DataView;

  constructor(readonly body: Uint8Array) {
    this.#view = new DataView(body.buffer, body.byteOffset, body.byteLength);
  }
  skip(bytes: number): void {
    this.#at += bytes;
  }
  u16(): number {
    return this.#view.getUint16((this.#at += 2) - 2, true);
  }
  u32(): number {
    return this.#view.getUint32((this.#at += 4) - 4, true);
  }
  u64(): bigint {
    return this.#view.getBigUint64((this.#at += 8) - 8, true);
  }
  bytes(length = this.u32()): Uint8Array {
    if (this.#at + length > this.body.length) throw new Error("a record is cut short");
    return this.body.subarray(this.#at, (this.#at += length));
  }
  text(): string {
    return new TextDecoder().decode(this.bytes());
  }
  rest(): Uint8Array {
    return this.body.subarray(this.#at);
  }
}
