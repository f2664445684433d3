// Do the programs for the Naos run there, and are they small? Their processors are emulated; memory is measured on this one.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { root } from "../e2e/support.mjs";
import { recordPictures } from "../nao/pictures.mjs";
import { built, memoryOf, readElf, robots } from "../nao/robots.mjs";
import { command, scratch, sleep, start, startClients } from "./programs.mjs";
import { Report } from "./report.mjs";

const kSeconds = 20;

const freePort = () =>
  new Promise((done) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });

/** Returns the number of failed tests of tests/nao for that robot, and prints their output. */
function failing(preset) {
  const env = { ...process.env, FORESIGHT_NAO: preset, FORESIGHT_BIN: join(root, "build/release/bin") };
  const { stdout } = spawnSync("node", ["--test", "--test-reporter=tap", join(root, "tests/nao/nao.test.mjs")], {
    env,
    encoding: "utf8",
  });
  const failed = Number(/^# fail (\d+)$/m.exec(stdout)?.[1] ?? NaN);
  if (failed !== 0) console.log(stdout);
  return failed;
}

/** Returns the most memory [MB] while raw pictures of two cameras are recorded and four viewers watch. */
async function memory(preset, session, seconds) {
  const port = await freePort();
  const robot = start(
    "foresight-robot",
    [
      "--body",
      "replay",
      "--session",
      session,
      "--loop",
      "--record",
      "--profile",
      "full",
      "--port",
      port,
      "--state-dir",
      join(scratch, "state"),
      "--log-dir",
      join(scratch, `logs-${preset}`),
    ],
    [],
    preset,
  );
  await robot.firstLine;
  await sleep(2);
  const viewers = startClients(`ws://127.0.0.1:${port}/`, [
    "--clients",
    4,
    "--seconds",
    seconds + 10,
    "--watch",
    "objects,images,jpeg",
  ]);
  await sleep(seconds);
  const { most } = memoryOf(robot.pid);
  robot.stop();
  await robot.output;
  viewers.stop();
  const { messages } = await viewers.report;
  return { most, messages };
}

export async function nao({ seconds = kSeconds }) {
  const report = new Report("nao", "do the programs for the Naos run there, and are they lean?");
  const synthetic = join(scratch, "synthetic");
  command(join(root, "build/release/bin/foresight-lab"), "synthesize", synthetic, "--seconds", "1");
  const session = await recordPictures(scratch, synthetic, 1);
  const golden = readFileSync(join(root, "tests/golden/sim_signature.txt"), "utf8").trim();
  for (const preset of Object.keys(robots)) {
    const [emulator, ...words] = robots[preset].emulator;
    report.figure(`${preset}: program, viewer included`, readElf(built(preset)).size_bytes / 1e6, "MB", { atMost: 8 });
    report.figure(
      `${preset}: signature on its processor`,
      command(emulator, ...words, built(preset, "sim_signature")).trim(),
      "",
      { exactly: golden },
    );
    report.figure(`${preset}: tests that fail`, failing(preset), "", { exactly: 0 });
    const { most, messages } = await memory(preset, session, seconds);
    report.figure(`${preset}: resident set, largest, image buffers included`, most, "MB", { atMost: 48 });
    report.figure(`${preset}: messages to viewers meanwhile`, messages, "", { above: 0 });
  }
  return report.finish();
}
