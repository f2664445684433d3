// CRC-32 as zlib has it; Node has had one of its own only since 22.
import { createReadStream } from "node:fs";

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value;
});

/** Goes on with `bytes` where `crc`, that of all bytes before, ended; 0 begins. */
export function crc32(bytes, crc = 0) {
  let value = ~crc;
  for (let i = 0; i < bytes.length; ++i) value = table[(value ^ bytes[i]) & 255] ^ (value >>> 8);
  return ~value >>> 0;
}

/** Of a whole file: eight hexadecimal digits. */
export async function crc32OfFile(path) {
  let crc = 0;
  for await (const piece of createReadStream(path, { highWaterMark: 1 << 20 })) crc = crc32(piece, crc);
  return crc.toString(16).padStart(8, "0");
}
