// The one time that all views show: now, a moment of the last minutes, or any moment of a played recording. It is
// capture time of the reference: the first server that sends data. The others show the same moment by their own clocks.
// The states and their transitions are in time_state.ts, time_moves.ts and time_frame.ts.

import type { GameEvent } from "../memory/game_events";
import { ClockShifts, type Clocked } from "./clock_shifts";
import { earliest, latest } from "./earliest";
import { now } from "./frame.svelte";
import { beatOf, FrameSteps } from "./frame_steps";
import type { Left } from "./left";
import type { Server } from "./server.svelte";
import { ask, release, show, type Shown } from "./time_effects";
import { frame, obeyAddress } from "./time_frame";
import {
  followServer,
  goToNow,
  hold,
  pause,
  play,
  repeat,
  seek,
  setEdge,
  setLoop,
  setSpeed,
  toggle,
} from "./time_moves";
import {
  atOf,
  isLive,
  moves,
  opening,
  runs,
  type Change,
  type Effect,
  type Facts,
  type Phase,
  type TimeRange,
  type TimeState,
} from "./time_state";

export type { TimeRange } from "./time_state";

/** 1 is real time, negative is backwards. */
export const kSpeeds = [-20, -10, -5, -2, -1, -0.5, -0.1, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

export const seconds = (duration_ns: bigint): number => Number(duration_ns) / 1e9;
const nanoseconds = (duration: number): bigint => BigInt(Math.round(duration * 1e9));

/** The part of the viewer that time uses. */
interface Watched {
  readonly servers: Server[];
  readonly server: Server;
  readonly robot: string;
  /** Whether the page follows the shared playback of a recording. */
  readonly follows: boolean;
  get(setting: string): string;
  set(setting: string, value: string): void;
  say(level: "info", text: string, key: string): void;
}

export class Time {
  #state: TimeState;
  // the parts that components react to; they read the moment while drawing, because it changes with each frame
  #phase = $state<Phase["is"]>("live");
  #speed = $state(1);
  #loop = $state.raw<TimeRange>();
  #frame = now();
  readonly #shifts = new ClockShifts();
  readonly #steps: FrameSteps;

  constructor(readonly viewer: Watched) {
    // a page that follows must not move the others
    this.#state = opening(viewer.follows ? "" : viewer.get("at"), viewer.get("loop"));
    this.#loop = this.#state.loop;
    this.#steps = this.#stepsOf(viewer);
  }

  get reference(): Server {
    const { servers } = this.viewer;
    return servers.find(({ memory }) => memory.range()) ?? servers[0]!;
  }

  /** Whether the timeline is a recording's. */
  get recorded(): boolean {
    return this.reference.played !== undefined;
  }

  /** Whether all pages that follow share the playhead of the recording. */
  get shared(): boolean {
    return this.recorded && !this.reference.own;
  }

  /** Capture times from the oldest kept value to now, or of a whole recording. Undefined without data. */
  range(): TimeRange | undefined {
    return this.reference.memory.range();
  }

  get #facts(): Facts {
    const { reference } = this;
    const { played } = reference;
    return {
      now: now(),
      get range() {
        return reference.memory.range(); // looks at all objects: only if it is needed
      },
      recorded: played !== undefined,
      known: played?.known === true,
      plays: reference.runs,
      place_ns: played ? reference.place() : 0n,
      speed: played ? reference.wantedSpeed : 1,
      pending: reference.asked,
    };
  }

  /** The shown moment. */
  get at_ns(): bigint {
    return atOf(this.#state, this.#facts);
  }

  /** Whether new data are shown as they arrive: of a robot the newest, of a recording the server's playhead. */
  get live(): boolean {
    return this.#phase === "live" || this.#phase === "early";
  }

  /** Whether new data are shown as they arrive and more are expected. */
  get moves(): boolean {
    void this.#phase;
    return moves(this.#state, this.#facts);
  }

  /** Whether time advances, in either way. */
  get runs(): boolean {
    void this.#phase;
    return runs(this.#state, this.#facts);
  }

  /** Whether now is shown and nothing lies after it. */
  get atNow(): boolean {
    return this.live && !this.recorded;
  }

  /** The repeated range. */
  get loop(): TimeRange | undefined {
    return this.#loop;
  }

  /** 1 is real time, negative is backwards. For a recording the server's speed. */
  get speed(): number {
    return this.recorded && this.#speed > 0 ? this.reference.speed : this.#speed;
  }
  set speed(speed: number) {
    this.#do(setSpeed(this.#state, this.#facts, speed));
  }

  /** [ns] to add to the reference's time to get this server's. */
  shiftOf(server: Clocked): bigint {
    return this.#shifts.of(server, this.reference, isLive(this.#state), now());
  }

  // transitions

  /** Called before each drawing. */
  frame(): void {
    const time = now();
    const passed = time - this.#frame;
    this.#frame = time;
    for (const server of this.viewer.servers) server.frame();
    const { recalls } = this.reference;
    const playsAnother = this.reference.playsAnother(this.viewer.get("session"));
    this.#do(obeyAddress(this.#state, { ...this.#facts, recalls, playsAnother }));
    this.#steps.make();
    const [steps, addressAt] = [this.#steps.underWay, this.viewer.get("at")];
    this.#do(frame(this.#state, { ...this.#facts, passed, steps, addressAt }));
  }

  /** Goes to now, or to a recording's end. */
  now(): void {
    this.#do(goToNow(this.#state, this.#facts));
  }

  /** Whether the page will show the moment of its link as soon as the server has it. */
  get awaited(): boolean {
    return this.#state.asked_ns !== undefined;
  }

  /** Shows a recording where its server plays it; another viewer may have moved it. */
  follow(server: Server): void {
    if (server === this.reference) this.#do(followServer(this.#state));
  }

  /**
   * A connection has a new playhead of its own, which is paused. It goes on as the lost one was `left`. A page that opens
   * plays, unless a person has paused it already or a link asks for a moment, and at the speed that a person has chosen.
   */
  opened(server: Server, left: Left | undefined): void {
    const { phase, asked_ns, speed: chosen } = this.#state;
    if (asked_ns !== undefined && !server.playsAnother(this.viewer.get("session"))) return; // it shows this moment
    if (left ? !left.play : phase.is !== "live") return;
    server.ask({ play: true, speed: left?.speed ?? (chosen > 0 && chosen !== 1 ? chosen : server.speed) });
  }

  /** Before the first data: pauses as soon as they arrive. */
  pause(): void {
    this.#do(pause(this.#state, this.#facts));
  }

  play(): void {
    this.#do(play(this.#state, this.#facts));
  }

  toggle(): void {
    this.#do(toggle(this.#state, this.#facts));
  }

  /** Ends an advance by the page's clock. */
  hold(): void {
    this.#commit(hold(this.#state));
  }

  /** Chooses the next faster or slower speed. */
  pace(by: 1 | -1): void {
    const next =
      by > 0
        ? kSpeeds.find((speed) => speed > this.speed * 1.001)
        : kSpeeds.findLast((speed) => speed < this.speed * 0.999);
    if (next !== undefined) this.speed = next;
  }

  /** Goes to a moment, or to the nearest kept one. */
  seek(at_ns: bigint): void {
    this.#steps.end();
    this.#do(seek(this.#state, this.#facts, at_ns));
  }

  skip(duration: number): void {
    this.seek(this.at_ns + nanoseconds(duration));
    this.hold();
  }

  begin(): void {
    const range = this.range();
    if (range) this.seek(range.first_ns);
  }

  /** Goes to the next or previous frame of the most even object of the chosen robot or its world. */
  step(by: 1 | -1): void {
    if (!this.#steps.underWay) this.pause();
    this.#steps.add(by);
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
    this.jumpAmong(by, [...this.events().map(({ log_ns }) => log_ns), ...others]);
  }

  /** Goes to the next or previous of these moments [ns], which have any order. */
  jumpAmong(by: 1 | -1, moments: bigint[]): void {
    const at_ns = this.at_ns;
    const range = this.range();
    const inside = moments.filter((moment) => range && moment >= range.first_ns && moment <= range.last_ns);
    const next =
      by > 0 ? earliest(inside.filter((moment) => moment > at_ns)) : latest(inside.filter((moment) => moment < at_ns));
    if (next !== undefined) this.seek(next);
    this.hold();
  }

  // the repeated range

  /** Repeats the range between two moments, in either order. An empty range ends the loop. */
  repeat(one_ns: bigint, other_ns: bigint): void {
    this.#steps.end();
    this.#do(repeat(this.#state, this.#facts, one_ns, other_ns));
  }

  /** Like repeat(), but does not change how time advances. */
  setLoop(one_ns: bigint, other_ns: bigint): void {
    this.#commit(setLoop(this.#state, one_ns, other_ns));
  }

  /** Sets the loop's begin or end to the shown moment. */
  edge(which: "begin" | "end"): void {
    this.#commit(setEdge(this.#state, this.#facts, which));
  }

  endLoop(): void {
    this.#commit({ ...this.#state, loop: undefined });
  }

  // the state and the effects

  #do({ state, effects }: Change): void {
    this.#commit(state);
    for (const effect of effects) this.#carryOut(effect);
  }

  #commit(state: TimeState): void {
    const { viewer } = this;
    // the offsets of the clocks hold from the moment on at which the page leaves the live time
    if (isLive(this.#state) && !isLive(state)) this.#shifts.keep(viewer.servers, this.reference, now());
    const { loop } = state;
    const changesLoop = loop !== this.#state.loop;
    this.#state = state;
    this.#phase = state.phase.is;
    this.#speed = state.speed;
    this.#loop = loop;
    if (changesLoop) viewer.set("loop", loop ? `${loop.first_ns}-${loop.last_ns}` : "");
  }

  #carryOut(effect: Effect): void {
    const { viewer } = this;
    switch (effect.do) {
      case "ask":
        this.#steps.end();
        return ask(this.#shown, effect);
      case "show":
        return show(this.#shown, this.at_ns);
      case "release":
        return release(this.#shown);
      case "note":
        if (this.#state.asked_ns === undefined) viewer.set("at", effect.at);
        return;
      case "say":
        viewer.say("info", effect.text, "asked moment");
    }
  }

  get #shown(): Shown {
    return { servers: this.viewer.servers, shiftOf: (server) => this.shiftOf(server) };
  }

  #stepsOf(viewer: Watched): FrameSteps {
    const shift = () => this.shiftOf(viewer.server);
    const isLiveNow = () => isLive(this.#state);
    return new FrameSteps({
      get waits() {
        return isLiveNow() && viewer.server.asked;
      },
      get finds() {
        return viewer.server.findsFrames;
      },
      beat: () => beatOf(viewer.server.memory.objectsOf(viewer.robot)),
      find: (object, from_ns, by) => viewer.server.frameBeside(object.channel.topic, from_ns, by),
      holds: (at_ns) => !viewer.server.played || viewer.server.memory.holds(at_ns),
      at_ns: () => this.at_ns + shift(),
      go: (at_ns) => this.#do(seek(this.#state, this.#facts, at_ns - shift())),
      warn: (sentence) => viewer.server.status("warning", sentence, "step"),
    });
  }
}
