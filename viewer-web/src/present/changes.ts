// When what a row says changed last, to let the eye find what moves.

const kMostRows = 2000; // [rows] more than ever on screen; beyond it the oldest are forgotten

export class Changes {
  #rows = new Map<string, { text: string; changed: number }>();

  /** Notes what the row at `path` says now. [s] since it last said something else; Infinity while it always said the same. */
  sinceChange(path: string, text: string, now: number): number {
    const before = this.#rows.get(path);
    const changed = !before ? -Infinity : before.text === text ? before.changed : now;
    this.#rows.delete(path); // to the end: what is looked at is kept longest
    this.#rows.set(path, { text, changed });
    if (this.#rows.size > kMostRows) this.#rows.delete(this.#rows.keys().next().value!);
    return now - changed;
  }
}
