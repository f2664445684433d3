// Playback wishes of the page, one under way at a time. While a person drags along the timeline, only the last place
// counts, and the server never gets wishes faster than it answers.

import type { PlaybackWish } from "./frames";

const kPatience = 5; // [s] a refusing server may answer with a sentence that names no wish

export class Wishes {
  #underway: { wish: PlaybackWish; request: string; since: number } | undefined;
  #next: PlaybackWish | undefined;
  #count = 0;

  /** `send` returns false if no server is connected. */
  constructor(readonly send: (wish: PlaybackWish, request: string) => boolean) {}

  /** The newest wish that is not fulfilled yet. */
  get pending(): PlaybackWish | undefined {
    return this.#next ?? this.#underway?.wish;
  }

  /** `now`: the page's steady clock [s]. */
  ask(wish: PlaybackWish, now: number): void {
    // a wish without a place keeps the place of a waiting seek
    const next = { ...wish, seek_ns: wish.seek_ns ?? this.#next?.seek_ns };
    if (this.#underway) this.#next = next;
    else this.#begin(next, now);
  }

  /** Returns whether `request` answers a wish of ours. If so, the next wish is sent. */
  answered(request: string, now: number): boolean {
    if (!this.#underway || request !== this.#underway.request) return false;
    const next = this.#next;
    this.clear();
    if (next) this.#begin(next, now);
    return true;
  }

  /** Returns true once when a wish was not answered in time. All wishes are then dropped. */
  gaveUp(now: number): boolean {
    if (!this.#underway || now - this.#underway.since <= kPatience) return false;
    this.clear();
    return true;
  }

  clear(): void {
    this.#underway = this.#next = undefined;
  }

  #begin(wish: PlaybackWish, now: number): void {
    const request = `page ${++this.#count}`;
    if (this.send(wish, request)) this.#underway = { wish, request, since: now };
  }
}
