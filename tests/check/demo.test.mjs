// scripts/demo with a build and a server of two lines each.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { chmodSync, copyFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { repositoryOf } from "./repository.mjs";

const scripts = fileURLToPath(new URL("../../scripts", import.meta.url));

/** A TCP port that was free a moment ago. */
async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await new Promise((done) => server.once("listening", done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

/** A stand-in for the runtime: answers every request after one second. */
const server = `#!/usr/bin/env node
const port = Number(process.argv[process.argv.indexOf("--port") + 1]);
setTimeout(() => require("node:http").createServer((_, response) => response.end("{}")).listen(port, "127.0.0.1"), 1000);
`;

test("the demo waits for its server, however long the build took", { timeout: 120_000 }, async (t) => {
  const root = repositoryOf(t, {
    "scripts/setup": "#!/bin/sh\n",
    "scripts/build": "#!/bin/sh\n",
    "build/release/bin/foresight-robot": server,
  });
  for (const name of ["demo", "lib.sh", "durations.txt"])
    copyFileSync(join(scripts, name), join(root, "scripts", name));
  for (const name of ["scripts/demo", "scripts/setup", "scripts/build", "build/release/bin/foresight-robot"])
    chmodSync(join(root, name), 0o755);

  // bash counts SECONDS on from the environment: the build seems to have taken 2000 s
  const port = await freePort();
  const demo = spawn(join(root, "scripts/demo"), ["--port", String(port)], {
    env: { ...process.env, SECONDS: "2000" },
  });
  const ended = new Promise((done) => demo.once("exit", done));
  let said = "";
  for (const stream of [demo.stdout, demo.stderr]) stream.on("data", (bytes) => (said += bytes));
  await Promise.race([
    ended,
    new Promise((done) => demo.stdout.on("data", () => said.includes("Open http") && done())),
  ]);
  demo.kill("SIGTERM");
  await ended;
  assert.match(said, new RegExp(`Open http://localhost:${port}/`));
});
