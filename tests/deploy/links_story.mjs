// scripts/deploy over a link that breaks. One test builds on the other.
import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { chmodSync, existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { until } from "../e2e/support.mjs";
import { makePrograms } from "./programs.mjs";
import { World } from "./world.mjs";

export function linksStory() {
  let world, tim, programs, heavy;

  before(async () => {
    world = new World(["tim", "lea"]);
    ({ tim } = world);
    programs = makePrograms();
    // rsync finds no part of it on the robot
    heavy = join(world.home, "heavy");
    writeFileSync(heavy, Buffer.concat([readFileSync(programs.first.path), randomBytes(4e6)]));
    chmodSync(heavy, 0o755);
    await world.deploy(0, "--setup", "tim", "lea");
    await deploy(0, "tim", "lea");
  });
  after(() => world?.field.end());

  /** Deploys the first program. */
  const deploy = (status, ...names) => world.deploy(status, ...names, "--program", programs.first.path);

  test("a connection that is cut while sending does not disturb the running version; the next attempt succeeds", async () => {
    const running = world.programOn(tim);
    const staging = join(tim.home, "foresight/staging/bin");
    world.field.slow(tim, "2mbit");
    const started = world.start("deploy", "tim", "lea", "--program", heavy);
    await until(() => existsSync(staging) && readdirSync(staging).length > 0, "the first bytes");
    world.field.pull(tim);
    const { status, output } = await started.ended;
    assert.equal(status, 1);
    assert.match(output, /tim {2}FAILED: (rsync ended with status \d+|the connection was lost)/);
    assert.match(output, /lea {2}runs build/);
    world.field.plug(tim);
    world.field.slow(tim, "1gbit");
    assert.equal(world.programOn(tim), running);
    assert.match(await deploy(0, "tim"), /runs build/);
  });

  test("a robot that is off is reported at once", async () => {
    world.field.pull(tim);
    assert.match(await deploy(1, "tim"), /tim {2}FAILED: no ssh server answers at port 22 of 10.14.1.1/);
    world.field.plug(tim);
  });

  test("a stopped command leaves no files here and does not disturb the running version there", async () => {
    await until(
      () =>
        world.run("deploy", "tim", "--program", programs.first.path, "--dry-run").then(({ status }) => status === 0),
      "the network",
    );
    const running = world.programOn(tim);
    world.field.slow(tim, "2mbit");
    const started = world.start("deploy", "tim", "--program", heavy);
    await until(() => /tim {2}sends/.test(started.output), "the command to send");
    await until(() => world.on(tim, "ls -A foresight/staging/bin 2>/dev/null || :") !== "", "the first bytes");
    started.child.kill("SIGINT");
    assert.equal((await started.ended).status, 130);
    assert.deepEqual(readdirSync(world.temporary), []);
    world.field.slow(tim, "1gbit");
    assert.equal(world.programOn(tim), running);
  });
}
