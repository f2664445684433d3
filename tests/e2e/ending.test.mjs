// SIGTERM ends every program within a second, whatever it is doing.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync, truncateSync, writeFileSync } from "node:fs";
import http from "node:http";
import net from "node:net";
import { join } from "node:path";
import { test } from "node:test";
import { atEnd, bin, play, robot, start, statusOf, synthesize, temporaryFolder, until, within } from "./support.mjs";

const kLongest_ms = 10_000; // far less than a program that hangs; the bench mcap measures the second

/** Sends SIGTERM and returns the status of `ended`, a promise. The program must end in time. */
async function endOf(kill, ended) {
  const begin = performance.now();
  kill("SIGTERM");
  const { status } = await within(ended, "the end after SIGTERM", kLongest_ms);
  return { status, took_ms: performance.now() - begin };
}

/** A server on loopback that takes connections and never answers. Returns its port. */
async function silentServer(t) {
  const sockets = [];
  const server = net.createServer((socket) => sockets.push(socket.on("error", () => {})));
  atEnd(t, () => sockets.concat(server).forEach((one) => (one.destroy ?? one.close).call(one)));
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return server.address().port;
}

/** The name of a thread, or "" when it has just ended. */
function nameOf(pid, thread) {
  try {
    return readFileSync(`/proc/${pid}/task/${thread}/comm`, "utf8").trim();
  } catch {
    return "";
  }
}

/** Whether the thread of a process that waits for SIGTERM runs. Before it, others block the signal only for a moment. */
const takesEnd = (pid) => readdirSync(`/proc/${pid}/task`).some((thread) => nameOf(pid, thread) === "end");

/** Adds a file of 40 GB, without a block on the disk, to a session. */
function addLargeFile(session) {
  const file = join(session, "large");
  writeFileSync(file, "");
  truncateSync(file, 40e9);
}

for (const body of ["attached", "sim", "replay"])
  test(`a runtime with the body ${body} ends within a second`, async (t) => {
    const folder = temporaryFolder(t);
    const options = ["--team", "14", "--player", "2"];
    const server =
      body === "replay"
        ? await robot(t, folder, await synthesize(folder))
        : await start(
            t,
            folder,
            "foresight-robot",
            "--body",
            body,
            ...options,
            ...(body === "attached" ? ["--door", join(folder, "door")] : []),
          );
    assert.equal((await endOf(server.kill, server.ended)).status, 0, server.output);
  });

test("a server ends within a second while it computes a checksum and sends a file; meanwhile the status is there at once", async (t) => {
  const folder = temporaryFolder(t);
  const session = await synthesize(folder);
  addLargeFile(session);
  const server = await play(t, folder, session);
  const ask = (path) => http.get({ host: "127.0.0.1", port: server.port, path, agent: false }).on("error", () => {});
  ask("/api/sessions/synthetic/files");
  const download = ask("/logs/synthetic/files/large");
  await within(
    new Promise((done) => download.on("response", (response) => response.once("data", done))),
    "the first bytes",
  );
  const begin = performance.now();
  await statusOf(server);
  assert.ok(performance.now() - begin < kLongest_ms, "the status waits");
  assert.equal((await endOf(server.kill, server.ended)).status, 0, server.output);
});

test("a relay ends within a second while it connects to a robot that does not answer", async (t) => {
  const folder = temporaryFolder(t);
  const port = await silentServer(t);
  const server = await start(
    t,
    folder,
    "foresight-lab",
    "relay",
    `127.0.0.1:${port}`,
    "--log-dir",
    join(folder, "logs"),
  );
  assert.equal((await endOf(server.kill, server.ended)).status, 0, server.output);

  // it also asks for the name of the robot before it serves
  const early = spawn(join(bin, "foresight-lab"), [
    "relay",
    `127.0.0.1:${port}`,
    "--port",
    "0",
    "--state-dir",
    join(folder, "state"),
  ]);
  const ended = new Promise((done) => early.on("close", (status) => done({ status })));
  atEnd(t, () => early.kill("SIGKILL"));
  await until(() => takesEnd(early.pid), "a relay that takes SIGTERM");
  assert.equal((await endOf((signal) => early.kill(signal), ended)).status, 0);
});
