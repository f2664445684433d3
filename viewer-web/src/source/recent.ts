// The last minutes of a live server, which remembers its small objects for pages that come late.

import { byTime } from "./by_time";
import { channelsIn, type Recorded } from "./mcap";

const kMostSeconds = 20; // [s] for one answer
const kAtOnce = 8; // [objects] in one answer, so that the page never works long on one

export type Remembered = Pick<Recorded, "topic" | "messages">;

/**
 * Fetches the remembered messages of `topics`, each in order of capture time, from `path` of the page's own server.
 * Returns undefined if the server refuses. Rejects with a sentence.
 */
export async function fetchRecent(path: string, topics: string[]): Promise<Remembered[] | undefined> {
  const signal = AbortSignal.timeout(kMostSeconds * 1000);
  let bytes: Uint8Array;
  try {
    const response = await fetch(`${path}?${new URLSearchParams({ topics: topics.join("\n") })}`, { signal });
    if ([401, 403, 404, 503].includes(response.status)) return undefined;
    if (!response.ok) throw new Error(`HTTP ${response.status}`);
    bytes = new Uint8Array(await response.arrayBuffer());
  } catch (error) {
    throw new Error(`The last minutes of ${topics[0]} cannot be had: ${(error as Error).message}.`);
  }
  const { channels, damage } = channelsIn(bytes);
  if (damage) throw new Error(`The last minutes of ${topics[0]} cannot be read: ${damage}.`);
  for (const { messages } of channels) messages.sort(byTime);
  return channels;
}

/** Fetches the last minutes of the wanted objects, a few at a time, in the order in which they were wanted. */
export class Recalls {
  #topics = new Set<string>();
  #state: "waits" | "rests" | "runs" | "stopped" = "waits";

  /** `arrived` gets the messages of a topic; `failed` gets a sentence. */
  constructor(
    readonly fetchSome: (topics: string[]) => Promise<Remembered[] | undefined> | undefined,
    readonly arrived: (remembered: Remembered) => void,
    readonly failed: (sentence: string) => void,
  ) {}

  want(topic: string): void {
    if (this.#state === "stopped") return;
    this.#topics.add(topic);
    if (this.#state === "rests") void this.#run();
  }

  /** Begins to fetch. Nothing is fetched before. */
  begin(): void {
    if (this.#state === "waits") void this.#run();
  }

  /** Whether an answer is to come. */
  get busy(): boolean {
    return this.#state === "runs" || (this.#state === "waits" && this.#topics.size > 0);
  }

  /** Nothing arrives any more. */
  stop(): void {
    this.#state = "stopped";
    this.#topics.clear();
  }

  async #run(): Promise<void> {
    this.#state = "runs";
    while (this.#topics.size > 0) {
      const topics = [...this.#topics].slice(0, kAtOnce);
      for (const topic of topics) this.#topics.delete(topic);
      try {
        const all = await this.fetchSome(topics);
        if (this.#stopped) return;
        if (!all) this.#topics.clear(); // refused: the others would be refused too
        for (const remembered of all ?? []) this.arrived(remembered);
      } catch (error) {
        if (this.#stopped) return;
        this.failed((error as Error).message);
        this.#topics.clear();
      }
    }
    this.#state = "rests";
  }
  get #stopped(): boolean {
    return this.#state === "stopped";
  }
}
