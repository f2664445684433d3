// Everything the connected robots tell: the newest value of each memory object, by topic.

import type { Channel } from "../source/texts";
import { MemoryObject, type RobotName } from "./memory_object";
import { LogHistory } from "./log_history";
import { ServerClock } from "./server_clock";

export class Memory {
  readonly clock = new ServerClock();
  readonly log = new LogHistory();
  #objects = new Map<string, MemoryObject>();

  /** Forgets everything: another run of the server begins. */
  reset(): void {
    this.clock.clear();
    this.log.clear();
    this.#objects.clear();
  }

  /** A channel known from before, same schema, keeps its value and counts: the connection was lost, not the run. */
  offer(channel: Channel): void {
    const known = this.#objects.get(channel.topic)?.channel;
    if (known && known.schema === channel.schema && known.schemaName === channel.schemaName) return;
    this.#objects.set(channel.topic, new MemoryObject(channel));
  }

  withdraw(topic: string): void {
    this.#objects.delete(topic);
  }

  /** What came before a pause says nothing about the rate after it. */
  subscribed(topic: string, is: boolean): void {
    const object = this.#objects.get(topic);
    if (!object) return;
    object.subscribed = is;
    object.rate.clear();
  }

  arrived(topic: string, log_ns: bigint, data: Uint8Array, now: number): void {
    const object = this.#objects.get(topic);
    if (!object) return;
    object.arrived(log_ns, data, now);
    if (isLog(object)) this.log.arrived(object, log_ns);
  }

  get(topic: string): MemoryObject | undefined {
    return this.#objects.get(topic);
  }

  /** [s] since the newest value of `object` was sensed; undefined when there is none or the server tells no time. */
  age(object: MemoryObject, now: number): number | undefined {
    return object.newest && this.clock.age(object.newest.log_ns, now);
  }

  /** All robots that offer anything, in order of team and player. */
  robots(): RobotName[] {
    const names = new Set([...this.#objects.values()].map(({ robot }) => robot).filter((robot) => robot !== ""));
    return [...names].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  }

  /** The robot's own objects by name, then what belongs to no single robot. */
  objectsOf(robot: RobotName): MemoryObject[] {
    return [...this.#objects.values()]
      .filter((object) => object.robot === robot || object.robot === "")
      .sort((a, b) => Number(a.robot === "") - Number(b.robot === "") || a.name.localeCompare(b.name, "en"));
  }
}

const isLog = (object: MemoryObject): boolean => object.kind === "log" && !object.derived;
