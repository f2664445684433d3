// foresight-robot with the body nao: a stand-in for the robot, the real guardian and the real runtime.
import assert from "node:assert/strict";
import { createSocket } from "node:dgram";
import { describe, test } from "node:test";
import { atEnd, start, statusOf, temporaryFolder, until } from "../e2e/support.mjs";
import { commander, kHead, kKick, kSit, kStand, walkSpeed } from "./commander.mjs";
import { join, open } from "./runtime.mjs";
import { World } from "./world.mjs";

/** Returns a free UDP port. */
const freePort = async () => {
  const probe = createSocket("udp4");
  await new Promise((done) => probe.bind(0, "127.0.0.1", done));
  const { port } = probe.address();
  await new Promise((done) => probe.close(done));
  return port;
};

describe("body nao", { concurrency: 4 }, () => {
  test("LoLA's values are in memory, with the robot's identity", async (t) => {
    const { world, live, newest } = await open(t, [
      "joints",
      "inertial",
      "fsr",
      "touch",
      "battery",
      "sonar",
      "body",
      "motion_status",
    ]);
    for (const object of ["joints", "inertial", "fsr", "touch", "battery", "sonar", "body", "motion_status"])
      await live.until(() => newest(object), object);
    assert.equal(newest("joints").position.length, 25);
    assert.ok(Math.abs(newest("inertial").accelerometer_z - 9.81) < 0.01);
    assert.ok(Math.abs(newest("battery").charge - 0.8) < 0.001);
    await live.until(() => newest("body").head_id === "P0000074A03S84F00006", "the identity");
    assert.equal(newest("body").mode, "MODE_UNSTIFF");
    world.happen("chest");
    await live.until(() => newest("touch").chest_button, "the button");
    world.happen("release");
    await until(async () => newest("body").mode !== "MODE_UNSTIFF" || world.click(), "the mode");
    await live.until(() => newest("motion_status").standing, "it stands");
  });

  test("a team's process moves the head, walks, stops and sits it down; a kick on one leg is refused visibly", async (t) => {
    const { world, live, newest, door } = await open(t, ["body", "motion_status", "joints"]);
    await live.until(() => newest("body"), "the body");
    await world.play();
    const command = commander(t, door);
    command(kHead(0.8, 0.1));
    const there = live.until(
      () => Math.abs(newest("joints").position[0] - 0.8) < 0.01 && Math.abs(newest("joints").position[1] - 0.1) < 0.01,
      "the head is there",
    );
    await there.catch((error) =>
      assert.fail(`${error.message}: ${JSON.stringify(newest("body"))} ${JSON.stringify(newest("motion_status"))}`),
    );
    command(kKick);
    const refusal = "body nao kicks only with a step of the walk (in_walk): it stands";
    await live.until(() => newest("body").refused === refusal, "the refusal");
    const walks = () => newest("motion_status").walking && newest("motion_status").velocity_x > 0.15;
    command(walkSpeed(0.2));
    const knees = [];
    await live.until(() => (knees.push(newest("joints").position[10]), walks()), "it walks");
    assert.ok(Math.max(...knees) - Math.min(...knees) > 0.1, "the knee bends and stretches");
    command(kStand);
    await live.until(() => !newest("motion_status").walking && newest("motion_status").standing, "it stands again");
    command(kSit);
    await live.until(() => newest("motion_status").running === "sit", "it sits down");
    await world.untilSeated();
    assert.equal(newest("body").refused, "");
    command(kStand);
    await world.untilStanding();
  });

  test("a runtime that is killed while the robot walks leaves it standing, then seated", async (t) => {
    const { world, server, live, newest, door } = await open(t, ["body", "motion_status"]);
    await live.until(() => newest("body"), "the body");
    await world.play();
    const command = commander(t, door);
    command(walkSpeed(0.2));
    await live.until(() => newest("motion_status").walking, "it walks");
    live.socket.terminate();
    server.kill("SIGKILL");
    await world.untilSeated();
  });

  test("sit_and_soft needs no token and takes the stiffness away", async (t) => {
    const { world, live, newest } = await open(t, ["body"]);
    await live.until(() => newest("body"), "the body");
    await world.play();
    assert.deepEqual(await live.call("sit_and_soft"), { ok: true });
    await world.until((state) => state.stiffness === 0, "it is soft");
    await live.until(() => newest("body").reason.includes("asked for sit_and_soft"), "the reason");
  });

  test("a runtime that is stopped on purpose sits the robot down and does not count as crashed", async (t) => {
    const { world, server, live, newest } = await open(t, ["body"]);
    await live.until(() => newest("body"), "the body");
    await world.play();
    live.socket.terminate();
    await server.stop();
    await world.untilSeated();
    assert.doesNotMatch(world.guardian.errors, /crashed/);
  });

  test("a runtime that was killed and started again waits for the GameController", async (t) => {
    const { world, server, live, newest } = await open(t, ["body"]);
    await live.until(() => newest("body"), "the body");
    await world.play();
    server.kill("SIGKILL");
    await server.ended;
    const port = await freePort();
    const again = await join(
      t,
      world,
      ["body", "game"],
      "--game-controller",
      "--game-port",
      String(port),
      "--port",
      "0",
    );
    await again.live.until(() => again.newest("body")?.reason.includes("waits for the GameController"), "it waits");
    // it holds, unless the start took so long on a busy machine that the guardian has sat it down
    if ((await world.state()).stiffness <= 0.8) await world.untilSeated();
    const socket = createSocket("udp4");
    atEnd(t, () => socket.close());
    const packet = playingPacket();
    await until(async () => {
      socket.send(packet, port, "127.0.0.1");
      return again.newest("body").mode === "MODE_PLAYING" && again.newest("body").reason === "";
    }, "it plays");
  });

  test("the body is attached and names another program at LoLA's socket", async (t) => {
    const world = new World(t);
    await world.startRobot();
    const first = await world.startGuardian();
    await world.untilSaid("LoLA is there");
    world.link += "2";
    await world.startGuardian();
    await world.until(() => world.guardian.errors.includes("it serves one program"), "it is taken");
    const folder = temporaryFolder(t);
    const server = await start(
      t,
      folder,
      "foresight-robot",
      "--body",
      "nao",
      "--guardian",
      world.link,
      "--door",
      `${folder}/door`,
    );
    assert.match(
      server.output,
      new RegExp(`LoLA at .* belongs to foresight-guard \\(process ${first.pid}\\).*going on as body attached`),
    );
    assert.equal((await statusOf(server)).body, "attached");
  });

  test("the runtime reports a missing guardian, and begins when there is one", async (t) => {
    const world = new World(t);
    await world.startRobot();
    const { live, newest } = await join(t, world, ["body", "joints"]);
    await live.until(() => newest("body")?.reason.includes("expected foresight-guardian to listen"), "the reason");
    await world.startGuardian();
    await live.until(() => newest("joints"), "the joints");
  });
});

/** A packet of the GameController of 2024: teams 14 and 5 play, nobody is penalised. */
function playingPacket() {
  const bytes = Buffer.alloc(118);
  bytes.write("RGme");
  bytes.set([18, 1, 5, 0, 0, 0, 3, 0, 1, 14], 4);
  bytes.writeInt16LE(600, 14);
  for (const [at, team] of [
    [18, 14],
    [68, 5],
  ]) {
    bytes[at] = team;
    bytes.writeUInt16LE(1200, at + 8);
  }
  return bytes;
}
