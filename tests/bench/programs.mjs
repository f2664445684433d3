// Starts the programs of the benches and reads their reports.
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const builds = fileURLToPath(new URL("../../build/", import.meta.url));

/** A folder that is removed when this process ends. */
export const scratch = mkdtempSync(join(tmpdir(), "foresight-bench."));

const running = new Set();
const undo = [() => rmSync(scratch, { recursive: true, force: true })];

/** Calls `action` when this process ends, the last one first. */
export const atEnd = (action) => undo.push(action);

process.on("exit", () => {
  for (const child of running) child.kill("SIGKILL");
  for (const action of undo.reverse()) {
    try {
      action();
    } catch {
      // continue with the next action
    }
  }
});
for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.on(signal, () => process.exit(130));

export const sleep = (seconds) => new Promise((done) => setTimeout(done, seconds * 1000));

/** Runs a command of the system to its end; returns its output, or throws an Error with it. */
export const command = (name, ...args) =>
  execFileSync(name, args, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

/**
 * Starts a program of ours. `before` are words in front of its name (ip netns exec …).
 * `output` becomes all it prints, `report` the JSON of its last line, `firstLine` its first line, `address` what it
 * says to be served at. `preset` is whose build of it.
 */
export function start(name, args, before = [], preset = "release") {
  const words = [...before, join(builds, preset, "bin", name), ...args.map(String)];
  const child = spawn(words[0], words.slice(1), { stdio: ["ignore", "pipe", "inherit"] });
  running.add(child);
  let text = "";
  const ended = new Promise((done) => child.on("close", (code) => (running.delete(child), done(code))));
  const firstLine = new Promise((done, fail) => {
    child.stdout.on("data", (data) => ((text += data), text.includes("\n") && done(text.slice(0, text.indexOf("\n")))));
    child.on("close", () => fail(new Error(`${name} ended before it was ready`)));
  });
  firstLine.catch(() => {}); // some callers do not wait for it
  const output = ended.then((code) => {
    if (code !== 0) throw new Error(`${name} ended with status ${code}: ${words.join(" ")}`);
    return text.trim();
  });
  const address = new Promise((done) =>
    child.stdout.on("data", () => {
      const found = /^http:\/\/\S+:\d+/m.exec(text);
      if (found) done(found[0]);
    }),
  );
  const report = output.then((all) => JSON.parse(all.split("\n").at(-1)));
  for (const later of [output, report]) later.catch(() => {}); // the error appears where the promise is awaited
  return { pid: child.pid, firstLine, address, output, report, stop: () => child.kill("SIGTERM") };
}

/** Runs a program of ours that prints lines of JSON; returns them. */
export const cases = async (name, args = [], before = []) =>
  (await start(name, args, before).output).split("\n").map((line) => JSON.parse(line));

/** Reports whether the release build has a program of ours. */
export const isBuilt = (name) => existsSync(join(builds, "release", "bin", name));

/** Reports whether the kernel can start a program of ours: not all run those for 32-bit processors. */
export const canStart = (name, preset) =>
  // bash says so with status 126, other ways of starting it would take it for a script
  spawnSync("bash", ["-c", 'exec "$0" 1', join(builds, preset, "bin", name)]).status !== 126;

let sessions = 0;

/** A robot under load: `args` of bench_runtime beside address and folders. `address` and `before` are of a network. */
export async function startRobot(args, { address = "127.0.0.1", before = [], logs } = {}) {
  const state = join(scratch, "state");
  const folder = logs ?? join(scratch, `logs${++sessions}`);
  const robot = start(
    "bench_runtime",
    ["--bind", address, "--port", 0, "--state-dir", state, "--log-dir", folder, ...args],
    before,
  );
  const port = (await robot.firstLine).match(/:(\d+)\//)[1];
  const token = readFileSync(join(state, "token"), "utf8").trim();
  const report = robot.report.finally(() => logs || rmSync(folder, { recursive: true, force: true }));
  report.catch(() => {});
  return { ...robot, report, url: (query = "") => `ws://${address}:${port}/?token=${token}${query}` };
}

/** Returns the folder of the only session below `logs`, beside files of the recorder's own. */
export function onlySession(logs) {
  const sessions = readdirSync(logs).filter((name) => !name.startsWith("."));
  if (sessions.length !== 1) throw new Error(`expected one session in ${logs}, got ${sessions.length}`);
  return join(logs, sessions[0]);
}

/**
 * Viewers. They stand for other machines, so they get out of the robot's way where they share its processor:
 * they run at the lowest priority.
 */
export const startClients = (url, args, { before = [] } = {}) =>
  start("bench_client", ["--url", url, ...args], [...before, "nice", "-n", "19"]);
