// A whole game on a slow disk: are messages lost, and does the recording have the announced size?
import { slowDisk } from "./disk.mjs";
import { startRobot } from "./programs.mjs";
import { Report } from "./report.mjs";

const asAnnounced = { between: [0.85, 1.1] };
const kOwn = ["clock", "runtime", "log"];
const isCamera = (topic) => /\/camera_(top|bottom)$/.test(topic);

/** Number of written messages that the recording lacks; of images it should hold every sixth (5 Hz of 30). */
export function lost(run, everyImage) {
  let missing = 0;
  for (const [topic, written] of Object.entries(run.written)) {
    const recorded = run.recorded.messages[topic] ?? 0;
    if (isCamera(topic)) missing += Math.max(0, Math.floor((written / everyImage) * 0.99) - recorded);
    else if (!kOwn.some((own) => topic.endsWith("/" + own))) missing += Math.abs(written - recorded);
  }
  return missing;
}

export async function half({ minutes = 20, speed = 1 }) {
  const report = new Report("half", "is a game of two halves recorded on a slow disk, and does it fit?");
  const half = minutes / 2; // [min] of the robot's time
  // at a higher speed the bench takes less time
  const disk = slowDisk({
    sizeMb: Math.ceil(40 * half + 200),
    bytesPerSecond: 2e6 * speed,
    stallMs: 200 / speed,
    stallEvery: 5 / speed,
  });
  console.log(`   two halves of ${half} min, ${speed} times as fast; disk: ${disk.words}`);
  const runs = [];
  for (const which of ["first", "second"]) {
    console.log(`   ${which} half …`);
    const robot = await startRobot(
      ["--profile", "game", "--cameras", 2, "--seconds", (half * 60) / speed, "--speed", speed, ...disk.args],
      { logs: disk.folder, before: disk.before },
    );
    runs.push(await robot.report);
  }
  disk.stop();
  for (const [i, run] of runs.entries()) {
    const name = `half ${i + 1}`;
    const written = Object.values(run.written).reduce((a, b) => a + b, 0);
    report.figure(`${name}: lost`, lost(run, 6), `of ${written}`, { exactly: 0 });
    report.figure(`${name}: dropped, as the recorder counts`, run.recorded.dropped, "", { exactly: 0 });
    report.figure(`${name}: damaged`, run.recorded.damaged, "", { exactly: 0 });
    // the files' size beyond their messages counts once per session, not per minute
    const perMinute = run.recorded.size_bytes / 1e6 / ((run.seconds * speed) / 60);
    report.figure(`${name}: size`, perMinute, "MB/min");
    report.figure(
      `${name}: size, part of what was announced`,
      perMinute / run.recorded.announced_mb_per_minute,
      "",
      asAnnounced,
    );
  }

  // the other profiles announce their size too: measured on the real disk
  for (const profile of ["vision", "full"]) {
    const robot = await startRobot(["--profile", profile, "--cameras", 2, "--seconds", Math.min(20, half * 60)]);
    const run = await robot.report;
    const perMinute = run.recorded.size_bytes / 1e6 / (run.seconds / 60);
    report.figure(`profile ${profile}: lost`, lost(run, 1), "", { exactly: 0 });
    report.figure(`profile ${profile}: size`, perMinute, "MB/min");
    report.figure(
      `profile ${profile}: size, part of what was announced`,
      perMinute / run.recorded.announced_mb_per_minute,
      "",
      asAnnounced,
    );
  }
  return report.finish();
}
