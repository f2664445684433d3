// Match mode on real network interfaces: tcpdump captures the packets on the wireless one during a game.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";

import { atEnd, require, start, temporaryFolder, until, within } from "./support.mjs";

const kWireless = "10.0.14.2",
  kWired = "10.1.14.2";
const State = { initial: 0, ready: 1, set: 2, playing: 3, finished: 4 };

const ip = (...words) => execFileSync("ip", words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

function whyNot() {
  if (process.getuid() !== 0) return "network namespaces need root";
  try {
    ip("netns", "list");
    execFileSync("tcpdump", ["--version"], { stdio: "ignore" });
    return false;
  } catch (error) {
    return `no network namespaces, or no tcpdump: ${String(error.message).trim()}`;
  }
}

/** Three hosts: the robot, and one at the other end of each of its networks: {robot, field, lab}, words to run there. */
function network(t) {
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
function peer(t, host, program) {
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
const gameController = (t, host) =>
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

/** Requests a path repeatedly and prints the status of each answer, or 0 if none comes within a second. */
const asker = (t, host, address, path) =>
  peer(
    t,
    host,
    `
  const ask = async () => {
    const status = await fetch("http://${address}:8765${path}", { signal: AbortSignal.timeout(1000) }).then((answer) => answer.status, () => 0);
    say(status);
    setTimeout(ask, 100);
  };
  ask();
`,
  );

/** A viewer: prints each text message and the end of the connection. Sends the lines of its input. */
const viewer = (t, host, address, query) =>
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

/** All packets from the robot's wireless address: [{seconds, text}] since the capture began. */
function capture(t, host, file) {
  const child = spawn(host[0], [...host.slice(1), "tcpdump", "-i", "wlan0", "-U", "-w", file, "src", kWireless], {
    stdio: ["ignore", "ignore", "pipe"],
  });
  let talk = "";
  child.stderr.on("data", (bytes) => (talk += bytes));
  atEnd(t, () => child.kill("SIGKILL"));
  return {
    begun: () => until(() => talk.includes("listening on"), "tcpdump listens"),
    packets: async () => {
      child.kill("SIGINT");
      await within(new Promise((ended) => child.on("close", ended)), "the end of tcpdump");
      const text = execFileSync("tcpdump", ["-nn", "-tt", "-r", file], {
        encoding: "utf8",
        stdio: ["ignore", "pipe", "ignore"],
      });
      return text
        .trim()
        .split("\n")
        .filter(Boolean)
        .map((line) => ({ seconds: Number(line.split(" ")[0]), text: line }));
    },
  };
}

test(
  "during a game only messages that the rules allow leave over the wireless network",
  { skip: whyNot() },
  async (t) => {
    const folder = temporaryFolder(t);
    const { robot, field, lab } = network(t);
    await start(
      t,
      folder,
      [...robot, "foresight-robot"],
      "--body",
      "attached",
      "--team",
      "14",
      "--player",
      "2",
      "--bind",
      "0.0.0.0",
      "--port",
      "8765",
      "--wireless",
      "wlan0",
      "--game-controller",
      "--return-packets",
      "--profile",
      "game",
    );
    const token = readFileSync(join(folder, "state/token"), "utf8").trim();

    const game = gameController(t, field);
    const besideTheField = viewer(t, field, kWireless, "");
    const byCable = viewer(t, lab, kWired, `?token=${token}`);
    const statusByAir = asker(t, field, kWireless, "/api/status");
    await until(() => besideTheField.said.some(({ op }) => op === "serverInfo"), "the viewer by air is served");
    await until(() => statusByAir.said.at(-1) === 200, "the status by air");

    const captured = capture(t, robot, join(folder, "wlan0.pcap"));
    await captured.begun();
    game.tell(State.ready);
    await until(() => besideTheField.said.at(-1).op === "closed", "the viewer by air is disconnected");
    await until(() => statusByAir.said.at(-1) === 0, "no status by air");
    const silence = Date.now() / 1000;

    // over a cable viewers are served
    const statusByCable = asker(t, lab, kWired, "/api/status");
    const logByCable = asker(t, lab, kWired, `/logs/any.mcap?token=${token}`);
    await until(() => statusByCable.said.at(-1) === 200, "the status by cable");
    await until(() => logByCable.said.at(-1) === 503, "a recording refused by cable");
    byCable.tell({ op: "setParameters", parameters: [{ name: "match_mode", value: false }] });
    await until(
      () => byCable.said.some(({ message }) => message?.includes("a game is in progress")),
      "a refusal by cable",
    );

    for (const state of [State.set, State.playing]) {
      game.tell(state);
      const knocked = statusByAir.said.length;
      await until(() => statusByAir.said.length > knocked + 1, "requests without an answer");
    }
    const finished = Date.now() / 1000;
    const packets = await captured.packets();
    game.tell(State.finished);
    await until(() => statusByAir.said.at(-1) === 200, "the status by air again");
    assert.equal(
      byCable.said.some(({ op }) => op === "closed"),
      false,
    );

    const during = packets.filter(({ seconds }) => seconds > silence && seconds < finished);
    const answers = during.filter(({ text }) => / > 10\.0\.14\.1\.3939: UDP/.test(text));
    assert.ok(answers.length >= 2, "it answers the GameController");
    assert.deepEqual(
      during.filter((packet) => !answers.includes(packet) && !/ARP/.test(packet.text)),
      [],
    );
  },
);
