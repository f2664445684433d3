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
  const made = { name, folder, seen: new Map(), kills: 0, lives: 0 };
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
    ++made.lives;
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

/** Looks at the state. Remembers the counts of each session, and the earlier sessions of its request. */
export async function look(robot) {
  const { lives } = robot;
  const recording = (await ask(robot, "/api/status"))?.recording;
  if (!recording?.session || recording.state === "off") return recording;
  const request = `${lives} ${recording.request}`;
  const before = [...robot.seen].filter(([session, seen]) => seen.of === request && session !== recording.session);
  robot.seen.set(recording.session, { ...recording, of: request, earlier: before.map(([session]) => session) });
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
        socket.send(
          JSON.stringify({
            op: "subscribe",
            subscriptions: message.channels.map(({ id }) => ({ id: ++last, channelId: id })),
          }),
        );
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
    while (performance.now() < until_ms && !robot.ended) (await look(robot), await sleep(0.1));
  })();
  const reading = (async () => {
    while (performance.now() < until_ms && !robot.ended) {
      for (const session of ((await ask(robot, "/api/sessions"))?.sessions ?? []).slice(-2))
        await fetch(`${robot.url}/logs/${session.name}.mcap`, { signal: AbortSignal.timeout(5000) })
          .then((answer) => answer.arrayBuffer())
          .catch(() => {});
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

/** The program's own account of a session that has ended: numbers in its session.json. */
function accountIn(folder) {
  try {
    const { complete, messages, dropped } = JSON.parse(readFileSync(join(folder, "session.json"), "utf8"));
    return complete && messages !== undefined ? { messages: Number(messages), dropped: Number(dropped) } : undefined;
  } catch {
    return undefined;
  }
}

const sumOf = (values) => values.reduce((a, b) => a + b, 0);

/**
 * The account of all messages. A session that has ended has the program's account in its session.json. Its files must hold as
 * many messages as that says. The numbers that are missing between the first and the last message of an object must be counted
 * there. The account also counts losses before the first and after the last stored message, which leave no gap.
 *
 * A session that a kill ended has no account. Its files must hold at least the messages that the status showed last. Messages
 * that were on the way to the files then are in flight at the kill. Numbers that are missing, and that no status showed as
 * dropped, were lost too shortly before the kill for anybody to read the count.
 */
export class Account {
  #sessions = [];
  #kills = 0;
  #dropped = new Map(); // by session, of those that have ended

  /** Counts the sessions of a program in one log folder. */
  add(robot, logs) {
    for (const session of existsSync(logs) ? readdirSync(logs).sort() : []) {
      const folder = join(logs, session);
      if (!existsSync(join(folder, "session.json"))) continue; // not begun
      const account = accountIn(folder);
      const shown = robot.seen.get(session);
      if (account) this.#dropped.set(session, account.dropped);
      this.#sessions.push({ robot: robot.name, session, ...countFiles(folder), account, shown });
    }
    [this.#kills, robot.kills] = [this.#kills + robot.kills, 0];
  }

  /** Messages of a session that nobody counted, and those of a killed one. */
  #judge({ robot, stored, gaps, account, shown }) {
    // a relay keeps the numbers of its robots, and a busy robot leaves out old versions for it
    const missing = robot === "foresight-lab" ? 0 : gaps;
    if (account)
      return {
        uncounted: Math.abs(account.messages - stored) + Math.max(0, missing - account.dropped),
        inFlight: 0,
        unread: 0,
        dropped: account.dropped,
      };
    if (!shown) return { uncounted: 0, inFlight: 0, unread: missing, dropped: 0 };
    const before = sumOf(shown.earlier.map((session) => this.#dropped.get(session) ?? 0)); // of the same request
    const dropped = Math.max(0, shown.dropped - before);
    return {
      uncounted: Math.max(0, shown.messages - stored),
      inFlight: Math.max(0, shown.messages + shown.waiting - stored),
      unread: Math.max(0, missing - dropped),
      dropped,
    };
  }

  tell(report) {
    const judged = this.#sessions.map((one) => ({ ...one, ...this.#judge(one) }));
    for (const { robot, session, stored, gaps, account, shown, uncounted, unread, dropped, unfinished } of judged) {
      if (uncounted + unread + gaps + dropped === 0) continue;
      const counts = account
        ? `${account.messages} messages and ${account.dropped} dropped in session.json`
        : shown
          ? `no end; ${shown.messages} messages, ${shown.waiting} waiting and ${dropped} dropped in its last status`
          : "no end and no status";
      console.log(
        `   ${robot} ${session}: ${stored} stored, ${gaps} missing between them; ${counts}${unfinished ? "; a file without an end" : ""}${uncounted ? `; ${uncounted} NOT COUNTED` : ""}`,
      );
    }
    const sum = (key) => sumOf(judged.map((one) => Number(one[key])));
    const killed = judged.filter(({ account }) => !account);
    report.figure("sessions", judged.length);
    report.figure("messages stored", sum("stored"));
    report.figure("messages counted as lost", sum("dropped"));
    report.figure("messages missing between stored ones", sum("gaps"));
    report.figure("messages lost without being counted", sum("uncounted"), "", { exactly: 0 });
    report.figure("kills", this.#kills);
    report.figure("sessions without an end", killed.length, "", { atMost: this.#kills });
    report.figure("messages not yet written at the kills", sum("inFlight"));
    report.figure(
      "messages not yet written at a kill, at most",
      Math.max(0, ...judged.map(({ inFlight }) => inFlight)),
      "",
      { atMost: 2 * kPerSecond },
    );
    report.figure("messages lost before a kill, with a count that nobody could read", sum("unread"));
    report.figure(
      "files that the disk left without an end",
      judged.filter(({ account, unfinished }) => account && unfinished).length,
    );
    report.figure("files that another reader cannot read", sum("unreadable"), "", { exactly: 0 });
  }
}
