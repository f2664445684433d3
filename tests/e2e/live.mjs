// A client of the Foxglove WebSocket protocol that uses only `ws`. It decodes messages by the announced schemas.
import assert from "node:assert/strict";
import { atEnd, require, start, temporaryFolder, within } from "./support.mjs";

const WebSocket = require("ws");
const { createFileRegistry, fromBinary, toJson } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = require("@bufbuild/protobuf/wkt");

export const kSubprotocols = ["foxglove.sdk.v1", "foxglove.websocket.v1"];

/** Returns a function that decodes messages by a serialised descriptor set into protobuf JSON with the schema's field names. */
export function decoderOf(schemaName, descriptorSet) {
  const registry = createFileRegistry(fromBinary(FileDescriptorSetSchema, descriptorSet));
  const schema = registry.getMessage(schemaName);
  const options = { registry, useProtoFieldName: true, alwaysEmitImplicit: true };
  return (data) => toJson(schema, fromBinary(schema, data), options);
}

/** Decodes one message likewise. */
export const decode = (schemaName, descriptorSet, data) => decoderOf(schemaName, descriptorSet)(data);

export class Live {
  infos = []; // every serverInfo
  channels = new Map(); // by topic
  services = new Map(); // name -> id
  statuses = [];
  values = []; // every parameterValues
  times = []; // [ns]
  messages = new Map(); // topic -> [{log_ns, data}]
  answers = new Map(); // call id -> {raw, json}
  failures = []; // every serviceCallFailure
  closed; // {code, reason}
  #topics = []; // by subscription id
  #calls = 0;
  #waiting = new Set();

  /** Connects. `options` are those of ws, and `path`, `protocols`, `address`. */
  static async open(t, server, { path = "/", protocols = kSubprotocols, address = "localhost", ...options } = {}) {
    const live = new Live(new WebSocket(`ws://${address}:${server.port}${path}`, protocols, options));
    atEnd(t, () => live.socket.terminate());
    await live.until(() => live.infos.length > 0 && live.services.size > 0, "introduction of the server");
    return live;
  }

  constructor(socket) {
    this.socket = socket;
    socket.on("message", (bytes, isBinary) => (isBinary ? this.#frame(bytes) : this.#text(JSON.parse(bytes))));
    socket.on("close", (code, reason) => this.#changed((this.closed = { code, reason: reason.toString() })));
    socket.on("error", (error) => this.#changed((this.error = error)));
  }

  /** Returns the first true value of `condition`, which is called after each message. */
  until(condition, what, patience_ms) {
    const come = new Promise((resolve, reject) => {
      const ask = () => {
        const value = condition();
        if (!value && !this.error && !this.closed) return;
        this.#waiting.delete(ask);
        if (value) resolve(value);
        else reject(this.error ?? new Error(`the connection was closed: ${JSON.stringify(this.closed)}`));
      };
      this.#waiting.add(ask);
      ask();
    });
    return within(come, what, patience_ms);
  }

  send(message) {
    this.socket.send(typeof message === "string" || Buffer.isBuffer(message) ? message : JSON.stringify(message));
  }

  /** Subscribes to `topics`, as soon as all of them are announced. */
  async subscribe(...topics) {
    await this.until(() => topics.every((topic) => this.channels.has(topic)), `the channels ${topics.join(", ")}`);
    const subscriptions = topics.map((topic) => ({
      id: this.#topics.push(topic) - 1,
      channelId: this.channels.get(topic).id,
    }));
    for (const topic of topics) this.messages.set(topic, this.messages.get(topic) ?? []);
    this.send({ op: "subscribe", subscriptions });
  }

  /** Waits for a message of `topic` and returns the newest one. */
  async newest(topic) {
    await this.until(() => this.messages.get(topic).length > 0, `a message of ${topic}`);
    return this.messages.get(topic).at(-1);
  }

  decoded(topic, { data }) {
    const { schemaName, schema } = this.channels.get(topic);
    return decode(schemaName, Buffer.from(schema, "base64"), data);
  }

  /** Calls a service; returns its answer, also a refusal. */
  async call(name, request = {}) {
    const id = ++this.#calls;
    this.send(serviceCall(this.services.get(name), id, JSON.stringify(request)));
    return (await this.until(() => this.answers.get(id), `the answer of ${name}`)).json;
  }

  #changed() {
    for (const ask of [...this.#waiting]) ask();
  }

  #text(message) {
    switch (message.op) {
      case "serverInfo":
        this.infos.push(message);
        break;
      case "advertise":
        for (const channel of message.channels) this.channels.set(channel.topic, channel);
        break;
      case "advertiseServices":
        for (const { id, name } of message.services) this.services.set(name, id);
        break;
      case "status":
        this.statuses.push(message);
        break;
      case "parameterValues":
        this.values.push(message);
        break;
      case "serviceCallFailure":
        this.failures.push(message);
        break;
    }
    this.onText?.(message);
    this.#changed();
  }

  #frame(bytes) {
    if (bytes[0] === 1)
      this.messages
        .get(this.#topics[bytes.readUInt32LE(1)])
        .push({ log_ns: bytes.readBigUInt64LE(5), data: bytes.subarray(13) });
    if (bytes[0] === 2) this.times.push(bytes.readBigUInt64LE(1));
    if (bytes[0] === 3) {
      const text = 13 + bytes.readUInt32LE(9);
      this.answers.set(bytes.readUInt32LE(5), { raw: bytes, json: JSON.parse(bytes.subarray(text)) });
    }
    this.onFrame?.(bytes);
    this.#changed();
  }
}

/**
 * A simulated game that is paused one minute after its beginning, the same to the bit on every run. Its captain chooses
 * nothing by itself, because its number of rollouts depends on the processor. It answers questions.
 */
export async function pausedGame(t) {
  const server = await start(t, temporaryFolder(t), "foresight-robot", "--body", "sim", "--no-foresight");
  const live = await Live.open(t, server);
  await live.call("/sim/pause");
  await live.call("/sim/reset", { seed: 7 });
  const { ok, tick } = await live.call("/sim/step", { ticks: 1800 });
  assert.deepEqual({ ok, tick }, { ok: true, tick: 1800 });
  return { server, live };
}

/** The frame of a service call, written by hand from the description of the protocol. */
export function serviceCall(service, call, text, encoding = "json") {
  const head = Buffer.alloc(13);
  head[0] = 2;
  head.writeUInt32LE(service, 1);
  head.writeUInt32LE(call, 5);
  head.writeUInt32LE(encoding.length, 9);
  return Buffer.concat([head, Buffer.from(encoding + text)]);
}

/** A request of playback control, written by hand from the description of the protocol. */
export function playbackControl({ play, speed = 1, to_ns, id }) {
  const bytes = Buffer.alloc(19);
  bytes[0] = 3;
  bytes[1] = play ? 0 : 1;
  bytes.writeFloatLE(speed, 2);
  bytes[6] = to_ns === undefined ? 0 : 1;
  bytes.writeBigUInt64LE(to_ns ?? 0n, 7);
  bytes.writeUInt32LE(id.length, 15);
  return Buffer.concat([bytes, Buffer.from(id)]);
}

/** Returns the answer {status, text} to a WebSocket upgrade that is refused; fails if it is accepted. */
export function refusal(server, { path = "/", protocols = kSubprotocols, address = "127.0.0.1", ...options } = {}) {
  const socket = new WebSocket(`ws://${address}:${server.port}${path}`, protocols, options);
  return within(
    new Promise((resolve, reject) => {
      socket.on("open", () => reject(new Error("expected to be refused, was not")) || socket.terminate());
      socket.on("error", () => {});
      socket.on("unexpected-response", (_, response) => {
        let text = "";
        response.on("data", (bytes) => (text += bytes));
        response.on("end", () => resolve({ status: response.statusCode, text }));
      });
    }),
    "the refusal",
  );
}
