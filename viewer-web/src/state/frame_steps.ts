// Steps by frames: to the next or previous message of the most even object.

import type { MemoryObject } from "../memory/memory_object";
import type { RobotObject } from "../memory/schema";

const kLongestStep = 100; // frames that the server finds at once

/** The part of the page that steps use. Moments are of the server's clock. */
export interface Stepped {
  /** Whether the place is not known yet, because the server is about to pause. */
  readonly waits: boolean;
  /** The object that defines frames. */
  beat(): MemoryObject | undefined;
  /** Whether the server finds frames, because the page misses messages of a recording. */
  readonly finds: boolean;
  find(object: MemoryObject, from_ns: bigint, by: number): Promise<bigint>;
  /** Whether the page has all messages around a moment. */
  holds(at_ns: bigint): boolean;
  at_ns(): bigint;
  go(at_ns: bigint): void;
  warn(sentence: string): void;
}

export class FrameSteps {
  #left = 0; // frames to go, negative backwards
  #search: object | undefined; // the server's search for the frame of some of these steps

  constructor(readonly page: Stepped) {}

  get underWay(): boolean {
    return this.#left !== 0;
  }

  add(by: 1 | -1): void {
    this.#left += by;
    this.make();
  }

  end(): void {
    this.#left = 0;
    this.#search = undefined;
  }

  /** Makes the steps that can be made now. Those that are added during a search come next. */
  make(): void {
    const { page } = this;
    if (this.#left === 0 || this.#search || page.waits) return;
    const object = page.beat();
    if (!object) return this.end();
    if (page.finds) void this.#searchFrame(object);
    else this.#stepInHistory(object);
  }

  /** Asks the server for the frame: the page misses messages of places that it has not shown, and any while it is slow. */
  async #searchFrame(object: MemoryObject): Promise<void> {
    const { page } = this;
    const search = (this.#search = {});
    const by = Math.max(-kLongestStep, Math.min(this.#left, kLongestStep));
    try {
      const frame_ns = await page.find(object, page.at_ns(), by);
      if (this.#search !== search) return;
      const left = this.#left - by;
      this.#go(frame_ns);
      this.#left = left;
    } catch (error) {
      if (this.#search !== search) return;
      if (!this.#stepInHistory(object)) page.warn((error as Error).message);
    }
  }

  /** Makes all steps among the messages that the page holds. Returns false if it does not hold them. */
  #stepInHistory({ history }: MemoryObject): boolean {
    const { page } = this;
    const steps = this.#left;
    this.end();
    const at_ns = page.at_ns();
    const index = history.indexAt(at_ns);
    const isBetween = history.timeOf(index) !== at_ns;
    const frame_ns = history.timeOf(index + steps + (isBetween && steps < 0 ? 1 : 0));
    if (frame_ns === undefined || !page.holds(frame_ns)) return false;
    this.#go(frame_ns);
    return true;
  }

  /** Goes to a moment, which ends the steps that were asked for. */
  #go(at_ns: bigint): void {
    this.end();
    this.page.go(at_ns);
  }
}

const kBeats = ["truth/world", ...(["decision", "pose", "joints"] satisfies RobotObject[])];

/** Returns the object that defines frames: the image, else the world, else the decision or a belief, else the fullest. */
export function beatOf(objects: MemoryObject[]): MemoryObject | undefined {
  const received = objects.filter((object) => object.received > 0);
  const lengthOf = ({ history }: MemoryObject) => history.end - history.begin;
  return (
    received.find(({ isImage }) => isImage) ??
    kBeats.map((name) => received.find((object) => object.name === name)).find((object) => object !== undefined) ??
    received.sort((a, b) => lengthOf(b) - lengthOf(a))[0]
  );
}
