// Decompresses LZ4 frames, the format of recorded chunks. https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md

const kMagic = 0x184d2204;

/**
 * Returns the `size` [bytes] that `frame` was compressed from. Throws an Error with a sentence if the frame is
 * damaged.
 */
export function unpackLz4(frame: Uint8Array, size: number): Uint8Array {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  if (frame.length < 7 || view.getUint32(0, true) !== kMagic) throw new Error("expected an LZ4 frame");
  const flags = view.getUint8(4);
  const [hasBlockSums, hasSize, hasDictionary] = [flags & 16, flags & 8, flags & 1];
  let at = 7 + (hasSize ? 8 : 0) + (hasDictionary ? 4 : 0);
  const out = new Uint8Array(size);
  let end = 0; // of the decompressed bytes
  while (at + 4 <= frame.length) {
    const word = view.getUint32(at, true);
    at += 4;
    if (word === 0) break;
    const [length, packed] = [word & 0x7fffffff, word >>> 31 === 0];
    if (at + length > frame.length) throw new Error("the LZ4 frame is cut short");
    const block = frame.subarray(at, at + length);
    if (packed) end = unpackBlock(block, out, end);
    else if (end + length > size) throw new Error("the LZ4 frame holds more than it should");
    else {
      out.set(block, end);
      end += length;
    }
    at += length + (hasBlockSums ? 4 : 0);
  }
  if (end !== size) throw new Error(`the LZ4 frame holds ${end} bytes, expected ${size}`);
  return out;
}

/** Appends the decompressed `block` to the first `end` bytes of `out`. Returns the new end. */
function unpackBlock(block: Uint8Array, out: Uint8Array, end: number): number {
  let at = 0;
  const lengthOf = (short: number): number => {
    let length = short;
    if (short === 15)
      for (let more = 255; more === 255; length += more) {
        if (at >= block.length) throw new Error("an LZ4 block is cut short");
        more = block[at++]!;
      }
    return length;
  };
  while (at < block.length) {
    const token = block[at++]!;
    const literals = lengthOf(token >> 4);
    if (at + literals > block.length || end + literals > out.length) throw new Error("an LZ4 block does not fit");
    out.set(block.subarray(at, at + literals), end);
    at += literals;
    end += literals;
    if (at >= block.length) break; // the last sequence has literals only
    const offset = block[at]! | (block[at + 1]! << 8);
    at += 2;
    const copied = 4 + lengthOf(token & 15);
    if (offset === 0 || offset > end || end + copied > out.length)
      throw new Error("an LZ4 block refers to what is not there");
    for (let i = 0; i < copied; ++i, ++end) out[end] = out[end - offset]!; // the copy may overlap its source
  }
  return end;
}
