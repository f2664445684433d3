// Waiting times at the viewer, in Chromium without a graphics card: a seek in a long recording, opening a large
// one, the return of a page from the background. Also measures frames a second, the age and correctness of the shown
// data, and the growth of the page's memory.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { framesOf } from "../e2e/frames.mjs";
import { decode } from "../e2e/live.mjs";
import { readStreamed } from "../e2e/mcap.mjs";
import { drawn, openBrowser, openPage, state } from "./pages.mjs";
import { command, scratch, sleep, start } from "./programs.mjs";
import { Report } from "./report.mjs";
import { quantile } from "./statistics.mjs";
import { recordGame, whole } from "./viewer_whole.mjs";

const kSeeks = 60;
const kFourRobots = ["14/2", "14/3", "14/4", "14/5"];
const kLayers = "belief,uncertainty,view,intent,team,trail,names,everyone";
// the views of four robots; all objects of the first robot come in every view
const kViews = {
  camera: "camera",
  "8 plots": `plot?plot=${kFourRobots.flatMap((robot) => [`/${robot}/ball.x`, `/${robot}/pose.x`]).join("%20")}`,
  field: `field?layers=${kLayers}`,
  "four panes with raw pictures, field, plot and decision": `camera?panes=row(col(camera,field),col(plot,decision))&2.layers=${kLayers}&3.plot=ball.x%20ball.y%20pose.x`,
};

const stands = (page) => page.getByRole("button", { name: "Go on" }).waitFor();
const momentOf = (page) => BigInt(/[?&]at=(\d+)/.exec(page.url())?.[1] ?? 0);

async function seeks(report, browser, session) {
  const lab = start("foresight-lab", ["play", session, ...state]);
  const { page, seen } = await openPage(
    browser,
    `${await lab.address}/#/14/2/field?layers=truth,belief,error,uncertainty,view,intent,team,trail,names,everyone`,
  );
  await page.getByRole("button", { name: "Freeze view" }).click();
  await stands(page);
  const box = await page.getByLabel("Timeline").boundingBox();
  const times = [];
  const objects = [];
  for (let i = 0; i < kSeeks; ++i) {
    const before = seen.sought;
    const asked = performance.now();
    await page.mouse.click(box.x + (0.02 + 0.96 * Math.random()) * box.width, box.y + 20);
    while (seen.sought === before && performance.now() - asked < 5000) await sleep(0.002);
    await sleep(0.6); // longer than all measured times: every message has arrived
    // the server's own objects come once a second, independent of the seek
    const recorded = [...seen.first].filter(([id]) => !seen.topics.get(seen.subscribed.get(id))?.startsWith("/lab/"));
    const last = Math.max(...recorded.map(([, time]) => time));
    const atScreen = performance.now();
    await drawn(page);
    times.push(last - asked + (performance.now() - atScreen)); // and the time until it is drawn
    objects.push(recorded.length);
  }
  await page.close();
  lab.stop();
  report.figure(
    "seek in 20 min of 5 robots each: objects shown, at least",
    Math.min(...objects),
    `of ${seen.subscribed.size} subscribed`,
  );
  report.figure("seek until all is drawn, median", quantile(times, 0.5), "ms");
  report.figure("seek until all is drawn, p95", quantile(times, 0.95), "ms", { atMost: 200 });
}

/** Four robots, each with both cameras' raw pictures and all objects at 30 Hz. */
async function fluid(report, browser, seconds) {
  const sessions = kFourRobots.map((robot) => join(scratch, `fluid.${robot.replace("/", ".")}`));
  for (const [i, session] of sessions.entries())
    await start("foresight-lab", ["synthesize", session, "--robot", kFourRobots[i], "--seconds", 30]).output;
  const lab = start("foresight-lab", ["play", ...sessions, "--loop", ...state]);
  for (const [name, view] of Object.entries(kViews)) {
    const pictures = name.includes("raw pictures") ? "full" : "light";
    const { page, seen } = await openPage(browser, `${await lab.address}/#/14/2/${view}`, { picture: pictures });
    await sleep(5);
    const [before, began] = [seen.messages, performance.now()];
    report.figure(
      `four robots, ${name}: frames a second, median`,
      1000 / quantile(await framesOf(page, seconds), 0.5),
      "1/s",
      { atLeast: 55 },
    );
    report.figure(
      `four robots, ${name}: messages that the page takes in`,
      (seen.messages - before) / ((performance.now() - began) / 1000),
      "1/s",
    );
    await page.close();
  }
  lab.stop();
}

async function opens(report, browser, length) {
  const session = join(scratch, "large");
  await start("foresight-lab", ["synthesize", session, "--seconds", length]).output;
  report.figure("large session", Number(command("du", "-sb", session).split("\t")[0]) / 1e9, "GB", { atLeast: 1 });
  const began = performance.now();
  const lab = start("foresight-lab", ["play", session, ...state]);
  const address = await lab.address;
  const served = performance.now();
  const { page } = await openPage(browser, `${address}/#/14/2/camera`);
  await page.locator("canvas[aria-label='top camera']:not([hidden])").waitFor();
  const shown = performance.now();
  await page.close();
  lab.stop();
  report.figure("from start to the first picture of it", (shown - began) / 1000, "s", { atMost: 2 });
  report.figure("of that until the server answers", (served - began) / 1000, "s");
}

/** Returns the messages of a session that @mcap/core reads, by topic. */
function contentsOf(session) {
  return new Map(
    readdirSync(session)
      .filter((name) => name.endsWith(".mcap"))
      .flatMap((name) => [...readStreamed(readFileSync(join(session, name))).topics]),
  );
}

async function exact(report, browser, probes) {
  const session = join(scratch, "exact");
  await start("foresight-lab", ["synthesize", session, "--seconds", 30]).output;
  const contents = contentsOf(session);
  const lab = start("foresight-lab", ["play", session, ...state]);
  const { page } = await openPage(browser, `${await lab.address}/#/14/2/objects`);
  await page.getByRole("button", { name: "Freeze view" }).click();
  await stands(page);
  const box = await page.getByLabel("Timeline").boundingBox();
  const names = ["pose", "odometry", "inertial", "battery", "motion_status"].filter((name) =>
    contents.has(`/14/2/${name}`),
  );
  let compared = 0;
  let wrong = 0;
  for (let probe = 0; probe < probes; ++probe) {
    const name = names[Math.floor((probe * names.length) / probes)];
    const { schema, messages } = contents.get(`/14/2/${name}`);
    if (probe === 0 || name !== names[Math.floor(((probe - 1) * names.length) / probes)]) {
      await page.getByRole("searchbox").fill(name);
      await page.getByRole("button", { name: "Open all" }).click();
    }
    const before = momentOf(page);
    await page.mouse.click(box.x + (0.01 + 0.98 * Math.random()) * box.width, box.y + 20);
    for (let waited = 0; momentOf(page) === before && waited < 2; waited += 0.01) await sleep(0.01);
    const moment = momentOf(page);
    const then = messages.findLast(({ logTime }) => logTime <= moment);
    const expected = then && decode(schema.name, schema.data, then.data);
    // numbers at the top level of the message, as the tree formats them
    const wanted = Object.entries(expected ?? {}).filter(([, value]) => typeof value === "number");
    let right = false;
    for (let waited = 0; !right && waited < 2; waited += 0.02) {
      const rows = await page.evaluate(() =>
        [...document.querySelectorAll("[role=treeitem][aria-level='2']")].map((row) => [
          row.querySelector(".name").textContent.replace(/[▾▸]/g, "").trim(),
          row.querySelector(".value > span")?.textContent ?? "",
        ]),
      );
      const shown = new Map(rows);
      const visible = wanted.filter(([key]) => shown.has(key));
      right =
        visible.length > 0 && visible.every(([key, value]) => Number(shown.get(key)) === Number(value.toPrecision(7)));
      if (right) compared += visible.length;
      else await sleep(0.02);
    }
    if (!right) {
      ++wrong;
      console.log(`   ${name} at ${moment}: expected ${JSON.stringify(Object.fromEntries(wanted))}`);
    }
  }
  await page.close();
  lab.stop();
  report.figure("exact: probes", probes, "", { atLeast: 1000 });
  report.figure("exact: values compared", compared);
  report.figure("exact: probes that showed anything else", wrong, "", { exactly: 0 });
}

const kAge = (page) =>
  page.evaluate(() => {
    const row = [...document.querySelectorAll("tr")].find(
      (one) => one.querySelector("th")?.textContent.trim() === "pose",
    );
    const text = row?.querySelectorAll("td")[2]?.textContent ?? "";
    const [, value, unit] = /^([\d.]+) (ms|s)$/.exec(text) ?? [];
    return value === undefined ? undefined : Number(value) * (unit === "s" ? 1000 : 1);
  });

async function live(report, browser, { minutes, seconds }) {
  const robot = start("foresight-robot", ["--body", "sim", "--loop", "--log-dir", join(scratch, "logs"), ...state]);
  const { page } = await openPage(browser, `${await robot.address}/#/14/2/health`);
  await page.getByText("Page draws").waitFor();
  await sleep(5);
  const ages = [];
  for (let passed = 0; passed < seconds; passed += 0.13) {
    const age = await kAge(page);
    if (age !== undefined) ages.push(age);
    await sleep(0.13);
  }
  report.figure("age of a pose on the loopback, median", quantile(ages, 0.5), "ms");
  report.figure("age of a pose on the loopback, p95", quantile(ages, 0.95), "ms", { below: 150 });

  // a tab in the background stands still; afterwards it must skip the waiting data
  const devtools = await page.context().newCDPSession(page);
  const clock = () =>
    page
      .getByLabel("Moment", { exact: true })
      .textContent()
      .then((text) => text.split(":").reduce((sum, part) => 60 * sum + Number(part), 0)); // [s] of the day
  const [slept, before] = [performance.now(), await clock()];
  await devtools.send("Page.setWebLifecycleState", { state: "frozen" });
  await sleep(20);
  await devtools.send("Page.setWebLifecycleState", { state: "active" });
  const woken = performance.now();
  while (Math.abs((await clock()) - before - (performance.now() - slept) / 1000) > 0.3 || !((await kAge(page)) < 300)) {
    if (performance.now() - woken > 20000) break;
    await sleep(0.01);
  }
  report.figure("back to now after 20 s in the background", (performance.now() - woken) / 1000, "s", { below: 1 });

  // memory of the scripts, without the history that is kept on purpose, which is in buffers
  const heap = async () => {
    await devtools.send("HeapProfiler.collectGarbage");
    return (await devtools.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  await page.goto(page.url().replace("/health", "/field"));
  await sleep(20);
  const first = await heap();
  await sleep(60 * minutes);
  const last = await heap();
  await page.close();
  robot.stop();
  report.figure("memory of the scripts at the beginning", first, "MB");
  report.figure(`memory that it grew by in ${minutes} min`, last - first, "MB", { below: 3 });
}

/**
 * Options: `minutes` of watching for the memory, `seconds` for the age and for each view of four robots, `probes` of the
 * tree, `length` [min] of the game to seek in. `large` [s] is the length of a recording with pictures; 400 make more than
 * 1 GB. A value of 0 leaves a part out.
 */
export async function viewer({ minutes = 30, seconds = 30, probes = 1000, length = 20, large = 400 }) {
  const report = new Report("viewer", "what does a person at the viewer wait for, and is it right?");
  const browser = await openBrowser();
  if (seconds > 0) await fluid(report, browser, seconds);
  if (seconds > 0) await live(report, browser, { minutes, seconds });
  if (large > 0) await opens(report, browser, large);
  const game = length > 0 ? await recordGame(length) : undefined;
  if (game) await whole(report, browser, game);
  if (game) await seeks(report, browser, game);
  if (probes > 0) await exact(report, browser, probes);
  await browser.close();
  return report.finish();
}
