// One memory object of a robot as it arrives here: its newest value and how it comes.

import type { Channel } from "../source/texts";
import { decoderOf, type Decoded, type Decoder } from "./decoder";
import { History, type Entry } from "./history";
import { Rate } from "./rate";

/** `""` for what belongs to no single robot, such as /truth/world and what the lab's server says of itself. */
export type RobotName = string;

/** What the channel's metadata says, else team and player, if the topic begins with them: "14/2" of "/14/2/ball". */
export function robotOf(channel: Pick<Channel, "topic" | "metadata">): RobotName {
  const name = channel.metadata["robot"] || /^\/(\d+\/\d+)\//.exec(channel.topic)?.[1] || "";
  return name.includes("/") ? name : "";
}

/** The topic without its robot: "ball", "camera_top/jpeg", "truth/world". */
export function objectOf(channel: Pick<Channel, "topic" | "metadata">): string {
  const prefix = `/${robotOf(channel)}/`;
  return channel.topic.startsWith(prefix) ? channel.topic.slice(prefix.length) : channel.topic.replace(/^\//, "");
}

/** Which moment is shown, of all objects of a server together: a capture time, undefined for now. */
export interface Moment {
  ns: bigint | undefined;
  /** The recording stands: nothing is to come. */
  still?: boolean;
}

export class MemoryObject {
  readonly robot: RobotName;
  readonly name: string;
  /** What kind of object it is: "runtime" of /14/2/runtime and of /lab/1/runtime. */
  readonly kind: string;
  /** Made by the server out of another object, only while somebody subscribes. */
  readonly derived: boolean;
  /** One image per message: too much to subscribe to unasked. */
  readonly isImage: boolean;

  /** The newest message, undecoded. */
  newest: Entry | undefined;
  /** What came lately, the newest included. */
  readonly history = new History();
  received = 0;
  readonly rate = new Rate();
  /** Whether messages are on their way: we are connected and subscribed. */
  subscribed = false;
  /** [ns] of a recording: the place where the subscription began. */
  since_ns = 0n;
  /** The newest value is of another time of the recording than the one that was sought. */
  outdated = false;

  #decoder: Decoder | undefined; // made at first use: most schemas are never looked at
  #decoded: { entry: Entry; value: Decoded } | undefined;
  #shown: { ns: bigint; end: number; entry: Entry | undefined } | undefined; // found last in the history

  constructor(
    readonly channel: Channel,
    readonly moment: Moment = { ns: undefined },
  ) {
    this.robot = robotOf(channel);
    this.name = objectOf(channel);
    this.kind = this.name.slice(this.name.lastIndexOf("/") + 1);
    this.derived = channel.metadata["derived"] === "true";
    this.isImage = /(^|\.)(Raw|Compressed)?Image$/.test(channel.schemaName);
  }

  arrived(log_ns: bigint, data: Uint8Array, now: number): void {
    this.newest = { log_ns, data, arrived: now };
    ++this.received;
    this.outdated = false;
    this.rate.arrived(now);
  }

  /** Nothing is known any more. */
  forget(): void {
    this.newest = undefined;
    this.outdated = false;
    this.history.clear();
  }

  /** What a view shows: the newest message, or the newest of the moment looked at. */
  get shown(): Entry | undefined {
    const { ns } = this.moment;
    if (ns === undefined) return this.newest;
    const { end } = this.history;
    if (this.#shown?.ns !== ns || this.#shown.end !== end) {
      const entry = this.history.at(ns);
      // the same message stays the same object, so that it is decoded and drawn once
      const same = entry && entry.log_ns === this.#shown?.entry?.log_ns && entry.arrived === this.#shown.entry.arrived;
      this.#shown = { ns, end, entry: same ? this.#shown!.entry : entry };
    }
    return this.#shown.entry;
  }

  /** The shown message decoded, once per message and only when asked; undefined where there is none. */
  decoded(): Decoded | undefined {
    const entry = this.shown;
    if (!entry) return undefined;
    if (this.#decoded?.entry !== entry) this.#decoded = { entry, value: this.decode(entry.data) };
    return this.#decoded.value;
  }

  /** Any of its messages decoded. */
  decode(data: Uint8Array): Decoded {
    this.#decoder ??= decoderOf(this.channel);
    return this.#decoder(data);
  }

  /** [Hz] now, or at the moment looked at. */
  hz(now: number): number {
    return this.moment.ns === undefined ? this.rate.hz(now) : this.history.hzAt(this.moment.ns);
  }

  /** [s] for how long nothing came of what should have; undefined while all is well. Events are never due. */
  overdue(now: number): number | undefined {
    const isEvent = this.channel.metadata["delivery"] === "reliable";
    return this.subscribed && !isEvent && !this.moment.still && this.rate.overdue(now) ? this.rate.silence(now) : undefined;
  }
}
