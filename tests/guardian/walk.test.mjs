// The body `nao` on a robot in a physics engine: the real runtime, guardian and walk; only LoLA's end is MuJoCo.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { createReadStream, createWriteStream, existsSync } from "node:fs";
import { join as pathOf } from "node:path";
import { describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { open, shoot } from "../e2e/browser.mjs";
import { atEnd, bin, until } from "../e2e/support.mjs";
import { commander, kStand, walkSpeed } from "./commander.mjs";
import { join } from "./runtime.mjs";
import { World } from "./world.mjs";

const skip = existsSync(pathOf(bin, "lab_robot")) ? false : "MuJoCo is missing: install libmujoco-dev";

const kLab = fileURLToPath(new URL("../walk/lab.py", import.meta.url));

/** Starts the controls of scripts/walk-lab. */
function control(t, world, door, ...robot) {
  const [lines, states] = ["lines", "states"].map((name) => pathOf(world.folder, name));
  execFileSync("mkfifo", [lines, states]);
  const child = spawn("python3", [kLab, lines, states, ...robot], {
    env: { ...process.env, FORESIGHT_DOOR: door },
    stdio: "pipe",
  });
  child.stderr.pipe(process.stderr);
  createReadStream(lines).pipe(world.robot.stdin, { end: false });
  world.robot.stdout.pipe(createWriteStream(states).on("error", () => {})); // the lab may have ended
  atEnd(t, () => child.kill("SIGKILL"));
  return child;
}

// tests/walk judges the walk itself, in a time that does not depend on the machine. Here the physics follows the clock, so a
// busy machine may make the robot fall.
describe("a robot in the physics", { skip }, () => {
  test("stands up by its chest button, obeys commands to walk and is put up again with other servos, and begins to get up after a fall", async (t) => {
    const world = new World(t);
    await world.startRobot("lab_robot", "stiff");
    await world.startGuardian();
    const { server, live, newest, door } = await join(t, world, ["motion_status", "body", "joints"]);
    await world.play();
    const command = commander(t, door);
    assert.ok((await world.state()).upright);
    command(walkSpeed(0.1));
    await live.until(() => newest("motion_status").walking && newest("motion_status").velocity_x > 0.05, "it walks");
    world.happen("push 0.3 90");

    const { page, problems } = await open(t, `${server.http}/#/14/2/objects`);
    await page.getByRole("searchbox").fill("motion_status velocity");
    await page.getByText("velocity_x").first().waitFor();
    await shoot(page, "walking-robot");

    command(walkSpeed(0));
    await live.until(() => newest("motion_status").standing, "it stands in the walk");
    const knee = () => newest("joints").position[10];
    const before = knee();
    await page.goto(`${server.http}/#/14/2/parameters`);
    await page.getByLabel("Search parameters").fill("walk.");
    await page.getByLabel("hip_height", { exact: true }).fill("0.19");
    await page.getByLabel("hip_height", { exact: true }).press("Enter");
    await live.until(() => knee() > before + 0.2, "it bends its knees");
    await shoot(page, "walk-numbers");
    await page.getByLabel("hip_height", { exact: true }).fill("9");
    await page.getByLabel("hip_height", { exact: true }).press("Enter");
    await page.getByText("walk.hip_height: expected 0.053 to 0.848 m, got 9.").waitFor();
    await page.getByRole("button", { name: "Reset all" }).click();
    await live.until(() => knee() < before + 0.1, "it stands as before");
    assert.deepEqual(problems, []);

    world.happen("nonsense");
    await until(() => world.robot.errors.includes("lab_robot: cannot obey 'nonsense'"), "the refusal");
    command(kStand);
    world.happen("again soft 3");
    await world.until((state) => state.upright && state.frames > 0, "it is on its feet again");

    world.happen("push 9 0");
    await live.until(() => newest("motion_status").fall === "FALL_FALLEN", "it lies");
    await live.until(() => newest("motion_status").running === "get_up", "it gets up");
    await live.until(() => newest("body").doing === "DOING_GETTING_UP", "the body says so, too");
  });

  test("is pushed, put up and changed by clicks in the viewer", async (t) => {
    const world = new World(t);
    await world.startRobot("lab_robot", "stiff");
    await world.startGuardian();
    const { server, live, newest, door } = await join(t, world, ["motion_status", "body"]);
    const lab = control(t, world, door, "stiff", "1");
    await live.until(() => newest("body")?.mode === "MODE_PLAYING", "the lab has pressed the chest button");
    await world.until((state) => state.upright && state.stiffness > 0.5, "it stands");

    const { page, problems } = await open(t, `${server.http}/#/14/2/parameters`);
    const button = (name) => page.getByRole("button", { name, exact: true });
    await page.getByLabel("impulse", { exact: true }).fill("4.5");
    await page.getByLabel("impulse", { exact: true }).press("Enter");
    await page.getByText("● default").waitFor();
    await button("push from behind").click();
    await live.until(() => newest("motion_status").fall === "FALL_FALLEN", "it lies");
    assert.equal(newest("motion_status").fall_side, "FALL_SIDE_FRONT");
    await shoot(page, "walk-lab");
    // while it gets up by itself
    await live.until(() => newest("body").doing === "DOING_GETTING_UP", "it gets up");
    await button("put up").click();
    await world.until((state) => state.upright && state.stiffness > 0.5, "it is on its feet again");

    await page.getByLabel("servos", { exact: true }).selectOption("soft");
    await page.getByLabel("turf", { exact: true }).fill("4");
    await page.getByLabel("turf", { exact: true }).press("Enter");
    await world.until((state) => state.servos === "soft" && state.turf === 4, "another robot on other ground");
    await world.until((state) => state.upright && state.stiffness > 0.5, "it stands, too");
    lab.stdin.write("x");
    await until(() => lab.exitCode === 0, "x ends the lab");
    assert.equal(world.robot.errors, "");
    assert.deepEqual(problems, []);
  });

  test("walks to the ball by a strategy, and people see both on the field", async (t) => {
    const world = new World(t);
    await world.startRobot("lab_robot", "stiff");
    await world.startGuardian();
    const objects = ["motion_status", "body", "pose", "ball", "decision"];
    const words = ["--behaviour", "baseline", "--practice"];
    const { server, live, newest, door } = await join(t, world, objects, ...words);
    control(t, world, door, "stiff", "1", "--play");
    const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
    await live.until(() => newest("body")?.mode === "MODE_PLAYING", "the lab has pressed the chest button");
    await live.until(() => Math.hypot(newest("ball")?.x, newest("ball")?.y) < 0.45, "it walks to the ball");
    assert.ok(Math.hypot(newest("pose").x, newest("pose").y) > 0.1);
    assert.equal(newest("decision").role, "chaser");
    await shoot(page, "walk-lab-play");
    assert.deepEqual(problems, []);
  });
});
