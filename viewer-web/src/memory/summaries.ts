// Summaries of numbers of a played recording, which its server makes: a coarse one of the whole, and a fine one of the
// part that each view looks at.

import type { WholeNumbers, WholeRun } from "../source/whole";

/** Fetches summaries of several fields between two capture times. Rejects with a sentence. */
export type FetchNumbers = (
  fields: string[],
  range: { from_ns: bigint; to_ns: bigint },
  intervals: number,
  signal: AbortSignal,
) => Promise<WholeNumbers[]>;

interface Range {
  from_ns: bigint;
  to_ns: bigint;
}

const kWhole = 2048; // intervals of the whole: more than most screens have pixels
const kMost = 4096; // intervals of one answer
const kBetween = 0.25; // [s] between two requests for a part, while a view is zoomed

/** The summaries of the whole, which all views of a recording share. */
export class Summaries {
  #whole = new Map<string, WholeNumbers>(); // by field
  #failed = new Map<string, string>(); // sentences by field
  #reading = new Set<string>(); // fields whose whole is requested

  constructor(
    readonly range: Range,
    readonly fetch: FetchNumbers,
  ) {}

  /** The summary of a field, or undefined while there is none. */
  of(field: string): WholeNumbers | undefined {
    return this.#whole.get(field);
  }

  /** The reason why a field has no summary, or "". */
  problem(field: string): string {
    return this.#failed.get(field) ?? "";
  }

  /** Whether the summary of a field is under way. */
  reading(field: string): boolean {
    return this.#reading.has(field);
  }

  /** Fetches the fields that were not fetched yet, all at once. */
  want(fields: string[]): void {
    const missing = fields.filter(
      (field) => !this.#whole.has(field) && !this.#failed.has(field) && !this.#reading.has(field),
    );
    if (missing.length > 0) void this.#fetch(missing);
  }

  async #fetch(fields: string[]): Promise<void> {
    for (const field of fields) this.#reading.add(field);
    try {
      const found = await this.fetch(fields, this.range, kWhole, new AbortController().signal);
      for (const field of fields) {
        const one = found.find((summary) => summary.field === field);
        if (one && !one.problem) this.#whole.set(field, one);
        else this.#failed.set(field, one?.problem || "the server did not summarise it");
      }
    } catch (error) {
      // one bad field must not cost the others their summaries
      if (fields.length > 1) await Promise.all(fields.map((field) => this.#fetch([field])));
      else this.#failed.set(fields[0]!, (error as Error).message);
    }
    for (const field of fields) this.#reading.delete(field);
  }
}

/** The summaries for one view: those of the whole, and finer ones of the part that it looks at. */
export class ViewSummaries {
  #part = new Map<string, WholeNumbers>(); // by field
  #wanted: (Range & { fields: string; step_ns: number }) | undefined; // the part that was requested last
  #last = -Infinity; // [s] time of that request
  #asked: AbortController | undefined; // the request for the part

  constructor(readonly whole: Summaries) {}

  /** The summaries of a field that are there, coarse before fine. */
  of(field: string): WholeNumbers[] {
    return [this.whole.of(field), this.#part.get(field)].filter((one) => one !== undefined);
  }

  /**
   * Fetches what a view of `width` pixels needs: the whole of each field once, and its own part if that is too coarse.
   * Call it before each drawing. `now` is the page's steady clock [s].
   */
  update(fields: string[], view: Range, width: number, now: number): void {
    this.whole.want(fields);
    const known = fields.filter((field) => this.whole.of(field));
    const step_ns = Number(view.to_ns - view.from_ns) / Math.max(1, width); // of one pixel
    if (known.length === 0 || this.whole.of(known[0]!)!.step_ns <= step_ns) return;
    const wanted = this.#wanted;
    const covers = wanted?.fields === known.join(" ") && wanted.from_ns <= view.from_ns && wanted.to_ns >= view.to_ns;
    if ((covers && wanted.step_ns <= 1.5 * step_ns) || now - this.#last < kBetween) return;
    this.#last = now;
    void this.#fetch(known, view, step_ns);
  }

  /** Ends the request for a part. */
  stop(): void {
    this.#asked?.abort();
  }

  /** Fetches the view with its surroundings, so that it can move a little. */
  async #fetch(fields: string[], view: Range, step_ns: number): Promise<void> {
    this.#asked?.abort();
    const asked = (this.#asked = new AbortController());
    const length_ns = view.to_ns - view.from_ns;
    const from_ns = max(this.whole.range.from_ns, view.from_ns - length_ns);
    const to_ns = min(this.whole.range.to_ns, view.to_ns + length_ns);
    this.#wanted = { from_ns, to_ns, fields: fields.join(" "), step_ns };
    const intervals = Math.min(kMost, Math.max(1, Math.ceil(Number(to_ns - from_ns) / step_ns)));
    try {
      const found = await this.whole.fetch(fields, { from_ns, to_ns }, intervals, asked.signal);
      if (this.#asked !== asked) return;
      this.#part = new Map(found.filter(({ problem }) => !problem).map((one) => [one.field, one]));
    } catch {
      if (this.#asked === asked) this.#wanted = undefined; // the whole is still shown; it is asked again
    }
    if (this.#asked === asked) this.#asked = undefined;
  }
}

const max = (a: bigint, b: bigint): bigint => (a > b ? a : b);
const min = (a: bigint, b: bigint): bigint => (a < b ? a : b);

/** The runs of some fields of one topic, fetched once. */
export class WholeRuns {
  runs: WholeRun[] | undefined;
  /** The reason why they cannot be had, or "". */
  problem = "";

  constructor(fetch: () => Promise<WholeRun[]>) {
    fetch().then(
      (runs) => (this.runs = runs),
      (error: unknown) => (this.problem = (error as Error).message),
    );
  }
}
