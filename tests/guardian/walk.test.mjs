// The body `nao` on a robot in a physics engine: the real runtime, guardian and walk; only LoLA's end is MuJoCo.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { open, shoot } from "../e2e/browser.mjs";
import { Live } from "../e2e/live.mjs";
import { bin, start, temporaryFolder, until } from "../e2e/support.mjs";
import { commander, kStand, walkSpeed } from "./commander.mjs";
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

// How well it walks is the matter of tests/walk, whose time does not depend on the machine. Here a busy machine may make it
// fall, because the physics goes on at the pace of the clock.
describe("a robot in the physics", { skip }, () => {
  test("stands up by its chest button, obeys commands to walk and is put up again with other servos", async (t) => {
    const { world, server, live, status, command } = await standing(t, "stiff");
    assert.ok((await world.state()).upright);
    command(walkSpeed(0.1));
    await live.until(() => status().walking && status().velocity_x > 0.05, "it walks");
    world.happen("push 0.3 90");

    const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
    await page.getByRole("searchbox").fill("motion_status velocity");
    await page.getByText("velocity_x").first().waitFor();
    await shoot(page, "walking-robot");
    assert.deepEqual(problems, []);

    world.happen("nonsense");
    await until(() => world.robot.errors.includes("lab_robot: cannot obey 'nonsense'"), "the refusal");
    command(kStand);
    world.happen("again soft 3");
    await world.until((state) => state.upright && state.frames > 0, "it is on its feet again");
  });
});
