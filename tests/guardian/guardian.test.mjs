// The guardian's program between a stand-in for a robot and a runtime that lives, hangs and dies.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { run } from "../e2e/support.mjs";
import { World } from "./world.mjs";

/** Fates of the runtime while people and gravity act. */
const fates = {
  alive: () => {},
  hung: (world) => world.runtime.kill("SIGSTOP"),
  dead: (world) => world.runtime.kill("SIGKILL"),
};

/** Starts a robot that plays, and then applies the runtime's fate. */
async function playing(t, fate) {
  const world = new World(t);
  await world.start();
  await world.play();
  fates[fate](world);
  return world;
}

// these tests mostly wait
describe("the guardian", { concurrency: 6 }, () => {
  for (const fate of Object.keys(fates)) {
    test(`runtime ${fate}: the head held takes the stiffness away`, async (t) => {
      const world = await playing(t, fate);
      world.happen("head");
      // 100 ms are 8 cycles of the robot; the questions take some more
      assert.equal((await world.cycles(8)).stiffness, 0);
      world.happen("release");
      assert.equal((await world.cycles(200)).stiffness, 0);
    });

    test(`runtime ${fate}: sit-and-soft takes the stiffness away`, async (t) => {
      const world = await playing(t, fate);
      assert.equal((await run("foresight-guardian", "--link", world.link, "--sit-and-soft")).status, 0);
      assert.equal((await world.cycles(2)).stiffness, 0);
      assert.equal((await world.cycles(200)).stiffness, 0);
    });

    test(`runtime ${fate}: a fall tucks and softens`, async (t) => {
      const world = await playing(t, fate);
      world.happen("fall");
      await world.until((state) => state.stiffness > 0 && state.stiffness <= 0.31, "it tucks in");
      await world.until((state) => state.stiffness === 0, "it is soft");
      assert.equal((await world.cycles(200)).stiffness, 0);
    });

    test(`runtime ${fate}: heat sits it down`, async (t) => {
      const world = await playing(t, fate);
      world.happen("heat 80");
      await world.untilSeated();
    });

    test(`runtime ${fate}: an empty battery sits it down`, async (t) => {
      const world = await playing(t, fate);
      world.happen("battery 0.02");
      await world.untilSeated();
    });
  }

  for (const fate of ["hung", "dead"])
    test(`runtime ${fate}: the robot holds, sits and is soft; every frame is answered`, async (t) => {
      const world = await playing(t, fate);
      const held = await world.cycles(100);
      assert.ok(held.knee < 0.85 && held.stiffness > 0.8, `it holds: ${JSON.stringify(held)}`);
      const seated = await world.untilSeated();
      assert.equal(seated.bad_answers, 0);
      assert.ok(seated.answers >= seated.frames - 2, `${seated.answers} answers to ${seated.frames} frames`);
    });

  test("a runtime that hung continues while the robot still holds its posture", async (t) => {
    const world = await playing(t, "hung");
    await world.cycles(50);
    world.runtime.kill("SIGCONT");
    await world.untilDoing("playing", "standing");
  });

  test("after a restart the robot waits for the GameController; three crashes end seated with red eyes", async (t) => {
    const world = await playing(t, "dead");
    await world.startRuntime();
    await world.cycles(20);
    assert.match(world.runtime.said().reason, /waits for the GameController/);
    world.runtime.kill("SIGKILL");

    await world.startRuntime("--heard");
    await world.untilStanding();
    assert.equal(world.runtime.said().mode, "playing");
    world.runtime.kill("SIGKILL");

    const state = await world.untilSeated();
    assert.deepEqual(state.eye, [1, 0, 0]);
    await world.startRuntime("--heard");
    assert.equal((await world.cycles(200)).stiffness, 0);
    assert.match(world.runtime.said().reason, /crashed three times/);
  });

  test("a runtime that ends on purpose has not crashed", async (t) => {
    const world = await playing(t, "alive");
    for (let i = 0; i < 4; ++i) {
      world.runtime.kill("SIGTERM");
      assert.equal((await world.ended(world.runtime)).status, 0);
      await world.startRuntime("--heard");
      await world.cycles(20);
    }
    assert.doesNotMatch(world.guardian.errors, /crashed/);
    await world.untilStanding();
  });

  test("without a runtime the chest button has no effect", async (t) => {
    const world = new World(t);
    await world.startRobot();
    await world.startGuardian();
    await world.click();
    assert.equal((await world.cycles(300)).stiffness, 0);
  });

  test("wrong, short, huge and reordered frames are named, and the robot stays safe and recovers", async (t) => {
    const world = await playing(t, "alive");
    world.happen("reordered");
    const reordered = await world.cycles(50);
    assert.ok(reordered.knee < 0.85 && reordered.stiffness > 0.8, "another order of keys is as good");

    world.happen("broken");
    await world.untilSaid("LoLA: Gyroscope: expected finite numbers");
    const broken = await world.cycles(50);
    assert.ok(broken.knee < 0.85 && broken.stiffness > 0.8, "it holds");
    assert.ok(broken.answers >= broken.frames - 2, "frames that cannot be read are answered, too");
    world.happen("other");
    await world.untilStanding();

    // two halves make no frame, and a too large frame is refused as well
    for (const [kind, sentence] of [
      ["short", /LoLA: expected|LoLA: \w+: expected/],
      ["huge", /LoLA: expected/],
    ]) {
      const told = world.guardian.errors.length;
      world.happen(kind);
      await world.until(() => sentence.test(world.guardian.errors.slice(told)), "it is named");
      world.happen("other");
      await world.until((state) => state.connected, "it comes back");
      const { answers } = await world.state();
      await world.until((state) => state.answers > answers + 20, "it answers again");
    }
  });

  test("the guardian connects to LoLA again, and the robot does not move before a command", async (t) => {
    const world = await playing(t, "alive");
    world.happen("vanish");
    await world.untilSaid("LoLA is gone: it closed the connection");
    await world.until((state) => state.connected, "it is found again");
    await world.cycles(20);
    assert.match(world.runtime.said().reason, /waits for the GameController/);
    assert.ok((await world.state()).stiffness > 0.8, "it holds");

    world.robot.kill("SIGKILL");
    await world.ended(world.robot);
    await world.startRobot();
    await world.until((state) => state.answers > 20, "and even when all of LoLA was gone");
  });

  test("the guardian names another program at LoLA's socket, and takes over when that has ended", async (t) => {
    const world = new World(t);
    await world.startRobot();
    const first = await world.startGuardian();
    await world.untilSaid("LoLA is there");
    const link = world.link;
    world.link += "2";
    const second = await world.startGuardian();
    await world.untilSaid(`belongs to foresight-guard (process ${first.pid}), it serves one program at a time`);
    await world.startRuntime();
    assert.equal(world.runtime.said().taken, true);
    first.kill("SIGTERM");
    await world.ended(first);
    await world.untilSaid("LoLA is there: body P0000073A03S83I00011, head P0000074A03S84F00006");
    assert.ok(link !== world.link && second.pid > 0);
  });

  test("a second guardian on the same link is refused with a sentence", async (t) => {
    const world = new World(t);
    await world.startGuardian();
    const { status, stderr } = await run("foresight-guardian", "--lola", world.lola, "--link", world.link);
    assert.equal(status, 2);
    assert.equal(
      stderr,
      `foresight-guardian: guardian: expected nobody to listen at ${world.link}, another guardian does; end it, or choose another --link\n`,
    );
  });

  test("it sits the robot down before it ends, and reports whether it may be replaced", async (t) => {
    const world = await playing(t, "alive");
    await world.untilDoing("playing", "standing");
    const standing = await run("foresight-guardian", "--link", world.link, "--status");
    assert.deepEqual([standing.status, standing.stdout], [1, "playing, standing\n"]);
    world.guardian.kill("SIGTERM");
    assert.equal((await world.ended(world.guardian)).status, 0);
    const state = await world.state();
    assert.ok(state.knee > 2 && state.stiffness === 0, JSON.stringify(state));
    const gone = await run("foresight-guardian", "--link", world.link, "--status");
    assert.equal(gone.status, 2);
    assert.match(gone.stderr, /expected foresight-guardian to listen at .*; start it first/);
  });

  test("a state that cannot be read is unknown, and not soft", async (t) => {
    const world = await playing(t, "alive");
    const status = () => run("foresight-guardian", "--link", world.link, "--status");
    await world.untilDoing("playing", "standing");
    world.happen("broken");
    await world.cycles(5);
    const unknown = await status();
    assert.equal(unknown.status, 3);
    assert.match(unknown.stdout, /^unknown: LoLA.*\n$/);
    world.happen("other");
    await world.cycles(5);
    assert.equal((await status()).status, 1);
  });

  test("without LoLA the guardian holds nothing and may be replaced", async (t) => {
    const world = new World(t);
    await world.startGuardian();
    const { status, stdout } = await run("foresight-guardian", "--link", world.link, "--status");
    assert.equal(status, 0);
    assert.match(stdout, /^no LoLA: /);
  });

  test("random orders never move a robot that must be soft, and do no harm", async (t) => {
    const world = new World(t);
    await world.start("--wild", "1");
    await world.cycles(100);
    assert.equal((await world.state()).stiffness, 0);
    for (let i = 0; i < 3; ++i) await world.click();
    await world.cycles(300);
    world.happen("head");
    await world.cycles(10);
    world.happen("release");
    const state = await world.cycles(300);
    assert.equal(state.stiffness, 0);
    assert.equal(state.bad_answers, 0);
    assert.ok(state.answers >= state.frames - 2);
  });
});
