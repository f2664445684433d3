// The one time that all views show: now, or a moment of the last minutes, or any moment of a recording that a server
// plays. Counted in capture time of the reference, the first server that tells any; the others are shown at the same
// moment by their own clocks.

import type { GameEvent } from "../memory/game_events";
import type { MemoryObject } from "../memory/memory_object";
import { now } from "./frame.svelte";
import type { Server } from "./server.svelte";

/** 1 is real time, negative is backwards. */
export const kSpeeds = [-20, -10, -5, -2, -1, -0.5, -0.1, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

/** Clocks that agree so well are taken as one: over wireless we measure no better than the robots themselves do. */
const kAgree_ns = 250_000_000n;
const kLeastLoop_ns = 20_000_000n; // less is a click, not a range

export const seconds = (duration_ns: bigint): number => Number(duration_ns) / 1e9;
const nanoseconds = (duration: number): bigint => BigInt(Math.round(duration * 1e9));
const abs = (value: bigint): bigint => (value < 0n ? -value : value);

export interface TimeRange {
  first_ns: bigint;
  last_ns: bigint;
}

/** From one message of an object to its next one, or its last one, of which nothing is here. */
interface Step {
  object: MemoryObject;
  from_ns: bigint;
  by: 1 | -1;
  /** Some message after it; the next one unless another one lies between. */
  later_ns?: bigint;
}

/** What time needs of the viewer. */
interface Watched {
  readonly servers: Server[];
  readonly server: Server;
  readonly robot: string;
  get(setting: string): string;
  set(setting: string, value: string): void;
  say(level: "info", text: string, key: string): void;
}

export class Time {
  /** What comes is shown as it comes: the newest of a robot, or a recording wherever its server plays it. */
  live = $state(true);
  /** Time goes on from the moment looked at, by our own clock. */
  playing = $state(false);
  /** Played over and over. */
  loop = $state.raw<TimeRange>();
  #speed = $state(1);
  #early = $state(false); // paused before there was anything to stand at
  #at_ns = 0n;
  #frame = now();
  #shifts = new Map<Server, bigint>(); // [ns] how far ahead of the reference each clock was when the page stopped following
  #asked_ns: bigint | undefined; // by the address, until it is there
  #noted = 0; // [s] when the address was set last
  #stepping: Step | undefined; // by the server: what is looked for is to come
  #steps = 0; // to be done when that has come

  constructor(readonly viewer: Watched) {
    const asked = viewer.get("at");
    if (/^\d{1,19}$/.test(asked)) this.#asked_ns = BigInt(asked);
    const [first, last] = viewer.get("loop").split("-");
    if (/^\d{1,19}$/.test(first ?? "") && /^\d{1,19}$/.test(last ?? "")) this.loop = { first_ns: BigInt(first!), last_ns: BigInt(last!) };
  }

  get reference(): Server {
    const { servers } = this.viewer;
    return servers.find(({ memory }) => memory.range()) ?? servers[0]!;
  }

  /** Whether the timeline is that of a recording, which servers play and everybody who watches them shares. */
  get recorded(): boolean {
    return this.reference.played !== undefined;
  }

  /** Capture times from the oldest value that is kept to now, or those of a whole recording; undefined before anything came. */
  range(): TimeRange | undefined {
    return this.reference.memory.range();
  }

  /** Something has come, and where a recording is, is known. */
  get #isThere(): boolean {
    return this.range() !== undefined && (!this.recorded || this.reference.played!.known);
  }

  /** The moment that is shown. */
  get at_ns(): bigint {
    if (!this.live) return this.#at_ns;
    return this.recorded ? this.reference.place() : (this.range()?.last_ns ?? 0n);
  }

  /** What comes is shown, and more is coming: nobody looks at one moment. */
  get moves(): boolean {
    return this.live && (!this.recorded || this.reference.runs);
  }

  /** Time goes on, however. */
  get runs(): boolean {
    return (this.moves || this.playing) && !this.#early;
  }

  /** Now is shown, and nothing lies beyond it. */
  get atNow(): boolean {
    return this.live && !this.recorded;
  }

  /** 1 is real time, negative is backwards; of a recording as its server has it. */
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
    const [own, other] = [reference, server].map(({ memory, played }) => (played ? played.at(now()) : memory.clock.now_ns(now())));
    if (own === undefined || other === undefined) return 0n;
    return abs(other - own) < kAgree_ns ? 0n : other - own;
  }

  /** Before each drawing. */
  frame(): void {
    const time = now();
    const passed = time - this.#frame;
    this.#frame = time;
    for (const server of this.viewer.servers) server.frame();
    this.#obeyAddress();
    this.#finishStep();
    const range = this.range();
    if (!range) return this.live ? undefined : this.now();
    if (this.#early && this.#isThere) this.pause();
    if (this.playing) this.#advance(nanoseconds(passed * this.#speed), range);
    else if (this.moves) this.#repeat();
    // what was looked at may have been given up since
    if (!this.live && this.#at_ns < range.first_ns) this.#at_ns = range.first_ns;
    if (!this.live) this.#show();
    if (!this.runs && !this.#early && !this.#stepping && (!this.live || this.recorded) && time - this.#noted > 0.3) this.#note(String(this.at_ns));
    else if (this.moves && this.viewer.get("at") && this.recorded) this.#note("");
  }

  #advance(by_ns: bigint, { first_ns, last_ns }: TimeRange): void {
    this.#at_ns += by_ns;
    const loop = this.loop;
    if (loop && (this.#at_ns >= loop.last_ns || this.#at_ns < loop.first_ns)) this.#at_ns = by_ns < 0n ? loop.last_ns - 1n : loop.first_ns;
    if (this.#at_ns >= last_ns && !this.recorded) return this.now();
    if (this.#at_ns > first_ns) return;
    this.#at_ns = first_ns;
    this.playing = false;
  }

  /** Back to the beginning of the loop, when what comes has reached its end. */
  #repeat(): void {
    const { loop, reference, at_ns } = this;
    if (!loop || reference.asked || (at_ns < loop.last_ns && at_ns >= loop.first_ns)) return;
    if (this.recorded) return this.#ask(true, loop.first_ns);
    this.seek(loop.first_ns);
    this.playing = true;
  }

  /** To now; of a recording: to its end. */
  now(): void {
    const range = this.range();
    if (this.recorded && range) return this.seek(range.last_ns);
    this.live = true;
    this.playing = false;
    this.#setLoop(undefined);
    for (const { memory } of this.viewer.servers) memory.show(undefined);
    this.#note("");
  }

  /** A recording is shown as its server plays it, which somebody else may have moved. */
  follow(server: Server): void {
    if (server !== this.reference || this.live) return;
    this.live = true;
    this.playing = false;
    for (const { memory } of this.viewer.servers) memory.show(undefined);
  }

  /** Before anything came: as soon as something does. */
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

  /** The next faster or slower pace. */
  pace(by: 1 | -1): void {
    const next = by > 0 ? kSpeeds.find((speed) => speed > this.speed * 1.001) : kSpeeds.findLast((speed) => speed < this.speed * 0.999);
    if (next !== undefined) this.speed = next;
  }

  /** Looks at a moment and stands there; where none is kept, at the nearest one. */
  seek(at_ns: bigint): void {
    const range = this.range();
    if (!range) return;
    this.#begin();
    this.#asked_ns = this.#stepping = undefined;
    this.#at_ns = at_ns < range.first_ns ? range.first_ns : at_ns > range.last_ns ? range.last_ns : at_ns;
    this.#show();
  }

  /** From now on the moment is ours. */
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

  /** To the next or last frame of what the chosen robot, or its world, tells most evenly. */
  step(by: 1 | -1): void {
    const { server } = this.viewer;
    if (!this.#stepping) this.pause();
    const object = this.#beat(server);
    if (!object) return;
    if (this.#stepping || (server.played && (server.asked || object.outdated))) {
      this.#steps += by;
      return;
    }
    const { history, shown } = object;
    const [shift_ns, at_ns] = [this.shiftOf(server), this.at_ns + this.shiftOf(server)];
    const index = history.indexAt(at_ns);
    const onIt = history.timeOf(index) === at_ns;
    const next_ns = history.timeOf(by > 0 ? index + 1 : onIt ? index - 1 : index);
    if (next_ns !== undefined && (!server.played || server.memory.holds(next_ns))) return this.seek(next_ns - shift_ns);
    if (!server.played || !shown || (by > 0 && at_ns >= server.played.end_ns)) return;
    // not here, but the server has it: just before this one was the last one, and the next comes when it goes on
    if (by < 0 && shown.log_ns < at_ns) return this.seek(shown.log_ns - shift_ns);
    if (by < 0) this.seek(shown.log_ns - 1n - shift_ns);
    else this.#ask(true, this.live ? undefined : this.#at_ns);
    this.#stepping = { object, from_ns: shown.log_ns, by };
  }

  #finishStep(): void {
    const { server } = this.viewer;
    const step = this.#stepping;
    if (step && !server.asked && !step.object.outdated) this.#look(step, server);
    if (this.#stepping || this.#steps === 0 || server.asked) return;
    const by = this.#steps > 0 ? 1 : -1;
    this.#steps -= by;
    this.step(by);
  }

  /** Who plays on leaves messages out where a page cannot keep up: the last one before what came is asked for until it is known. */
  #look(step: Step, server: Server): void {
    const newest_ns = step.object.newest?.log_ns;
    if (newest_ns === undefined) return;
    const shift_ns = this.shiftOf(server);
    if (step.by < 0) {
      if (newest_ns !== step.from_ns) this.seek(newest_ns - shift_ns);
    } else if (newest_ns <= step.from_ns) {
      if (step.later_ns !== undefined) this.seek(step.later_ns - shift_ns);
      else if (server.ended) this.#stepping = undefined;
    } else {
      this.#ask(false, newest_ns - 1n - shift_ns);
      this.#stepping = { ...step, later_ns: newest_ns };
    }
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

  /** To the next event, or the one before; `others` are moments [ns] that count as such. */
  jump(by: 1 | -1, others: bigint[]): void {
    const moments = [...this.events().map(({ log_ns }) => log_ns), ...others];
    this.jumpAmong(by, moments.sort((a, b) => (a < b ? -1 : 1)));
  }

  /** To the next of these moments [ns], which are in order, or the one before. */
  jumpAmong(by: 1 | -1, moments: bigint[]): void {
    const at_ns = this.at_ns;
    const range = this.range();
    const within = moments.filter((moment) => range && moment >= range.first_ns && moment <= range.last_ns);
    const next = by > 0 ? within.find((moment) => moment > at_ns) : within.findLast((moment) => moment < at_ns);
    if (next !== undefined) this.seek(next);
    this.playing = false;
  }

  // a range that is played over and over

  /** Plays from one moment to another, in whatever order, again and again; a range of no length ends that. */
  repeat(one_ns: bigint, other_ns: bigint): void {
    this.setLoop(one_ns, other_ns);
    if (!this.loop) return;
    if (this.#speed < 0) this.#speed = 1;
    this.seek(this.loop.first_ns);
    this.play();
  }

  /** As repeat(), but time goes on as it did. */
  setLoop(one_ns: bigint, other_ns: bigint): void {
    const [first_ns, last_ns] = one_ns < other_ns ? [one_ns, other_ns] : [other_ns, one_ns];
    this.#setLoop(last_ns - first_ns < kLeastLoop_ns ? undefined : { first_ns, last_ns });
  }

  /** The loop begins, or ends, at the moment shown. */
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

  /** Where it stands already, or goes, it need not be asked again. */
  #stand(server: Server, at_ns: bigint): void {
    const { moment_ns } = server.memory;
    if (moment_ns === at_ns) return;
    const goesThere = server.place() === at_ns && !server.goes && (moment_ns === undefined || server.asked);
    if (!goesThere) server.stand(at_ns);
  }

  /** Asks all servers that play recordings; from then on they are followed. */
  #ask(play: boolean, seek_ns?: bigint): void {
    this.live = true;
    this.playing = false;
    this.#stepping = undefined;
    const speed = this.#speed > 0 ? this.#speed : this.reference.speed;
    for (const server of this.viewer.servers) {
      if (server.played) server.ask({ play, speed, seek_ns: seek_ns === undefined ? undefined : server.played.within(seek_ns + this.shiftOf(server)) });
      else server.memory.show(undefined);
    }
  }

  /** What gives the frames: the picture, else the world, else what the robot decides or believes. */
  #beat(server: Server): MemoryObject | undefined {
    const objects = server.memory.objectsOf(this.viewer.robot).filter(({ newest }) => newest);
    const wanted = [({ isImage }: MemoryObject) => isImage, ...["truth/world", "decision", "pose", "joints"].map((name) => (object: MemoryObject) => object.name === name)];
    for (const is of wanted) {
      const found = objects.find(is);
      if (found) return found;
    }
    return objects.sort((a, b) => b.history.end - b.history.begin - (a.history.end - a.history.begin))[0];
  }

  /** A link names a moment: it is shown when it is there; what is gone for good is said. */
  #obeyAddress(): void {
    const asked_ns = this.#asked_ns;
    const range = asked_ns === undefined ? undefined : this.range();
    if (asked_ns === undefined || !range || !this.#isThere || (range.last_ns < asked_ns && !this.recorded)) return;
    this.#asked_ns = undefined;
    if (asked_ns >= range.first_ns && asked_ns <= range.last_ns) return this.seek(asked_ns);
    this.viewer.set("at", "");
    const why = this.recorded ? "The moment of this link is not within this recording." : "The moment of this link is older than what this page has seen; a recording on the robot may hold it.";
    this.viewer.say("info", why, "asked moment");
  }

  #note(at: string): void {
    this.#noted = now();
    if (this.#asked_ns === undefined) this.viewer.set("at", at);
  }
}

/** [ns] between recordings of one game none, as their clocks agree; else what puts their beginnings side by side. */
function shiftBetween(one: { start_ns: bigint; end_ns: bigint }, other: { start_ns: bigint; end_ns: bigint }): bigint {
  const overlap = one.start_ns <= other.end_ns && other.start_ns <= one.end_ns;
  return overlap ? 0n : other.start_ns - one.start_ns;
}
