// One server the page watches: its connection and its memory. A robot, a recording being played, a simulated game.

import type { RobotName } from "../memory/memory_object";
import { Memory } from "../memory/memory";
import type { Past } from "../memory/past";
import { Played } from "../memory/played";
import { allStreamStatistics, recordingStatistics, runtimesOf, type RecordingStatistics, type StreamStatistics } from "../memory/statistics";
import { Client, type Connection, type Listener, type Socket } from "../source/client";
import { ClockExchange } from "../source/clock_exchange";
import type { PlaybackState, PlaybackWish } from "../source/frames";
import type { Target } from "../source/target";
import type { Channel, Level, ServerInfo } from "../source/texts";
import { Wishes } from "../source/wishes";
import { now } from "./frame.svelte";

/** A body that is no robot in the world: what is shown must not be taken for live. */
const kBodyWords: Record<string, string> = { recording: "a recording", replay: "a replay", sim: "a simulation" };

const kOutdated = 0.3; // [s] after a place was sought: what has not come by then has no value there
const kIntroduction = 1; // [s] in which a server that offers no services tells what it has
const kSettled = 0.15; // [s] a moment stands before the server goes there, too

/** Where a server's sentences go. */
export interface Speaker {
  /** Whether there are more servers than one: then sentences tell whose they are. */
  readonly several: boolean;
  say(level: Level, text: string, key?: string): void;
  dismiss(keys: string[]): void;
  /** Somebody else moved the recording that this server plays, or it cannot be moved. */
  follow(server: Server): void;
}

export class Server implements Listener {
  readonly memory: Memory;
  readonly client: Client;

  connectionState = $state.raw<Connection>({ state: "connecting" });
  /** Why there is no connection; "" while there is one, and before the first try failed. */
  lost = $state("");
  info = $state.raw<ServerInfo>();
  /** Whether it has told all that it has; ours tell it in parts, and their services last. */
  toldAll = $state(false);
  #introduced_s = 0; // when it began to
  parameterValues = $state.raw<ReadonlyMap<string, unknown>>(new Map());
  serviceNames = $state.raw<string[]>([]);
  #clock = new ClockExchange((request) => this.client.call("clock_sync", request));
  /** The recording that this server plays; undefined where it plays none. */
  played = $state.raw<Played>();
  #told = $state(0); // grows when the playback is told to go otherwise
  #wishes = new Wishes((wish, request) => this.client.ask(wish, request));
  #sought: number | undefined; // [s] when the playback last went elsewhere
  #refused = false; // it did not do what was asked, and said why: then only what the page holds can be looked at
  #left_ns: bigint | undefined; // the moment that was shown when something else was asked for
  #settling = { at_ns: undefined as bigint | undefined, since: 0 };
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
    const url = new URL(target.url);
    url.searchParams.set("playback", "yes"); // we understand how it goes
    this.client = new Client(url.href, this, (url, subprotocols) => new WebSocket(url, subprotocols) as Socket);
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

  // the recording that it plays

  /** Whether it plays a recording that goes on; reactive. */
  get runs(): boolean {
    return (void this.#told, this.played?.runs === true);
  }
  /** Whether the recording is at its end. */
  get ended(): boolean {
    return (void this.#told, this.played?.status === "ended");
  }
  /** 1 is real time; as the server was told last, by whomever. */
  get speed(): number {
    return (void this.#told, this.played?.speed ?? 1);
  }

  /** Where the recording is, or was asked to be. */
  place(): bigint {
    return this.#wishes.pending?.seek_ns ?? this.played?.at(now()) ?? 0n;
  }

  /** Whether it has not answered yet. */
  get asked(): boolean {
    return this.#wishes.pending !== undefined;
  }
  /** Whether it plays on, or was asked to. */
  get goes(): boolean {
    return this.#wishes.pending?.play ?? this.runs;
  }

  /** What is shown stays until the answer comes. */
  ask(wish: PlaybackWish): void {
    this.#left_ns = this.memory.moment_ns;
    this.#wishes.ask(wish, now());
  }

  /** Stands at `at_ns`: at once out of what the page holds, else by asking for it. */
  stand(at_ns: bigint): void {
    if (this.memory.holds(at_ns)) this.memory.show(at_ns);
    else if (this.#refused) this.speaker.follow(this);
    else this.ask({ play: false, speed: this.speed, seek_ns: at_ns });
  }

  /** Before each drawing. */
  frame(): void {
    const time = now();
    this.memory.reached(time);
    if (this.info && !this.toldAll && time - this.#introduced_s > kIntroduction) this.toldAll = true;
    if (this.#sought !== undefined && time - this.#sought > kOutdated) {
      this.#sought = undefined;
      this.memory.dropOutdated();
    }
    if (this.#wishes.gaveUp(time)) {
      this.#refused = true;
      if (this.memory.moment_ns === undefined) this.speaker.follow(this);
    }
    this.#settle(time);
  }

  /** A moment that was found here is sought at the server, too: pictures are kept seldomer here, and what is opened now is not. */
  #settle(time: number): void {
    const at_ns = this.played && this.memory.moment_ns;
    if (at_ns !== this.#settling.at_ns) this.#settling = { at_ns, since: time };
    if (at_ns === undefined || time - this.#settling.since < kSettled || this.asked || this.#refused) return;
    this.#wishes.ask({ play: false, speed: this.speed, seek_ns: at_ns }, time);
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
    if (restarted) return this.#beginAgain();
    if (!fresh) return;
    this.toldAll = false;
    this.#introduced_s = now();
    this.memory.reset();
    this.#wishes.clear();
    this.#refused = false;
    this.memory.played = this.played = info.capabilities.includes("playbackControl") && info.span ? new Played(info.span.start_ns, info.span.end_ns) : undefined;
    this.speaker.dismiss([...this.#alertKeys]);
    this.parameterValues = new Map();
    ++this.#offers;
  }
  #beginAgain(): void {
    const { played, memory } = this;
    if (!played) return memory.restart();
    played.heard(played.start_ns, now());
    memory.sought(played.start_ns);
    this.#sought = now();
  }
  playback(state: PlaybackState): void {
    const { played, memory } = this;
    if (!played) return;
    const time = now();
    this.#wishes.answered(state.request, time);
    const isOurs = state.request !== ""; // also when it comes late
    if (isOurs) this.#refused = false;
    played.told(state, time);
    if (state.didSeek) {
      memory.sought(state.time_ns);
      this.#sought = time;
    }
    ++this.#told;
    const shown_ns = memory.moment_ns;
    if (shown_ns !== undefined && (shown_ns === state.time_ns || shown_ns === this.#left_ns || !memory.holds(shown_ns))) memory.show(undefined);
    if (!isOurs) this.speaker.follow(this);
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
    this.memory.subscribed(topic, is, now());
  }
  message(topic: string, log_ns: bigint, data: Uint8Array): void {
    this.memory.arrived(topic, log_ns, data, now());
  }
  time(now_ns: bigint): void {
    this.memory.clock.heard(now_ns, now());
    this.played?.heard(now_ns, now());
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
    if (names.length > 0) this.toldAll = true;
    if (names.includes("clock_sync")) this.#clock.start();
    else this.#clock.stop();
  }
}
