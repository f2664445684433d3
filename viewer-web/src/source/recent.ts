// The last minutes of a live server, which remembers its small objects for pages that come late.

import { recordedIn, type Recorded } from "./mcap";

const kMostSeconds = 20; // [s] for one answer

/**
 * Fetches the remembered messages of `topic`, in order of capture time, from `path` of the page's own server. Returns
 * undefined if the server refuses, as to other machines during a game. Rejects with a sentence.
 */
export async function fetchRecent(path: string, topic: string): Promise<Recorded["messages"] | undefined> {
  const signal = AbortSignal.timeout(kMostSeconds * 1000);
  let bytes: Uint8Array;
  try {
    const response = await fetch(`${path}?${new URLSearchParams({ topic })}`, { signal });
    if ([401, 403, 404, 503].includes(response.status)) return undefined;
    if (!response.ok) throw new Error(`HTTP ${response.status}`);
    bytes = new Uint8Array(await response.arrayBuffer());
  } catch (error) {
    throw new Error(`The last minutes of ${topic} cannot be had: ${(error as Error).message}.`);
  }
  const { messages, damage } = recordedIn(bytes);
  if (damage) throw new Error(`The last minutes of ${topic} cannot be read: ${damage}.`);
  return messages.sort((a, b) => (a.log_ns < b.log_ns ? -1 : a.log_ns > b.log_ns ? 1 : 0));
}

/** Fetches the last minutes of one object after the other. */
export class Recalls {
  #topics = new Set<string>();
  #runs = false;
  #stopped = false;

  /** `arrived` gets the messages of a topic; `failed` gets a sentence. */
  constructor(
    readonly fetchOne: (topic: string) => Promise<Recorded["messages"] | undefined>,
    readonly arrived: (topic: string, messages: Recorded["messages"]) => void,
    readonly failed: (sentence: string) => void,
  ) {}

  want(topic: string): void {
    this.#topics.add(topic);
    if (!this.#runs) void this.#run();
  }

  /** Nothing arrives any more. */
  stop(): void {
    this.#stopped = true;
    this.#topics.clear();
  }

  async #run(): Promise<void> {
    this.#runs = true;
    for (const topic of this.#topics) {
      this.#topics.delete(topic);
      try {
        const messages = await this.fetchOne(topic);
        if (this.#stopped) return;
        if (messages) this.arrived(topic, messages);
        else this.#topics.clear(); // refused: the others would be refused too
      } catch (error) {
        if (this.#stopped) return;
        this.failed((error as Error).message);
        this.#topics.clear();
      }
    }
    this.#runs = false;
  }
}
