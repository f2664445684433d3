// The workspace Debug of the viewer: the time until its first screen, until a step is drawn, and of a comparison of futures.
import { kSubprotocols, Live } from "../e2e/live.mjs";
import { require } from "../e2e/support.mjs";
import { drawn, openBrowser, openPage, state } from "./pages.mjs";
import { start } from "./programs.mjs";
import { median } from "./report.mjs";
import { quantile } from "./statistics.mjs";

const WebSocket = require("ws");

const kOpenings = 7;
const kSteps = 120;
const kChanges = 5;

/** Waits for the explained decision and its tree. */
async function explained(page) {
  const debug = page.getByRole("region", { name: "Debug", exact: true });
  await debug.getByRole("status", { name: "Why" }).filter({ hasText: " plays " }).waitFor();
  await debug.getByRole("group", { name: "Decision tree" }).getByRole("button").first().waitFor();
  await drawn(page);
}

/** Runs in the page: steps once, and returns the time until new values are drawn [ms], or undefined if none changed. */
function timeOfStep(patience) {
  const debug = document.querySelector("section[aria-label=Debug]");
  const step = [...debug.querySelectorAll("button")].find((button) => button.textContent === "Step");
  const values = debug.querySelector("table[aria-label='Comparisons on the path']");
  return new Promise((done) => {
    const began = performance.now();
    const observer = new MutationObserver(() => {
      observer.disconnect();
      requestAnimationFrame(() => setTimeout(() => done(performance.now() - began)));
    });
    observer.observe(values, { subtree: true, childList: true, characterData: true });
    setTimeout(() => (observer.disconnect(), done(undefined)), patience);
    step.click();
  });
}

/** Runs in the page: the time until the table of effects is there [ms]. */
async function timeOfFutures() {
  const panel = document.querySelector("[aria-label='Change and run again']");
  const run = panel.querySelector("button.primary");
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  while (run.disabled) await frame();
  const began = performance.now();
  run.click();
  do await frame();
  while ((run.disabled || !panel.querySelector("table")) && performance.now() - began < 60_000);
  return performance.now() - began;
}

export async function workspace(report) {
  const robot = start("foresight-robot", ["--body", "sim", "--player", 2, "--seed", 7, ...state]);
  const address = await robot.address;
  const browser = await openBrowser();
  const live = new Live(new WebSocket(`ws://${new URL(address).host}/`, kSubprotocols));
  await live.until(() => live.services.has("/sim/step"), "the services");
  // in play
  for (const ticks of [1800, 600]) await live.call("/sim/step", { ticks });
  live.socket.terminate();

  const first = [];
  let control;
  for (let i = 0; i < kOpenings; ++i) {
    const began = performance.now();
    const { page } = await openPage(browser, `${address}/#/14/2/debug`);
    await explained(page);
    first.push(performance.now() - began);
    if (i + 1 < kOpenings) await page.close();
    else control = page;
  }
  report.figure("workspace Debug: until its first screen, median", median(first) / 1000, "s", { atMost: 1 });

  const steps = [];
  for (let i = 0; i < kSteps; ++i) steps.push(await control.evaluate(timeOfStep, 1000));
  const changed = steps.filter((time) => time !== undefined);
  report.figure("workspace Debug: steps that change a shown value", changed.length);
  report.figure("workspace Debug: until a step is drawn, median", median(changed), "ms");
  report.figure("workspace Debug: until a step is drawn, p95", quantile(changed, 0.95), "ms", { atMost: 50 });

  await control.getByRole("button", { name: "change…" }).click();
  await control.getByLabel("An edit").fill("set ball 1 0.5");
  await control.keyboard.press("Enter");
  await control.getByRole("group", { name: "Moved" }).waitFor();
  const futures = [];
  for (let i = 0; i < kChanges; ++i) futures.push(await control.evaluate(timeOfFutures));
  report.figure("workspace Debug: 200 pairs of futures of 30 s, median", median(futures) / 1000, "s");
  robot.stop();
}
