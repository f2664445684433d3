// What the page knows: fed by the client, read by the views. Values of memory objects are plain and read when drawn;
// only what changes rarely is reactive.

import type { MemoryObject } from "../memory/memory_object";
import { kTruth } from "../draw/scene";
import { Memory } from "../memory/memory";
import { allStreamStatistics, recordingStatistics, runtimesOf, type RecordingStatistics, type StreamStatistics } from "../memory/statistics";
import { Client, type Connection, type Listener, type Socket } from "../source/client";
import { ClockExchange } from "../source/clock_exchange";
import type { Target } from "../source/target";
import type { Channel, Level, ServerInfo } from "../source/texts";
import { withAlert, withoutAlerts, type Alert } from "./alerts";
import { now } from "./frame.svelte";
import { hashOf, routeOf, type Route, type View } from "./route";

export class Viewer implements Listener {
  readonly memory = new Memory();
  readonly client: Client;

  connectionState = $state.raw<Connection>({ state: "connecting" });
  /** Why there is no connection; "" while there is one, and before the first try failed. */
  lost = $state("");
  info = $state.raw<ServerInfo>();
  alerts = $state.raw<Alert[]>([]);
  parameterValues = $state.raw<ReadonlyMap<string, unknown>>(new Map());
  serviceNames = $state.raw<string[]>([]);
  route = $state.raw<Route>(routeOf(location.hash));
  #clock = new ClockExchange((request) => this.client.call("clock_sync", request));
  #offers = $state(0); // grows when objects come or go

  robots = $derived.by(() => (this.#offers, this.memory.robots()));
  /** The chosen robot while it is there, else the one that the program is, else the first one. */
  robot = $derived([this.route.robot, this.info?.metadata["robots"]].find((name) => this.robots.includes(name ?? "")) ?? this.robots[0] ?? "");
  objects: MemoryObject[] = $derived.by(() => (this.#offers, this.memory.objectsOf(this.robot)));
  /** The chosen view; where none was chosen what the robot sees, or the game of one that has no camera. */
  view: View = $derived(this.route.view || (this.#playsBlind() ? "field" : "camera"));

  constructor(readonly target: Target) {
    this.client = new Client(target.url, this, (url, subprotocols) => new WebSocket(url, subprotocols) as Socket);
    window.addEventListener("hashchange", () => (this.route = routeOf(location.hash)));
    this.client.start();
  }

  #playsBlind(): boolean {
    return this.objects.some(({ channel }) => channel.topic === kTruth) && !this.objects.some(({ isImage }) => isImage);
  }

  go(to: Partial<Route>): void {
    location.hash = hashOf({ robot: this.robot, view: this.view, ...to });
  }

  say(level: Level, text: string, key?: string): void {
    this.alerts = withAlert(this.alerts, level, text, key);
  }

  dismiss(keys: string[]): void {
    this.alerts = withoutAlerts(this.alerts, keys);
  }

  /** Calls a service; a failure becomes an alert. True when it was done. */
  async do(service: string, request: object): Promise<boolean> {
    try {
      await this.client.call(service, request);
      this.dismiss([`service ${service}`]);
      return true;
    } catch (error) {
      this.say("error", (error as Error).message, `service ${service}`);
      return false;
    }
  }

  /** The server's own count of its streams, by topic; empty until a `runtime` object came. */
  statistics(): Map<string, StreamStatistics> {
    return allStreamStatistics(runtimesOf(this.objects));
  }

  recording(): RecordingStatistics | undefined {
    const [runtime] = runtimesOf(this.objects);
    return runtime && recordingStatistics(runtime);
  }

  // what the client tells

  connection(connection: Connection): void {
    this.connectionState = connection;
    if (connection.state === "open") this.lost = "";
    if (connection.state === "waiting") this.lost = connection.why;
  }
  introduced(info: ServerInfo, fresh: boolean): void {
    this.info = info;
    if (!fresh) return;
    this.memory.reset();
    this.alerts = [];
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
  status(level: Level, message: string, id?: string): void {
    this.say(level, message, id);
  }
  removeStatus(ids: string[]): void {
    this.dismiss(ids);
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
