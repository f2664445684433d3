// The real page in a real browser: Chromium, steered by playwright-core.
import { accessSync, constants, mkdirSync } from "node:fs";
import { after } from "node:test";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { atEnd, require } from "./support.mjs";

const { chromium } = require("playwright-core");

const found = (name) =>
  process.env.PATH.split(delimiter)
    .map((folder) => join(folder, name))
    .find(isProgram);
function isProgram(path) {
  try {
    return accessSync(path, constants.X_OK) ?? true;
  } catch {
    return false;
  }
}

// one browser of a kind for all tests of a file; each test has its own profile in it
const launched = new Map();
function browser(kind) {
  const executablePath = found("chromium") ?? found("chromium-browser") ?? found("google-chrome");
  if (!executablePath) throw new Error("there is no chromium in PATH; scripts/setup test installs it");
  const graphics =
    kind === "software3d"
      ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
      : ["--disable-gpu"];
  const args = [
    "--no-sandbox",
    ...graphics,
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
  ];
  if (!launched.has(kind)) launched.set(kind, chromium.launch({ executablePath, args }));
  return launched.get(kind);
}
after(() => Promise.all([...launched.values()].map(async (browser) => (await browser).close())));

export const kDesktop = { width: 1280, height: 800 };
export const kPhone = { width: 390, height: 844 };

/** The words that Chromium writes when a server ends. They depend on the moment in which a connection breaks. */
const kBrokenConnection =
  /ERR_CONNECTION_(REFUSED|RESET|CLOSED|ABORTED)|ERR_SOCKET_NOT_CONNECTED|ERR_EMPTY_RESPONSE|WebSocket connection to/;

/**
 * Opens a page. `problems` collects errors that a person does not see: errors on the console, exceptions, refusals by the
 * Content-Security-Policy. A test that breaks connections on purpose says so, and so does one whose page needs a graphics
 * card's functions, at the pace of a processor (`software3d`).
 */
export async function open(
  t,
  url,
  { viewport = kDesktop, breaksConnections = false, software3d = false, ...options } = {},
) {
  const context = await (
    await browser(software3d ? "software3d" : "plain")
  ).newContext({ viewport, locale: "en-GB", timezoneId: "UTC", reducedMotion: "reduce", ...options });
  atEnd(t, () => context.close());
  const page = await context.newPage();
  page.setDefaultTimeout(60_000); // room for a busy machine; only a failure takes this long
  const problems = [];
  const expected = (text) =>
    /GPU stall due to ReadPixels/.test(text) || // by our own screenshots
    (breaksConnections && kBrokenConnection.test(text));
  page.on(
    "console",
    (message) =>
      ["error", "warning"].includes(message.type()) && !expected(message.text()) && problems.push(message.text()),
  );
  page.on("pageerror", (error) => problems.push(String(error)));
  await page.exposeFunction("foresightProblem", (text) => problems.push(text));
  await page.addInitScript(() =>
    document.addEventListener("securitypolicyviolation", (event) =>
      window.foresightProblem(`CSP: ${event.violatedDirective} ${event.blockedURI}`),
    ),
  );
  await page.goto(url);
  return { page, problems, context };
}

/** Saves a screenshot for people into the folder FORESIGHT_SHOTS, by default the one of temporary files. */
export async function shoot(page, name) {
  const folder = process.env.FORESIGHT_SHOTS ?? join(tmpdir(), "foresight-shots");
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** Does the same on a desktop and on a phone, in light and in dark colours. */
export async function shootEach(page, name) {
  for (const [device, viewport] of [
    ["desktop", kDesktop],
    ["phone", kPhone],
  ])
    for (const colorScheme of ["light", "dark"]) {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      await shoot(page, `${name}-${device}-${colorScheme}`);
    }
}

/** Returns the mean colours of the cells of a grid over the picture of `locator`: rows of [r, g, b]. */
export async function coloursOnScreen(context, locator, columns, rows) {
  const png = await locator.screenshot();
  const page = await context.newPage(); // a blank one may do what the viewer's policy forbids
  try {
    return await page.evaluate(
      async ({ base64, columns, rows }) => {
        const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
        const canvas = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
        canvas.drawImage(picture, 0, 0);
        const mean = (left, top, width, height) => {
          const { data } = canvas.getImageData(left, top, width, height);
          const sum = [0, 0, 0];
          for (let i = 0; i < data.length; ++i) if (i % 4 < 3) sum[i % 4] += data[i];
          return sum.map((value) => value / (data.length / 4));
        };
        const [width, height] = [Math.floor(picture.width / columns), Math.floor(picture.height / rows)];
        return Array.from({ length: rows }, (_, row) =>
          Array.from({ length: columns }, (_, column) => mean(column * width, row * height, width, height)),
        );
      },
      { base64: png.toString("base64"), columns, rows },
    );
  } finally {
    await page.close();
  }
}

/** The same of a YUYV picture, by the plain formula of JPEG's colours (BT.601, full range). */
export function coloursOfYuyv({ width, height, data }, columns, rows) {
  const cell = (column, row) => {
    const [cellWidth, cellHeight] = [width / columns, height / rows];
    const sum = [0, 0, 0];
    let count = 0;
    for (let y = Math.ceil(row * cellHeight); y < (row + 1) * cellHeight; ++y)
      for (let x = Math.ceil(column * cellWidth); x < (column + 1) * cellWidth; ++x, ++count) {
        const pair = 2 * (y * width + (x & ~1));
        const [luma, u, v] = [data[2 * (y * width + x)], data[pair + 1] - 128, data[pair + 3] - 128];
        [luma + 1.402 * v, luma - 0.344 * u - 0.714 * v, luma + 1.772 * u].forEach(
          (value, i) => (sum[i] += Math.min(255, Math.max(0, value))),
        );
      }
    return sum.map((value) => value / count);
  };
  return Array.from({ length: rows }, (_, row) => Array.from({ length: columns }, (_, column) => cell(column, row)));
}
