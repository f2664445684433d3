// A recording of full-size pictures of both cameras, as a Nao's driver delivers them.
import { renameSync } from "node:fs";
import { join } from "node:path";
import { readSession, writeSession } from "../e2e/mcap.mjs";

const kWidth = 640,
  kHeight = 480,
  kHz = 30,
  kYuyv = 1; // as in proto/foresight/camera.proto
const kBegin_ns = 1_800_000_000_000_000_000n;

function varint(number) {
  const bytes = [];
  for (; number > 127; number = Math.floor(number / 128)) bytes.push((number % 128) + 128);
  return [...bytes, number];
}

/** A foresight.Image: a slope with some noise, which moves with `frame`. */
function image(frame) {
  const data = Buffer.alloc(2 * kWidth * kHeight);
  for (let i = 0, noise = 1; i < data.length; ++i) {
    noise = (noise * 75 + 74) % 65537;
    data[i] = i % 2 ? 128 : ((i >> 3) + 5 * frame + (noise & 15)) & 255;
  }
  return Buffer.concat([
    Buffer.from([0x08, kYuyv, 0x10, ...varint(kWidth), 0x18, ...varint(kHeight), 0x22, ...varint(data.length)]),
    data,
  ]);
}

/** Writes `seconds` of them as robot 14/2 into `folder`/pictures; the schema is that of the recording `like`. */
export async function recordPictures(folder, like, seconds) {
  const session = join(folder, "pictures");
  const { schema } = readSession(like).get("/14/2/camera_top");
  const messages = Array.from({ length: Math.ceil(seconds * kHz) }, (_, frame) => ({
    logTime: kBegin_ns + BigInt(Math.round((frame * 1e9) / kHz)),
    data: image(frame),
  }));
  const write = (place, camera) =>
    writeSession(place, { name: "pictures", topic: `/14/2/${camera}`, schema, messages });
  await write(session, "camera_top");
  await write(join(folder, "bottom"), "camera_bottom");
  renameSync(join(folder, "bottom/stream.mcap"), join(session, "bottom.mcap"));
  return session;
}
