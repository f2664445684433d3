// One ssh connection to a robot for all commands, for rsync, and for HTTP to the robot's own loopback.
import { spawn } from "node:child_process";
import { mkdirSync } from "node:fs";
import http from "node:http";
import { connect } from "node:net";
import { homedir } from "node:os";
import { dirname, join } from "node:path";
import { RobotFailed } from "./failure.mjs";
import { removeScratch, scratchFolder } from "./scratch.mjs";

const kPing_ms = 2000; // timeout after which a robot counts as absent at an address
const kSilence_s = 3, kSilences = 3; // after this many unanswered pings, at this interval, a connection is lost
const kRequest_ms = 3000;

/** Runs a program to its end. Returns {status, stdout, stderr}; status 127 if there is no such program. */
export function run(words, { input = "", terminal = false } = {}) {
  return new Promise((done) => {
    const child = spawn(words[0], words.slice(1), { stdio: terminal ? "inherit" : "pipe" });
    const got = { stdout: "", stderr: "" };
    child.on("error", (error) => done({ ...got, status: 127, stderr: error.message }));
    child.on("close", (status) => done({ ...got, status: status ?? 255 }));
    if (terminal) return;
    for (const stream of ["stdout", "stderr"]) child[stream].setEncoding("utf8").on("data", (text) => (got[stream] += text));
    child.stdin.on("error", () => {}); // it ended without reading all
    child.stdin.end(input);
  });
}

/** Returns true if a program listens at `port` of `host`. */
export function answers(host, port, patience_ms = kPing_ms) {
  return new Promise((done) => {
    const socket = connect({ host, port });
    const end = (answer) => (socket.destroy(), done(answer));
    socket.setTimeout(patience_ms, () => end(false));
    socket.on("connect", () => end(true));
    socket.on("error", () => end(false));
  });
}

/** Returns the first of the robot's addresses at which the port with the name `port` answers, or undefined. */
export async function addressThatAnswers(robot, port) {
  for (const address of robot.addresses) if (await answers(address, robot[port])) return address;
  return undefined;
}

/** Quotes `text` as one word of a POSIX shell. */
export const quoted = (text) => `'${text.replaceAll("'", `'\\''`)}'`;

// the servers of the old systems support nothing newer
const kOldKeys = ["HostKeyAlgorithms=+ssh-rsa", "PubkeyAcceptedKeyTypes=+ssh-rsa"];

/** The file with the host keys of the team's robots, by name, because a robot's address may change. */
export const knownHosts = () => join(homedir(), ".config/foresight/known_hosts");

/** A connection to one robot. */
export class Connection {
  #folder;
  #master;

  constructor(robot, address) {
    this.robot = robot;
    this.address = address;
  }

  /** Logs in at the first address that answers. If `interactive`, ssh may ask for a password; otherwise it needs a key. */
  static async open(robot, { interactive = false } = {}) {
    const address = await addressThatAnswers(robot, "ssh_port");
    if (!address) throw new RobotFailed(`no ssh server answers at port ${robot.ssh_port} of ${robot.addresses.join(" or ")}: is it on, and are we in its network?`);
    const connection = new Connection(robot, address);
    await connection.#logIn(interactive);
    return connection;
  }

  async #logIn(interactive) {
    this.#folder = scratchFolder();
    mkdirSync(dirname(knownHosts()), { recursive: true });
    const forward = ["-L", `${this.#socket}:127.0.0.1:${this.robot.http_port}`];
    const only = ["-o", "ControlMaster=yes", "-o", `BatchMode=${interactive ? "no" : "yes"}`, "-o", "NumberOfPasswordPrompts=3"];
    // it ends with its input, and so with this process in any case
    const words = [...this.#ssh, ...only, ...forward, this.#login, "echo connected; exec cat >/dev/null"];
    this.#master = spawn(words[0], words.slice(1), { stdio: ["pipe", "pipe", "pipe"] });
    let said = "";
    this.#master.stderr.setEncoding("utf8").on("data", (text) => (said = (said + text).slice(-4000)));
    const failed = await new Promise((done) => {
      this.#master.stdout.on("data", () => done(undefined));
      this.#master.on("error", (error) => done(error.message));
      this.#master.on("close", () => done(said.trim() || "ssh ended without a word"));
    });
    if (failed === undefined) return;
    await this.close();
    throw new RobotFailed(`cannot log in as ${this.#login}: ${explained(failed, this.robot)}`);
  }

  get #login() {
    return `${this.robot.user}@${this.address}`;
  }

  get #socket() {
    return join(this.#folder, "http");
  }

  get #ssh() {
    const options = [
      `ControlPath=${join(this.#folder, "ssh")}`,
      `HostKeyAlias=${this.robot.name}.foresight`,
      `UserKnownHostsFile=${knownHosts()}`,
      "StrictHostKeyChecking=accept-new",
      "ConnectTimeout=5",
      `ServerAliveInterval=${kSilence_s}`,
      `ServerAliveCountMax=${kSilences}`,
      "LogLevel=ERROR",
      ...(this.robot.model === "nao-v6" ? [] : kOldKeys),
      ...(this.robot.key ? [`IdentityFile=${this.robot.key}`] : []),
    ];
    return ["ssh", "-p", String(this.robot.ssh_port), ...options.flatMap((option) => ["-o", option])];
  }

  /** The ssh command for all later steps; it never opens a second connection. */
  get #again() {
    return [...this.#ssh, "-o", "ControlMaster=no", "-o", "BatchMode=yes"];
  }

  /** Runs a line of POSIX shell in the robot's home. Returns {status, stdout, stderr}. */
  async run(command, { input } = {}) {
    const { status, stdout, stderr } = await run([...this.#again, this.#login, command], { input });
    if (status === 255) throw new RobotFailed(`the connection was lost: ${stderr.trim() || "no answer"}`);
    return { status, stdout, stderr };
  }

  /** Runs a command that must succeed. Returns its output, or throws RobotFailed with `what` and the last line of output. */
  async must(what, command, options) {
    const { status, stdout, stderr } = await this.run(command, options);
    if (status !== 0) throw new RobotFailed(`${what}: ${(stderr.trim() || stdout.trim() || `exit status ${status}`).split("\n").at(-1)}`);
    return stdout;
  }

  /** Runs a command at this terminal, where the robot may ask for a password. Returns its exit status. */
  async runAtTerminal(command) {
    return (await run([...this.#again, "-t", this.#login, command], { terminal: true })).status;
  }

  /**
   * Makes the folder `to` in the robot's home equal to `from`, by checksums, and removes stale files. Unchanged files are copied
   * from `like`, a folder beside it. With `dry` nothing changes. Returns the line of rsync for each file.
   */
  async push(from, to, { like, dry = false } = {}) {
    const words = ["rsync", "-rpLcz", "--delete", "--timeout=10", "--itemize-changes", ...(dry ? ["--dry-run"] : [])];
    if (like) words.push(`--copy-dest=${like}`);
    const { status, stdout, stderr } = await run([...words, "-e", this.#again.join(" "), `${from}/`, `${this.#login}:${to}/`]);
    if (status === 0) return stdout.trim();
    throw new RobotFailed(`rsync ended with status ${status}: ${stderr.trim().split("\n").at(-1) ?? "no reason given"}`);
  }

  /** Sends GET `path` to the runtime over the robot's loopback. Returns {status, body}, or undefined without an answer. */
  get(path) {
    return new Promise((done) => {
      const sent = http.get({ socketPath: this.#socket, path, agent: false, timeout: kRequest_ms }, (response) => {
        let body = "";
        response.setEncoding("utf8").on("data", (text) => (body += text));
        response.on("error", () => done(undefined));
        response.on("end", () => done({ status: response.statusCode, body }));
      });
      sent.on("timeout", () => sent.destroy());
      sent.on("error", () => done(undefined));
    });
  }

  async close() {
    this.#master.stdin.on("error", () => {}); // it has ended already
    this.#master.stdin.end();
    const ended = new Promise((done) => (this.#master.exitCode === null && this.#master.signalCode === null ? this.#master.on("close", done) : done()));
    const late = setTimeout(() => this.#master.kill(), 1000);
    await ended;
    clearTimeout(late);
    removeScratch(this.#folder);
  }
}

/** Returns the advice for the two most frequent refusals, else the last line of `said`. */
function explained(said, { name }) {
  if (/HOST IDENTIFICATION HAS CHANGED|Host key verification failed/.test(said))
    return `it is not the robot we know as '${name}', or it was flashed anew; then scripts/deploy --setup ${name}`;
  if (/Permission denied/.test(said)) return `it does not know our key; scripts/deploy --setup ${name} brings it there`;
  return said.split("\n").at(-1);
}

/** Does `work` with a connection to `robot`, and closes it in any case. */
export async function connected(robot, work, options) {
  const connection = await Connection.open(robot, options);
  try {
    return await work(connection);
  } finally {
    await connection.close();
  }
}
