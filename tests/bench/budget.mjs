// What does the runtime cost the robot? Instructions that callgrind counts while the program for the Nao V6 plays a
// recording and records it: as slowly as callgrind needs to play every frame.
import { readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { readSession } from "../e2e/mcap.mjs";
import { recordPictures } from "../nao/pictures.mjs";
import { kAtomInstructions, startCounted } from "./atom.mjs";
import { command, onlySession, scratch, sleep } from "./programs.mjs";
import { Report, pretty } from "./report.mjs";

const kFrameHz = 30;
const kInstructionsPerFrame = kAtomInstructions / kFrameHz;
const kPart = 0.15;

const lab = fileURLToPath(new URL("../../build/release/bin/foresight-lab", import.meta.url));

/** Returns the instructions that playing the first part of `session` takes, and the number of its frames. */
async function instructions({ session, profile, speed, recorded_hz }, seconds) {
  const logs = join(scratch, "budget-logs");
  rmSync(logs, { recursive: true, force: true });
  const robot = startCounted(
    "foresight-robot",
    [
      "--body",
      "replay",
      "--session",
      session,
      "--speed",
      speed,
      "--loop",
      "--record",
      "--profile",
      profile,
      "--port",
      0,
      "--state-dir",
      join(scratch, "state"),
      "--log-dir",
      logs,
    ],
    "nao-v6",
  );
  await robot.firstLine;
  await sleep(seconds);
  robot.stop();
  await robot.output;
  const recording = onlySession(logs);
  const status = JSON.parse(command(lab, "info", "--json", recording));
  const recorded = Math.max(
    ...status.streams
      .filter(({ topic }) => /vision|camera_top$|camera_bottom$/.test(topic))
      .map(({ messages }) => messages),
  );
  return { total: robot.count(), frames: (recorded * kFrameHz) / recorded_hz };
}

/** Instructions per frame, without the start and the end of the program. */
async function perFrame(play, seconds) {
  const short = await instructions(play, seconds / 4);
  const long = await instructions(play, seconds);
  const frames = long.frames - short.frames;
  const kept = frames / (0.75 * seconds * play.speed * kFrameHz);
  if (kept < 0.9)
    throw new Error(`only ${pretty(100 * kept)} % of the frames were played: this machine is too busy to count`);
  return (long.total - short.total) / frames;
}

export async function budget({ seconds = 40 }) {
  const report = new Report("budget", "what does the runtime cost the robot?");
  const session = join(scratch, "budget-session");
  command(lab, "synthesize", session, "--seconds", "10");
  const pictures = await recordPictures(scratch, session, 1);
  const topics = [...readSession(session).keys()];
  for (const file of readdirSync(session).filter((name) => /camera_(top|bottom)\.mcap$/.test(name)))
    rmSync(join(session, file));

  const told = (name, count, bar) => report.figure(name, (100 * count) / kInstructionsPerFrame, "% of a core", bar);
  const objects = await perFrame({ session, profile: "game", speed: 1, recorded_hz: kFrameHz }, seconds);
  report.figure("instructions per frame, all objects but images", objects / 1e6, "million");
  told(`${topics.length} objects at their rates, recorded in profile game, no images`, objects, {
    atMost: 100 * kPart,
  });
  told(
    "two cameras of 640x480 at 30 Hz as JPEG 320x240 at 5 Hz (profile game), besides",
    await perFrame({ session: pictures, profile: "game", speed: 0.1, recorded_hz: 5 }, 3 * seconds),
  );
  told(
    "two cameras of 640x480 at 30 Hz as they are (profile full), besides",
    await perFrame({ session: pictures, profile: "full", speed: 0.1, recorded_hz: kFrameHz }, 3 * seconds),
  );
  return report.finish();
}
