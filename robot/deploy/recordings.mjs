// The recordings on a robot, through its HTTP API.
import http from "node:http";
import { BadInput, RobotFailed } from "./failure.mjs";
import { answers } from "./ssh.mjs";

const kSilence_ms = 5000; // timeout of a connection that transfers
const kReading_ms = 120000; // the robot reads whole files, for their checksums or an index, from a slow disk
const kPause_ms = 250; // between two questions whether it has read them
const kSockets = 3;

/** A failure for which the robot did answer: it refused the request. */
export class Refused extends RobotFailed {
  constructor(status, sentence) {
    super(sentence);
    this.status = status;
  }
}

/** Returns a name on the robot that becomes a file or folder here; throws if it could lead out of our folder. */
function safeName(name) {
  if (typeof name !== "string" || !/^[\w+][\w+.-]*$/.test(name)) throw new RobotFailed(`expected names of letters, digits, _, +, . and -, got ${JSON.stringify(name)}`);
  return name;
}

const isSession = ({ start_ns, streams } = {}) => /^\d{1,19}$/.test(start_ns) && Array.isArray(streams);
const isFile = ({ size_bytes, crc32 } = {}) => Number.isSafeInteger(size_bytes) && size_bytes >= 0 && /^[0-9a-f]{8}$/.test(crc32);

/** Returns the robot's reason for a refusal, in one sentence. */
function sentenceOf(status, body) {
  try {
    return JSON.parse(body).error ?? `it answered with status ${status}`;
  } catch {
    return body.trim().split("\n")[0].slice(0, 200) || `it answered with status ${status}`;
  }
}

/** The recordings of one robot. */
export class Recordings {
  #agent = new http.Agent({ keepAlive: true, maxSockets: kSockets });

  /** `token` may be absent; only deleting needs it. */
  constructor(host, port, token) {
    Object.assign(this, { host, port, token });
  }

  /** Returns true if the robot can be reached. */
  isThere() {
    return answers(this.host, this.port);
  }

  close() {
    this.#agent.destroy();
  }

  /** Returns the response to a request once its head has come. Throws RobotFailed after a silence of `silence_ms`. */
  #ask(path, { method = "GET", headers = {}, silence_ms = kSilence_ms } = {}) {
    return new Promise((done, fail) => {
      const sent = http.request({ host: this.host, port: this.port, path, method, headers, agent: this.#agent, timeout: silence_ms }, done);
      sent.on("timeout", () => sent.destroy(new Error(`nothing came for ${silence_ms / 1000} s`)));
      sent.on("error", (error) => fail(new RobotFailed(`the connection was lost: ${error.message}`)));
      sent.end();
    });
  }

  async #text(path, expected, options) {
    const response = await this.#ask(path, options);
    let body = "";
    try {
      for await (const text of response.setEncoding("utf8")) body += text;
    } catch (error) {
      throw new RobotFailed(`the connection was lost: ${error.message}`);
    }
    if (response.statusCode !== expected) throw new Refused(response.statusCode, sentenceOf(response.statusCode, body));
    return body;
  }

  async #json(path, options) {
    const body = await this.#text(path, 200, options);
    try {
      return JSON.parse(body);
    } catch {
      throw new RobotFailed(`${path}: expected JSON, got '${body.slice(0, 60)}'`);
    }
  }

  /** Returns [{session, state, kept, start_ns, streams: [{file, schema, size_bytes}]}] once the robot knows all streams. */
  async sessions() {
    const end_ms = performance.now() + kReading_ms;
    for (;;) {
      const { sessions } = await this.#json("/api/sessions");
      if (!Array.isArray(sessions) || !sessions.every(isSession)) throw new RobotFailed("expected a list of sessions, got something else: is that runtime older than this command?");
      for (const { session } of sessions) safeName(session);
      const unread = sessions.find(({ read }) => read === false);
      if (!unread) return sessions;
      if (performance.now() > end_ms) throw new RobotFailed(`${unread.session}: the robot has been reading it for ${kReading_ms / 1000} s: run the command again later`);
      await new Promise((done) => setTimeout(done, kPause_ms));
    }
  }

  /** Returns [{name, size_bytes, crc32}]: all files of a session that is not being recorded. */
  async files(session) {
    const { files } = await this.#json(`/api/sessions/${session}/files`, { silence_ms: kReading_ms });
    if (!Array.isArray(files) || !files.every(isFile)) throw new RobotFailed(`${session}: expected a list of files, got something else`);
    for (const { name } of files) safeName(name);
    return files;
  }

  /** Returns the bytes of a file from `from` on, as {from, pieces}. The robot may begin at 0 instead. */
  async bytes(session, name, from) {
    const path = `/logs/${session}/files/${name}`;
    const response = await this.#ask(path, { headers: from > 0 ? { range: `bytes=${from}-` } : {} });
    if (response.statusCode === 200) return { from: 0, pieces: response };
    const begins = /^bytes (\d+)-/.exec(response.headers["content-range"] ?? "")?.[1];
    if (response.statusCode === 206 && Number(begins) === from) return { from, pieces: response };
    response.resume();
    throw new Refused(response.statusCode, `${path}: it answered with status ${response.statusCode}`);
  }

  async remove(session) {
    await this.#text(`/logs/${session}?token=${encodeURIComponent(this.token ?? "")}`, 204, { method: "DELETE" });
  }
}

/** Returns the word of --token; it must be usable in an address. */
export function tokenText(value, option) {
  if (!/^[\x21-\x7e]{8,}$/.test(value)) throw new BadInput(`${option}: expected 8 characters or more without blanks, got '${value}'`);
  return value;
}
