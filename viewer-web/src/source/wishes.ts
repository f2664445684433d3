// What we wish of a playback, one wish on its way at a time: while a person drags along the strip of time only the last
// place counts, and the server is never asked faster than it answers.

import type { PlaybackWish } from "./frames";

const kPatience = 5; // [s] a server that may not obey answers with a sentence that names no wish

export class Wishes {
  #underway: { wish: PlaybackWish; request: string; since: number } | undefined;
  #next: PlaybackWish | undefined;
  #count = 0;

  /** `send` says whether there is somebody to ask. */
  constructor(readonly send: (wish: PlaybackWish, request: string) => boolean) {}

  /** What was wished last and is not yet so. */
  get pending(): PlaybackWish | undefined {
    return this.#next ?? this.#underway?.wish;
  }

  /** `now` is our own steady clock [s]. */
  ask(wish: PlaybackWish, now: number): void {
    // a place that waits to be sought is not given up because of a wish that names none
    const next = { ...wish, seek_ns: wish.seek_ns ?? this.#next?.seek_ns };
    if (this.#underway) this.#next = next;
    else this.#begin(next, now);
  }

  /** Whether this answers a wish of ours; then the next one goes out. */
  answered(request: string, now: number): boolean {
    if (!this.#underway || request !== this.#underway.request) return false;
    const next = this.#next;
    this.clear();
    if (next) this.#begin(next, now);
    return true;
  }

  /** True once when a wish was not answered in time; then nothing is wished any more. */
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
