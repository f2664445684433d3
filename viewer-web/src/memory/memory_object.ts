// One memory object of a robot as the page receives it: its newest value and its rate.

import type { Channel } from "../source/texts";
import { decoderOf, type Decoded, type Decoder } from "./decoder";
import { History, type Entry } from "./history";
import { Rate } from "./rate";
import type { RobotObject, RobotObjects } from "./schema";
import type { Fields, Unknown } from "./value";

/** `""` for objects without a robot, such as /truth/world and the lab server's own. */
export type RobotName = string;

/** Returns the robot in the channel's metadata, else team and player from the topic: "14/2" in "/14/2/ball". */
export function robotOf(channel: Pick<Channel, "topic" | "metadata">): RobotName {
  const name = channel.metadata["robot"] || /^\/(\d+\/\d+)\//.exec(channel.topic)?.[1] || "";
  return name.includes("/") ? name : "";
}

/** Returns the topic without its robot: "ball", "camera_top/jpeg", "truth/world". */
export function objectOf(channel: Pick<Channel, "topic" | "metadata">): string {
  const prefix = `/${robotOf(channel)}/`;
  return channel.topic.startsWith(prefix) ? channel.topic.slice(prefix.length) : channel.topic.replace(/^\//, "");
}

/** Reports whether an object is one of ours by its last name: "runtime" of /14/2/runtime and of /lab/1/runtime. */
export const isKind = <Name extends RobotObject>(
  object: MemoryObject,
  name: Name,
): object is MemoryObject<RobotObjects[Name]> => object.kind === name;

/** Reports whether a topic is that of one of our objects, of any robot: "/14/2/ball". */
export const isTopicOf = (topic: string, name: RobotObject): boolean => topic.endsWith(`/${name}`);

/** Returns the topic of one of our objects of a robot: "/14/2/ball". */
export const topicOfRobot = (robot: RobotName, name: RobotObject): string => `/${robot}/${name}`;

/** Returns the shown fields of an object, or none without an object or a message that can be decoded. */
export const valueOf = <M>(object: MemoryObject<M> | undefined): Fields<M> => object?.decoded()?.fields ?? new Map();

/** The moment that all objects of a server show: a capture time, or undefined for now. */
export interface Moment {
  ns: bigint | undefined;
  /** True while the recording or the simulated game is paused: no message is due. */
  still?: boolean;
}

/** A message of the history, decoded. */
export type Near<M = Unknown> = Pick<Entry, "log_ns" | "arrived"> & Decoded<M>;

/** `M`: the type of its messages, if it is one of ours. */
export class MemoryObject<M = Unknown> {
  readonly robot: RobotName;
  readonly name: string;
  /** The object's last name: "runtime" of /14/2/runtime and of /lab/1/runtime. */
  readonly kind: string;
  /** The server computes it from another object, only while it is subscribed. */
  readonly derived: boolean;
  /** One image or point cloud per message: too large to subscribe to on its own. */
  readonly isImage: boolean;

  /** The newest message, not decoded. */
  newest: Entry | undefined;
  /** The recent messages, including the newest. */
  readonly history = new History();
  received = 0;
  readonly rate = new Rate();
  /** Whether messages are expected: the page is connected and subscribed. */
  subscribed = false;
  /** [ns] For a recording: the place where the subscription began. */
  since_ns = 0n;
  /** True after a seek, until a value from the new time arrives. */
  outdated = false;

  #decoder: Decoder | undefined; // created on first use: most schemas are never needed
  #decoded: { entry: Entry; value: Decoded<M> } | undefined;
  #near: Near<M> | undefined;
  // the last result of the search in the history
  #shown: { ns: bigint; end: number; generation: number; entry: Entry | undefined } | undefined;

  constructor(
    readonly channel: Channel,
    readonly moment: Moment = { ns: undefined },
  ) {
    this.robot = robotOf(channel);
    this.name = objectOf(channel);
    this.kind = this.name.slice(this.name.lastIndexOf("/") + 1);
    this.derived = channel.metadata["derived"] === "true";
    this.isImage = /(^|\.)((Raw|Compressed)?Image|PointCloud)$/.test(channel.schemaName);
  }

  arrived(log_ns: bigint, data: Uint8Array, now: number): void {
    this.newest = { log_ns, data, arrived: now };
    ++this.received;
    this.outdated = false;
    this.rate.arrived(now);
  }

  /** Drops a value that is not of the present time. The history keeps it. */
  dropNewest(): void {
    this.newest = undefined;
    this.outdated = false;
  }

  /** The message that views show: the newest, or the newest at the chosen moment. */
  get shown(): Entry | undefined {
    const { ns } = this.moment;
    if (ns === undefined) return this.newest;
    const { end, generation } = this.history;
    if (this.#shown?.ns !== ns || this.#shown.end !== end || this.#shown.generation !== generation) {
      const entry = this.history.at(ns);
      // the same message stays the same object, so that it is decoded and drawn once
      const same = entry && entry.log_ns === this.#shown?.entry?.log_ns && entry.arrived === this.#shown.entry.arrived;
      this.#shown = { ns, end, generation, entry: same ? this.#shown!.entry : entry };
    }
    return this.#shown.entry;
  }

  /** Decodes the shown message, once and on demand. Undefined if there is none. */
  decoded(): Decoded<M> | undefined {
    const entry = this.shown;
    if (!entry) return undefined;
    if (this.#decoded?.entry !== entry) this.#decoded = { entry, value: this.decode(entry.data) };
    return this.#decoded.value;
  }

  /** Finds the message captured nearest to `log_ns`, at most `most_ns` away. The last one stays decoded. */
  near(log_ns: bigint, most_ns: bigint): Near<M> | undefined {
    const entry = this.history.near(log_ns, most_ns);
    if (!entry) return undefined;
    const isSame = this.#near?.log_ns === entry.log_ns && this.#near.arrived === entry.arrived;
    if (!isSame) this.#near = { log_ns: entry.log_ns, arrived: entry.arrived, ...this.decode(entry.data) };
    return this.#near;
  }

  /** Decodes any message of the object. */
  decode(data: Uint8Array): Decoded<M> {
    this.#decoder ??= decoderOf(this.channel);
    return this.#decoder(data) as Decoded<M>;
  }

  /** [Hz] now, or at the chosen moment. */
  hz(now: number): number {
    return this.moment.ns === undefined ? this.rate.hz(now) : this.history.hzAt(this.moment.ns);
  }

  /** [s] for which a due message is missing. Undefined while all is well; events are never due. */
  overdue(now: number): number | undefined {
    const isEvent = this.channel.metadata["delivery"] === "reliable";
    return this.subscribed && !isEvent && !this.moment.still && this.rate.overdue(now)
      ? this.rate.silence(now)
      : undefined;
  }
}
