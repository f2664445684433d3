// The body `nao` on a robot in a physics engine: the real runtime, guardian and walk; only LoLA's end is MuJoCo.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { open, shoot } from "../e2e/browser.mjs";
import { Live } from "../e2e/live.mjs";
import { bin, start, temporaryFolder } from "../e2e/support.mjs";
import { commander, kSit, kStand, walkSpeed } from "./commander.mjs";
import { World } from "./world.mjs";

const skip = existsSync(join(bin, "lab_robot")) ? false : "MuJoCo is missing: install libmujoco-dev";

/** A robot that stands and plays, its runtime, and a team's process. */
async function standing(t, servos) {
  const world = new World(t);
  await world.startRobot("lab_robot", servos);
  await world.startGuardian();
  const folder = temporaryFolder(t);
  const door = `${folder}/door`;
  const args = ["--body", "nao", "--guardian", world.link, "--door", door];
  const server = await start(t, folder, "foresight-robot", ...args);
  const live = await Live.open(t, server);
  await live.until(() => live.channels.has("/14/2/motion_status"), "the channels");
  await live.subscribe("/14/2/motion_status");
  const status = () => {
    const message = live.messages.get("/14/2/motion_status").at(-1);
    return message ? live.decoded("/14/2/motion_status", message) : {};
  };
  await world.play();
  return { world, server, live, status, command: commander(t, door) };
}

describe("a walking robot", { skip, concurrency: 2 }, () => {
  for (const servos of ["stiff", "soft"])
    test(`with ${servos} servos walks, turns, withstands pushes and stands`, async (t) => {
      const { world, server, live, status, command } = await standing(t, servos);
      const began = await world.state();
      command(walkSpeed(0.15));
      const way = (state) => Math.hypot(state.x - began.x, state.y - began.y);
      await world.until((state) => !state.upright || way(state) > 0.4, "it has walked 40 cm");
      for (const degrees of [0, 90, 180, 270]) {
        world.happen(`push 0.6 ${degrees}`);
        await world.cycles(170);
      }
      assert.ok((await world.state()).upright, "it is on its feet");
      assert.ok(status().walking);
      assert.ok(Math.abs(status().velocity_x) > 0);

      const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
      await page.getByText("motion_status").first().click();
      await page.getByText("velocity_x").first().waitFor();
      await shoot(page, `walk-${servos}`);
      assert.deepEqual(problems, []);

      const { heading } = await world.state();
      command(walkSpeed(0, 0.5));
      const turned = (state) => Math.cos(state.heading - heading) < 0.5;
      assert.ok((await world.until((state) => !state.upright || turned(state), "it has turned")).upright);
      command(kStand);
      await live.until(() => status().standing && !status().walking, "it stands");
      assert.ok((await world.state()).upright);
      command(kSit);
      await live.until(() => status().running === "sit", "it sits down");
    });
});
