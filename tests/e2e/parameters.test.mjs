// Live parameters as a person uses them in Chromium: a real process in Python announces them through the door.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { open, shootEach } from "./browser.mjs";
import { atEnd, needsNetwork, own, start, statusOf, temporaryFolder, until } from "./support.mjs";

const kClient = fileURLToPath(new URL("../../robot/client", import.meta.url));

/** Announces parameters and prints the values whenever one changes; plays a game state if asked to. */
const kProcess = `
import json, sys, time
import foresight
walk = foresight.Parameters("walk")
walk.number("step_height", 0.02, range=(0, 0.05), unit="m", text="Height of a foot over the ground in the middle of a step.")
walk.number("speed", 0.25, range=(0, 0.4), unit="m/s", text="Speed forward of the fastest walk.")
walk.number("gain", 1.5, text="Gain of the balance by the hip; without a range.")
walk.whole("warm_up", 3, range=(0, 10), unit="steps", text="Steps before the fastest walk is allowed.")
walk.yes_no("arms", True, text="Whether the arms swing.")
walk.choice("gait", "calm", ["calm", "fast", "careful"], text="The kind of walk.")
walk.text("note", "turf of hall A", text="Shown in the team's own log.")
kick = foresight.Parameters("kick")
kick.number("force", 0.8, range=(0, 1), text="Part of the strongest kick.")
kick.button("kick_now", "Kicks once, wherever the ball is.")
game = foresight.Writer("game", "foresight.GameState")
playing = 0
shown = None
while True:
    for one in (walk, kick):
        one.poll()
    values = {"walk." + name: walk[name] for name in walk}
    values["kick.force"] = kick["force"]
    values["kick.kick_now"] = kick["kick_now"]
    if values != shown:
        print(json.dumps(values), flush=True)
        shown = values
    if "game" in sys.argv:
        playing += 1
        if playing % 50 == 1:
            state = foresight.uint_field(5, 14) + foresight.uint_field(6, 2) + foresight.uint_field(7, 5)
            game.write(foresight.now_ns(), state + foresight.float_field(11, 600))
    time.sleep(0.01)
`;

/** Starts the process; `values` are those that it has now. */
function process_(t, folder, ...words) {
  const child = spawn("python3", ["-c", kProcess, ...words], {
    env: { ...process.env, PYTHONPATH: kClient, FORESIGHT_DOOR: join(folder, "door") },
    stdio: ["ignore", "pipe", "inherit"],
  });
  const state = { values: {}, child };
  createInterface({ input: child.stdout }).on("line", (line) => (state.values = JSON.parse(line)));
  atEnd(t, () => child.kill("SIGKILL"));
  return state;
}

const attached = (t, folder, ...words) =>
  start(t, folder, "foresight-robot", "--body", "attached", "--door", join(folder, "door"), ...words);

const row = (page, name) => page.locator(`[data-parameter="${name}"]`);
const is = (state, name, value) =>
  until(
    () => state.values[name] === value,
    `${name} = ${value}`,
    undefined,
    () => state.values,
  );

test("parameters are found, set, reset, saved and loaded", async (t) => {
  const folder = temporaryFolder(t);
  const server = await attached(t, folder);
  const { page, problems } = await open(t, `${server.http}/#/14/2/parameters`);
  await page.getByText("No process of 14/2 has announced parameters.").waitFor();
  await shootEach(page, "parameters-none");
  const state = process_(t, folder);
  await row(page, "walk.step_height").waitFor();
  await page.getByRole("region", { name: "Process kick" }).waitFor();
  await shootEach(page, "parameters");

  // numbers by keyboard, by slider and typed
  const slider = page.getByLabel("walk.step_height slider");
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await is(state, "walk.step_height", 0.0205);
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + 20, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width + 40, box.y + box.height / 2, { steps: 12 });
  await page.mouse.up();
  await is(state, "walk.step_height", 0.05);
  const gain = page.getByLabel("gain", { exact: true });
  await gain.fill("-2,75");
  await gain.press("Enter");
  await is(state, "walk.gain", -2.75);

  // the other types
  await page.getByLabel("arms", { exact: true }).uncheck();
  await is(state, "walk.arms", false);
  await page.getByLabel("gait", { exact: true }).selectOption("careful");
  await is(state, "walk.gait", "careful");
  await page.getByLabel("note", { exact: true }).fill('wet "turf", Tor №2');
  await page.getByLabel("note", { exact: true }).press("Enter");
  await is(state, "walk.note", 'wet "turf", Tor №2');

  const kick = page.getByRole("button", { name: "kick now", exact: true });
  await row(page, "kick.kick_now").getByText("not pressed yet").waitFor();
  await kick.click();
  await is(state, "kick.kick_now", 1);
  await kick.click();
  await is(state, "kick.kick_now", 2);
  await row(page, "kick.kick_now").getByText("pressed twice").waitFor();

  // a wrong value gets one sentence, and nothing is sent
  const warmUp = page.getByLabel("warm_up", { exact: true });
  for (const [typed, sentence] of [
    ["11", "walk.warm_up: expected 0 to 10 steps, got 11."],
    ["1.5", "walk.warm_up: expected a whole number, got 1.5."],
    ["many", "walk.warm_up: expected a number, got “many”."],
  ]) {
    await warmUp.fill(typed);
    await warmUp.press("Enter");
    await row(page, "walk.warm_up").getByText(sentence).waitFor();
  }
  await shootEach(page, "parameters-changed");
  await warmUp.press("Escape");
  assert.equal(await warmUp.inputValue(), "3");
  assert.equal(state.values["walk.warm_up"], 3);

  // search and filter; a link shows the same
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.getByLabel("Search parameters").fill("hip");
  await row(page, "walk.speed").waitFor({ state: "detached" });
  assert.equal(await page.locator("[data-parameter]").count(), 1);
  assert.match(page.url(), /parameters=hip/);
  await page.getByLabel("Search parameters").fill("");
  await page.getByRole("button", { name: "Changed (5)" }).click();
  await row(page, "kick.force").waitFor({ state: "detached" });
  assert.equal(await page.locator("[data-parameter]").count(), 5);
  await page.getByRole("button", { name: "Changed (5)" }).click();

  // save, reset all, undo, reset one, load
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save as a file" }).click(),
  ]);
  const file = join(folder, download.suggestedFilename());
  await download.saveAs(file);
  assert.equal(JSON.parse(readFileSync(file, "utf8")).values["walk.step_height"], 0.05);
  await page.getByRole("button", { name: "Reset all" }).click();
  await page.getByText("5 values reset.").waitFor();
  await is(state, "walk.gait", "calm");
  await is(state, "walk.step_height", 0.02);
  await page.getByRole("button", { name: "Undo" }).click();
  await is(state, "walk.step_height", 0.05);
  await page.getByRole("button", { name: "Reset walk.step_height" }).click();
  await is(state, "walk.step_height", 0.02);
  await page.getByRole("button", { name: "Changed (4)" }).waitFor();
  await page.getByLabel("Load a file").setInputFiles(file);
  await page.getByText(/^1 value set from/).waitFor();
  await is(state, "walk.step_height", 0.05);
  writeFileSync(
    file,
    JSON.stringify({ foresight_parameters: 1, values: { "walk.speed": 9, "walk.knee": 1, "kick.force": 0.5 } }),
  );
  await page.getByLabel("Load a file").setInputFiles(file);
  await page.getByText("walk.speed: expected 0 to 0.4 m/s, got 9.").waitFor();
  await page.getByText('"walk.knee": no process announces this parameter.').waitFor();
  await is(state, "kick.force", 0.5);
  await shootEach(page, "parameters-loaded");
  assert.deepEqual(problems, []);
});

test("parameters of a killed process are shown as gone, and it gets its values again", async (t) => {
  const folder = temporaryFolder(t);
  const server = await attached(t, folder);
  const first = process_(t, folder);
  const { page, problems } = await open(t, `${server.http}/#/14/2/parameters`);
  await page.getByLabel("gait", { exact: true }).selectOption("fast");
  await is(first, "walk.gait", "fast");
  first.child.kill("SIGKILL");
  // the connections of its two groups end one after the other
  await page.getByText("gone – its values are kept until it is back").nth(1).waitFor();
  assert.equal(await page.getByLabel("gait", { exact: true }).isDisabled(), true);
  await shootEach(page, "parameters-gone");
  const second = process_(t, folder);
  await is(second, "walk.gait", "fast");
  await page.getByText("gone – its values are kept until it is back").first().waitFor({ state: "detached" });
  assert.equal(await page.getByLabel("gait", { exact: true }).isDisabled(), false);

  // a moment of the past shows its values, which cannot be changed
  await page.keyboard.press("Space");
  await page.getByText("These are the values of the moment that is shown.").waitFor();
  await page.getByRole("button", { name: "Go to now" }).click();
  await page.getByText("These are the values of the moment that is shown.").waitFor({ state: "detached" });
  assert.deepEqual(problems, []);
});

test("a game locks the parameters for other machines", needsNetwork, async (t) => {
  const folder = temporaryFolder(t);
  const server = await attached(t, folder, "--bind", "0.0.0.0");
  const token = readFileSync(join(folder, "state/token"), "utf8").trim();
  const state = process_(t, folder);
  const { page, problems } = await open(t, `http://${own}:${server.port}/?token=${token}#/14/2/parameters`);
  await page.getByLabel("gait", { exact: true }).selectOption("fast");
  await is(state, "walk.gait", "fast");
  process_(t, folder, "game");
  await until(async () => (await statusOf(server)).game.match_mode, "match mode");
  await page.getByText("A game is in progress: the parameters are locked until it has finished").waitFor();
  assert.equal(await page.getByLabel("gait", { exact: true }).isDisabled(), true);
  await shootEach(page, "parameters-match");
  // on the robot itself people still set them
  const { page: here } = await open(t, `${server.http}/#/14/2/parameters`);
  await here.getByLabel("gait", { exact: true }).selectOption("careful");
  await is(state, "walk.gait", "careful");
  assert.deepEqual(problems, []);
});
