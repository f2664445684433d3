// Stand-ins for a robot and for the runtime, with the real guardian between them: three processes of a test.
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { join } from "node:path";
import { atEnd, bin, temporaryFolder, until, within } from "../e2e/support.mjs";

/** Starts a program and keeps the lines that it prints. It ends with the test. */
function launch(t, program, ...args) {
  const child = spawn(join(bin, program), args, { stdio: ["pipe", "pipe", "pipe"] });
  const process = {
    pid: child.pid,
    stdout: child.stdout,
    lines: [],
    errors: "",
    kill: (signal) => child.kill(signal),
    stdin: child.stdin,
  };
  child.stdin.on("error", () => {}); // it may have ended already
  createInterface({ input: child.stdout }).on("line", (line) => process.lines.push(line));
  child.stderr.on("data", (bytes) => (process.errors += bytes));
  process.ended = new Promise((done) => child.on("close", (status, signal) => done({ status, signal })));
  atEnd(t, async () => {
    if (child.exitCode === null && child.signalCode === null) child.kill("SIGKILL");
    await process.ended;
  });
  return process;
}

export class World {
  constructor(t) {
    this.t = t;
    this.folder = temporaryFolder(t);
    this.lola = join(this.folder, "lola");
    this.link = join(this.folder, "guardian");
  }

  /** `program` is fake_robot, or lab_robot, which has physics. */
  async startRobot(program = "fake_robot", ...args) {
    this.robot = launch(this.t, program, this.lola, ...args);
    await until(() => this.robot.lines.length > 0, "LoLA listens");
    return this.robot;
  }

  async startGuardian() {
    this.guardian = launch(this.t, "foresight-guardian", "--lola", this.lola, "--link", this.link);
    await until(() => this.guardian.lines.some((line) => line.startsWith("real-time priority")), "the guardian runs");
    return this.guardian;
  }

  /** A stand-in for the runtime. */
  async startRuntime(...args) {
    const runtime = launch(this.t, "fake_runtime", this.link, ...args);
    runtime.said = () => JSON.parse(runtime.lines.at(-1) ?? "{}");
    await until(() => runtime.lines.length > 0, "the runtime has a report");
    this.runtime = runtime;
    return runtime;
  }

  async start(...args) {
    await this.startRobot();
    await this.startGuardian();
    return this.startRuntime(...args);
  }

  /** Sends an event to the robot. */
  happen(line) {
    this.robot.stdin.write(`${line}\n`);
  }

  /** Returns the robot's state. */
  async state() {
    const before = this.robot.lines.length;
    this.happen("state");
    await until(() => this.robot.lines.length > before, "the robot's state");
    return JSON.parse(this.robot.lines.at(-1));
  }

  /** Waits for a state that fulfils `isSo`, and returns it. */
  async until(isSo, what) {
    let state;
    await until(async () => isSo((state = await this.state())), what).catch((error) => {
      throw new Error(`${error.message}; the robot: ${JSON.stringify(state)}; the guardian: ${this.guardian?.errors}`);
    });
    return state;
  }

  /** Waits for `count` more cycles of the robot, which is its own time, independent of the load of the machine. */
  async cycles(count) {
    const { frames } = await this.state();
    return this.until((state) => state.frames >= frames + count, `${count} cycles`);
  }

  async click() {
    this.happen("chest");
    await this.cycles(6);
    this.happen("release");
    await this.cycles(4);
  }

  /** The robot stands and plays. A click has no effect while a busy machine keeps the runtime silent. */
  async play() {
    const isGreen = ({ chest }) => chest.join() === "0,1,0";
    for (let i = 0; i < 20 && !isGreen(await this.state()); ++i) await this.click();
    await this.untilStanding();
  }

  untilDoing = (mode, doing) =>
    until(
      () => this.runtime.said().mode === mode && this.runtime.said().doing === doing,
      `the guardian is ${mode}, ${doing}`,
    );
  untilStanding = () => this.until((state) => state.stiffness > 0.8 && state.knee < 0.85, "it stands");
  untilSeated = () => this.until((state) => state.stiffness === 0 && state.knee > 2, "it sits and is soft");

  /** Waits for a sentence of the guardian with `part`, and returns it. */
  untilSaid = (part) =>
    until(
      () => this.guardian.errors.includes(part),
      `the guardian says '${part}'`,
      undefined,
      () => this.guardian.errors,
    );

  ended = (process) => within(process.ended, "the end of a process");
}
