// What does the runtime cost the robot? Instructions that callgrind counts while the program for the Nao V6 plays a
// recording in real time and records it.
import { readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { readSession } from "../e2e/mcap.mjs";
import { recordPictures } from "../nao/pictures.mjs";
import { command, scratch, sleep, start } from "./programs.mjs";
import { Report, pretty } from "./report.mjs";

const kFrameHz = 30;
const kInstructionsPerFrame = (1.6e9 * 0.7) / kFrameHz; // of one Atom core of 1.6 GHz, at 0.7 instructions per cycle
const kPart = 0.15;

const lab = fileURLToPath(new URL("../../build/release/bin/foresight-lab", import.meta.url));

/** How many instructions it takes to play `session` for so long, from the start on, and how many frames that were. */
async function instructions(session, profile, seconds) {
  const logs = join(scratch, "budget-logs"), counts = join(scratch, "budget.callgrind");
  rmSync(logs, { recursive: true, force: true });
  const robot = start("foresight-robot", ["--body", "replay", "--session", session, "--loop", "--record", "--profile", profile, "--port", 0,
    "--state-dir", join(scratch, "state"), "--log-dir", logs],
  ["valgrind", "--quiet", "--tool=callgrind", `--callgrind-out-file=${counts}`], "nao-v6");
  await robot.firstLine;
  await sleep(seconds);
  robot.stop();
  await robot.output;
  const recording = join(logs, readdirSync(logs)[0]);
  const status = JSON.parse(command(lab, "info", "--json", recording));
  const total = Number(/^(?:summary|totals): (\d+)/m.exec(command("grep", "-E", "^(summary|totals):", counts))[1]);
  const frames = Math.max(...status.streams.filter(({ topic }) => /vision|camera_top$|camera_bottom$/.test(topic)).map(({ messages }) => messages));
  return { total, frames };
}

/** Instructions per frame, the start and the end of the program left out. */
async function perFrame(session, profile, seconds) {
  const short = await instructions(session, profile, seconds / 4);
  const long = await instructions(session, profile, seconds);
  const frames = long.frames - short.frames;
  const kept = frames / ((0.75 * seconds) * kFrameHz);
  if (kept < 0.9) throw new Error(`only ${pretty(100 * kept)} % of the frames were played: this machine is too busy to count`);
  return (long.total - short.total) / frames;
}

export async function budget({ seconds = 40 }) {
  const report = new Report("budget", "what does the runtime cost the robot?");
  const session = join(scratch, "budget-session");
  command(lab, "synthesize", session, "--seconds", "10");
  const pictures = await recordPictures(scratch, session, 1);
  const topics = [...readSession(session).keys()];
  for (const file of readdirSync(session).filter((name) => /camera_(top|bottom)\.mcap$/.test(name))) rmSync(join(session, file));

  const told = (name, count, bar) => report.figure(name, (100 * count) / kInstructionsPerFrame, "% of a core", bar);
  const objects = await perFrame(session, "game", seconds);
  report.figure("instructions per frame, all objects but images", objects / 1e6, "million");
  told(`${topics.length} objects at their rates, recorded in profile game, no images`, objects, { atMost: 100 * kPart });
  told("two cameras of 640x480 at 30 Hz as JPEG 320x240 at 5 Hz (profile game), besides", await perFrame(pictures, "game", seconds));
  told("two cameras of 640x480 at 30 Hz as they are (profile full), besides", await perFrame(pictures, "full", seconds));
  return report.finish();
}
