// scripts/deploy against real ssh servers: two robots, each with a system of its own. One test builds on the other.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync, readlinkSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { until } from "../e2e/support.mjs";
import { makePrograms } from "./programs.mjs";
import { World } from "./world.mjs";

const kReady = 1,
  kPlaying = 3,
  kFinished = 4;

export function deployStory() {
  let world, tim, lea, programs;
  const untouched = new Map(); // robot -> its home before the first deployment

  before(() => {
    world = new World(["tim", "lea"]);
    ({ tim, lea } = world);
    programs = makePrograms();
    world.on(
      tim,
      "mkdir Config && echo 1 >Config/settings.cfg && mkdir -m 700 .ssh && printf 'ssh-rsa AAAAold somebody' >.ssh/authorized_keys",
    );
    for (const robot of [tim, lea]) untouched.set(robot, world.listing(robot));
  });
  after(() => world?.field.end());

  const deploy = (...words) => world.deploy(...words);
  const send = (program, ...words) => [...words, "--program", program.path ?? program];
  const pathOn = (robot, path) => join(robot.home, "foresight", path);

  test("a robot without our key is not changed", async () => {
    assert.match(
      await deploy(1, ...send(programs.first, "tim")),
      /tim {2}FAILED: cannot log in as nao@10.14.1.1: it does not know our key; scripts\/deploy --setup tim/,
    );
    assert.equal(world.listing(tim), untouched.get(tim));
  });

  test("setup describes the robot and installs our key once", async () => {
    const output = await deploy(0, "--setup", "tim", "lea");
    assert.match(output, /tim {2}image: B-Human's image \(Ubuntu 22.04.4 LTS\), neither systemd nor OpenRC/);
    assert.match(output, /tim {2}LoLA: no socket/);
    assert.match(output, /tim {2}our key is there now/);
    assert.match(output, /lea {2}set up: scripts\/deploy logs in without a password/);
    assert.match(await deploy(0, "--setup", "1"), /our key is there already/);
    assert.equal(world.on(tim, "grep -c 'the team.s key' .ssh/authorized_keys"), "1");
    assert.equal(world.on(tim, "tail -n 1 .ssh/authorized_keys"), "ssh-rsa AAAAold somebody");
  });

  test("a dry run changes nothing", async () => {
    const listing = world.listing(tim);
    assert.match(
      await deploy(0, ...send(programs.first, "tim", "--dry-run")),
      /would send everything; nothing runs now/,
    );
    assert.equal(world.listing(tim), listing);
  });

  test("the first version is installed and runs as that robot", async () => {
    assert.match(
      await deploy(0, ...send(programs.first, "tim", "--field", "B")),
      new RegExp(`tim {2}runs build ${programs.first.build.replace("+", "\\+")}`),
    );
    const status = world.statusOf(tim);
    assert.deepEqual([status.build, status.body, status.robots], [programs.first.build, "attached", ["14/1"]]);
    assert.match(world.programOn(tim), /--field=B --bind=0.0.0.0/);
    assert.deepEqual(JSON.parse(readFileSync(pathOn(tim, "current/etc/robot.json"))), {
      name: "tim",
      team: 14,
      player: 1,
      colour: "blue",
      model: "nao-v6",
      field: "B",
    });
    assert.ok(!existsSync(pathOn(tim, "previous")));
  });

  test("two robots are updated side by side; the previous version and the runtime's files are kept", async () => {
    const token = readFileSync(pathOn(tim, "state/token"), "utf8");
    world.on(tim, "mkdir foresight/logs/a-session && echo x >foresight/logs/a-session/note");
    // remains of a transfer that was cut off
    world.on(tim, "mkdir -p foresight/staging/bin && echo old >foresight/staging/bin/stale");
    const first = readlinkSync(pathOn(tim, "current"));

    const output = await deploy(0, ...send(programs.second, "1", lea.address));
    for (const name of ["tim", "lea"]) assert.match(output, new RegExp(`${name} {2}runs build 5ec0`));
    for (const [robot, number] of [
      [tim, 1],
      [lea, 2],
    ]) {
      const { build, robots } = world.statusOf(robot);
      assert.deepEqual({ build, robots }, { build: programs.second.build, robots: [`14/${number}`] });
    }
    assert.equal(readlinkSync(pathOn(tim, "previous")), first);
    assert.deepEqual(readdirSync(pathOn(tim, "current/bin")), ["foresight-robot"]);
    assert.equal(readFileSync(pathOn(tim, "state/token"), "utf8"), token);
    assert.equal(world.on(tim, "cat foresight/logs/a-session/note"), "x");
    assert.equal(readdirSync(pathOn(tim, "versions")).length, 2);
    assert.doesNotMatch(world.programOn(tim), /--field/);
  });

  test("a dry run of an update reports the differences", async () => {
    assert.match(
      await deploy(0, ...send(programs.second, "tim", "--dry-run")),
      /tim {2}would send nothing new; build 5ec0/,
    );
    assert.match(
      await deploy(0, ...send(programs.second, "tim", "--dry-run", "--player", "4")),
      /tim {2}would send etc\/robot.json, etc\/settings;/,
    );
  });

  test("an update that crashes is rolled back, and its last log lines are printed", async () => {
    const output = await deploy(1, ...send(programs.crashing, "tim"));
    assert.match(output, /tim {2}the horizon is missing/);
    assert.match(
      output,
      /FAILED: build crashing1: it crashed three times within a minute and stays down: exit status 3; rolled back to build 5ec0.*, which runs/,
    );
    assert.equal(world.statusOf(tim).build, programs.second.build);
    assert.equal(readdirSync(pathOn(tim, "versions")).length, 1);
  });

  test("an update that reports another build is rolled back", async () => {
    assert.match(
      await deploy(1, ...send(programs.lying, "tim")),
      /FAILED: build lying1: it answers as build \w+\+?; rolled back to build 5ec0.*, which runs/,
    );
    assert.equal(world.statusOf(tim).build, programs.second.build);
  });

  test("after a first version that crashes no program runs", async () => {
    await deploy(0, "--undo", "lea", "--yes");
    await deploy(0, "--setup", "lea");
    assert.match(
      await deploy(1, ...send(programs.crashing, "lea")),
      /FAILED: build crashing1: .*; there was no version before it, nothing runs now/,
    );
    assert.equal(world.programOn(lea), "");
    await deploy(0, ...send(programs.first, "lea"));
  });

  test("a program that the robot cannot run does not stop the running one; the other robots continue", async () => {
    const running = world.programOn(tim);
    assert.match(
      await deploy(1, ...send(programs.foreign, "tim", "lea")),
      /tim {2}FAILED: the program does not run on this robot: .*Exec format error/,
    );
    assert.equal(world.programOn(tim), running);
  });

  test("without a restart the new version waits for the next start", async () => {
    const running = world.programOn(tim);
    assert.match(
      await deploy(0, ...send(programs.first, "tim", "--no-restart")),
      /is there and runs when it is started next/,
    );
    assert.equal(world.programOn(tim), running);
    world.on(tim, "foresight/current/foresight stop && foresight/current/foresight start");
    await until(
      () =>
        world.programOn(tim) !== "" &&
        world.on(tim, "foresight/current/bin/foresight-robot --version") === programs.first.build,
      "the new one",
    );
  });

  test("a port of another user's runtime is reported, and no program is stopped", async () => {
    world.on(tim, "foresight/current/foresight stop");
    world.on(
      tim,
      "foresight/current/bin/foresight-robot --body sim --state-dir foresight/state --log-dir /tmp/other >/tmp/other.log 2>&1 &",
    );
    await until(() => world.on(tim, "cat /tmp/other.log").includes("http://"), "the other one");
    assert.match(
      await deploy(1, ...send(programs.second, "tim")),
      /FAILED: port 8765 is taken by a runtime \(build \S+\) that was not started by us/,
    );
    assert.match(world.programOn(tim), /--body sim/);
    world.on(tim, `kill ${world.programOn(tim).split(" ")[0]}`);
    await until(() => world.programOn(tim) === "", "its end");
    await deploy(0, ...send(programs.first, "tim"));
  });

  test("during a game nothing is changed without --force", async () => {
    for (const [state, name] of [
      [kReady, "READY"],
      [kPlaying, "PLAYING"],
    ]) {
      world.sendState(tim, state);
      await until(() => world.statusOf(tim).game.state === name.toLowerCase(), name);
      const running = world.programOn(tim);
      for (const words of [
        send(programs.second, "tim"),
        send(programs.second, "tim", "--no-restart"),
        ["--undo", "tim", "--yes"],
      ])
        assert.match(await deploy(1, ...words), new RegExp(`FAILED: the game is ${name}; nothing was changed`));
      assert.equal(world.programOn(tim), running);
    }
    assert.match(await deploy(0, ...send(programs.second, "tim", "--force")), /runs build 5ec0/);
    world.sendState(tim, kPlaying);
    await until(() => world.statusOf(tim).game.in_progress, "the game");
    world.sendState(tim, kFinished);
    await until(() => !world.statusOf(tim).game.in_progress, "the end of the game");
    await deploy(0, ...send(programs.second, "tim"));
  });

  test("another robot at a known address is not trusted", async () => {
    const key = join(tim.folder, "run/host_key");
    world.field.runOn(tim, "rm /run/host_key* && ssh-keygen -q -t ed25519 -N '' -f /run/host_key && kill -HUP 1", {
      as: "root",
    });
    assert.ok(existsSync(key));
    await until(async () => {
      const { output } = await world.run("deploy", ...send(programs.first, "tim", "--dry-run"));
      return /FAILED: cannot log in as nao@10.14.1.1: it is not the robot we know as 'tim', or it was flashed anew/.test(
        output,
      );
    }, "the refusal");
    await deploy(0, "--setup", "tim");
    await deploy(0, ...send(programs.first, "tim", "--dry-run"));
  });

  test("undo asks before it removes recordings, and leaves no trace", async () => {
    assert.match(
      await deploy(0, "--undo", "tim"),
      /tim: recordings are still on the robot: \d+, together 1 MB. Remove them\? \[y\/N\] there is no terminal to ask: no[^]*nothing of ours is left but ~\/foresight\/logs/,
    );
    assert.equal(world.on(tim, "cat foresight/logs/a-session/note; ls foresight"), "x\nlogs\nmade");
    assert.equal(world.programOn(tim), "");
    await deploy(0, "--setup", "tim");
    await deploy(0, ...send(programs.first, "tim"));
    await deploy(0, "--undo", "tim", "lea", "--yes");
    for (const robot of [tim, lea]) {
      assert.equal(world.listing(robot), untouched.get(robot));
      assert.equal(world.programOn(robot), "");
      assert.equal(world.on(robot, "ls /dev/shm"), "");
    }
  });

  test("a folder of that name that is not ours is left alone", async () => {
    world.on(lea, "mkdir foresight && echo theirs >foresight/file");
    const listing = world.listing(lea);
    assert.match(
      await deploy(1, "--setup", "lea"),
      /FAILED: preparing ~\/foresight: there is a ~\/foresight on the robot that is not ours/,
    );
    assert.equal(world.listing(lea), listing);
  });

  test("wrong arguments give one sentence and exit status 2", async () => {
    assert.equal(await deploy(2, "bob"), `deploy: expected one of tim, lea (${world.file}), got 'bob'\n`);
    assert.equal(
      await deploy(2, "tim", "lea", "--player", "3"),
      "deploy: --player: expected one robot to give number 3, got 2\n",
    );
    assert.equal(
      await deploy(2, "tim", "--program", "/nothing"),
      "deploy: --program: expected a file, got '/nothing'\n",
    );
    assert.match(
      await deploy(2, "tim", "--robots", "/nothing"),
      /^deploy: \/nothing: expected the team's robots \(.*\), got ENOENT\n$/,
    );
    assert.equal(await deploy(2, "--setup", "--undo", "tim"), "deploy: expected --setup or --undo, got both\n");
  });
}
