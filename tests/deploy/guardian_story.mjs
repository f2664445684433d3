// scripts/deploy to a robot whose body is ours: the guardian is changed only while the robot has no stiffness. Its LoLA is a
// stand-in, the rest is real. One test builds on the other.
import assert from "node:assert/strict";
import { appendFileSync, chmodSync, copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { bin, until } from "../e2e/support.mjs";
import { makePrograms } from "./programs.mjs";
import { World } from "./world.mjs";

export function guardianStory() {
  let world, tim, programs, untouched;
  const guardians = {}; // first, second: files that differ in an unused byte; crashing

  before(() => {
    world = new World(["tim"], { body: "nao" });
    tim = world.tim;
    programs = makePrograms();
    for (const name of ["first", "second"])
      copyFileSync(join(bin, "foresight-guardian"), (guardians[name] = join(world.temporary, name)));
    appendFileSync(guardians.second, "\n");
    writeFileSync(
      (guardians.crashing = join(world.temporary, "crashing")),
      "#!/bin/sh\necho 'my legs are missing' >&2\nexit 3\n",
    );
    for (const file of Object.values(guardians)) chmodSync(file, 0o755);
    copyFileSync(join(bin, "fake_robot"), join(tim.home, "fake_robot"));
    untouched = world.listing(tim);
  });
  after(() => world?.field.end());

  const deploy = (...words) => world.deploy(...words);
  const send = (guardian) => deploy(0, "tim", "--program", programs.first.path, "--guardian", guardian);

  /** The robots file without bodies of ours. */
  function attached() {
    const robots = JSON.parse(readFileSync(world.file, "utf8"));
    const file = join(world.home, "attached.json");
    writeFileSync(file, JSON.stringify({ ...robots, robots: robots.robots.map(({ body, ...rest }) => rest) }));
    return file;
  }

  const kGuardian = "foresight/guardian/bin/foresight-guardian";
  /** The robot's state as its guardian reports it, and true if the robot has no stiffness. */
  const told = () => {
    const [text, status] = world.on(tim, `${kGuardian} --status 2>&1; echo "/$?"`).split("\n/");
    return { text, soft: status === "0" };
  };
  const pid = () => world.on(tim, "cat foresight/state/guardian/pid");
  const isRunning = (guardian) => readFileSync(join(tim.home, kGuardian)).equals(readFileSync(guardian));

  async function stand() {
    // a press of too few cycles of the guardian, on a busy machine, does not count
    const click = "echo chest >/tmp/happens; sleep 0.2; echo release >/tmp/happens; sleep 0.3";
    while (/^unstiff/.test(told().text)) world.on(tim, click);
    await until(() => /, standing$/.test(told().text), "it stands");
  }

  test("the first version brings a guardian, which waits for LoLA", async () => {
    await deploy(0, "--setup", "tim");
    assert.match(await send(guardians.first), /tim {2}a new guardian owns LoLA\n[^]*tim {2}runs build/);
    assert.match(told().text, /^no LoLA: /);
    assert.ok(isRunning(guardians.first));
    assert.equal(world.statusOf(tim).body, "nao");
  });

  test("the same guardian is left alone", async () => {
    const before = pid();
    assert.doesNotMatch(await send(guardians.first), /guardian/);
    assert.equal(pid(), before);
  });

  test("a robot that has stiffness keeps its guardian; everything else is updated", async () => {
    world.on(
      tim,
      "mkfifo /tmp/happens; (sleep 1000 >/tmp/happens & ./fake_robot /tmp/robocup </tmp/happens >/tmp/fake.log 2>&1) >/dev/null 2>&1 &",
    );
    await until(() => /soft/.test(told().text), "LoLA");
    await stand();
    const before = pid();
    const output = await send(guardians.second);
    assert.match(
      output,
      /tim {2}NOT done: the guardian stays the one before, as the robot has stiffness \(initial, .*\): deploy again when it sits/,
    );
    assert.match(output, /tim {2}runs build/);
    assert.equal(pid(), before);
    assert.ok(isRunning(guardians.first));
    assert.match(
      await deploy(1, "--undo", "tim", "--yes"),
      /FAILED: stopping: the robot has stiffness \(initial, .*\): it must sit first, by three fingers on its head/,
    );
  });

  test("a robot whose state cannot be read keeps its guardian, too", async () => {
    world.on(tim, "echo broken >/tmp/happens");
    await until(() => /^unknown: /.test(told().text), "frames that cannot be read");
    const before = pid();
    assert.match(
      await send(guardians.second),
      /tim {2}NOT done: the guardian stays the one before, as it is not known whether the robot has stiffness \(unknown: .*\): deploy again when it sits/,
    );
    assert.equal(pid(), before);
    assert.match(
      await deploy(1, "--undo", "tim", "--yes"),
      /FAILED: stopping: the robot may have stiffness \(unknown: .*\): it must sit first/,
    );
    world.on(tim, "echo other >/tmp/happens");
    await until(() => !/^unknown: /.test(told().text), "whole frames");
  });

  test("a soft robot gets the new guardian", async () => {
    world.on(tim, `${kGuardian} --sit-and-soft`);
    await until(() => told().soft, "it is soft");
    assert.match(await send(guardians.second), /tim {2}a new guardian owns LoLA/);
    assert.ok(isRunning(guardians.second));
    await until(() => /soft/.test(told().text), "LoLA, again");
  });

  test("a guardian that does not run is put back, and nothing else is changed", async () => {
    const running = world.programOn(tim);
    const output = await deploy(1, "tim", "--program", programs.second.path, "--guardian", guardians.crashing);
    assert.match(
      output,
      /tim {2}my legs are missing[^]*FAILED: the guardian does not run, and nothing else was changed\n/,
    );
    assert.ok(isRunning(guardians.second));
    await until(() => told().soft, "the one before");
    assert.equal(world.programOn(tim), running);
  });

  test("a robot whose body changes to another one loses its guardian", async () => {
    assert.doesNotMatch(await deploy(0, "tim", "--robots", attached(), "--program", programs.first.path), /guardian/);
    assert.equal(world.statusOf(tim).body, "attached");
    assert.doesNotMatch(world.on(tim, "ls foresight; cat /proc/[0-9]*/comm"), /guardian/);
    await send(guardians.first);
  });

  test("undo leaves no trace", async () => {
    await deploy(0, "--undo", "tim", "--yes");
    assert.equal(world.listing(tim), untouched);
    assert.equal(world.on(tim, "cat /proc/[0-9]*/comm | grep -c foresight || :"), "0");
  });

  test("a guardian for a robot that has another body is refused", async () => {
    assert.equal(
      await deploy(2, "tim", "--robots", attached(), "--program", programs.first.path, "--guardian", guardians.first),
      "deploy: --guardian: expected a robot with the body nao, got none\n",
    );
  });
}
