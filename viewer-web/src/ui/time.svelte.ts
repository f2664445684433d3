// The one time that all views show: now, or a moment of the last minutes. Counted in capture time of the reference, the
// first server that tells any; the others are shown at the same moment by their own clocks.

import type { GameEvent } from "../memory/game_events";
import type { MemoryObject } from "../memory/memory_object";
import { now } from "./frame.svelte";
import type { Server } from "./server.svelte";

export const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10];

/** Clocks that agree so well are taken as one: over wireless we measure no better than the robots themselves do. */
const kAgree_ns = 250_000_000n;

export const seconds = (duration_ns: bigint): number => Number(duration_ns) / 1e9;
const nanoseconds = (duration: number): bigint => BigInt(Math.round(duration * 1e9));
const abs = (value: bigint): bigint => (value < 0n ? -value : value);

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
  /** The newest is shown, as it comes. */
  live = $state(true);
  /** Time goes on from the moment looked at. */
  playing = $state(false);
  speed = $state(1);
  #at_ns = 0n;
  #frame = now();
  #shifts = new Map<Server, bigint>(); // [ns] how far ahead of the reference each clock was when the page stopped following
  #asked_ns: bigint | undefined; // by the address, until it is there
  #noted = 0; // [s] when the address was set last

  constructor(readonly viewer: Watched) {
    const asked = viewer.get("at");
    if (/^\d{1,19}$/.test(asked)) this.#asked_ns = BigInt(asked);
  }

  get reference(): Server {
    const { servers } = this.viewer;
    return servers.find(({ memory }) => memory.range()) ?? servers[0]!;
  }

  /** Capture times from the oldest value that is kept to now; undefined before anything came. */
  range(): { first_ns: bigint; last_ns: bigint } | undefined {
    return this.reference.memory.range();
  }

  /** The moment that is shown. */
  get at_ns(): bigint {
    return this.live ? (this.range()?.last_ns ?? 0n) : this.#at_ns;
  }

  /** [ns] to add to the reference's time to get this server's. */
  shiftOf(server: Server): bigint {
    const { reference } = this;
    if (server === reference) return 0n;
    if (!this.live) return this.#shifts.get(server) ?? 0n;
    const [own, other] = [reference, server].map(({ memory }) => memory.clock.now_ns(now()));
    if (own === undefined || other === undefined) return 0n;
    return abs(other - own) < kAgree_ns ? 0n : other - own;
  }

  /** Before each drawing. */
  frame(): void {
    const time = now();
    const passed = time - this.#frame;
    this.#frame = time;
    this.#obeyAddress();
    if (this.live) return;
    const range = this.range();
    if (!range) return this.now();
    if (this.playing) {
      this.#at_ns += nanoseconds(passed * this.speed);
      if (this.#at_ns >= range.last_ns) return this.now();
    }
    // what was looked at may have been given up since
    if (this.#at_ns < range.first_ns) this.#at_ns = range.first_ns;
    this.#show();
    if (!this.playing && time - this.#noted > 0.3) this.#note(String(this.#at_ns));
  }

  now(): void {
    this.live = true;
    this.playing = false;
    for (const { memory } of this.viewer.servers) memory.show(undefined);
    this.#note("");
  }

  pause(): void {
    if (this.live) this.seek(this.at_ns);
    this.playing = false;
  }

  toggle(): void {
    if (this.live || this.playing) this.pause();
    else this.playing = true;
  }

  /** Looks at a moment; where none is kept, at the nearest one. */
  seek(at_ns: bigint): void {
    const range = this.range();
    if (!range) return;
    if (this.live) this.#shifts = new Map(this.viewer.servers.map((server) => [server, this.shiftOf(server)]));
    this.live = false;
    this.#asked_ns = undefined;
    this.#at_ns = at_ns < range.first_ns ? range.first_ns : at_ns > range.last_ns ? range.last_ns : at_ns;
    this.#show();
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
    this.pause();
    const { server } = this.viewer;
    const history = this.#beat(server)?.history;
    if (!history) return;
    const [shift_ns, at_ns] = [this.shiftOf(server), this.#at_ns + this.shiftOf(server)];
    const index = history.indexAt(at_ns);
    const onIt = history.timeOf(index) === at_ns;
    const next_ns = history.timeOf(by > 0 ? index + 1 : onIt ? index - 1 : index);
    if (next_ns !== undefined) this.seek(next_ns - shift_ns);
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

  /** To the next event, or the one before. */
  jump(by: 1 | -1): void {
    const at_ns = this.at_ns;
    const range = this.range();
    const events = this.events().filter(({ log_ns }) => range && log_ns >= range.first_ns && log_ns <= range.last_ns);
    const next = by > 0 ? events.find(({ log_ns }) => log_ns > at_ns) : events.findLast(({ log_ns }) => log_ns < at_ns);
    if (next) this.seek(next.log_ns);
    this.playing = false;
  }

  #show(): void {
    for (const server of this.viewer.servers) server.memory.show(this.#at_ns + this.shiftOf(server));
  }

  /** What gives the frames: the picture, else the world, else what the robot decides or believes. */
  #beat(server: Server): MemoryObject | undefined {
    const objects = server.memory.objectsOf(this.viewer.robot).filter(({ history }) => history.end > history.begin);
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
    if (asked_ns === undefined || !range || range.last_ns < asked_ns) return;
    this.#asked_ns = undefined;
    if (asked_ns >= range.first_ns) return this.seek(asked_ns);
    this.viewer.set("at", "");
    this.viewer.say("info", "The moment of this link is older than what this page has seen; a recording on the robot may hold it.", "asked moment");
  }

  #note(at: string): void {
    this.#noted = now();
    if (this.#asked_ns === undefined) this.viewer.set("at", at);
  }
}
