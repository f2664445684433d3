// Our client of the Foxglove WebSocket protocol v1. It stays connected, keeps the wanted topics subscribed and calls
// services.

import { Calls, type Answer } from "./calls";
import { readFrame, writePlaybackWish, writeServiceCall, type PlaybackState, type PlaybackWish } from "./frames";
import { readText, type Channel, type Level, type ServerInfo } from "./texts";

export const kSubprotocols = ["foxglove.sdk.v1", "foxglove.websocket.v1"];

const kReconnectMs = 1000;
const kConnectTimeoutMs = 5000;
/** Timeout of a server that has sent Time frames and is now silent. TCP alone notices a lost server much later. */
const kSilenceMs = 5000;

/**
 * `connecting`: a try is under way. `open`: the server has introduced itself. `waiting`: the next try begins within a
 * second.
 */
export type Connection = { state: "connecting" | "open" } | { state: "waiting"; why: string };

/** The events of a client. Times from the wire stay bigint ns. */
export interface Listener {
  connection(connection: Connection): void;
  /**
   * The server has introduced itself; channels follow. `fresh`: this is another run, so everything known is void.
   * `restarted`: the server's time went back on the same connection, and its channels stay.
   */
  introduced(info: ServerInfo, fresh: boolean, restarted: boolean): void;
  advertised(channels: Channel[]): void;
  unadvertised(channels: Channel[]): void;
  /** Called when a subscription of this topic begins (`is`) or ends. */
  subscribed(topic: string, is: boolean): void;
  message(topic: string, log_ns: bigint, data: Uint8Array): void;
  time(now_ns: bigint): void;
  /** Whether this connection has a playhead of its own in the recording. The playhead's state follows. */
  playhead(own: boolean): void;
  playback(state: PlaybackState): void;
  status(level: Level, message: string, id?: string, cause?: string): void;
  removeStatus(ids: string[]): void;
  parameters(values: { name: string; value: unknown }[]): void;
  services(names: string[]): void;
}

/** The part of a WebSocket that the client uses, so that a test can be the server. */
export interface Socket {
  binaryType: string;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(data: string | Uint8Array): void;
  close(): void;
}

export class Client {
  #socket: Socket | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #open = false;
  #heartbeat = false; // true after a Time frame came over this connection
  #sessionId: string | undefined;
  #channels = new Map<string, Channel>(); // by topic
  #wanted = new Map<string, number>(); // topic -> number of users
  #subscriptions = new Map<number, Channel>(); // by subscription id
  #nextSubscription = 0;
  #syncing = false;
  #services = new Map<string, number>();
  #calls = new Calls();

  constructor(
    /** Returns the address of the next try. */
    readonly address: () => string,
    readonly listener: Listener,
    readonly openSocket: (url: string, subprotocols: string[]) => Socket,
  ) {}

  start(): void {
    this.listener.connection({ state: "connecting" });
    let socket: Socket;
    try {
      socket = this.openSocket(this.address(), kSubprotocols);
    } catch (error) {
      this.#retry(`The browser refused to connect: ${(error as Error).message}`);
      return;
    }
    this.#socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onmessage = ({ data }) => this.#receive(data);
    socket.onclose = ({ code, reason }) => this.#lost(closeSentence(this.#open, code, reason));
    this.#within(kConnectTimeoutMs, "No answer from the robot.");
  }

  stop(): void {
    this.#drop();
  }

  /** Keeps `topic` subscribed, also after each reconnect, until the returned function is called. */
  want(topic: string): () => void {
    this.#wanted.set(topic, (this.#wanted.get(topic) ?? 0) + 1);
    this.#sync();
    let released = false;
    return () => {
      if (released) return;
      released = true;
      const others = this.#wanted.get(topic)! - 1;
      if (others > 0) this.#wanted.set(topic, others);
      else this.#wanted.delete(topic);
      this.#sync();
    };
  }

  /** Calls a service that speaks JSON. Rejects with a sentence on a failure, a timeout or the answer {"ok": false}. */
  call(name: string, request: object, timeoutMs?: number): Promise<Answer> {
    const service = this.#services.get(name);
    if (!this.#open) return Promise.reject(new Error("Not connected to the robot."));
    if (service === undefined) return Promise.reject(new Error(`The robot does not offer '${name}'.`));
    const { id, answer } = this.#calls.begin(name, timeoutMs);
    this.#socket?.send(writeServiceCall(service, id, "json", new TextEncoder().encode(JSON.stringify(request))));
    return answer;
  }

  /**
   * Sets parameters. The server answers with the values that hold, and with a sentence for each that it refuses. Returns
   * false if no server is connected.
   */
  setParameters(values: ReadonlyMap<string, number | boolean | string>): boolean {
    const parameters = [...values].map(([name, value]) => ({ name, value }));
    if (this.#open) this.#send({ op: "setParameters", parameters, id: "set" });
    return this.#open;
  }

  /**
   * Sends a wish to a server that plays a recording. The answer carries `request`. Returns false if no server is
   * connected.
   */
  ask(wish: PlaybackWish, request: string): boolean {
    if (this.#open) this.#socket?.send(writePlaybackWish(wish, request));
    return this.#open;
  }

  /**
   * Asks for a playhead of this connection's own in the recording, or for the shared one. Returns false if no server is
   * connected.
   */
  choosePlayhead(own: boolean): boolean {
    if (this.#open) this.#send({ op: "playhead", own });
    return this.#open;
  }

  #receive(data: unknown): void {
    this.#expectMore();
    if (typeof data === "string") this.#receiveText(data);
    else if (data instanceof ArrayBuffer) this.#receiveFrame(data);
  }

  #receiveFrame(data: ArrayBuffer): void {
    const frame = readFrame(data);
    switch (frame.kind) {
      case "message": {
        // messages of an ended subscription may still arrive
        const channel = this.#subscriptions.get(frame.subscription);
        if (channel) this.listener.message(channel.topic, frame.log_ns, frame.data);
        break;
      }
      case "time":
        this.#heartbeat = true;
        this.#expectMore();
        this.listener.time(frame.now_ns);
        break;
      case "playback":
        this.listener.playback(frame.state);
        break;
      case "response":
        this.#calls.answer(frame.call, frame.encoding, frame.data);
        break;
      case "malformed":
        this.#complain(frame.why);
    }
  }

  #receiveText(data: string): void {
    const text = readText(data);
    switch (text.op) {
      case "serverInfo":
        this.#introduce(text.info);
        break;
      case "advertise":
        if (text.rejected > 0) this.#complain(`advertise: ${text.rejected} channels without a usable id or topic`);
        this.#advertise(text.channels);
        break;
      case "unadvertise":
        this.#withdraw([...this.#channels.values()].filter(({ id }) => text.channelIds.includes(id)));
        break;
      case "status":
        this.listener.status(text.level, text.message, text.id, text.cause);
        break;
      case "removeStatus":
        this.listener.removeStatus(text.statusIds);
        break;
      case "parameterValues":
        this.listener.parameters(text.parameters);
        break;
      case "advertiseServices":
        for (const { id, name } of text.services) this.#services.set(name, id);
        this.listener.services([...this.#services.keys()]);
        break;
      case "unadvertiseServices":
        for (const [name, id] of this.#services) if (text.serviceIds.includes(id)) this.#services.delete(name);
        this.listener.services([...this.#services.keys()]);
        break;
      case "playhead":
        this.listener.playhead(text.own);
        break;
      case "serviceCallFailure":
        this.#calls.fail(text.call, text.message || "The robot refused without a reason.");
        break;
      case "malformed":
        this.#complain(text.why);
    }
  }

  #introduce(info: ServerInfo): void {
    const fresh = info.sessionId === undefined || info.sessionId !== this.#sessionId;
    const restarted = this.#open && fresh; // otherwise only its metadata changed
    this.#sessionId = info.sessionId;
    if (restarted) this.#resubscribe();
    else if (!this.#open) this.#forget();
    this.#open = true;
    this.#expectMore();
    this.listener.connection({ state: "open" });
    this.listener.introduced(info, fresh, restarted);

    if (info.capabilities.includes("parameters")) this.#send({ op: "getParameters", parameterNames: [], id: "all" });
    if (info.capabilities.includes("parametersSubscribe"))
      this.#send({ op: "subscribeParameterUpdates", parameterNames: [] });
  }

  #advertise(channels: Channel[]): void {
    // a topic that returns with another id or schema is another channel
    const known = channels.filter((channel) => sameChannel(this.#channels.get(channel.topic), channel));
    const added = channels.filter((channel) => !known.includes(channel));
    this.#withdraw(added.flatMap(({ topic }) => this.#channels.get(topic) ?? []));
    for (const channel of added) this.#channels.set(channel.topic, channel);
    this.listener.advertised(added);
    this.#sync();
  }

  #withdraw(channels: Channel[]): void {
    if (channels.length === 0) return;
    for (const channel of channels) this.#channels.delete(channel.topic);
    this.listener.unadvertised(channels);
    this.#sync();
  }

  /**
   * Subscribes to all topics that are wanted and offered, and ends the other subscriptions. Changes within one turn of
   * the event loop are sent together.
   */
  #sync(): void {
    if (this.#syncing) return;
    this.#syncing = true;
    queueMicrotask(() => {
      this.#syncing = false;
      if (!this.#open) return;

      const ended = [...this.#subscriptions].filter(
        ([, channel]) => !this.#wanted.has(channel.topic) || this.#channels.get(channel.topic) !== channel,
      );
      for (const [id] of ended) this.#subscriptions.delete(id);
      const active = new Set([...this.#subscriptions.values()].map(({ topic }) => topic));
      const begun = [...this.#channels.values()]
        .filter(({ topic }) => this.#wanted.has(topic) && !active.has(topic))
        .map((channel) => ({ id: this.#nextSubscription++, channel }));
      for (const { id, channel } of begun) this.#subscriptions.set(id, channel);

      if (ended.length > 0) this.#send({ op: "unsubscribe", subscriptionIds: ended.map(([id]) => id) });
      if (begun.length > 0)
        this.#send({ op: "subscribe", subscriptions: begun.map(({ id, channel }) => ({ id, channelId: channel.id })) });
      for (const [, { topic }] of ended) this.listener.subscribed(topic, false);
      for (const { channel } of begun) this.listener.subscribed(channel.topic, true);
    });
  }

  #complain(why: string): void {
    this.listener.status("error", `The robot sent something unreadable: ${why}.`, `unreadable: ${why}`);
  }

  #send(message: object): void {
    this.#socket?.send(JSON.stringify(message));
  }

  #within(milliseconds: number, otherwise: string): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#lost(otherwise), milliseconds);
  }

  #expectMore(): void {
    if (this.#heartbeat) this.#within(kSilenceMs, "The robot fell silent.");
    else if (this.#open) clearTimeout(this.#timer);
  }

  #lost(why: string): void {
    this.#drop();
    this.#retry(why);
  }

  #retry(why: string): void {
    this.listener.connection({ state: "waiting", why });
    this.#timer = setTimeout(() => this.start(), kReconnectMs);
  }

  #drop(): void {
    clearTimeout(this.#timer);
    const socket = this.#socket;
    this.#socket = undefined;
    if (socket) {
      socket.onmessage = socket.onclose = null;
      socket.close();
    }
    this.#open = this.#heartbeat = false;
    this.#forget();
  }

  /** Subscribes again to all channels, so that the newest message of each object comes again. */
  #resubscribe(): void {
    for (const { topic } of this.#subscriptions.values()) this.listener.subscribed(topic, false);
    if (this.#subscriptions.size > 0)
      this.#send({ op: "unsubscribe", subscriptionIds: [...this.#subscriptions.keys()] });
    this.#subscriptions.clear();
    this.#sync();
  }

  /** Forgets the state of one connection or run. The wanted topics stay wanted. */
  #forget(): void {
    for (const { topic } of this.#subscriptions.values()) this.listener.subscribed(topic, false);
    this.#calls.failAll("The connection to the robot was lost.");
    this.#channels.clear();
    this.#subscriptions.clear();
    this.#services.clear();
    this.listener.services([]);
  }
}

const sameChannel = (a: Channel | undefined, b: Channel): boolean =>
  a !== undefined &&
  a.id === b.id &&
  a.encoding === b.encoding &&
  a.schemaName === b.schemaName &&
  a.schema === b.schema;

/**
 * Returns the likely reason of a closed connection. Browsers give a page almost no information about a refused
 * upgrade.
 */
function closeSentence(wasOpen: boolean, code: number, reason: string): string {
  if (reason) return `The robot closed the connection: ${reason}`;
  if (wasOpen) return "The connection to the robot was lost.";
  return code === 1006
    ? "No robot answers, or it refused this page (token, origin)."
    : `Connection closed with code ${code}.`;
}
