// Every view in both themes, on a desktop, an upright tablet and a phone. Texts are readable and whole, controls have names
// and a visible focus, and fingers find large targets.
import assert from "node:assert/strict";
import { test } from "node:test";
import { faultsOf, unmarkedFocus } from "./audit.mjs";
import { kPhone, open } from "./browser.mjs";
import { start, temporaryFolder, until } from "./support.mjs";

const kTouch = { hasTouch: true, isMobile: true };
const kScreens = {
  desktop: { viewport: { width: 1440, height: 900 } },
  tablet: { viewport: { width: 820, height: 1180 }, ...kTouch },
  phone: { viewport: kPhone, ...kTouch },
};
/** The hash of each view, and the name of its region. */
const kViews = {
  field: "Field",
  camera: "Camera",
  objects: "Objects",
  "plot?plot=ball.x%20distance(ball,truth.ball)": "Plot",
  decision: "Decision",
  "what-if": "What-if",
  health: "Health",
  log: "Log",
  sessions: "Sessions",
  parameters: "Parameters",
  debug: "Debug",
  "ground-truth": "Ground truth",
  "field?panes=row(field:3,col(decision:3,plot:2):2)&3.plot=ball.x": "Field",
};
/** Dialogs by their names, and how they are opened. Escape closes them. */
const kOverlays = {
  Layout: (page) => page.getByRole("button", { name: "Layout" }).click(),
  "Robots and servers": (page) => page.getByRole("button", { name: "Robots and servers" }).click(),
  Keys: (page) => page.keyboard.press("?"),
};

const simulated = (t) =>
  start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7", "--player", "2");

/** Waits until a judge finds no fault: a view may still be loading. */
async function soundly(page, judge, options, where) {
  let faults;
  const judged = async () => (faults = await page.evaluate(judge, options)).length === 0;
  await until(judged, `${where} without faults`, 10_000, () => faults).catch(() => {});
  assert.deepEqual(faults, [], where);
}

async function soundInBothThemes(page, screen, where) {
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    await soundly(page, faultsOf, { finger: screen !== "desktop" }, `${where}, ${screen}, ${colorScheme}`);
  }
}

for (const [screen, options] of Object.entries(kScreens))
  test(`on a ${screen}, every view is readable, named and whole in both themes`, async (t) => {
    const server = await simulated(t);
    const { page, problems } = await open(t, `${server.http}/#/14/2/field`, options);
    for (const [hash, name] of Object.entries(kViews)) {
      await page.evaluate((hash) => (location.hash = `#/14/2/${hash}`), hash);
      await page.getByRole("region", { name, exact: true }).first().waitFor();
      await soundInBothThemes(page, screen, hash);
      if (screen === "desktop") await soundly(page, unmarkedFocus, undefined, `the focus in ${hash}`);
    }
    if (screen === "desktop")
      for (const [name, show] of Object.entries(kOverlays)) {
        await show(page);
        await page.getByRole("dialog", { name }).waitFor();
        await soundInBothThemes(page, screen, name);
        await page.keyboard.press("Escape");
      }
    await page.getByRole("button", { name: "Find moments" }).click();
    await page.getByRole("region", { name: "Moments" }).waitFor();
    await soundInBothThemes(page, screen, "moments");
    assert.deepEqual(problems, []);
  });

test("on a phone, header, team and time take at most a quarter of the height, and the own team is first", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`, kScreens.phone);
  const team = page.getByRole("group", { name: "Team" });
  await team.getByRole("button").nth(5).waitFor();
  const titles = await team.getByRole("button").evaluateAll((all) => all.map(({ title }) => title.split("/")[0]));
  assert.deepEqual(
    titles,
    [...titles].sort((one, other) => Number(other === "14") - Number(one === "14")),
  );
  assert.equal(titles[0], "14");
  const heights = await page
    .locator("#app > :is(header, .team, footer)")
    .evaluateAll((all) => all.map((element) => element.getBoundingClientRect().height));
  assert.equal(heights.length, 3);
  const share = heights.reduce((sum, height) => sum + height, 0) / kPhone.height;
  assert.ok(share <= 0.25, `they take ${(100 * share).toFixed(0)} % of the height`);
  assert.deepEqual(problems, []);
});
