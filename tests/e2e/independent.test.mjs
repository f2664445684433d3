// A session of ours in another project's viewer: Rerun in Chromium reads it from our server and draws the field.
//
// It is large, and nothing else needs it: `npm ci` in tests/e2e/independent installs it; otherwise the test is skipped.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import http from "node:http";
import { extname, join } from "node:path";
import { test } from "node:test";
import { coloursOnScreen, open, shoot } from "./browser.mjs";
import { readSession } from "./mcap.mjs";
import { atEnd, play, root, synthesize, temporaryFolder, until } from "./support.mjs";

const kPackage = join(root, "tests/e2e/independent/node_modules/@rerun-io/web-viewer");
const needsRerun = {
  skip: existsSync(kPackage) ? false : "npm ci in tests/e2e/independent brings the viewer that this needs",
};
const kTypes = { ".js": "text/javascript", ".wasm": "application/wasm" };
const kPage = `<!doctype html><title>Rerun</title><style>body { margin: 0 }</style><script type="module">
  import { WebViewer } from "/index.js";
  window.viewer = new WebViewer();
  window.opened = [];
  viewer.on("recording_open", (event) => opened.push(event));
  await viewer.start(new URLSearchParams(location.search).get("url"), document.body, { width: "1280px", height: "800px", hide_welcome_screen: true, render_backend: "webgl" });
</script>`;

/** Serves the other viewer's page and files; returns the address. */
async function serveRerun(t) {
  const server = http.createServer((request, response) => {
    const name = new URL(request.url, "http://localhost").pathname.slice(1);
    if (name === "") return response.writeHead(200, { "Content-Type": "text/html" }).end(kPage);
    const file = join(kPackage, extname(name) ? name : `${name}.js`); // a module names another one without its ending
    if (!/^[\w.]+$/.test(name) || !existsSync(file)) return response.writeHead(404).end();
    response
      .writeHead(200, { "Content-Type": kTypes[extname(file)] ?? "application/octet-stream" })
      .end(readFileSync(file));
  });
  await new Promise((listening) => server.listen(0, "localhost", listening));
  atEnd(t, () => server.close());
  return `http://localhost:${server.address().port}`;
}

test("Rerun opens a session by its address, with all of its time, and draws the field", needsRerun, async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder, { name: "independent", seconds: 3 });
  const rerun = await serveRerun(t);
  const server = await play(t, folder, session, "--allow-origin", rerun);
  const address = `http://localhost:${server.port}/logs/independent.mcap?foxglove`;
  const { page, context } = await open(t, `${rerun}/?url=${encodeURIComponent(address)}`, { software3d: true });

  const recording = await until(
    () => page.evaluate(() => window.viewer?.ready && window.viewer.get_active_recording_id()),
    "an active recording",
  );
  const times = [...readSession(session).values()].flatMap(({ messages }) =>
    messages.map(({ logTime }) => Number(logTime)),
  );
  // it also has a timeline of its own, log_time, with the times of reading; the one that it shows first differs from run to run
  const range = () =>
    page.evaluate((recording) => window.viewer.get_time_range(recording, "message_log_time"), recording);
  const near = (one, other) => Math.abs(one - other) < 1e6; // [ns] a double holds such times to a few hundred ns
  await until(async () => {
    const { min, max } = (await range()) ?? {};
    return near(min, Math.min(...times)) && near(max, Math.max(...times));
  }, "the whole time of the session");
  assert.equal((await page.evaluate(() => window.opened)).length, 1);

  // without any set-up its 3D view shows the field's points: the carpet's edge and robots in red jerseys
  const drawn = async () => {
    const cells = (await coloursOnScreen(context, page.locator("canvas").first(), 256, 160)).flat();
    const some = (is) => cells.filter(([red, green, blue]) => is(red, green, blue)).length;
    return {
      carpet: some((red, green, blue) => green < 110 && green > red + 15 && green > blue + 8),
      red: some((red, green, blue) => red > green + 80 && red > blue + 80),
    };
  };
  await until(
    async () => Object.values(await drawn()).every((cells) => cells >= 3),
    "the field with robots",
    undefined,
    drawn,
  );
  await shoot(page, "rerun");
});
