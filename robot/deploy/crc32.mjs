// CRC-32 as in zlib; Node has its own only since version 22.
import { createReadStream } from "node:fs";

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value;
});

/** Returns the checksum after `bytes`; `crc` is that of all bytes before them, 0 at the beginning. */
export function crc32(bytes, crc = 0) {
  let value = ~crc;
  for (let i = 0; i < bytes.length; ++i) value = table[(value ^ bytes[i]) & 255] ^ (value >>> 8);
  return ~value >>> 0;
}

/** Returns the checksum of a whole file: eight hexadecimal digits. */
export async function crc32OfFile(path) {
  let crc = 0;
  for await (const piece of createReadStream(path, { highWaterMark: 1 << 20 })) crc = crc32(piece, crc);
  return crc.toString(16).padStart(8, "0");
}
