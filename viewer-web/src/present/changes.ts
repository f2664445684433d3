// Time of each row's last change, to show the eye what moves.

const kMostRows = 2000; // [rows] more than are ever on screen; beyond it the oldest are dropped

export class Changes {
  #rows = new Map<string, { text: string; changed: number }>();

  /** Notes the row's text now. Returns the time [s] since it last changed, or Infinity if it never did. */
  sinceChange(path: string, text: string, now: number): number {
    const before = this.#rows.get(path);
    const changed = !before ? -Infinity : before.text === text ? before.changed : now;
    this.#rows.delete(path); // to the end: rows in use are kept longest
    this.#rows.set(path, { text, changed });
    if (this.#rows.size > kMostRows) this.#rows.delete(this.#rows.keys().next().value!);
    return now - changed;
  }
}
