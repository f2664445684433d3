// One server the page watches: its connection and its memory. A robot, a recording being played, a simulated game.

import type { RobotName } from "../memory/memory_object";
import { Memory } from "../memory/memory";
import type { Past } from "../memory/past";
import { allStreamStatistics, recordingStatistics, runtimesOf, type RecordingStatistics, type StreamStatistics } from "../memory/statistics";
import { Client, type Connection, type Listener, type Socket } from "../source/client";
import { ClockExchange } from "../source/clock_exchange";
import type { Target } from "../source/target";
import type { Channel, Level, ServerInfo } from "../source/texts";
import { now } from "./frame.svelte";

/** A body that is no robot in the world: what is shown must not be taken for live. */
const kBodyWords: Record<string, string> = { recording: "a recording", replay: "a replay", sim: "a simulation" };

/** Where a server's sentences go. */
export interface Speaker {
  /** Whether there are more servers than one: then sentences tell whose they are. */
  readonly several: boolean;
  say(level: Level, text: string, key?: string): void;
  dismiss(keys: string[]): void;
}

export class Server implements Listener {
  readonly memory: Memory;
  readonly client: Client;

  connectionState = $state.raw<Connection>({ state: "connecting" });
  /** Why there is no connection; "" while there is one, and before the first try failed. */
  lost = $state("");
  info = $state.raw<ServerInfo>();
  parameterValues = $state.raw<ReadonlyMap<string, unknown>>(new Map());
  serviceNames = $state.raw<string[]>([]);
  #clock = new ClockExchange((request) => this.client.call("clock_sync", request));
  #offers = $state(0); // grows when objects come or go
  #alertKeys = new Set<string>();

  robots: RobotName[] = $derived.by(() => (this.#offers, this.memory.robots()));
  /** "a simulation"; "" for a robot in the world. */
  body = $derived(kBodyWords[this.info?.metadata["body"] ?? ""] ?? "");

  constructor(
    readonly target: Target,
    past: Past,
    readonly speaker: Speaker,
  ) {
    this.memory = new Memory(past);
    this.client = new Client(target.url, this, (url, subprotocols) => new WebSocket(url, subprotocols) as Socket);
    this.client.start();
  }

  /** The end: nothing comes any more, and what was known is forgotten. */
  stop(): void {
    this.client.stop();
    this.#clock.stop();
    this.memory.reset();
    this.speaker.dismiss([...this.#alertKeys]);
  }

  /** Counts up when objects come or go: to be read by what lists them. */
  get offers(): number {
    return this.#offers;
  }

  objectsOf(robot: RobotName) {
    return (this.#offers, this.memory.objectsOf(robot));
  }

  /** Calls a service; a failure becomes an alert. True when it was done. */
  async do(service: string, request: object): Promise<boolean> {
    try {
      await this.client.call(service, request);
      this.removeStatus([`service ${service}`]);
      return true;
    } catch (error) {
      this.status("error", (error as Error).message, `service ${service}`);
      return false;
    }
  }

  /** The server's own count of its streams, by topic; empty until a `runtime` object came. */
  statistics(): Map<string, StreamStatistics> {
    return allStreamStatistics(runtimesOf([...this.memory.objects()]));
  }

  recording(): RecordingStatistics | undefined {
    const [runtime] = runtimesOf([...this.memory.objects()]);
    return runtime && recordingStatistics(runtime);
  }

  // what the client tells

  connection(connection: Connection): void {
    this.connectionState = connection;
    if (connection.state === "open") this.lost = "";
    if (connection.state === "waiting") this.lost = connection.why;
  }
  introduced(info: ServerInfo, fresh: boolean, restarted: boolean): void {
    this.info = info;
    if (restarted) return this.memory.restart();
    if (!fresh) return;
    this.memory.reset();
    this.speaker.dismiss([...this.#alertKeys]);
    this.parameterValues = new Map();
    ++this.#offers;
  }
  advertised(channels: Channel[]): void {
    for (const channel of channels) this.memory.offer(channel);
    ++this.#offers;
  }
  unadvertised(channels: Channel[]): void {
    for (const { topic } of channels) this.memory.withdraw(topic);
    ++this.#offers;
  }
  subscribed(topic: string, is: boolean): void {
    this.memory.subscribed(topic, is);
  }
  message(topic: string, log_ns: bigint, data: Uint8Array): void {
    this.memory.arrived(topic, log_ns, data, now());
  }
  time(now_ns: bigint): void {
    this.memory.clock.heard(now_ns, now());
  }
  status(level: Level, message: string, id: string = message): void {
    const key = `${this.target.host} ${id}`;
    this.#alertKeys.add(key);
    this.speaker.say(level, this.speaker.several ? `${this.target.host}: ${message}` : message, key);
  }
  removeStatus(ids: string[]): void {
    this.speaker.dismiss(ids.map((id) => `${this.target.host} ${id}`));
  }
  parameters(values: { name: string; value: unknown }[]): void {
    this.parameterValues = new Map([...this.parameterValues, ...values.map(({ name, value }) => [name, value] as const)]);
  }
  services(names: string[]): void {
    this.serviceNames = names;
    if (names.includes("clock_sync")) this.#clock.start();
    else this.#clock.stop();
  }
}
