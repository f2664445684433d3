// Three hosts on one machine, as network namespaces: a robot with a wireless network and a cable, and the programs of others.
import { execFileSync, spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { atEnd, require } from "./support.mjs";

export const kWireless = "10.0.14.2",
  kWired = "10.1.14.2"; // of the robot
export const State = { initial: 0, ready: 1, set: 2, playing: 3, finished: 4 };

const ip = (...words) => execFileSync("ip", words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

/** Why these hosts are impossible here, or false. `programs` are needed too, such as tcpdump. */
export function whyNoHosts(...programs) {
  if (process.getuid() !== 0) return "network namespaces need root";
  try {
    ip("netns", "list");
    for (const program of programs) execFileSync(program, ["--version"], { stdio: "ignore" });
    return false;
  } catch (error) {
    return `no network namespaces, or a program is missing: ${String(error.message).trim()}`;
  }
}

/** Three hosts: the robot, and one at the other end of each of its networks: {robot, field, lab}, words to run there. */
export function network(t) {
  const id = `fm${process.pid % 100000}`;
  const hosts = Object.fromEntries(["robot", "field", "lab"].map((name) => [name, `${id}${name[0]}`]));
  for (const host of Object.values(hosts)) {
    ip("netns", "add", host);
    atEnd(t, () => ip("netns", "delete", host));
    ip("-n", host, "link", "set", "lo", "up");
  }
  for (const [device, other, here, there] of [
    ["wlan0", hosts.field, kWireless, "10.0.14.1"],
    ["eth0", hosts.lab, kWired, "10.1.14.1"],
  ]) {
    ip("link", "add", device, "netns", hosts.robot, "type", "veth", "peer", "name", device, "netns", other);
    for (const [host, address] of [
      [hosts.robot, here],
      [other, there],
    ]) {
      ip("-n", host, "address", "add", `${address}/24`, "broadcast", "+", "dev", device);
      ip("-n", host, "link", "set", device, "up");
    }
  }
  return Object.fromEntries(Object.entries(hosts).map(([name, host]) => [name, ["ip", "netns", "exec", host]]));
}

/** Starts a program on a host; it reads and writes lines of JSON. */
export function peer(t, host, program) {
  const prelude =
    "const say = (what) => console.log(JSON.stringify(what));" +
    "const hear = (then) => require('readline').createInterface({ input: process.stdin }).on('line', (line) => then(JSON.parse(line)));";
  const child = spawn(host[0], [...host.slice(1), process.execPath, "-e", prelude + program], {
    stdio: ["pipe", "pipe", "inherit"],
  });
  atEnd(t, () => child.kill("SIGKILL"));
  const said = [];
  createInterface({ input: child.stdout }).on("line", (line) => said.push(JSON.parse(line)));
  return { said, tell: (what) => child.stdin.write(`${JSON.stringify(what)}\n`) };
}

/** Broadcasts the newest state from its input ten times a second, as the GameController of 2024 does. */
export const gameController = (t, host) =>
  peer(
    t,
    host,
    `
  const socket = require("dgram").createSocket("udp4");
  let state = 0, packet = 0;
  socket.bind(() => {
    socket.setBroadcast(true);
    setInterval(() => {
      const bytes = Buffer.alloc(118);
      bytes.write("RGme");
      bytes.set([18, packet++ & 255, 5, 0, 0, 0, state, 0, 1, 14], 4);
      bytes.writeInt16LE(600, 14);
      for (const [at, team] of [[18, 14], [68, 5]]) {
        bytes[at] = team;
        bytes.writeUInt16LE(1200, at + 8);
      }
      socket.send(bytes, 3838, "10.0.14.255");
    }, 100);
  });
  hear((told) => { state = told; });
`,
  );

/** Requests a path repeatedly and prints `of` each answer, by default its status, or 0 if none comes within a second. */
export const asker = (t, host, address, path, of = "answer.status") =>
  peer(
    t,
    host,
    `
  const ask = async () => {
    const status = await fetch("http://${address}:8765${path}", { signal: AbortSignal.timeout(1000) }).then(async (answer) => ${of}, () => 0);
    say(status);
    setTimeout(ask, 100);
  };
  ask();
`,
  );

/** A viewer: prints each text message and the end of the connection. Sends the lines of its input. */
export const viewer = (t, host, address, query) =>
  peer(
    t,
    host,
    `
  const { WebSocket } = require(${JSON.stringify(require.resolve("ws"))});
  const socket = new WebSocket("ws://${address}:8765/${query}", ["foxglove.sdk.v1"]);
  socket.on("message", (bytes, binary) => { if (!binary) say(JSON.parse(bytes)); });
  socket.on("error", () => {});
  socket.on("close", () => say({ op: "closed" }));
  hear((told) => socket.send(JSON.stringify(told)));
`,
  );

/**
 * Asks what-if questions: a line of its input is a question. Prints {op: "answer", answer}, refusals as they come, and
 * {op: "closed"} at the end of the connection.
 */
export const questioner = (t, host, address, query) =>
  peer(
    t,
    host,
    `
  const { WebSocket } = require(${JSON.stringify(require.resolve("ws"))});
  const socket = new WebSocket("ws://${address}:8765/${query}", ["foxglove.sdk.v1"], { handshakeTimeout: 1000 });
  let calls = 0, service;
  socket.on("message", (bytes, binary) => {
    if (binary && bytes[0] === 3) return say({ op: "answer", answer: JSON.parse(bytes.subarray(13 + bytes.readUInt32LE(9))) });
    if (binary) return;
    const told = JSON.parse(bytes);
    service ??= told.services?.find(({ name }) => name === "/foresight/what_if")?.id;
    if (told.op === "advertiseServices" && service !== undefined) say({ op: "ready" });
    if (told.op === "serviceCallFailure") say(told);
  });
  socket.on("error", () => {});
  socket.on("close", () => say({ op: "closed" }));
  hear((question) => {
    const head = Buffer.alloc(13);
    head[0] = 2;
    head.writeUInt32LE(service, 1);
    head.writeUInt32LE(++calls, 5);
    head.writeUInt32LE(4, 9);
    socket.send(Buffer.concat([head, Buffer.from("json" + JSON.stringify(question))]));
  });
`,
  );
