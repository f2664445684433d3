// Helpers of the tests of the programs: folders, recordings, running programs, waiting.
//
// FORESIGHT_BIN names the folder of the programs. FORESIGHT_VIEWER names the folder of a viewer (npm run build makes
// viewer-web/dist); it is shown in place of the viewer inside the programs. Nothing here sleeps for a fixed time.
// A test waits for a condition, and a time limit only says when to give up.
import { execFile, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import { networkInterfaces, tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { standIn } from "./stand_in.mjs";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const bin = resolve(process.env.FORESIGHT_BIN ?? join(root, "build/dev/bin"));

/** Packages are those of the viewer: there is no second list of them. */
export const require = createRequire(join(root, "viewer-web/package.json"));

/** The option of a test that needs real recordings. */
export const needsData = {
  skip: process.env.FORESIGHT_DATA ? false : "FORESIGHT_DATA names no folder of real recordings",
};
export const dataFile = (path) => join(process.env.FORESIGHT_DATA, path);

const endings = new WeakMap(); // test -> actions

/** Runs `action` after the test, the last one first: a program ends before its folder is removed. */
export function atEnd(t, action) {
  if (!endings.has(t)) {
    endings.set(t, []);
    t.after(async () => {
      const failures = [];
      for (const ending of endings.get(t).reverse())
        await Promise.resolve()
          .then(ending)
          .catch((error) => failures.push(error));
      if (failures.length > 0) throw failures[0];
    });
  }
  endings.get(t).push(action);
}

/** An IPv4 address of this machine that is not loopback, or undefined. A test with `needsNetwork` is skipped without it. */
export const own = Object.values(networkInterfaces())
  .flat()
  .find(({ family, internal }) => family === "IPv4" && !internal)?.address;
export const needsNetwork = { skip: own ? false : "this machine has no address but loopback" };

/** Makes a folder for this test and removes it afterwards. */
export function temporaryFolder(t) {
  const folder = mkdtempSync(join(tmpdir(), "foresight-"));
  atEnd(t, () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

const kPatienceMs = 60000; // room for a busy machine; only a failure takes this long
const kLongestRunMs = 300000; // of a program that computes, such as a comparison

/** A value in an error sentence, cut to a readable length. */
const seen = (value) => (typeof value === "string" ? value : (JSON.stringify(value) ?? String(value))).slice(0, 400);

/**
 * Returns the first true value of `condition`, which is called every 20 ms. `what` names the condition in the error.
 * The error also shows what `saw` returns at the end, by default the last value of the condition.
 */
export async function until(condition, what, patience_ms = kPatienceMs, saw = (value) => value) {
  const end = performance.now() + patience_ms;
  for (;;) {
    const value = await condition();
    if (value) return value;
    if (performance.now() > end)
      throw new Error(`waited ${patience_ms / 1000} s in vain: ${what}; last seen: ${seen(await saw(value))}`);
    await new Promise((done) => setTimeout(done, 20));
  }
}

/** Rejects with `what` if `promise` is not settled in time. */
export function within(promise, what, patience_ms = kPatienceMs) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`waited ${patience_ms / 1000} s in vain: ${what}`)), patience_ms);
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

/** Runs a program to its end: {status, stdout, stderr}. */
export async function run(program, ...args) {
  try {
    return { status: 0, ...(await promisify(execFile)(join(bin, program), args, { timeout: kLongestRunMs })) };
  } catch (error) {
    return { status: error.code, stdout: error.stdout, stderr: error.stderr };
  }
}

async function made(session, ...args) {
  const { status, stderr } = await run("foresight-lab", ...args);
  if (status !== 0) throw new Error(stderr);
  return session;
}

/** Makes a recording of the synthetic robot 14/2 in `folder`/`name`. Its first seconds: it stands, then walks. */
export const synthesize = (folder, { name = "synthetic", seconds = 2 } = {}) =>
  made(join(folder, name), "synthesize", join(folder, name), "--seconds", String(seconds));

/** 33 s of a real Nao of 2009, as robot 14/2. */
export const importReal = (folder) =>
  made(
    join(folder, "real"),
    "import",
    "bhuman2009",
    dataFile("bhuman2009/logfile.log"),
    "--session",
    join(folder, "real"),
    "--robot",
    "14/2",
  );

/**
 * Starts a program that serves, on a free port unless `args` name one, and waits for its address. It is stopped with the
 * test, which fails if the program then ends with an error. `command` is the program, or a list of words that ends
 * with it: ["qemu-i386", "-cpu", "n270", path].
 */
export async function start(t, folder, command, ...args) {
  const [path, ...before] = [command].flat().reverse();
  const [program, words] = [basename(path), [...before.reverse(), resolve(bin, path)]];
  const options = ["--state-dir", join(folder, "state"), ...(args.includes("--port") ? [] : ["--port", "0"])];
  if (program === "foresight-robot") options.push("--log-dir", join(folder, "logs"));
  const child = spawn(words[0], [...words.slice(1), ...args, ...options], { stdio: ["ignore", "pipe", "pipe"] });
  const server = { pid: child.pid, folder, output: "", kill: (signal) => child.kill(signal) };
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (bytes) => (server.output += bytes));
  server.ended = new Promise((resolve) => child.on("close", (status, signal) => resolve({ status, signal })));

  server.stop = async () => {
    child.kill("SIGCONT"); // a stopped one could not hear the rest
    child.kill("SIGTERM");
    try {
      return await within(server.ended, `the end of ${program} after SIGTERM`);
    } catch (error) {
      child.kill("SIGKILL");
      throw error;
    }
  };
  atEnd(t, async () => {
    if (child.exitCode !== null || child.signalCode !== null) return;
    const { status } = await server.stop();
    if (status !== 0) throw new Error(`${program} ended with ${status}: ${server.output}`);
  });

  const gone = server.ended.then(({ status }) => {
    throw new Error(`${program} ended with status ${status}: ${server.output}`);
  });
  gone.catch(() => {});
  const line = until(
    () => /^http:\/\/[\w.]+:(\d+)\/$/m.exec(server.output),
    `the address of ${program}`,
    kPatienceMs,
    () => server.output,
  );
  server.port = Number((await Promise.race([line, gone]))[1]);
  // the viewer inside the program, or a fresh build of it in front
  const viewer = process.env.FORESIGHT_VIEWER;
  const address =
    args.includes("--bind") && args[args.indexOf("--bind") + 1] !== "0.0.0.0"
      ? args[args.indexOf("--bind") + 1]
      : "localhost";
  server.http = `http://${address}:${viewer ? await standIn(t, atEnd, resolve(viewer), { host: address, port: server.port }) : server.port}`;
  return server;
}

/** foresight-lab play. */
export const play = (t, folder, session, ...args) => start(t, folder, "foresight-lab", "play", session, ...args);

/** A short simulated game, recorded and played again and again. */
export async function playGame(t) {
  const folder = temporaryFolder(t);
  const rules = "spl2012:2,half_duration=30,ready_duration=5";
  const file = join(folder, "game.mcap");
  const { status, stderr } = await run("foresight-sim", "match", "--seed", "7", "--rules", rules, "--mcap", file);
  if (status !== 0) throw new Error(stderr);
  return play(t, folder, file, "--loop");
}

/** foresight-robot with the body of a recording; sessions go to `folder`/logs. */
export const robot = (t, folder, session, ...args) =>
  start(t, folder, "foresight-robot", "--body", "replay", "--session", session, ...args);

/** Sends one HTTP request as it is and follows no redirect: returns {status, headers, body}. `options` are those of http.request. */
export function request(server, path, { address = "127.0.0.1", ...options } = {}) {
  return within(
    new Promise((resolve, reject) => {
      const sent = http.request({ host: address, port: server.port, path, agent: false, ...options }, (response) => {
        const pieces = [];
        response.on("data", (piece) => pieces.push(piece));
        response.on("error", reject);
        response.on("end", () =>
          resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(pieces) }),
        );
      });
      sent.on("error", reject);
      sent.end();
    }),
    `the answer to ${path}`,
  );
}

export const getJson = async (server, path, options) => JSON.parse((await request(server, path, options)).body);
export const statusOf = (server) => getJson(server, "/api/status");
/** The sessions of a server, when it has read all of their files. */
export const sessionsOf = (server) =>
  until(async () => {
    const { sessions } = await getJson(server, "/api/sessions");
    return sessions.every(({ read }) => read) && sessions;
  }, "the account of all sessions");

/** Waits until a recording has begun. Returns the name of its session. */
export const recordedSession = (server) =>
  until(async () => (await statusOf(server)).recording.session, "a recording that begins");

/** Downloads `path` as a browser does: it follows the redirects of live sessions. */
export async function download(server, path) {
  const first = await request(server, path);
  const last = first.status === 307 ? await request(server, first.headers.location) : first;
  if (last.status !== 200) throw new Error(`${path}: status ${last.status}: ${last.body}`);
  return last.body;
}
