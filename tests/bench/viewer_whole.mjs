// Opening a long recording in the viewer: the time until all of its events are listed, and until a plot of the whole is
// drawn.
import { join } from "node:path";
import { openPage, state } from "./pages.mjs";
import { scratch, sleep, start } from "./programs.mjs";

const kPatience = 120; // [s]
const kFirstLine = [0x00, 0x7a, 0xad]; // in the light theme: src/draw/plot.ts

/** A simulated game of two teams of five, `minutes` long, as one recording of all beliefs and actions of its robots. */
export async function recordGame(minutes) {
  const game = join(scratch, "game.mcap");
  const rules = `spl2025:5,halves=1,half_duration=${60 * minutes}`;
  await start("foresight-sim", ["match", "--rules", rules, "--mcap", game]).output;
  return game;
}

/** Opens the recording anew in `view`; `shown` waits for what is measured. Returns the time from the program's start [s]. */
async function timeUntil(browser, game, view, shown) {
  const began = performance.now();
  const lab = start("foresight-lab", ["play", game, ...state]);
  const address = await lab.address;
  const { page } = await openPage(browser, `${address}/#/14/2/${view}`);
  const found = await shown(page, address);
  const passed = (performance.now() - began) / 1000;
  await page.close();
  lab.stop();
  return { passed, found };
}

/** Asks again and again until the answer is true. */
async function until(holds, what) {
  for (let waited = 0; !(await holds()); waited += 0.03) {
    if (waited > kPatience) throw new Error(`viewer: no ${what} within ${kPatience} s`);
    await sleep(0.03); // often enough, and the page has time to draw
  }
}

/** Waits until the list has as many events as the server knows. Returns their number. */
async function allEvents(page, address) {
  await page.getByRole("button", { name: "Find moments" }).click();
  const rows = page.getByRole("list", { name: "Events" }).getByRole("button");
  await rows.first().waitFor();
  const { events } = await (await fetch(`${address}/api/whole/events`)).json();
  await until(async () => (await rows.count()) === events.length, "list of all events");
  return events.length;
}

/** Waits until the first line is drawn in each tenth of the plot but the outermost ones. */
async function wholePlot(page) {
  const canvas = page.locator("canvas[aria-label=Plot]");
  await canvas.waitFor();
  await until(() => canvas.evaluate(isDrawnEverywhere, kFirstLine), "plot of the whole recording");
}

/** Runs in the page. */
function isDrawnEverywhere(element, colour) {
  const { width, height } = element;
  if (width === 0 || height === 0) return false;
  const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(element, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height);
  const tenths = new Set();
  for (let i = 0; i < width * height; ++i)
    if (colour.every((value, c) => Math.abs(data[4 * i + c] - value) < 24))
      tenths.add(Math.floor((10 * (i % width)) / width));
  return [1, 2, 3, 4, 5, 6, 7, 8].every((tenth) => tenths.has(tenth));
}

export async function whole(report, browser, game) {
  const listed = await timeUntil(browser, game, "field", allEvents);
  report.figure("whole recording: events in it", listed.found);
  report.figure("from start until all its events are listed", listed.passed, "s", { atMost: 3 });
  const plot = await timeUntil(browser, game, "plot?plot=/14/2/ball.x%20/14/2/pose.x", wholePlot);
  report.figure("from start until its whole is plotted", plot.passed, "s", { atMost: 3 });
}
