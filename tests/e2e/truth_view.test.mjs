// The view Ground truth in a real browser, with a small server of its own in place of `foresight-lab truth`.
import assert from "node:assert/strict";
import { test } from "node:test";
import { faultsOf, unmarkedFocus } from "./audit.mjs";
import { coloursOnScreen, kPhone, open, shootEach } from "./browser.mjs";
import { play, synthesize, temporaryFolder, until } from "./support.mjs";
import { kLandmarks, pixelOf, truthServer } from "./truth_server.mjs";

/** Opens the page of any server, connected to a server of ground truth. */
async function openTruth(t, { truth, view = "ground-truth", ...options } = {}) {
  const folder = temporaryFolder(t);
  const host = await play(t, folder, await synthesize(folder, { seconds: 1 }));
  return open(t, `${host.http}/?ws=ws://127.0.0.1:${truth.port}#/${view}`, options);
}

const figure = (page, name) => page.getByRole("figure", { name });
const textOf = (locator) => locator.textContent();
const visible = (pose) =>
  kLandmarks
    .map((landmark) => ({ ...landmark, pixel: pixelOf(pose, [landmark.x, landmark.y, landmark.z]) }))
    .filter(({ pixel }) => pixel && pixel.x > 5 && pixel.y > 5 && pixel.x < 635 && pixel.y < 475);

const imageOf = (page) => page.getByLabel(/that sensor 1 sees$/);
const fieldOf = (page) => page.getByLabel("The field from above, with the truth");
/** Returns where a pixel of the image is in its box. */
function inImage({ width, height }, { x, y }) {
  const scale = Math.min(width / 640, height / 480);
  return { x: width / 2 + scale * (x - 320), y: height / 2 + scale * (y - 240) };
}
/** Returns where a point of the field is in its box, where the field lies on its long side. */
function inField({ width, height }, { x, y }) {
  // the sensor at y = -4.1 and the border of 0.7 m have room
  const scale = Math.min(width / (9 + 1.4), height / (2 * (4.1 + 0.45)));
  return { x: width / 2 + scale * x, y: height / 2 - scale * y };
}
/** Returns the place of a pixel of the image on the page. */
async function onPage(page, pixel) {
  const box = await imageOf(page).boundingBox();
  const { x, y } = inImage(box, pixel);
  return { x: box.x + x, y: box.y + y };
}
// the click waits until its target rests: an answer can move it
const clickImage = async (page, pixel) =>
  imageOf(page).click({ position: inImage(await imageOf(page).boundingBox(), pixel) });
const clickField = async (page, landmark) =>
  fieldOf(page).click({ position: inField(await fieldOf(page).boundingBox(), landmark) });
const row = (page, name) => page.getByRole("row").filter({ has: page.getByRole("button", { name, exact: true }) });

test("a sensor is described, drawn as points and as an image, and compared with the true positions", async (t) => {
  const truth = await truthServer(t);
  const { page, problems, context } = await openTruth(t, { truth });
  await page.getByRole("region", { name: "Ground truth" }).waitFor();
  const state = page.getByRole("status", { name: "Sensor" });
  await until(
    async () => /synthetic.*watching, 30\.0 images a second/s.test(await textOf(state)),
    "the sensor's state",
  );
  await until(
    async () =>
      /4 robots, ball\s+Mean error over 3 s: robots [\d.]+ cm, ball/.test(await textOf(figure(page, "Field"))),
    "the errors in words",
    undefined,
    () => textOf(figure(page, "Field")),
  );
  await until(async () => /2\.25 m\s+7\.00 m/.test(await textOf(figure(page, /^Image/))), "the range of the depths");

  // near ground is brighter than far ground
  const image = page.getByLabel("Depths that sensor 1 sees");
  const bright = ([r, g, b]) => r + g + b;
  await until(async () => {
    const colours = await coloursOnScreen(context, image, 8, 8);
    return bright(colours[6][3]) > bright(colours[3][3]) + 60;
  }, "the depths in colours");
  // the points are on the carpet's colour, in the middle of the picture
  const points = page.getByLabel("Points that sensor 1 measures");
  await until(
    async () => bright((await coloursOnScreen(context, points, 6, 6))[3][2]) > 90,
    "the points",
    undefined,
    () => coloursOnScreen(context, points, 6, 6),
  );
  await shootEach(page, "ground-truth");
  assert.deepEqual(problems, []);
});

test("a sensor without images says why, and one without a place is not calibrated", async (t) => {
  const truth = await truthServer(t);
  const { page, problems } = await openTruth(t, { truth });
  await page.getByRole("button", { name: /sensor 2/ }).click();
  await page.getByRole("alert").getByText("freenect:0: no sensor is connected").waitFor();
  await page.getByText("This sensor offers no depth image.").first().waitFor();
  truth.state.calibrated = false;
  await page.getByRole("button", { name: "sensor 1" }).click();
  await page.getByText("not calibrated: as the sensor sees it").waitFor();
  assert.deepEqual(problems, []);
});

test("a sensor learns the empty field, and says so", async (t) => {
  const truth = await truthServer(t);
  const { page, problems } = await openTruth(t, { truth });
  await page.getByRole("button", { name: "empty field" }).click();
  const panel = page.getByRole("region", { name: "Empty field" });
  await panel.getByText(/Nobody may stand on the field/).waitFor();
  await panel.getByText("not learned: depths are compared with a flat carpet").waitFor();
  await panel.getByRole("button", { name: "Learn the empty field" }).click();
  await panel.getByText("learned from 15 images").waitFor();
  await page.getByRole("status", { name: "Sensor" }).getByText("empty field learned from 15 images").waitFor();
  assert.deepEqual(truth.requests.at(-1), { name: "/truth/background", request: { sensor: 1 } });
  await shootEach(page, "ground-truth-empty-field");
  assert.deepEqual(problems, []);
});

test("a server of ground truth opens with this view, and others do not offer it", async (t) => {
  const truth = await truthServer(t);
  const { page } = await openTruth(t, { truth, view: "" });
  await page.getByRole("region", { name: "Ground truth" }).waitFor();
  const folder = temporaryFolder(t);
  const host = await play(t, folder, await synthesize(folder, { seconds: 1 }));
  const other = await open(t, `${host.http}/#/14/2/field`);
  await other.page.getByRole("link", { name: "debug", exact: true }).waitFor();
  assert.equal(await other.page.getByRole("link", { name: "ground truth" }).count(), 0);
  await other.page.evaluate(() => (location.hash = "#/14/2/ground-truth"));
  await other.page.getByText("foresight-lab truth --source synthetic").waitFor();
});

test("a sensor is calibrated by clicks in the image and on the field, in either order", async (t) => {
  const truth = await truthServer(t);
  const { page, problems } = await openTruth(t, { truth, view: "ground-truth?calibrate=yes" });
  const step = page.getByRole("status", { name: "Next step" });
  const landmarks = visible(truth.pose);
  assert.ok(landmarks.length >= 5);
  await row(page, landmarks[0].name).waitFor();

  // the image first, and the field first
  await clickImage(page, landmarks[0].pixel);
  await until(async () => /its place on the field/.test(await textOf(step)), "a question for the place");
  await clickField(page, landmarks[0]);
  await row(page, landmarks[0].name).getByText("clicked").waitFor();
  await clickField(page, landmarks[1]);
  await until(
    async () => (await textOf(step)).includes(`${landmarks[1].name} in the image`),
    "a question for the pixel",
  );
  await clickImage(page, landmarks[1].pixel);
  await page.getByRole("alert").getByText("Refused: expected at least 4 landmarks, got 2").waitFor();
  const save = page.getByRole("button", { name: "Save as lab.json" });
  assert.ok(await save.isDisabled());

  for (const landmark of landmarks.slice(2)) {
    await page.getByRole("button", { name: landmark.name, exact: true }).click();
    await clickImage(page, landmark.pixel);
  }
  const residual = async ({ name }) => Number(/([\d.]+) px/.exec(await textOf(row(page, name)))?.[1] ?? NaN);
  const all = () => Promise.all(landmarks.map(residual));
  await until(async () => (await all()).every((pixels) => pixels < 1.5), "small residuals", undefined, all);
  const verdict = page.getByRole("region", { name: "Calibration" });
  await verdict.getByText(/Expected error on the field: mean [\d.]+ cm, 95 % below [\d.]+ cm\./).waitFor();
  await shootEach(page, "ground-truth-calibration");

  // arrow keys spoil a click by 24 px, and a drag corrects it
  const last = landmarks.at(-1);
  const before = truth.requests.at(-1).request.clicks.find(({ landmark }) => landmark === last.name);
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.getByRole("button", { name: last.name, exact: true }).click();
  await page.keyboard.press("ArrowRight");
  const newest = () => truth.requests.at(-1).request.clicks.find(({ landmark }) => landmark === last.name);
  await until(() => Math.abs(newest().x - before.x - 0.25) < 1e-9, "a quarter of a pixel", undefined, newest);
  for (let i = 0; i < 12; ++i) await page.keyboard.press("Shift+ArrowRight");
  await page
    .getByRole("alert")
    .getByText(/^Refused: the landmarks are/)
    .waitFor();
  assert.ok(await save.isDisabled());
  const wrong = await onPage(page, newest());
  const right = await onPage(page, last.pixel);
  await page.mouse.move(wrong.x, wrong.y);
  await page.mouse.down();
  await page.mouse.move(right.x, right.y, { steps: 4 });
  await page.mouse.up();
  await until(async () => (await residual(last)) < 1.5, "the corrected residual", undefined, all);

  await save.click();
  await page.getByText("✓ saved as lab.json").waitFor();
  assert.equal(truth.requests.at(-1).request.save, true);
  assert.equal(truth.requests.at(-1).request.clicks.length, landmarks.length);

  // a click is removed from the list
  await page.getByRole("button", { name: `Remove the click of ${last.name}` }).click();
  await page.getByText("not saved yet").waitFor();
  await until(() => truth.requests.at(-1).request.clicks.length === landmarks.length - 1, "a fit without it");
  assert.deepEqual(problems, []);
});

test("a click is made to a fraction of a pixel, and a saved calibration is continued", async (t) => {
  const truth = await truthServer(t, { colour: false, clicks: [{ landmark: "centre line +y", x: 320, y: 96.5 }] });
  const { page, problems } = await openTruth(t, { truth, view: "ground-truth?calibrate=yes" });
  await row(page, "centre line +y").getByText("clicked").waitFor();
  const at = await onPage(page, { x: 200, y: 300 });
  await page.mouse.move(at.x, at.y);
  await page
    .getByRole("figure", { name: /^Image/ })
    .getByText(/pixel (199|200)\.\d, (299|300)\.\d/)
    .waitFor();
  for (let i = 0; i < 6; ++i) await page.mouse.wheel(0, -200);
  await page.getByRole("button", { name: "whole" }).waitFor();
  // enlarged, a pixel of the page is a small part of the image's
  const told = async () => Number(/pixel ([\d.]+),/.exec(await textOf(figure(page, /^Image/)))[1]);
  await page.mouse.move(at.x + 20, at.y);
  const [here, there] = [await told(), (await page.mouse.move(at.x + 22, at.y), await told())];
  assert.ok(there > here && there - here < 0.5, `from ${here} to ${there}`);
  await page.mouse.click(at.x + 22, at.y);
  await page.getByRole("button", { name: "centre line -y", exact: true }).click();
  const click = await until(
    () => truth.requests.at(-1).request.clicks?.find(({ landmark }) => landmark === "centre line -y"),
    "the click",
  );
  assert.ok(Math.abs(click.x - there) < 0.1, `x ${click.x}, shown ${there}`);
  assert.deepEqual(problems, []);
});

for (const [screen, viewport] of [
  ["a desktop", { width: 1440, height: 900 }],
  ["a phone", kPhone],
])
  test(`on ${screen}, all parts are readable, named and whole in both themes`, async (t) => {
    const truth = await truthServer(t);
    const finger = viewport === kPhone;
    const { page, problems } = await openTruth(t, {
      truth,
      viewport,
      ...(finger ? { hasTouch: true, isMobile: true } : {}),
    });
    await page.getByRole("status", { name: "Sensor" }).waitFor();
    for (const hash of ["", "?part=points", "?part=field", "?calibrate=yes", "?calibrate=yes&part=field"]) {
      await page.evaluate((hash) => (location.hash = `#/ground-truth${hash}`), hash);
      for (const colorScheme of ["light", "dark"]) {
        await page.emulateMedia({ colorScheme });
        let faults;
        const judged = async () => (faults = await page.evaluate(faultsOf, { finger })).length === 0;
        await until(judged, `${hash} without faults`, 10_000, () => faults).catch(() => {});
        assert.deepEqual(faults, [], `${hash} ${colorScheme}`);
      }
      if (!finger) assert.deepEqual(await page.evaluate(unmarkedFocus), [], `the focus in ${hash}`);
    }
    assert.deepEqual(problems, []);
  });
