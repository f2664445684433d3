// Programs for the Naos on emulated processors, on kernels as old as the robots' and in an empty system. FORESIGHT_NAO names
// the presets, by default "nao-v6". FORESIGHT_BIN is the folder of the other programs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Live } from "../e2e/live.mjs";
import { readStreamed } from "../e2e/mcap.mjs";
import { bin, download, request, sessionsOf, start, synthesize, temporaryFolder, until } from "../e2e/support.mjs";
import { recordPictures } from "./pictures.mjs";
import { built, chosen, memoryOf, needsMovbe, readElf, robots } from "./robots.mjs";

const kMostProgram_mb = 8;
const kMostMemory_mb = 48;

/** Plays a simulated game that a client watches and that is recorded and downloaded. */
async function serves(t, folder, command) {
  const server = await start(t, folder, command, "--body", "sim", "--seed", "7", "--record");
  assert.match((await request(server, "/")).headers["content-type"], /^text\/html/, "the viewer");
  const live = await Live.open(t, server);
  await live.until(() => live.channels.has("/truth/world") && live.channels.has("/14/2/decision"), "the channels");
  await live.subscribe("/truth/world", "/14/2/decision");
  await live.until(() => [...live.messages.values()].every((list) => list.length >= 30), "a second of them");
  assert.equal(live.decoded("/14/2/decision", await live.newest("/14/2/decision")).strategy, "baseline");
  assert.equal((await live.call("stop_recording")).ok, true);

  const [session] = await sessionsOf(server);
  const { topics } = readStreamed(await download(server, session.url));
  for (const topic of ["/truth/world", "/14/2/decision", "/5/1/pose"])
    assert.ok(topics.get(topic)?.messages.length >= 30, topic);
  assert.equal((await server.stop()).status, 0);
}

/** Returns words that run a program with an empty folder as its root. */
const inEmptyRoot = (folder) =>
  process.getuid() === 0 ? ["chroot", folder] : ["unshare", "--map-root-user", "chroot", folder];

const canEmptyRoot = () => {
  try {
    execFileSync("unshare", ["--map-root-user", "true"], { stdio: "ignore" });
    return { skip: false };
  } catch {
    return { skip: process.getuid() === 0 ? false : "an empty root needs root, or user namespaces" };
  }
};

for (const preset of chosen) {
  const { emulator, kernel } = robots[preset];
  const program = built(preset);

  test(`${preset}: one file of ${kMostProgram_mb} MB at most, static, stripped`, (t) => {
    const { bits, size_bytes, isStatic, isStripped } = readElf(program);
    t.diagnostic(`${(size_bytes / 1e6).toFixed(2)} MB`);
    assert.deepEqual(
      { bits, isStatic, isStripped },
      { bits: preset === "nao-v6" ? 64 : 32, isStatic: true, isStripped: true },
    );
    assert.ok(size_bytes <= kMostProgram_mb * 1e6, `${size_bytes} bytes`);
  });

  test(`${preset}: on the robot's processor a game is simulated, watched, recorded and downloaded`, async (t) => {
    await serves(t, temporaryFolder(t), [...emulator, program]);
  });

  test(
    `${preset}: it needs no files of the system`,
    { ...needsMovbe, ...(needsMovbe.skip ? {} : canEmptyRoot()) },
    async (t) => {
      const folder = temporaryFolder(t);
      for (const name of ["bin", "tmp"]) mkdirSync(join(folder, name));
      copyFileSync(program, join(folder, "bin/foresight-robot"));
      await serves(t, "/tmp", [...inEmptyRoot(folder), "/bin/foresight-robot"]);
    },
  );

  test(`${preset}: a kernel as old as Linux ${kernel} is new enough`, needsMovbe, async (t) => {
    await serves(t, temporaryFolder(t), [join(bin, "old_kernel"), kernel, program]);
  });

  test(
    `${preset}: ${kMostMemory_mb} MB of memory at most, with pictures watched and recorded`,
    needsMovbe,
    async (t) => {
      const folder = temporaryFolder(t);
      const session = await recordPictures(folder, await synthesize(folder, { seconds: 1 }), 0.5);
      const server = await start(
        t,
        folder,
        program,
        "--body",
        "replay",
        "--session",
        session,
        "--record",
        "--profile",
        "full",
        "--loop",
      );
      const live = await Live.open(t, server);
      const pictures = ["/14/2/camera_top/raw", "/14/2/camera_bottom/jpeg"];
      await live.until(() => pictures.every((topic) => live.channels.has(topic)), "the channels");
      await live.subscribe(...pictures);
      await until(() => pictures.every((topic) => live.messages.get(topic).length >= 20), "pictures");
      const { now, most } = memoryOf(server.pid);
      t.diagnostic(`${now.toFixed(1)} MB, ${most.toFixed(1)} MB at most`);
      assert.ok(most <= kMostMemory_mb, `${most} MB`);
    },
  );
}
