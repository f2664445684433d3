// A team and its robots: a robots file, a person's home with a key, and the commands as that person gives them.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { chmodSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "../e2e/support.mjs";
import { Field, inNetwork, kPassword } from "./field.mjs";

// bash needs a hundredth of the time of node
const kAskStatus =
  "exec 3<>/dev/tcp/127.0.0.1/8765; printf 'GET /api/status HTTP/1.1\\r\\nHost: localhost\\r\\nConnection: close\\r\\n\\r\\n' >&3; cat <&3";

/** A packet of the GameController of 2025 (format 18): our team's second half, with half its time gone. */
function controlPacket(state) {
  const team = (number) => Buffer.from([number, 0, 1, 1, 0, 0, 0, 0, 176, 4, ...Array(40).fill(0)]);
  const head = Buffer.from([...Buffer.from("RGme"), 18, 0, 5, 0, 0, 0, state, 0, 0, 14, 44, 1, 0, 0]);
  return Buffer.concat([head, team(14), team(5)]);
}

/** Team 14 with robots of these names, players 1, 2, ..., and `body`; other options are those of Field.addRobot(). */
export class World {
  constructor(names, { body, ...options } = {}) {
    this.field = new Field();
    this.home = join(this.field.folder, "person");
    this.temporary = join(this.home, "tmp");
    for (const folder of [join(this.home, ".ssh"), this.temporary]) mkdirSync(folder, { recursive: true });
    execFileSync("ssh-keygen", [
      "-q",
      "-t",
      "ed25519",
      "-N",
      "",
      "-C",
      "the team's key",
      "-f",
      join(this.home, ".ssh/id_ed25519"),
    ]);
    writeFileSync(join(this.home, "password"), `#!/bin/sh\necho ${kPassword}\n`);
    chmodSync(join(this.home, "password"), 0o755);
    for (const name of names) this[name] = this.field.addRobot(name, options);
    this.file = join(this.home, "robots.json");
    const robots = names.map((name, index) => ({
      name,
      address: this[name].address,
      model: "nao-v6",
      body,
      player: index + 1,
    }));
    writeFileSync(this.file, JSON.stringify({ team: 14, colour: "blue", key: "~/.ssh/id_ed25519", robots }));
  }

  /** Starts a script in the lab: {child, output, ended}; `ended` becomes {status, output}. */
  start(script, ...words) {
    const asks = { SSH_ASKPASS: join(this.home, "password"), SSH_ASKPASS_REQUIRE: "force", DISPLAY: "none" };
    const environment = {
      ...process.env,
      HOME: this.home,
      TMPDIR: this.temporary,
      FORESIGHT_ROBOTS: this.file,
      ...asks,
    };
    const command = [...inNetwork(this.field.lab), join(root, "scripts", script), ...words];
    const child = spawn(command[0], command.slice(1), {
      cwd: this.home,
      env: environment,
      stdio: ["ignore", "pipe", "pipe"],
    });
    const started = { child, output: "" };
    for (const stream of [child.stdout, child.stderr]) stream.on("data", (text) => (started.output += text));
    started.ended = new Promise((done) => child.on("close", (status) => done({ status, output: started.output })));
    return started;
  }

  run(script, ...words) {
    return this.start(script, ...words).ended;
  }

  /** Runs scripts/deploy, which must end with `status`; returns its output. */
  async deploy(status, ...words) {
    const { output, status: got } = await this.run("deploy", ...words);
    assert.equal(got, status, output);
    return output;
  }

  /** Runs a line of shell on a robot, as its user. */
  on(robot, line) {
    return this.field.runOn(robot, line).trim();
  }

  /** Returns the status that the runtime on a robot reports. */
  statusOf(robot) {
    return JSON.parse(this.on(robot, `bash -c "${kAskStatus}"`).split("\r\n\r\n")[1]);
  }

  /** The process of the runtime on a robot, and its command line; "" if there is none. */
  programOn(robot) {
    const line =
      "for program in /proc/[0-9]*; do if [ $(readlink $program/exe | grep -c foresight-robot) = 1 ]; then echo ${program#/proc/} $(tr '\\0' ' ' <$program/cmdline); fi; done";
    return this.on(robot, line);
  }

  /** Every file in the robot's home with its owner, mode and content. */
  listing(robot) {
    return this.on(
      robot,
      "find . -mindepth 1 -printf '%y %m %u %P %l\\n' | sort; find . -type f -exec sha256sum {} + | sort -k 2",
    );
  }

  /** Sends the GameController's state to a robot. The GameController keeps its port, and robots follow one sender. */
  sendState(robot, state) {
    const packet = controlPacket(state).toString("base64");
    const send = `const socket = require("dgram").createSocket("udp4"); socket.bind(38380, () => socket.send(Buffer.from("${packet}", "base64"), 3838, "${robot.address}", () => socket.close()));`;
    execFileSync(inNetwork(this.field.lab)[0], [...inNetwork(this.field.lab).slice(1), process.execPath, "-e", send]);
  }
}
