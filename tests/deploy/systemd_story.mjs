// scripts/deploy to a robot whose user has a systemd. One test builds on the other.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { until } from "../e2e/support.mjs";
import { makePrograms } from "./programs.mjs";
import { World } from "./world.mjs";

const kHasSystemd = existsSync("/usr/lib/systemd/systemd");

export function systemdStory() {
  let world, tim, programs, untouched, answers;

  const systemctl = (...words) =>
    world.on(tim, `XDG_RUNTIME_DIR=/run/user/$(id -u) systemctl --user ${words.join(" ")} 2>&1 || :`);

  before(async () => {
    if (!kHasSystemd) return;
    world = new World(["tim"], { systemd: true });
    tim = world.tim;
    programs = makePrograms();
    answers = await until(() => /^HOME=/m.test(systemctl("show-environment")), "systemd", 15_000).catch(() => false);
    untouched = world.listing(tim);
  });
  after(() => world?.field.end());

  const deploy = (...words) => world.deploy(...words);

  /** A test that needs the user's systemd. */
  const story = (name, work) =>
    test(name, { skip: kHasSystemd ? false : "there is no systemd on this machine" }, (t) =>
      answers ? work(t) : t.skip("systemd does not start for a user here"),
    );

  story("without a terminal the commands as root are printed, and with --yes they run", async () => {
    const told = await deploy(0, "--setup", "tim");
    assert.match(told, /tim {2}image: an Ubuntu \(Ubuntu 22.04.4 LTS\), systemd\n/);
    assert.match(
      told,
      /tim: root on the robot: loginctl enable-linger nao\n.*\[y\/N\] there is no terminal to ask: no/,
    );
    assert.match(
      told,
      /NOT done: Foresight starts when the robot is switched on.*: as root on the robot: loginctl enable-linger nao/,
    );
    assert.match(told, /NOT done: Foresight may have a real-time priority/);
    assert.equal(world.on(tim, "ls /tmp"), "");
    assert.doesNotMatch(await deploy(0, "--setup", "tim", "--yes"), /NOT done/);
    assert.match(
      world.on(tim, "cat /tmp/sudo.log"),
      /^-n sh -c loginctl enable-linger nao\n-n sh -c mkdir -p \/etc\/systemd\/system\/user@.service.d && printf/,
    );
  });

  story("the program is a unit of the user that starts with it", async () => {
    assert.match(await deploy(0, "tim", "--program", programs.first.path), /tim {2}runs build/);
    assert.equal(systemctl("is-active", "foresight"), "active");
    assert.equal(systemctl("is-enabled", "foresight"), "enabled");
    assert.match(await deploy(0, "tim", "--program", programs.second.path), /tim {2}runs build 5ec0/);
  });

  story("an update that crashes is rolled back", async () => {
    const output = await deploy(1, "tim", "--program", programs.crashing);
    assert.match(
      output,
      /FAILED: build crashing1: it crashed three times within a minute and stays down: exit-code, exited 3; rolled back to build 5ec0.*, which runs/,
    );
    assert.equal(world.statusOf(tim).build, programs.second.build);
  });

  story("systemd restarts a killed program, but not after the third kill within a minute", async () => {
    for (let crash = 1; crash <= 3; ++crash) {
      const [pid] = (await until(() => world.programOn(tim), "the program")).split(" ");
      world.on(tim, `kill -KILL ${pid}`);
      await until(() => world.programOn(tim).split(" ")[0] !== pid, "its end");
    }
    await until(() => systemctl("is-active", "foresight") === "failed", "systemd gives up");
    assert.equal(
      world.on(tim, "foresight/current/foresight status || echo $?"),
      "crashed three times within a minute and stays down: signal, killed KILL\n4",
    );
    world.on(tim, "foresight/current/foresight start");
    assert.equal(world.on(tim, "foresight/current/foresight status"), "runs");
  });

  story("undo leaves no trace", async () => {
    await deploy(0, "--undo", "tim", "--yes");
    assert.equal(world.listing(tim), untouched);
    assert.equal(world.programOn(tim), "");
    assert.match(systemctl("status", "foresight"), /could not be found/);
    assert.match(world.on(tim, "cat /tmp/sudo.log"), /-n sh -c loginctl disable-linger nao/);
  });
}
