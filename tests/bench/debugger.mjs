// How long does a person wait for the debugger in a game of 20 minutes and in the viewer, and what do traces cost?
import { statSync } from "node:fs";
import { join } from "node:path";
import { scratch, start } from "./programs.mjs";
import { median, Report } from "./report.mjs";
import { workspace } from "./workspace.mjs";

const kSeed = 7;
const kHalf = 600; // [s]
const kPlaces = 200;
const kPlayers = 4; // of a side, in bench_debugger, too

export async function debuggerTimes({ games = 100 }) {
  const report = new Report("debugger", "does a person wait for the past of a game?");
  const seen = await start("bench_debugger", [kSeed, kHalf, kPlaces, games]).report;
  const minutes = seen.ticks / 1800;
  report.figure("length of the game", minutes, "min");
  report.figure("going to a tick: median", median(seen.goto_ms), "ms");
  report.figure("going to a tick: slowest", Math.max(...seen.goto_ms), "ms", { atMost: 50 });
  report.figure("going to a tick without key frames: slowest", Math.max(...seen.cold_goto_ms), "ms", { atMost: 50 });
  report.figure("key frames", seen.key_frames_bytes / 1e6, "MB", { atMost: 16 });
  for (const [condition, ms] of Object.entries(seen.search_ms))
    report.figure(`searching the whole game for '${condition}'`, ms / 1000, "s", { atMost: 1 });
  report.figure("a game without traces", seen.game_ms, "ms");
  report.figure("traces of all robots: longer by", 100 * (seen.traced_game_ms / seen.game_ms - 1), "%", { atMost: 10 });
  const file = join(scratch, "game.mcap");
  const rules = `spl2012:${kPlayers},half_duration=${kHalf}`;
  await start("foresight-sim", ["match", "--seed", kSeed, "--rules", rules, "--mcap", file]).output;
  // beliefs and truth are in the file, too: the traces alone need less
  const mb = statSync(file).size / 1e6 / (2 * kPlayers * minutes);
  report.figure("recording with traces, of a robot and minute", mb, "MB", { atMost: 1 });
  await workspace(report);
  return report.finish();
}
