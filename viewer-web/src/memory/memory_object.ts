// One memory object of a robot as it arrives here: its newest value and how it comes.

import type { Channel } from "../source/texts";
import { decoderOf, type Decoded, type Decoder } from "./decoder";
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

export class MemoryObject {
  readonly robot: RobotName;
  readonly name: string;
  /** What kind of object it is: "runtime" of /14/2/runtime and of /lab/1/runtime. */
  readonly kind: string;
  /** Made by the server out of another object, only while somebody subscribes. */
  readonly derived: boolean;
  /** One image per message: too much to subscribe to unasked. */
  readonly isImage: boolean;

  /** The newest message, undecoded; `arrived` [s] is on our own steady clock. */
  newest: { log_ns: bigint; data: Uint8Array; arrived: number } | undefined;
  received = 0;
  readonly rate = new Rate();
  /** Whether messages are on their way: we are connected and subscribed. */
  subscribed = false;

  #decoder: Decoder | undefined; // made at first use: most schemas are never looked at
  #decoded: Decoded | undefined;

  constructor(readonly channel: Channel) {
    this.robot = robotOf(channel);
    this.name = objectOf(channel);
    this.kind = this.name.slice(this.name.lastIndexOf("/") + 1);
    this.derived = channel.metadata["derived"] === "true";
    this.isImage = /(^|\.)(Raw|Compressed)?Image$/.test(channel.schemaName);
  }

  arrived(log_ns: bigint, data: Uint8Array, now: number): void {
    this.newest = { log_ns, data, arrived: now };
    this.#decoded = undefined;
    ++this.received;
    this.rate.arrived(now);
  }

  /** The newest message decoded, once per message and only when asked; undefined before the first one. */
  decoded(): Decoded | undefined {
    if (!this.newest) return undefined;
    this.#decoder ??= decoderOf(this.channel);
    return (this.#decoded ??= this.#decoder(this.newest.data));
  }

  /** [s] for how long nothing came of what should have; undefined while all is well. Events are never due. */
  overdue(now: number): number | undefined {
    const isEvent = this.channel.metadata["delivery"] === "reliable";
    return this.subscribed && !isEvent && this.rate.overdue(now) ? this.rate.silence(now) : undefined;
  }
}
