// All memory objects of one server by topic, with newest value and past.

import type { Channel } from "../source/texts";
import type { Entry } from "./history";
import { GameEvents } from "./game_events";
import { LogHistory } from "./log_history";
import { isKind, MemoryObject, topicOfRobot, type Moment, type RobotName } from "./memory_object";
import { Past } from "./past";
import type { Played } from "./played";
import type { DecisionTrace, LogText, RobotObject, RobotObjects, WorldObject, WorldObjects } from "./schema";
import { ServerClock } from "./server_clock";
import { simulationOf } from "./simulation";

export class Memory {
  readonly clock = new ServerClock();
  readonly log = new LogHistory();
  readonly events = new GameEvents();
  /** Only for a server that plays a recording; set by the connection's owner. */
  played: Played | undefined;
  #objects = new Map<string, MemoryObject>();
  #moment: Moment = { ns: undefined };
  #arrived: number | undefined;
  #leastLag: number | undefined; // [s] between capture and arrival, of the fastest message
  #seen = { from_ns: 0n, to_ns: 0n }; // for a recording: the page has received all of this part, without a gap

  constructor(readonly past = new Past()) {}

  /** The capture time that all objects show, or undefined for the newest of each. */
  get moment_ns(): bigint | undefined {
    return this.#moment.ns;
  }

  /** Whether no message is due, because the recording or the simulated game is paused. */
  get still(): boolean {
    return this.#moment.still === true || this.#moment.ns !== undefined;
  }

  /** [s] Arrival of the newest message of a robot or its world. The server's reports on itself do not count. */
  get arrivedAt(): number | undefined {
    return this.#arrived;
  }

  /** Shows the moment `log_ns` in all objects, or the newest of each if undefined. */
  show(log_ns: bigint | undefined): void {
    const returns = log_ns === undefined && this.#moment.ns !== undefined && !this.played;
    this.#moment.ns = log_ns;
    // time has gone back meanwhile: the past that was looked at does not belong to the new messages
    if (returns)
      for (const { history, newest } of this.#objects.values())
        if (newest && history.goesBack(newest.log_ns)) history.clear();
  }

  /**
   * Handles a server time that went back, by a seek or a restarted recording. Another past begins, unless one is being
   * looked at.
   */
  restart(): void {
    this.clock.clear();
    if (this.#moment.ns !== undefined) return;
    for (const { history } of this.#objects.values()) history.clear();
    this.#leastLag = undefined;
    this.events.clear();
  }

  /**
   * Handles a seek: playback continues at `at_ns`, and the newest message of each object from before it comes next.
   * The old values stay until then, so that nothing flickers. dropOutdated() drops the values of objects that have none
   * at that time.
   */
  sought(at_ns: bigint): void {
    const { from_ns, to_ns } = this.#seen;
    const leavesGap = at_ns < from_ns || at_ns > to_ns;
    if (leavesGap) this.#seen = { from_ns: at_ns, to_ns: at_ns };
    for (const object of this.#objects.values()) {
      if (leavesGap) object.history.clear();
      object.outdated = object.newest !== undefined;
    }
    this.events.sought();
    this.log.sought(at_ns);
  }

  /** Drops the values of the objects that have none at the time of the last seek. One that comes late is shown again. */
  dropOutdated(): void {
    for (const object of this.#objects.values()) if (object.outdated) object.dropNewest();
  }

  /** Notes that playback has reached `now`. */
  reached(now: number): void {
    const at_ns = this.played?.at(now) ?? 0n;
    if (at_ns > this.#seen.to_ns) this.#seen.to_ns = at_ns;
    this.#moment.still = this.played ? !this.played.runs : simulationOf(this)?.paused === true;
  }

  /** The part of a recording whose histories are complete, or undefined if there is none. */
  seen(): { from_ns: bigint; to_ns: bigint } | undefined {
    if (!this.played) return undefined;
    let from_ns = this.#seen.from_ns;
    for (const { subscribed, since_ns, history } of this.#objects.values()) {
      if (!subscribed) continue;
      if (since_ns > from_ns) from_ns = since_ns;
      if (history.given_up_ns !== undefined && history.given_up_ns > from_ns) from_ns = history.given_up_ns;
    }
    return { from_ns, to_ns: this.#seen.to_ns };
  }

  holds(at_ns: bigint): boolean {
    const seen = this.seen();
    return seen !== undefined && at_ns >= seen.from_ns && at_ns <= seen.to_ns;
  }

  /** Forgets everything, because another run of the server begins. */
  reset(): void {
    for (const topic of [...this.#objects.keys()]) this.withdraw(topic);
    this.#arrived = undefined;
    this.#leastLag = undefined;
    this.clock.clear();
    this.log.clear();
    this.events.clear();
    this.#seen = { from_ns: 0n, to_ns: 0n };
  }

  /**
   * Adds a channel. A known one with the same schema keeps its past and counts: only the connection was lost, not the
   * run.
   */
  offer(channel: Channel): void {
    const known = this.#objects.get(channel.topic)?.channel;
    if (known && known.schema === channel.schema && known.schemaName === channel.schemaName) return;
    this.withdraw(channel.topic);
    this.#objects.set(channel.topic, new MemoryObject(channel, this.#moment));
  }

  withdraw(topic: string): void {
    const object = this.#objects.get(topic);
    if (object) this.past.forget(object.history);
    this.#objects.delete(topic);
  }

  /** Notes the begin or end of a subscription. Messages from before a pause are not counted in the rate after it. */
  subscribed(topic: string, is: boolean, now = 0): void {
    const object = this.#objects.get(topic);
    if (!object) return;
    object.subscribed = is;
    object.rate.clear();
    if (!this.played || !is) return;
    // nothing later of this object is known
    object.since_ns = this.#seen.to_ns = this.played.at(now);
  }

  arrived(topic: string, log_ns: bigint, data: Uint8Array, now: number): void {
    const object = this.#objects.get(topic);
    if (!object) return;
    object.arrived(log_ns, data, now);
    this.#leastLag = Math.min(this.#leastLag ?? Infinity, lagOf(object.newest!));
    if (!kOwnKinds.includes(object.kind)) this.#arrived = now;
    this.#keep(object);
    if (isLog(object)) this.log.arrived(object, object.newest!);
    this.events.arrived(object, object.newest!);
  }

  /**
   * Stores the earlier messages of an object that a live server remembers, in order of capture time. They take the place
   * of all that the page has of this time.
   */
  recall(topic: string, messages: readonly { log_ns: bigint; data: Uint8Array }[], now: number): void {
    const object = this.#objects.get(topic);
    const newest_ns = messages.at(-1)?.log_ns;
    if (!object || newest_ns === undefined) return;
    const lag = this.#leastLag ?? now - Number(newest_ns) / 1e9;
    const entries = messages.map(({ log_ns, data }) => ({ log_ns, data, arrived: Number(log_ns) / 1e9 + lag }));
    this.past.recall(object.history, entries);
    if (isLog(object)) this.log.recall(object, entries);
    this.events.recall(object, entries);
  }

  /** Stores the newest message. A restarted recording must not remove the past that a person looks at. */
  #keep(object: MemoryObject): void {
    const { history, newest } = object;
    // a repeated message, or the last one before the place of a seek
    if (this.played && history.last_ns !== undefined && newest!.log_ns <= history.last_ns) return;
    if (this.#moment.ns !== undefined && history.goesBack(newest!.log_ns)) return;
    this.past.keep(history, newest!, object.isImage);
  }

  get(topic: string): MemoryObject | undefined {
    return this.#objects.get(topic);
  }

  /** Returns one of our objects of a robot. */
  of<Name extends RobotObject>(robot: RobotName, name: Name): MemoryObject<RobotObjects[Name]> | undefined {
    return this.get(topicOfRobot(robot, name)) as MemoryObject<RobotObjects[Name]> | undefined;
  }

  /** Returns the decisions of another tree, which foresight-lab redecide writes beside the recorded ones. */
  redecisionsOf(robot: RobotName): MemoryObject<DecisionTrace> | undefined {
    return this.get(`/${robot}/redecision`) as MemoryObject<DecisionTrace> | undefined;
  }

  /** Returns one of our objects that belong to no robot. */
  world<Topic extends WorldObject>(topic: Topic): MemoryObject<WorldObjects[Topic]> | undefined {
    return this.get(topic) as MemoryObject<WorldObjects[Topic]> | undefined;
  }

  /** [s] since the shown value of `object` was captured. Undefined without a value or without the server's time. */
  age(object: MemoryObject, now: number): number | undefined {
    return object.shown && this.ageOf(object.shown.log_ns, now);
  }

  /** [s] from `capture_ns` to the shown moment. */
  ageOf(capture_ns: bigint, now: number): number | undefined {
    const at_ns = this.#moment.ns;
    const shown_ns = at_ns ?? this.played?.at(now);
    return shown_ns === undefined ? this.clock.age(capture_ns, now) : Math.max(0, Number(shown_ns - capture_ns) / 1e9);
  }

  objects(): Iterable<MemoryObject> {
    return this.#objects.values();
  }

  /**
   * Capture times of the oldest kept value and of the newest known moment. Retained values do not count: the newest ones
   * from before the page came. For a recording: its whole span.
   */
  range(): { first_ns: bigint; last_ns: bigint } | undefined {
    if (this.played) return { first_ns: this.played.start_ns, last_ns: this.played.end_ns };
    let [first, last]: [bigint | undefined, bigint | undefined] = [undefined, this.clock.last_ns];
    const isRetained = (entry: Entry) => lagOf(entry) > this.#leastLag! + kRetained;
    for (const { history } of this.#objects.values()) {
      const { last_ns } = history;
      const first_ns = history.movesSince(isRetained);
      if (first_ns !== undefined && (first === undefined || first_ns < first)) first = first_ns;
      if (last_ns !== undefined && (last === undefined || last_ns > last)) last = last_ns;
    }
    return first === undefined || last === undefined ? undefined : { first_ns: first, last_ns: last };
  }

  /** All robots that offer an object, sorted by team and player; the team of the robot `own` is first. */
  robots(own: RobotName = ""): RobotName[] {
    const names = new Set([...this.#objects.values()].map(({ robot }) => robot).filter((robot) => robot !== ""));
    const [team] = own.split("/");
    const other = (name: RobotName) => Number(name.split("/")[0] !== team);
    return [...names].sort((a, b) => other(a) - other(b) || a.localeCompare(b, "en", { numeric: true }));
  }

  /** The robot's own objects by name, then those without a robot. */
  objectsOf(robot: RobotName): MemoryObject[] {
    return [...this.#objects.values()]
      .filter((object) => object.robot === robot || object.robot === "")
      .sort((a, b) => Number(a.robot === "") - Number(b.robot === "") || a.name.localeCompare(b.name, "en"));
  }
}

const kRetained = 1; // [s] a value that comes so much later than others was retained by the server

const lagOf = ({ log_ns, arrived }: Entry): number => arrived - Number(log_ns) / 1e9;

/** Objects in which a server reports on itself, also while its robot is silent. */
const kOwnKinds: readonly string[] = ["runtime", "log", "clock"] satisfies RobotObject[];

const isLog = (object: MemoryObject): object is MemoryObject<LogText> => isKind(object, "log") && !object.derived;
