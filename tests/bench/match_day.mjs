// A match day for the benches: programs that record, a GameController, people who watch, and an account of all messages.
import dgram from "node:dgram";
import { existsSync, mkdirSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { readStreamed } from "../e2e/mcap.mjs";
import { require } from "../e2e/support.mjs";
import { sleep, start } from "./programs.mjs";

const WebSocket = require("ws");
export const kGamePort = 38380;

/** A packet of the GameController, format 19: team 14 against team 5. */
function controlPacket(number, state, firstHalf) {
  const packet = Buffer.alloc(198);
  packet.write("RGme");
  packet.set([19, number & 255, 5, 0, 0, 0, state, 0, firstHalf, 14], 4);
  packet.writeInt16LE(600, 14);
  packet[18] = 14;
  packet[18 + 90] = 5;
  return packet;
}

/** A GameController whose halves take 15 s, with 1 s before and after each. */
export function startGameController() {
  const socket = dgram.createSocket("udp4");
  let number = 0;
  const timer = setInterval(() => {
    const half_s = (number / 2) % 17;
    const state = half_s < 1 ? 0 : half_s < 3 ? 1 : half_s < 5 ? 2 : half_s < 16 ? 3 : 4;
    socket.send(controlPacket(number, state, Math.floor(number / 34) % 2), kGamePort, "127.0.0.1");
    ++number;
  }, 500);
  return () => (clearInterval(timer), socket.close());
}

/**
 * A program of ours, with the counts of its sessions that it reported last. `before` are words in front of its name.
 * `restart()` kills it and starts it again with the same folders and the same port.
 */
export async function program(name, args, folder, { before = [], log_mb = 2000 } = {}) {
  mkdirSync(folder, { recursive: true });
  const own = ["--state-dir", join(folder, "state"), "--log-dir", join(folder, "logs"), "--log-mb", log_mb];
  const made = { name, folder, seen: new Map(), kills: 0 };
  const begin = async (port) => {
    const child = start(name, [...args, ...own, "--port", port], before);
    const ended = () => (made.ended ||= made.child === child);
    Object.assign(made, { child, ended: false });
    child.output.then(ended, ended);
    made.url = await Promise.race([child.address, child.output]); // fails with the program
    made.token = readFileSync(join(folder, "state/token"), "utf8").trim();
  };
  made.restart = async () => {
    const killed = made.child;
    made.child = undefined;
    ++made.kills;
    process.kill(killed.pid, "SIGKILL");
    await killed.output.catch(() => {});
    await begin(new URL(made.url).port);
  };
  await begin(0);
  return made;
}

export async function ask(robot, path, options) {
  try {
    const answer = await fetch(robot.url + path, { signal: AbortSignal.timeout(5000), ...options });
    return answer.ok ? await answer.json() : undefined;
  } catch {
    return undefined; // this request met a fault
  }
}

/** Looks at the state, and remembers the counts of each session. */
export async function look(robot) {
  const recording = (await ask(robot, "/api/status"))?.recording;
  if (recording?.session && recording.state !== "off") robot.seen.set(recording.session, recording);
  return recording;
}

/** A viewer that subscribes to all channels for a while, and asks a question. */
function watch(robot, stay_ms) {
  return new Promise((done) => {
    const socket = new WebSocket(`${robot.url.replace("http", "ws")}/?token=${robot.token}`, ["foxglove.sdk.v1"]);
    const end = setTimeout(() => socket.terminate(), stay_ms);
    let last = 0;
    socket.on("message", (bytes, isBinary) => {
      if (isBinary) return;
      const message = JSON.parse(bytes);
      if (message.op === "advertise")
        socket.send(JSON.stringify({ op: "subscribe", subscriptions: message.channels.map(({ id }) => ({ id: ++last, channelId: id })) }));
      const question = message.services?.find(({ name }) => name === "what_if");
      if (!question) return;
      const words = Buffer.from(JSON.stringify({ budget_ms: 200 }));
      const head = Buffer.alloc(13);
      head[0] = 2;
      head.writeUInt32LE(question.id, 1);
      head.writeUInt32LE(1, 5);
      head.writeUInt32LE(4, 9);
      socket.send(Buffer.concat([head, Buffer.from("json"), words]));
    });
    socket.on("error", () => {});
    socket.on("close", () => (clearTimeout(end), done()));
  });
}

/** Everything that people do: status, lists, downloads, viewers that come and go. */
export async function use(robot, until_ms) {
  const looking = (async () => {
    while (performance.now() < until_ms && !robot.ended) await look(robot), await sleep(0.1);
  })();
  const reading = (async () => {
    while (performance.now() < until_ms && !robot.ended) {
      for (const session of ((await ask(robot, "/api/sessions"))?.sessions ?? []).slice(-2))
        await fetch(`${robot.url}/logs/${session.name}.mcap`, { signal: AbortSignal.timeout(5000) }).then((answer) => answer.arrayBuffer()).catch(() => {});
      await sleep(0.5);
    }
  })();
  const watching = (async () => {
    while (performance.now() < until_ms && !robot.ended) await watch(robot, 3000);
  })();
  await Promise.all([looking, reading, watching]);
}

/** Messages in the files of a session, and numbers missing between the first and the last one of each object. */
function countFiles(folder) {
  const found = { stored: 0, gaps: 0, unreadable: 0, unfinished: false };
  for (const name of readdirSync(folder).filter((file) => file.endsWith(".mcap"))) {
    try {
      const contents = readStreamed(readFileSync(join(folder, name)), { allowUnfinished: true });
      found.unfinished ||= contents.unfinished;
      for (const [topic, { messages }] of contents.topics) {
        found.stored += messages.length;
        if (/camera/.test(topic) || messages.length === 0) continue; // pictures are thinned
        const numbers = messages.map(({ sequence }) => sequence);
        found.gaps += numbers.at(-1) - numbers[0] + 1 - messages.length;
      }
    } catch (error) {
      console.log(`   ${join(folder, name)}: ${error.message}`);
      ++found.unreadable;
    }
  }
  return found;
}

const kPerSecond = 200; // messages of a robot, at most

/**
 * The account of all messages. A message is lost if its number is missing between the first and the last of its object. It is
 * lost without being counted if the program counted fewer, or counts it among those in its files.
 */
export class Account {
  #sum = { stored: 0, counted: 0, lost: 0, uncounted: 0, unreadable: 0, unfinished: 0, kills: 0, unwritten: 0 };

  /** Counts the sessions of a program in one log folder. */
  add(robot, logs) {
    for (const session of existsSync(logs) ? readdirSync(logs).filter((name) => robot.seen.has(name)) : []) {
      const { stored, gaps, unreadable, unfinished } = countFiles(join(logs, session));
      const { dropped, messages } = robot.seen.get(session);
      this.#sum.stored += stored;
      this.#sum.counted += dropped;
      this.#sum.lost += gaps;
      // a relay keeps the numbers of its robots, and a busy robot leaves out old versions for it
      this.#sum.uncounted += robot.name === "foresight-lab" ? 0 : Math.max(0, gaps - dropped);
      const unwritten = Math.max(0, messages - stored);
      if (unfinished) this.#sum.unwritten = Math.max(this.#sum.unwritten, unwritten);
      else this.#sum.uncounted += unwritten;
      this.#sum.unreadable += unreadable;
      this.#sum.unfinished += Number(unfinished);
      console.log(`   ${robot.name} ${session}: ${stored} stored, ${gaps} missing, ${dropped} counted as lost${unfinished ? ", no end" : ""}`);
    }
    [this.#sum.kills, robot.kills] = [this.#sum.kills + robot.kills, 0];
  }

  tell(report) {
    report.figure("messages stored", this.#sum.stored);
    report.figure("messages lost", this.#sum.lost);
    report.figure("messages counted as lost", this.#sum.counted);
    report.figure("messages lost without being counted", this.#sum.uncounted, "", { exactly: 0 });
    report.figure("kills", this.#sum.kills);
    report.figure("messages not yet written at a kill, at most", this.#sum.unwritten, "", { atMost: 2 * kPerSecond });
    report.figure("sessions without an end", this.#sum.unfinished, "", { atMost: this.#sum.kills });
    report.figure("files that another reader cannot read", this.#sum.unreadable, "", { exactly: 0 });
  }
}
