// One watched server with its connection and memory: a robot, a played recording or a simulated game.

import { knownEvents } from "../memory/game_events";
import { nearestKept, nearestOf } from "../memory/kept";
import type { RobotName } from "../memory/memory_object";
import { Memory } from "../memory/memory";
import type { Past } from "../memory/past";
import { Played } from "../memory/played";
import {
  allStreamStatistics,
  processStatistics,
  recordingStatistics,
  runtimesOf,
  type RecordingStatistics,
  type StreamStatistics,
} from "../memory/statistics";
import { causeOf } from "../source/calls";
import { Client, type Connection, type Listener, type Socket } from "../source/client";
import { livenessOf, type Liveness } from "../present/liveness";
import { simulationOf } from "../memory/simulation";
import { Summaries, WholeRuns } from "../memory/summaries";
import { sensorNumbers } from "../memory/truth";
import { fetchRecent, Recalls } from "../source/recent";
import { ClockExchange } from "../source/clock_exchange";
import type { PlaybackState, PlaybackWish } from "../source/frames";
import type { Target } from "../source/target";
import type { Channel, Level, ServerInfo } from "../source/texts";
import { Wishes } from "../source/wishes";
import { keep, kept } from "./browser";
import { now } from "./frame.svelte";
import { leftIn, textOfLeft, type Left } from "./left";

/** Bodies that are no real robot; the page names them, so that nobody takes them for live. */
const kBodyWords: Record<string, string> = { recording: "a recording", replay: "a replay", sim: "a simulation" };

const kStepService = "message_beside";
const kWatchService = "watch_session";
const kOutdated = 0.3; // [s] after a seek: an object without a message by then has no value there
const kIntroduction = 1; // [s] for the introduction of a server without services
const kFirstScreen = 0.6; // [s] in which the page shows the present, before it asks for the past
const kCounting = 2; // [s] until a server has written each of its streams and counted it, once a second
const kTopicsAtOnce = 8; // the server refuses more than 32 requests of a page at once
const kSettled = 0.15; // [s] the page waits at a moment before the server seeks it too

/** Receives a server's sentences. */
export interface Speaker {
  /** True if there are several servers. Then each sentence names its server. */
  readonly several: boolean;
  say(level: Level, text: string, key?: string): void;
  dismiss(keys: string[]): void;
  /** Called when somebody else moved the played recording, or when it cannot be moved. */
  follow(server: Server): void;
  /** Whether a connection follows the shared playback of a recording. Otherwise it has a playhead of its own. */
  readonly follows: boolean;
  /** The moment [ns] that the page's address asks for, or undefined. */
  readonly asked_ns: bigint | undefined;
  /** Called when a new connection has a playhead of its own, with the state in which an earlier one was lost. */
  opened(server: Server, left: Left | undefined): void;
}

export class Server implements Listener {
  readonly memory: Memory;
  readonly client: Client;

  connectionState = $state.raw<Connection>({ state: "connecting" });
  /** The reason why there is no connection. "" while connected, and before the first failed try. */
  lost = $state("");
  info = $state.raw<ServerInfo>();
  /** Whether the server has announced everything. Our servers announce in parts, services last. */
  toldAll = $state(false);
  #introduced_s = 0; // begin of the introduction
  parameterValues = $state.raw<ReadonlyMap<string, unknown>>(new Map());
  serviceNames = $state.raw<string[]>([]);
  #clock = new ClockExchange((request) => this.client.call("clock_sync", request));
  /** Name of the session that it plays; "" for a live robot, or for several sessions. */
  session = $derived(this.info?.metadata["session"] ?? "");
  /** Whether it can play another session of its folder. */
  canWatch = $derived(this.serviceNames.includes(kWatchService));
  /** The recording that this server plays, or undefined. */
  played = $state.raw<Played>();
  /** Whether its recording may have a playhead for each connection. */
  offersOwn = $derived(this.played !== undefined && this.info?.metadata["own_playheads"] === "yes");
  /** Whether games at this robot are tests, in which the wireless network stays open. */
  practice = $derived(this.parameterValues.get("match_mode") === false);
  /** Whether the server refused something for want of the right token, until a person types one or declines. */
  wantsToken = $state(false);
  #told = $state(0); // counts changes of the playback
  #wishes = new Wishes((wish, request) => this.client.ask(wish, request));
  #sought: number | undefined; // [s] time of the last seek
  #refused = false; // true after the server refused a wish: then only moments that the page holds can be shown
  #left_ns: bigint | undefined; // the shown moment when the last wish was sent
  /** Whether this connection has a playhead of its own in the recording. */
  own = $state(false);
  #opens = false; // a new connection has not told its playhead yet
  #left: Left | undefined; // of the lost connection
  #settling = { at_ns: undefined as bigint | undefined, since: 0 };
  /** Whether the server is being asked for all events of its recording. */
  learnsEvents = $state(false);
  #summaries: Summaries | undefined;
  #runs = new Map<string, WholeRuns>(); // by topic and fields
  #offers = $state(0); // counts announced and withdrawn objects
  #alertKeys = new Set<string>();
  #recalls: Recalls | undefined; // of a live server that remembers its last minutes

  robots: RobotName[] = $derived.by(() => (this.#offers, this.memory.robots(this.info?.metadata["robots"])));
  /** The numbers of the sensors beside the field, sorted. */
  sensors: number[] = $derived.by(() => (this.#offers, sensorNumbers(this.memory)));
  /** Such as "a simulation"; "" for a real robot. */
  body = $derived(kBodyWords[this.info?.metadata["body"] ?? ""] ?? "");

  constructor(
    readonly target: Target,
    past: Past,
    readonly speaker: Speaker,
  ) {
    this.memory = new Memory(past);
    // a link that names a moment does not go on from the last one
    if (speaker.asked_ns === undefined) this.#left = leftIn(kept("sessionStorage", `playhead ${target.host}`));
    this.client = new Client(
      () => this.#address(),
      this,
      (url, subprotocols) => new WebSocket(url, subprotocols) as Socket,
    );
    this.client.start();
  }

  /** The address of the next connection. A playhead of its own begins where the last one was, or where a link says. */
  #address(): string {
    const { speaker } = this;
    const url = new URL(this.target.url);
    url.searchParams.set("playback", "yes"); // asks for the playback state
    const at_ns = this.#left?.at_ns ?? speaker.asked_ns;
    if (!speaker.follows) url.searchParams.set("playhead", at_ns === undefined ? "own" : String(at_ns));
    return url.href;
  }

  /** Ends the connection and forgets everything. */
  stop(): void {
    this.#recalls?.stop();
    this.client.stop();
    this.#clock.stop();
    this.memory.reset();
    this.speaker.dismiss([...this.#alertKeys]);
  }

  /** Counts announced and withdrawn objects; lists of objects read it. */
  get offers(): number {
    return this.#offers;
  }

  objectsOf(robot: RobotName) {
    return (this.#offers, this.memory.objectsOf(robot));
  }

  /** Whether the page shows this robot as it is now. */
  liveness(): Liveness {
    const { memory, info, connectionState } = this;
    const paused = simulationOf(memory)?.paused === true;
    return livenessOf(
      { connected: connectionState.state === "open", known: info !== undefined, arrived: memory.arrivedAt, paused },
      now(),
    );
  }

  // the played recording

  /** Whether the recording is playing; reactive. */
  get runs(): boolean {
    return (void this.#told, this.played?.runs === true);
  }
  /** Whether the recording is at its end. */
  get ended(): boolean {
    return (void this.#told, this.played?.status === "ended");
  }
  /** 1 is real time; the last reported speed. */
  get speed(): number {
    return (void this.#told, this.played?.speed ?? 1);
  }

  /** As speed, or that of a pending wish. */
  get wantedSpeed(): number {
    return this.#wishes.pending?.speed ?? this.speed;
  }

  /** The playhead, or the place of a pending wish. */
  place(): bigint {
    return this.#wishes.pending?.seek_ns ?? this.played?.at(now()) ?? 0n;
  }

  /** Whether a wish is pending. */
  get asked(): boolean {
    return this.#wishes.pending !== undefined;
  }
  /** Whether it plays, or a pending wish asks it to. */
  get goes(): boolean {
    return this.#wishes.pending?.play ?? this.runs;
  }

  /** Sends a wish. The shown moment stays until the answer arrives. */
  ask(wish: PlaybackWish): void {
    this.#left_ns = this.memory.moment_ns;
    this.#wishes.ask(wish, now());
  }

  /** Asks for a playhead of its own, which goes on from the shared one, or for the shared one. */
  choose(own: boolean): void {
    if (this.offersOwn && own !== this.own) this.client.choosePlayhead(own);
  }

  /** Whether it plays a recording and finds its messages by time. */
  get findsFrames(): boolean {
    return this.played !== undefined && this.serviceNames.includes(kStepService);
  }

  /**
   * Returns the capture time of the message of `topic` that is `by` messages after `from_ns`, or before it if negative.
   * At an end of the recording it is that of the last message. Rejects with a sentence.
   */
  async frameBeside(topic: string, from_ns: bigint, by: number): Promise<bigint> {
    const { at_ns } = await this.client.call(kStepService, { topic, from_ns: String(from_ns), by });
    if (typeof at_ns !== "string" || !/^\d{1,20}$/.test(at_ns))
      throw new Error("The server did not name the time of the frame.");
    return BigInt(at_ns);
  }

  /**
   * Returns the capture time nearest to `at_ns` of the messages of `topics`, or undefined without one: in the whole
   * recording, else among the messages that the page holds.
   */
  async nearestTo(topics: string[], at_ns: bigint): Promise<bigint | undefined> {
    if (!this.findsFrames) return nearestKept(this.memory, topics, at_ns);
    const beside: (bigint | undefined)[] = [];
    for (let i = 0; i < topics.length; i += kTopicsAtOnce) {
      const some = topics.slice(i, i + kTopicsAtOnce);
      const asked = some.flatMap((topic) =>
        [-1, 1].map((by) => this.frameBeside(topic, at_ns, by).catch(() => undefined)),
      );
      beside.push(...(await Promise.all(asked)));
    }
    // at an end of a stream the answer is the moment itself
    const others = beside.filter((time_ns) => time_ns !== at_ns);
    return nearestOf(others, at_ns) ?? nearestKept(this.memory, topics, at_ns);
  }

  /** Pauses at `at_ns`: at once if the page holds the moment, else by a wish. */
  stand(at_ns: bigint): void {
    if (this.memory.holds(at_ns)) this.memory.show(at_ns);
    else if (this.#refused) this.speaker.follow(this);
    else this.ask({ play: false, speed: this.wantedSpeed, seek_ns: at_ns });
  }

  /** Called before each drawing. */
  frame(): void {
    const time = now();
    this.memory.reached(time);
    if (this.info && !this.toldAll && time - this.#introduced_s > kIntroduction) this.toldAll = true;
    // the present comes first; its parameters tell whether a game is in progress
    const hasShown = time - this.#introduced_s > kFirstScreen;
    if (this.toldAll && hasShown && this.parameterValues.size > 0) this.#recalls?.begin();
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

  /** Makes the server seek the shown moment too. The page stores fewer images, and no object that was opened later. */
  #settle(time: number): void {
    const at_ns = this.played && this.memory.moment_ns;
    if (at_ns !== this.#settling.at_ns) this.#settling = { at_ns, since: time };
    if (at_ns === undefined || time - this.#settling.since < kSettled || this.asked || this.#refused) return;
    this.#wishes.ask({ play: false, speed: this.wantedSpeed, seek_ns: at_ns }, time);
  }

  /** Calls a service and shows a failure as an alert. Returns true on success. */
  async do(service: string, request: object): Promise<boolean> {
    try {
      await this.client.call(service, request);
      this.removeStatus([`service ${service}`]);
      return true;
    } catch (error) {
      this.status("error", (error as Error).message, `service ${service}`, causeOf(error));
      return false;
    }
  }

  /** Pauses its simulated game, and returns it to an earlier tick. Rejects with the service's sentence. */
  async standAt(tick: number): Promise<void> {
    const ahead = Number((await this.client.call("/sim/pause", {}))["tick"]) - tick;
    if (ahead > 0) await this.client.call("/sim/back", { ticks: ahead });
  }

  /** Whether it plays another session than the one of a link. */
  playsAnother(session: string): boolean {
    return session !== "" && this.session !== "" && session !== this.session;
  }

  /** Makes it play another session, for all its viewers. Returns false, with an alert, if it cannot. */
  async watch(session: string): Promise<boolean> {
    return this.session === session || (await this.do(kWatchService, { session }));
  }

  /** The server's own statistics of its streams, by topic. Empty before the first `runtime` object. */
  statistics(): Map<string, StreamStatistics> {
    return allStreamStatistics(runtimesOf([...this.memory.objects()]));
  }

  /** Whether the robot has ever written a stream, by its own count: "unknown" at the beginning. */
  hasWritten(topic: string): "yes" | "no" | "unknown" {
    const [runtime] = runtimesOf([...this.memory.objects()]);
    const written = this.statistics().get(topic)?.sequence ?? 0;
    const waited = now() - this.#introduced_s > kCounting;
    if (!runtime) return waited ? "yes" : "unknown";
    if (written > 0) return "yes";
    return waited || (processStatistics(runtime)?.uptime ?? 0) > kCounting ? "no" : "unknown";
  }

  recording(): RecordingStatistics | undefined {
    const [runtime] = runtimesOf([...this.memory.objects()]);
    return runtime && recordingStatistics(runtime);
  }

  // events of the client

  connection(connection: Connection): void {
    if (connection.state === "waiting") this.#leave();
    this.connectionState = connection;
    if (connection.state === "open") this.lost = "";
    if (connection.state !== "waiting") return;
    if (this.lost === "") void this.#lookForRefusal();
    this.lost = connection.why;
  }
  /** Remembers the state of the playhead, which ends with its connection, so that the next one goes on from there. */
  #leave(): void {
    const { played } = this;
    if (this.connectionState.state !== "open" || !this.own || !played?.known) return;
    const { start_ns, end_ns } = played;
    const at_ns = this.memory.moment_ns ?? this.place();
    this.#left = { play: this.goes, speed: this.wantedSpeed, at_ns, start_ns, end_ns, session: this.session };
    this.#wishes.clear(); // nobody answers them
    played.told({ status: "paused", time_ns: at_ns, speed: this.#left.speed }, now());
    ++this.#told;
  }
  /** Keeps the state of the playhead for this tab, because the page ends. */
  keepPlayhead(): void {
    this.#leave();
    keep("sessionStorage", `playhead ${this.target.host}`, this.#left && this.own ? textOfLeft(this.#left) : "");
  }
  /** Asks by HTTP whether the connection was refused for want of a token, because a browser does not say it. */
  async #lookForRefusal(): Promise<void> {
    if (!this.target.ownHost) return;
    const answer = await fetch("/api/status", { signal: AbortSignal.timeout(5000) }).catch(() => undefined);
    if (answer?.status === 401) this.wantsToken = true;
  }
  /** Learns from the cause of a refusal that the token is missing or wrong. */
  refusedBecause(cause: string): void {
    if (cause === "token") this.wantsToken = true;
  }
  introduced(info: ServerInfo, fresh: boolean, restarted: boolean): void {
    this.info = info;
    if (restarted) return this.#beginAgain();
    this.#opens = true;
    const left = this.#left;
    const isSame = left?.start_ns === info.span?.start_ns && left?.end_ns === info.span?.end_ns;
    if (!isSame || left?.session !== this.session) this.#left = undefined;
    if (!fresh) return;
    this.toldAll = false;
    this.#introduced_s = now();
    this.memory.reset();
    this.#wishes.clear();
    this.#refused = false;
    this.memory.played = this.played =
      info.capabilities.includes("playbackControl") && info.span
        ? new Played(info.span.start_ns, info.span.end_ns)
        : undefined;
    this.#recalls?.stop();
    this.#recalls = this.#recallsFrom(info.metadata["recent"]);
    this.speaker.dismiss([...this.#alertKeys]);
    this.parameterValues = new Map();
    ++this.#offers;
    this.#summaries = undefined;
    this.#runs.clear();
    this.learnsEvents = false;
    if (this.summarises) void this.#learnEvents();
  }
  /** Whether the server may be asked about the whole of its recording: the page reaches its HTTP interface. */
  get summarises(): boolean {
    return this.played !== undefined && this.target.ownHost;
  }
  /** Summaries of numbers of the whole recording, if the server makes them. */
  get summaries(): Summaries | undefined {
    const { played } = this;
    if (!played || !this.summarises) return undefined;
    return (this.#summaries ??= new Summaries({ from_ns: played.start_ns, to_ns: played.end_ns }, async (...question) =>
      (await import("../source/whole")).fetchNumbers(...question),
    ));
  }
  /** Returns the runs of some fields of `topic` in the whole recording, if the server finds them. */
  runsOf(topic: string, fields: string[]): WholeRuns | undefined {
    if (!this.summarises) return undefined;
    const key = [topic, ...fields].join(" ");
    let runs = this.#runs.get(key);
    if (!runs) {
      runs = new WholeRuns(async () => (await import("../source/whole")).fetchRuns(topic, fields));
      this.#runs.set(key, runs);
    }
    return runs;
  }
  /** Learns all events of the recording. Without them the page knows those that it has seen. */
  async #learnEvents(): Promise<void> {
    const { played } = this;
    this.learnsEvents = true;
    try {
      const events = knownEvents(await (await import("../source/whole")).fetchEvents());
      if (this.played !== played) return;
      this.memory.events.know(events);
      ++this.#told;
    } catch {
      // an older server: its events become known while they are played
    } finally {
      if (this.played === played) this.learnsEvents = false;
    }
  }
  /** Whether earlier messages are on their way from the server's memory. */
  get recalls(): boolean {
    return this.#recalls?.busy === true;
  }
  #recallsFrom(path = ""): Recalls | undefined {
    if (!this.target.ownHost || !/^\/api\/\w+$/.test(path)) return undefined;
    return new Recalls(
      // during a game other machines are refused
      (topics) => (this.parameterValues.get("match_mode") === true ? undefined : fetchRecent(path, topics)),
      ({ topic, messages }) => this.memory.recall(topic, messages, now()),
      (sentence) => this.status("info", sentence, "recent"),
    );
  }
  #beginAgain(): void {
    const { played, memory } = this;
    if (!played) return memory.restart();
    played.heard(played.start_ns, now());
    memory.sought(played.start_ns);
    this.#sought = now();
  }
  playhead(own: boolean): void {
    this.own = own;
    if (!own) this.#left = undefined;
  }
  playback(state: PlaybackState): void {
    const { played, memory } = this;
    if (!played) return;
    const time = now();
    this.#wishes.answered(state.request, time);
    const isOurs = state.request !== ""; // also if late
    if (isOurs) this.#refused = false;
    played.told(state, time);
    if (state.didSeek) {
      memory.sought(state.time_ns);
      this.#sought = time;
    }
    ++this.#told;
    const shown_ns = memory.moment_ns;
    if (shown_ns !== undefined && (shown_ns === state.time_ns || shown_ns === this.#left_ns || !memory.holds(shown_ns)))
      memory.show(undefined);
    if (!isOurs && !this.own) this.speaker.follow(this);
    if (this.own && this.#opens) {
      const left = this.#left;
      this.#left = undefined;
      this.speaker.opened(this, left);
    }
    this.#opens = false;
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
    const object = this.memory.get(topic);
    if (is && object && !object.derived && !object.isImage) this.#recalls?.want(topic);
  }
  message(topic: string, log_ns: bigint, data: Uint8Array): void {
    this.memory.arrived(topic, log_ns, data, now());
  }
  time(now_ns: bigint): void {
    this.memory.clock.heard(now_ns, now());
    this.played?.heard(now_ns, now());
  }
  status(level: Level, message: string, id: string = message, cause = ""): void {
    this.refusedBecause(cause);
    const key = `${this.target.host} ${id}`;
    this.#alertKeys.add(key);
    this.speaker.say(level, this.speaker.several ? `${this.target.host}: ${message}` : message, key);
  }
  removeStatus(ids: string[]): void {
    this.speaker.dismiss(ids.map((id) => `${this.target.host} ${id}`));
  }
  parameters(values: { name: string; value: unknown }[]): void {
    this.parameterValues = new Map([
      ...this.parameterValues,
      ...values.map(({ name, value }) => [name, value] as const),
    ]);
  }
  services(names: string[]): void {
    this.serviceNames = names;
    if (names.length > 0) this.toldAll = true;
    if (names.includes("clock_sync")) this.#clock.start();
    else this.#clock.stop();
  }
}
