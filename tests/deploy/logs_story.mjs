// scripts/logs against the runtime itself, on two robots: bit-equal, over a link that breaks, until the robots are empty.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { bin, getJson, play, run, until } from "../e2e/support.mjs";
import { kUser } from "./field.mjs";
import { makePrograms } from "./programs.mjs";
import { World } from "./world.mjs";

const kPlaying = 3,
  kFinished = 4;

export function logsStory() {
  let world, tim, lea;
  const recorded = new Map(); // session -> its files as they were on the robot

  const filesOf = (folder) =>
    Object.fromEntries(
      readdirSync(folder)
        .sort()
        .map((name) => [name, readFileSync(join(folder, name))]),
    );

  /** Puts a recording onto a robot that is being set up. */
  function record(robot, session, seconds) {
    const folder = join(world.home, session);
    execFileSync(join(bin, "foresight-lab"), ["synthesize", folder, "--seconds", String(seconds)]);
    recorded.set(session, filesOf(folder));
    cpSync(folder, join(robot.home, "foresight/logs", session), { recursive: true });
    execFileSync("chown", ["-R", `${kUser}:${kUser}`, join(robot.home, "foresight/logs")]);
  }

  before(async () => {
    world = new World(["tim", "lea"]);
    ({ tim, lea } = world);
    await world.deploy(0, "--setup", "tim", "lea");
    await world.deploy(0, "tim", "lea", "--program", makePrograms().first.path);
    record(tim, "long", 4);
    record(tim, "short", 1);
    record(lea, "other", 1);
  });
  after(() => world?.field.end());

  /** Returns the folder of a copied session, below any day. */
  function home(robot, session) {
    const logs = join(world.home, "logs");
    const folders = existsSync(logs) ? readdirSync(logs).map((day) => join(logs, day, robot.name, session)) : [];
    return folders.find((folder) => existsSync(folder));
  }

  test("recordings without images arrive from both robots bit for bit", async () => {
    const { status, output } = await world.run("logs", "tim", "lea", "--no-images");
    assert.equal(status, 0, output);
    assert.match(output, /tim {2}2 sessions, .* MB, in logs\/\d{4}-\d\d-\d\d\/tim\n/);
    for (const [robot, session] of [
      [tim, "long"],
      [tim, "short"],
      [lea, "other"],
    ]) {
      const { "14.2.camera_top.mcap": top, "14.2.camera_bottom.mcap": bottom, ...rest } = recorded.get(session);
      assert.ok(top || bottom, "there were images");
      assert.deepEqual(filesOf(home(robot, session)), rest);
    }
    assert.equal((await run("foresight-lab", "info", home(lea, "other"))).status, 0);
  });

  test("after a broken link the next command fetches the rest", async () => {
    world.field.shape("20mbit");
    const started = world.start("logs", "tim");
    const parts = () =>
      readdirSync(home(tim, "long"))
        .filter((name) => name.endsWith(".part"))
        .map((name) => join(home(tim, "long"), name));
    await until(() => parts().some((path) => statSync(path).size > 300000), "a part");
    world.field.pull(tim);
    const { status, output } = await started.ended;
    assert.equal(status, 1, output);
    assert.match(output, /tim {2}FAILED: the connection was lost/);
    const [part] = parts();
    const had = readFileSync(part);
    assert.ok(
      had.length > 0 &&
        had.equals(recorded.get("long")[part.split("/").at(-1).replace(".part", "")].subarray(0, had.length)),
    );

    world.field.plug(tim);
    world.field.shape("1gbit");
    const again = await world.run("logs", "tim");
    assert.equal(again.status, 0, again.output);
    for (const session of ["long", "short"]) assert.deepEqual(filesOf(home(tim, session)), recorded.get(session));
  });

  test("during a game recordings stay on the robot", async () => {
    rmSync(home(lea, "other"), { recursive: true });
    world.sendState(lea, kPlaying);
    await until(() => world.statusOf(lea).game.in_progress, "the game");
    const { status, output } = await world.run("logs", "lea", "--delete");
    assert.equal(status, 1);
    assert.match(output, /lea {2}FAILED: a game is in progress/);
    world.sendState(lea, kFinished);
    await until(() => !world.statusOf(lea).game.in_progress, "the end of the game");
  });

  test("complete sessions are deleted, with the token that ssh reads", async () => {
    const { status, output } = await world.run("logs", "tim", "lea", "--delete");
    assert.equal(status, 0, output);
    assert.match(output, /tim {2}2 sessions, .* 2 deleted on the robot/);
    for (const [robot, session] of [
      [tim, "long"],
      [tim, "short"],
      [lea, "other"],
    ])
      assert.deepEqual(filesOf(home(robot, session)), recorded.get(session));
    assert.equal(world.on(tim, "ls foresight/logs"), "");
    assert.deepEqual(await world.run("logs", "tim"), { status: 0, output: "tim  nothing new\n" });
  });

  test("copied sessions can be played", async (t) => {
    const server = await play(t, world.home, home(tim, "long"), "--speed", "100");
    const { sessions } = await getJson(server, "/api/sessions");
    assert.equal(sessions.find(({ session }) => session === "long").state, "complete");
  });
}
