// Several views beside each other on one time: split, drag, maximise, keys, a robot for each pane, and links.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { kPhone, open, shoot } from "./browser.mjs";
import { robot, start, synthesize, temporaryFolder, until } from "./support.mjs";

const kWide = { width: 1440, height: 900 };
const kUpright = { width: 820, height: 1180 };
const simulated = (t) =>
  start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--seed", "7", "--player", "2");

/** The shown views in reading order. */
const viewsOf = (page) =>
  page
    .locator("[data-pane] > section, [data-pane] > .view")
    .evaluateAll((all) => all.map((view) => view.getAttribute("aria-label")));
const shows = (page, ...views) =>
  until(
    async () => (await viewsOf(page)).join() === views.join(),
    views.join(),
    undefined,
    () => viewsOf(page),
  );
const panesIn = (page) => new URLSearchParams(new URL(page.url()).hash.split("?")[1] ?? "").get("panes") ?? "";
const pane = (page, number) => page.locator(`[data-pane="${number}"]`);
const boxOf = (page, number) => pane(page, number).boundingBox();
const isMarked = (page, number) =>
  until(
    () => pane(page, number).evaluate((element) => element.classList.contains("marked")),
    `pane ${number} gets the keys`,
  );

test("a view is split, and panes are dragged, maximised and closed, by mouse", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await shows(page, "Field");
  assert.equal(await page.getByRole("button", { name: "Maximise" }).count(), 0, "one pane has no title");
  await page.getByRole("button", { name: "Split right" }).click();
  await shows(page, "Field", "Decision");
  await isMarked(page, 2);
  await pane(page, 2).getByRole("button", { name: "Split below" }).click();
  await shows(page, "Field", "Decision", "Plot");
  await page.waitForURL((url) => url.hash.includes("panes=row(field,col(decision,plot))"));

  // a border
  const border = page.getByRole("separator").first();
  const before = await boxOf(page, 1);
  const { x, y, height } = await border.boundingBox();
  await page.mouse.move(x + 4, y + height / 4);
  await page.mouse.down();
  await page.mouse.move(x + 100, y + height / 4, { steps: 3 });
  await page.mouse.move(x + 204, y + height / 4);
  await page.mouse.up();
  await until(async () => Math.abs((await boxOf(page, 1)).width - before.width - 200) < 10, "a wider field");
  await until(() => /^row\(field:6\d,col\(decision,plot\):3\d\)$/.test(panesIn(page)), "its weight in the address");
  await border.press("ArrowLeft");
  await until(async () => (await boxOf(page, 1)).width < before.width + 160, "a narrower field by the keyboard");

  // a title
  const title = pane(page, 2).locator("header strong").first();
  await title.dblclick();
  await shows(page, "Decision");
  assert.match(panesIn(page), /decision!/);
  await page.reload();
  await shows(page, "Decision");
  await title.dblclick();
  await shows(page, "Field", "Decision", "Plot");

  await pane(page, 2).getByRole("button", { name: "Close the pane" }).click();
  await shows(page, "Field", "Plot");
  await pane(page, 3).getByRole("button", { name: "Close the pane" }).click();
  await shows(page, "Field");
  assert.equal(panesIn(page), "");
  await page.goBack();
  await shows(page, "Field", "Plot");
  await shoot(page, "panes-two");
  assert.deepEqual(problems, []);
});

test("keys split, close, change and maximise panes, and go to the marked one", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await shows(page, "Field");
  await page.keyboard.press("a");
  await shows(page, "Field", "Decision");
  await page.keyboard.press("A");
  await shows(page, "Field", "Decision", "Plot");
  await isMarked(page, 3);
  await page.keyboard.press("1"); // the view of the marked pane
  await shows(page, "Field", "Decision", "Field");
  await page.keyboard.press("e");
  await isMarked(page, 1);
  await page.keyboard.press("E");
  await isMarked(page, 3);
  await page.keyboard.press("f"); // follows in one of the two fields
  await page.waitForURL((url) => url.hash.includes("3.follow=yes"));
  assert.doesNotMatch(page.url(), /[?&]follow=/);
  await page.keyboard.press("z");
  await shows(page, "Field");
  await page.keyboard.press("e"); // the next one alone
  await page.keyboard.press("e");
  await shows(page, "Decision");
  await page.keyboard.press("z");
  await shows(page, "Field", "Decision", "Field");
  await page.keyboard.press("q");
  await shows(page, "Field", "Field");
  for (let more = 0; more < 6; ++more) await page.keyboard.press("a");
  await until(async () => (await viewsOf(page)).length === 6, "six panes");
  await page.getByText("A page has 6 panes at most: close one first.").waitFor();
  await page.keyboard.press("?");
  for (const text of ["add a pane to the right, or below", "close the pane", "next or previous pane", "the pane alone"])
    await page.getByRole("dialog", { name: "Keys" }).getByText(text).waitFor();
  assert.deepEqual(problems, []);
});

test("each pane has its own robot and settings, and a link shows the same again", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field?layers=truth`, { viewport: kWide });
  await shows(page, "Field"); // a link of one view stays one view, also on a wide screen
  await page.keyboard.press("a");
  await page.keyboard.press("1");
  await shows(page, "Field", "Field");
  await pane(page, 2).getByRole("combobox", { name: "Robot of this pane" }).selectOption("5/3");
  await page.waitForURL((url) => url.hash.includes("2.robot=5/3"));
  await pane(page, 2).getByRole("button", { name: "Layers", exact: true }).click();
  await pane(page, 2).getByRole("button", { name: "names" }).click();
  await page.waitForURL((url) => /2\.layers=[^&]*names/.test(url.hash));
  const { hash } = new URL(page.url());
  assert.match(hash, /^#\/14\/2\/field\?/);
  assert.match(hash, /[?&]layers=truth(&|$)/);

  await page.keyboard.press("2"); // objects of one robot beside those of another
  await page.keyboard.press("3");
  await pane(page, 2).getByRole("treeitem").first().waitFor();
  await page.keyboard.press("1");
  await page.keyboard.press("j"); // the next robot of the marked pane
  await page.waitForURL((url) => url.hash.includes("2.robot=5/4"));
  assert.match(page.url(), /#\/14\/2\//);

  const again = await open(t, `${server.http}/${hash}`, { viewport: kWide });
  await shows(again.page, "Field", "Field");
  assert.equal(new URL(again.page.url()).hash, hash);
  assert.equal(await pane(again.page, 2).getByRole("combobox", { name: "Robot of this pane" }).inputValue(), "5/3");
  await pane(again.page, 2).getByRole("button", { name: "Layers", exact: true }).click();
  assert.equal(await pane(again.page, 2).getByRole("button", { name: "names" }).getAttribute("aria-pressed"), "true");
  assert.deepEqual([...problems, ...again.problems], []);
});

test("an arrangement saved as a file is loaded again, with its panes", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/field`);
  await page.keyboard.press("C");
  await shows(page, "Field", "Field", "Plot");
  const panes = panesIn(page);
  await page.getByRole("button", { name: "Layout", exact: true }).click();
  const [saved] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save as a file" }).click(),
  ]);
  const path = await saved.path();
  assert.equal(JSON.parse(readFileSync(path, "utf8")).settings.panes, panes);
  for (const number of [3, 2]) await pane(page, number).getByRole("button", { name: "Close the pane" }).click();
  await shows(page, "Field");
  await page.getByRole("button", { name: "Layout", exact: true }).click();
  await page.getByLabel("Load a file").setInputFiles(path);
  await shows(page, "Field", "Field", "Plot");
  assert.equal(panesIn(page), panes);
  assert.deepEqual(problems, []);
});

test("ready arrangements come by key and by menu; a wide page without a choice begins with Why", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, server.http, { viewport: kWide });
  await shows(page, "Field", "Decision", "Plot");
  await page.getByRole("list", { name: "Lines" }).getByText("ball.x").waitFor(); // the plot is not empty
  await shoot(page, "panes-why");
  await page.keyboard.press("M");
  await shows(page, "Field", "Log", "Health");
  await page.getByRole("button", { name: "Layout", exact: true }).click();
  await page.getByRole("button", { name: /^Seeing/ }).click();
  await shows(page, "Camera", "Field", "Plot");
  await page.keyboard.press("C");
  await shows(page, "Field", "Field", "Plot");
  const robotOf = (number) => pane(page, number).getByRole("combobox", { name: "Robot of this pane" }).inputValue();
  assert.equal(await robotOf(1), "", "the page's robot");
  assert.equal(await robotOf(2), "14/3");
  await shoot(page, "panes-compare");
  await page.keyboard.press("W");
  await shows(page, "Field", "Decision", "Plot");

  const small = await open(t, server.http);
  await shows(small.page, "Field");
  assert.deepEqual([...problems, ...small.problems], []);
});

test("an upright tablet shows two panes above each other, a phone one, and both reach the others", async (t) => {
  const server = await simulated(t);
  const hash = "#/14/2/field?panes=row(field:3,col(decision,plot):2)&3.plot=ball.x";
  const touch = { hasTouch: true, isMobile: true };
  const tablet = await open(t, `${server.http}/${hash}`, { viewport: kUpright, ...touch });
  await shows(tablet.page, "Field", "Decision");
  const [first, second] = [await boxOf(tablet.page, 1), await boxOf(tablet.page, 2)];
  assert.ok(first.width === kUpright.width && second.y >= first.y + first.height);
  await tablet.page.getByRole("button", { name: "3 Plot" }).tap();
  await shows(tablet.page, "Plot");
  await shoot(tablet.page, "panes-tablet");

  const phone = await open(t, `${server.http}/${hash}`, { viewport: kPhone, ...touch });
  await shows(phone.page, "Field");
  await phone.page.getByRole("button", { name: "2 Decision" }).tap();
  await shows(phone.page, "Decision");
  await shoot(phone.page, "panes-phone");
  assert.equal(new URL(phone.page.url()).hash, hash, "the link keeps all panes");
  assert.deepEqual([...tablet.problems, ...phone.problems], []);
});

test("the first view has data: a robot without pictures does not open on black cameras", async (t) => {
  const folder = temporaryFolder(t);
  const blind = await start(
    t,
    folder,
    "foresight-robot",
    ...["--body", "attached", "--behaviour", "baseline", "--team", "14", "--player", "2"],
    ...["--door", `${folder}/door`],
  );
  const { page, problems } = await open(t, blind.http);
  await shows(page, "Field");
  const seeing = await robot(t, folder, await synthesize(folder, { seconds: 2 }), "--loop");
  const other = await open(t, seeing.http);
  await shows(other.page, "Camera");
  assert.deepEqual([...problems, ...other.problems], []);
});

test("the team bar shows every robot on every view; a tap chooses one, and a silent one is gone", async (t) => {
  const server = await simulated(t);
  const { page, problems } = await open(t, `${server.http}/#/14/2/log`, { breaksConnections: true });
  const team = page.getByRole("group", { name: "Team" });
  const tiles = team.getByRole("button");
  await until(async () => (await tiles.count()) === 8, "a tile for each robot");
  await team.getByText("ready").first().waitFor();
  const skill = async () => (await tiles.nth(1).textContent()).includes("get ready");
  await until(skill, "the skill of 14/2");
  assert.equal(await tiles.nth(1).getAttribute("aria-pressed"), "true"); // the own team comes first
  await tiles.nth(4).click();
  await page.waitForURL((url) => url.hash.startsWith("#/5/1/log"));
  await page.keyboard.press("5"); // on another view it stays
  assert.equal(await tiles.nth(4).getAttribute("aria-pressed"), "true");
  server.kill("SIGSTOP");
  await team
    .getByText(/gone \d+ s/)
    .first()
    .waitFor();
  await shoot(page, "team-gone");
  server.kill("SIGCONT");
  await until(async () => (await team.getByText(/gone/).count()) === 0, "all robots back");
  assert.deepEqual(problems, []);
});
