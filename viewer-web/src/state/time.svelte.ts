// The one time that all views show: now, a moment of the last minutes, or any moment of a played recording. It is
// capture time of the reference: the first server that sends data. The others show the same moment by their own clocks.

import type { GameEvent } from "../memory/game_events";
import type { MemoryObject } from "../memory/memory_object";
import type { RobotObject } from "../memory/schema";
import { now } from "./frame.svelte";
import type { Server } from "./server.svelte";

/** 1 is real time, negative is backwards. */
export const kSpeeds = [-20, -10, -5, -2, -1, -0.5, -0.1, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

/** Clocks that differ by less count as equal. Over wireless, the page measures no better than the robots do. */
const kAgree_ns = 250_000_000n;
const kLongestStep = 100; // frames that the server finds at once
const kLeastLoop_ns = 20_000_000n; // a shorter one is a click, not a range

export const seconds = (duration_ns: bigint): number => Number(duration_ns) / 1e9;
const nanoseconds = (duration: number): bigint => BigInt(Math.round(duration * 1e9));
const abs = (value: bigint): bigint => (value < 0n ? -value : value);

export interface TimeRange {
  first_ns: bigint;
  last_ns: bigint;
}

/** The part of the viewer that time uses. */
interface Watched {
  readonly servers: Server[];
  readonly server: Server;
  readonly robot: string;
  get(setting: string): string;
  set(setting: string, value: string): void;
  say(level: "info", text: string, key: string): void;
}

export class Time {
  /** New data are shown as they arrive: of a robot the newest, of a recording the server's playhead. */
  live = $state(true);
  /** Time advances from the chosen moment by the page's clock. */
  playing = $state(false);
  /** The repeated range. */
  loop = $state.raw<TimeRange>();
  #speed = $state(1);
  #early = $state(false); // paused before the first data
  #at_ns = 0n;
  #frame = now();
  #shifts = new Map<Server, bigint>(); // [ns] offset of each clock to the reference when the page stopped following
  #asked_ns: bigint | undefined; // requested by the address, until it is shown
  #noted = 0; // [s] time of the last change of the address
  #steps = 0; // frames to go, negative backwards
  #search: object | undefined; // the server's search for the frame of some of these steps

  constructor(readonly viewer: Watched) {
    const asked = viewer.get("at");
    if (/^\d{1,19}$/.test(asked)) this.#asked_ns = BigInt(asked);
    const [first, last] = viewer.get("loop").split("-");
    if (/^\d{1,19}$/.test(first ?? "") && /^\d{1,19}$/.test(last ?? ""))
      this.loop = { first_ns: BigInt(first!), last_ns: BigInt(last!) };
  }

  get reference(): Server {
    const { servers } = this.viewer;
    return servers.find(({ memory }) => memory.range()) ?? servers[0]!;
  }

  /** Whether the timeline is a recording's, which all its viewers share. */
  get recorded(): boolean {
    return this.reference.played !== undefined;
  }

  /** Capture times from the oldest kept value to now, or of a whole recording. Undefined without data. */
  range(): TimeRange | undefined {
    return this.reference.memory.range();
  }

  /** Whether there are data and the playhead of a recording is known. */
  get #isThere(): boolean {
    return this.range() !== undefined && (!this.recorded || this.reference.played!.known);
  }

  /** The shown moment. */
  get at_ns(): bigint {
    if (!this.live) return this.#at_ns;
    return this.recorded ? this.reference.place() : (this.range()?.last_ns ?? 0n);
  }

  /** Whether new data are shown as they arrive and more are expected. */
  get moves(): boolean {
    return this.live && (!this.recorded || this.reference.runs);
  }

  /** Whether time advances, in either way. */
  get runs(): boolean {
    return (this.moves || this.playing) && !this.#early;
  }

  /** Whether now is shown and nothing lies after it. */
  get atNow(): boolean {
    return this.live && !this.recorded;
  }

  /** 1 is real time, negative is backwards. For a recording the server's speed. */
  get speed(): number {
    return this.recorded && this.#speed > 0 ? this.reference.speed : this.#speed;
  }
  set speed(speed: number) {
    this.#speed = speed;
    if (!this.recorded) return;
    if (speed < 0 && this.runs) this.play();
    else if (speed > 0) this.#ask(this.runs, this.live ? undefined : this.#at_ns);
  }

  /** [ns] to add to the reference's time to get this server's. */
  shiftOf(server: Server): bigint {
    const { reference } = this;
    if (server === reference) return 0n;
    if (reference.played && server.played) return shiftBetween(reference.played, server.played);
    if (!this.live) return this.#shifts.get(server) ?? 0n;
    const [own, other] = [reference, server].map(({ memory, played }) =>
      played ? played.at(now()) : memory.clock.now_ns(now()),
    );
    if (own === undefined || other === undefined) return 0n;
    return abs(other - own) < kAgree_ns ? 0n : other - own;
  }

  /** Called before each drawing. */
  frame(): void {
    const time = now();
    const passed = time - this.#frame;
    this.#frame = time;
    for (const server of this.viewer.servers) server.frame();
    this.#obeyAddress();
    this.#makeSteps();
    const range = this.range();
    if (!range) return this.live ? undefined : this.now();
    if (this.#early && this.#isThere) this.pause();
    if (this.playing) this.#advance(nanoseconds(passed * this.#speed), range);
    else if (this.moves) this.#repeat();
    // the shown moment may have been dropped from memory
    if (!this.live && this.#at_ns < range.first_ns) this.#at_ns = range.first_ns;
    if (!this.live) this.#show();
    if (!this.runs && !this.#early && this.#steps === 0 && (!this.live || this.recorded) && time - this.#noted > 0.3)
      this.#note(String(this.at_ns));
    else if (this.moves && this.viewer.get("at") && this.recorded) this.#note("");
  }

  #advance(by_ns: bigint, { first_ns, last_ns }: TimeRange): void {
    this.#at_ns += by_ns;
    const loop = this.loop;
    if (loop && (this.#at_ns >= loop.last_ns || this.#at_ns < loop.first_ns))
      this.#at_ns = by_ns < 0n ? loop.last_ns - 1n : loop.first_ns;
    if (this.#at_ns >= last_ns && !this.recorded) return this.now();
    if (this.#at_ns > first_ns) return;
    this.#at_ns = first_ns;
    this.playing = false;
  }

  /** Returns to the loop's begin when its end is reached. */
  #repeat(): void {
    const { loop, reference, at_ns } = this;
    if (!loop || reference.asked || (at_ns < loop.last_ns && at_ns >= loop.first_ns)) return;
    if (this.recorded) return this.#ask(true, loop.first_ns);
    this.seek(loop.first_ns);
    this.playing = true;
  }

  /** Goes to now, or to a recording's end. */
  now(): void {
    const range = this.range();
    if (this.recorded && range) return this.seek(range.last_ns);
    this.live = true;
    this.playing = false;
    this.#setLoop(undefined);
    for (const { memory } of this.viewer.servers) memory.show(undefined);
    this.#note("");
  }

  /** Shows a recording where its server plays it; another viewer may have moved it. */
  follow(server: Server): void {
    if (server !== this.reference || this.live) return;
    this.live = true;
    this.playing = false;
    for (const { memory } of this.viewer.servers) memory.show(undefined);
  }

  /** Before the first data: pauses as soon as they arrive. */
  pause(): void {
    this.#early = !this.#isThere;
    if (this.#early) return;
    this.playing = false;
    if (this.recorded) {
      if (this.moves) this.#ask(false);
    } else if (this.live) this.seek(this.at_ns);
  }

  play(): void {
    this.#early = false;
    if (!this.range()) return;
    if (!this.recorded || this.#speed < 0) {
      this.pause();
      this.#begin();
      this.playing = true;
      return;
    }
    this.playing = false;
    this.#ask(true, this.live ? undefined : this.#at_ns);
  }

  toggle(): void {
    if (this.runs) this.pause();
    else this.play();
  }

  /** Chooses the next faster or slower speed. */
  pace(by: 1 | -1): void {
    const next =
      by > 0
        ? kSpeeds.find((speed) => speed > this.speed * 1.001)
        : kSpeeds.findLast((speed) => speed < this.speed * 0.999);
    if (next !== undefined) this.speed = next;
  }

  /** Pauses at a moment, or at the nearest kept one. */
  seek(at_ns: bigint): void {
    const range = this.range();
    if (!range) return;
    this.#begin();
    this.#asked_ns = undefined;
    this.#endSteps();
    this.#at_ns = at_ns < range.first_ns ? range.first_ns : at_ns > range.last_ns ? range.last_ns : at_ns;
    this.#show();
  }

  /** Stops following the newest data. */
  #begin(): void {
    if (!this.live) return;
    this.#shifts = new Map(this.viewer.servers.map((server) => [server, this.shiftOf(server)]));
    this.#at_ns = this.at_ns;
    this.live = false;
  }

  skip(duration: number): void {
    this.seek(this.at_ns + nanoseconds(duration));
    this.playing = false;
  }

  begin(): void {
    const range = this.range();
    if (range) this.seek(range.first_ns);
  }

  /** Goes to the next or previous frame of the most even object of the chosen robot or its world. */
  step(by: 1 | -1): void {
    if (this.#steps === 0) this.pause();
    this.#steps += by;
    this.#makeSteps();
  }

  #endSteps(): void {
    this.#steps = 0;
    this.#search = undefined;
  }

  #makeSteps(): void {
    const { server } = this.viewer;
    // a server that is about to pause has not reported the place yet
    if (this.#steps === 0 || this.#search || (this.live && server.asked)) return;
    const object = this.#beat(server);
    if (!object) return this.#endSteps();
    if (server.findsFrames) void this.#searchFrame(server, object);
    else this.#stepInHistory(server, object);
  }

  /**
   * Asks the server of a recording for the frame, because the page misses messages: those of places that it has not
   * shown, and any while it is slow. Steps that are made meanwhile come next.
   */
  async #searchFrame(server: Server, object: MemoryObject): Promise<void> {
    const search = (this.#search = {});
    const [shift_ns, by] = [this.shiftOf(server), Math.max(-kLongestStep, Math.min(this.#steps, kLongestStep))];
    try {
      const frame_ns = await server.frameBeside(object.channel.topic, this.at_ns + shift_ns, by);
      if (this.#search !== search) return;
      const left = this.#steps - by;
      this.seek(frame_ns - shift_ns);
      this.#steps = left;
    } catch (error) {
      if (this.#search !== search) return;
      if (!this.#stepInHistory(server, object)) server.status("warning", (error as Error).message, "step");
    }
  }

  /** Makes all steps among the messages that the page holds. Returns false if it does not hold them. */
  #stepInHistory(server: Server, { history }: MemoryObject): boolean {
    const [steps, shift_ns] = [this.#steps, this.shiftOf(server)];
    this.#endSteps();
    const at_ns = this.at_ns + shift_ns;
    const index = history.indexAt(at_ns);
    const isBetween = history.timeOf(index) !== at_ns;
    const frame_ns = history.timeOf(index + steps + (isBetween && steps < 0 ? 1 : 0));
    if (frame_ns === undefined || (server.played && !server.memory.holds(frame_ns))) return false;
    this.seek(frame_ns - shift_ns);
    return true;
  }

  /** All events of all servers, in the reference's time, oldest first. */
  events(): GameEvent[] {
    const { servers } = this.viewer;
    const all = servers.flatMap((server) => {
      const shift_ns = this.shiftOf(server);
      const events = server.memory.events.all();
      return shift_ns === 0n ? events : events.map((event) => ({ ...event, log_ns: event.log_ns - shift_ns }));
    });
    return servers.length === 1 ? all : all.sort((a, b) => Number(a.log_ns - b.log_ns));
  }

  /** Goes to the next or previous event. `others` are more moments [ns]. */
  jump(by: 1 | -1, others: bigint[]): void {
    const moments = [...this.events().map(({ log_ns }) => log_ns), ...others];
    this.jumpAmong(
      by,
      moments.sort((a, b) => (a < b ? -1 : 1)),
    );
  }

  /** Goes to the next or previous of these sorted moments [ns]. */
  jumpAmong(by: 1 | -1, moments: bigint[]): void {
    const at_ns = this.at_ns;
    const range = this.range();
    const within = moments.filter((moment) => range && moment >= range.first_ns && moment <= range.last_ns);
    const next = by > 0 ? within.find((moment) => moment > at_ns) : within.findLast((moment) => moment < at_ns);
    if (next !== undefined) this.seek(next);
    this.playing = false;
  }

  // the repeated range

  /** Repeats the range between two moments, in either order. An empty range ends the loop. */
  repeat(one_ns: bigint, other_ns: bigint): void {
    this.setLoop(one_ns, other_ns);
    if (!this.loop) return;
    if (this.#speed < 0) this.#speed = 1;
    this.seek(this.loop.first_ns);
    this.play();
  }

  /** Like repeat(), but does not change how time advances. */
  setLoop(one_ns: bigint, other_ns: bigint): void {
    const [first_ns, last_ns] = one_ns < other_ns ? [one_ns, other_ns] : [other_ns, one_ns];
    this.#setLoop(last_ns - first_ns < kLeastLoop_ns ? undefined : { first_ns, last_ns });
  }

  /** Sets the loop's begin or end to the shown moment. */
  edge(which: "begin" | "end"): void {
    const range = this.range();
    if (!range) return;
    const at_ns = this.at_ns;
    const { first_ns, last_ns } = this.loop ?? range;
    if (which === "begin") this.#setLoop({ first_ns: at_ns, last_ns: last_ns > at_ns ? last_ns : range.last_ns });
    else this.#setLoop({ first_ns: first_ns < at_ns ? first_ns : range.first_ns, last_ns: at_ns });
  }

  endLoop(): void {
    this.#setLoop(undefined);
  }

  #setLoop(loop: TimeRange | undefined): void {
    this.loop = loop;
    this.viewer.set("loop", loop ? `${loop.first_ns}-${loop.last_ns}` : "");
  }

  #show(): void {
    for (const server of this.viewer.servers) {
      const at_ns = this.#at_ns + this.shiftOf(server);
      if (!server.played) server.memory.show(at_ns);
      else this.#stand(server, server.played.within(at_ns));
    }
  }

  /** Pauses the server at `at_ns`, unless it is there or under way. */
  #stand(server: Server, at_ns: bigint): void {
    const { moment_ns } = server.memory;
    if (moment_ns === at_ns) return;
    const goesThere = server.place() === at_ns && !server.goes && (moment_ns === undefined || server.asked);
    if (!goesThere) server.stand(at_ns);
  }

  /** Sends a wish to all servers that play recordings, and follows them from then on. */
  #ask(play: boolean, seek_ns?: bigint): void {
    this.live = true;
    this.playing = false;
    this.#endSteps();
    const speed = this.#speed > 0 ? this.#speed : this.reference.speed;
    for (const server of this.viewer.servers) {
      if (server.played)
        server.ask({
          play,
          speed,
          seek_ns: seek_ns === undefined ? undefined : server.played.within(seek_ns + this.shiftOf(server)),
        });
      else server.memory.show(undefined);
    }
  }

  /** The object that defines frames: the image, else the world, else the decision or a belief. */
  #beat(server: Server): MemoryObject | undefined {
    const objects = server.memory.objectsOf(this.viewer.robot).filter(({ received }) => received > 0);
    const wanted = [
      ({ isImage }: MemoryObject) => isImage,
      ...["truth/world", ...(["decision", "pose", "joints"] satisfies RobotObject[])].map(
        (name) => (object: MemoryObject) => object.name === name,
      ),
    ];
    for (const is of wanted) {
      const found = objects.find(is);
      if (found) return found;
    }
    return objects.sort((a, b) => b.history.end - b.history.begin - (a.history.end - a.history.begin))[0];
  }

  /** Shows the moment of a link as soon as it is available, or reports that it is gone. */
  #obeyAddress(): void {
    const asked_ns = this.#asked_ns;
    if (this.reference.playsAnother(this.viewer.get("session"))) return; // a person may watch that one
    const range = asked_ns === undefined ? undefined : this.range();
    if (asked_ns === undefined || !range || !this.#isThere || (range.last_ns < asked_ns && !this.recorded)) return;
    if (asked_ns < range.first_ns && this.reference.recalls) return;
    this.#asked_ns = undefined;
    if (asked_ns >= range.first_ns && asked_ns <= range.last_ns) return this.seek(asked_ns);
    this.viewer.set("at", "");
    const why = this.recorded
      ? "The moment of this link is not within this recording."
      : "The moment of this link is older than the data of this page; a recording on the robot may hold it.";
    this.viewer.say("info", why, "asked moment");
  }

  #note(at: string): void {
    this.#noted = now();
    if (this.#asked_ns === undefined) this.viewer.set("at", at);
  }
}

/** [ns] 0 between recordings of one game, whose clocks agree; otherwise the shift that aligns their begins. */
function shiftBetween(one: { start_ns: bigint; end_ns: bigint }, other: { start_ns: bigint; end_ns: bigint }): bigint {
  const overlap = one.start_ns <= other.end_ns && other.start_ns <= one.end_ns;
  return overlap ? 0n : other.start_ns - one.start_ns;
}
