// Download of one file: it resumes an interrupted attempt, and checks the checksum.
import { closeSync, createWriteStream, existsSync, fsyncSync, mkdirSync, openSync, renameSync, rmSync, statSync } from "node:fs";
import { dirname } from "node:path";
import { pipeline } from "node:stream/promises";
import { crc32OfFile } from "./crc32.mjs";
import { RobotFailed } from "./failure.mjs";
import { Refused } from "./recordings.mjs";

const kAttempts = 3;
const kPause_ms = 1000;

const sizeOf = (path) => (existsSync(path) ? statSync(path).size : 0);

/** Returns true if the file at `path` has the expected size and checksum. */
async function isWhole(path, { size_bytes, crc32 }) {
  return existsSync(path) && statSync(path).size === size_bytes && (await crc32OfFile(path)) === crc32;
}

/** Downloads the missing rest of the file to `part`. Calls `arrived` with the size of each piece. */
async function fetchRest(recordings, session, { name, size_bytes }, part, arrived) {
  if (sizeOf(part) > size_bytes) rmSync(part);
  const have = sizeOf(part);
  if (have === size_bytes && have > 0) return;
  const { from, pieces } = await recordings.bytes(session, name, have);
  const counted = async function* (source) {
    for await (const piece of source) {
      arrived(piece.length);
      yield piece;
    }
  };
  try {
    await pipeline(pieces, counted, createWriteStream(part, { flags: from > 0 ? "a" : "w" }));
  } catch (error) {
    if (error.syscall === "write" || error.syscall === "open") throw new RobotFailed(`writing ${part}: ${error.code}`);
    throw new RobotFailed(`the connection was lost: ${error.message}`);
  }
}

/**
 * Downloads `file` ({name, size_bytes, crc32}) of a session to `path`. The bytes first go to `path`.part, which an interrupted
 * download leaves behind. Does nothing if the file is complete already. Throws RobotFailed if the connection does not come
 * back, and Refused if the robot refuses.
 */
export async function bring(recordings, session, file, path, arrived = () => {}) {
  if (await isWhole(path, file)) return arrived(file.size_bytes);
  mkdirSync(dirname(path), { recursive: true });
  const part = `${path}.part`;
  arrived(Math.min(sizeOf(part), file.size_bytes));
  for (let attempt = 1; ; ++attempt) {
    const had = sizeOf(part);
    try {
      await fetchRest(recordings, session, file, part, arrived);
      if (await isWhole(part, file)) break;
      // the part from an earlier attempt may be of a file that has changed since
      rmSync(part, { force: true });
      if (had === 0) throw new RobotFailed(`${session}/${file.name}: the downloaded file does not have the checksum ${file.crc32}`);
      arrived(-file.size_bytes);
    } catch (error) {
      if (error instanceof Refused || attempt === kAttempts) throw error;
      await new Promise((done) => setTimeout(done, kPause_ms));
      if (!(await recordings.isThere())) throw error;
    }
  }
  // the robot may delete its copy after this, so ours must survive a loss of power here
  const written = openSync(part, "r");
  fsyncSync(written);
  closeSync(written);
  renameSync(part, path);
}
