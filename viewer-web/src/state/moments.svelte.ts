// Interesting moments: the matches of a condition, breakpoints and bookmarks. All are in the page's address.

import { tickAt } from "../memory/simulation";
import { Breakpoint } from "./breakpoint";
import { breakpointsOf, kLongestCondition, kMostBreakpoints, textOfBreakpoints } from "./breakpoints";
import { bookmarksOf, textOfBookmarks, withBookmark, type Bookmark } from "./bookmarks";
import { now } from "./frame.svelte";
import { Search } from "./search.svelte";
import type { Viewer } from "./viewer.svelte";

const kBudget = 4; // [ms] of a frame for reading the past

/** A condition that stops time, with its matches. */
export interface KeptBreakpoint {
  condition: string;
  /** false: it is only shown. */
  on: boolean;
  search: Search;
}

export class Moments {
  open = $state(false);

  query: string = $derived.by(() => this.viewer.get("find"));
  readonly search: Search;
  /** Whether time stops when the condition begins to hold. */
  stops: boolean = $derived.by(() => this.viewer.get("stop") === "yes");
  readonly #searches = new Map<string, Search>(); // by condition
  breakpoints: KeptBreakpoint[] = $derived.by(() =>
    breakpointsOf(this.viewer.get("breaks")).map((kept) => ({ ...kept, search: this.#searchFor(kept.condition) })),
  );
  readonly #breakpoint = new Breakpoint();
  #frame = 0; // [s] time of the last one in which something could stop
  bookmarks: Bookmark[] = $derived.by(() => bookmarksOf(this.viewer.get("marks")));

  constructor(readonly viewer: Viewer) {
    this.search = new Search(viewer, () => this.query);
    this.open = ["find", "marks", "breaks"].some((setting) => viewer.get(setting) !== "");
  }

  #searchFor(condition: string): Search {
    let search = this.#searches.get(condition);
    if (!search) this.#searches.set(condition, (search = new Search(this.viewer, () => condition)));
    return search;
  }

  get #all(): Search[] {
    return [this.search, ...this.breakpoints.map(({ search }) => search)];
  }

  /** The searches of the breakpoints that are on. */
  get #kept(): Search[] {
    return this.breakpoints.filter(({ on }) => on).map(({ search }) => search);
  }

  /** All topics that are read. */
  get topics(): string[] {
    return [...new Set(this.#all.flatMap(({ condition }) => condition?.topics ?? []))];
  }

  /** Called before each drawing. */
  update(): void {
    const all = this.#all;
    for (const search of all) search.update(kBudget / all.length);
    const stopping = [...(this.stops ? [this.search] : []), ...this.#kept].filter(({ condition }) => condition);
    if (stopping.length === 0) return this.#breakpoint.clear();
    const { time } = this.viewer;
    const stop_ns = this.#breakpoint.stopAt(time.at_ns, time.runs, beginsOf(stopping), this.#elapsed_ns());
    if (stop_ns === undefined) return;
    const wasLive = time.live;
    time.seek(stop_ns);
    time.hold();
    if (wasLive) void this.#stopGame(stop_ns);
  }

  /**
   * A simulated game stands still too. Beliefs and decisions of a tick are those of its begin, so it stands at the next one.
   * The page then shows it live, so that it can step.
   */
  async #stopGame(at_ns: bigint): Promise<void> {
    const { server, time } = this.viewer;
    if (!server.serviceNames.includes("/sim/back")) return;
    const tick = tickAt(server.memory, at_ns + time.shiftOf(server));
    if (tick === undefined) return;
    try {
      await server.standAt(tick + 1);
      this.#breakpoint.clear(); // the ticks that were taken back stop nothing
      time.now();
    } catch (error) {
      server.status("error", (error as Error).message, "breakpoint");
    }
  }

  /** The time since the last call, at the pace of the playback. */
  #elapsed_ns(): bigint {
    const frame = now();
    const elapsed = Math.max(0, frame - this.#frame) * Math.max(1, this.viewer.time.speed);
    this.#frame = frame;
    return BigInt(Math.round(1e9 * elapsed));
  }

  stopThere(stops: boolean): void {
    this.viewer.set("stop", stops ? "yes" : "");
  }

  find(query: string): void {
    this.viewer.set("find", query);
  }

  /** Goes to the next or previous begin of a match, or of a breakpoint's. */
  jump(by: 1 | -1): void {
    this.viewer.time.jumpAmong(by, beginsOf([this.search, ...this.#kept]));
  }

  /** Whether the searched condition can become a breakpoint. */
  get canBreak(): boolean {
    return (
      this.search.condition !== undefined &&
      this.query.length <= kLongestCondition &&
      this.breakpoints.length < kMostBreakpoints &&
      this.breakpoints.every(({ condition }) => condition !== this.query.trim())
    );
  }
  /** Makes the searched condition a breakpoint. */
  break(): void {
    this.#keepBreakpoints([...this.breakpoints, { condition: this.query.trim(), on: true }]);
    this.viewer.set("find", "");
    this.viewer.set("stop", "");
  }
  turn(condition: string, on: boolean): void {
    this.#keepBreakpoints(this.breakpoints.map((kept) => (kept.condition === condition ? { condition, on } : kept)));
  }
  unbreak(condition: string): void {
    this.#keepBreakpoints(this.breakpoints.filter((kept) => kept.condition !== condition));
    this.#searches.delete(condition);
  }
  #keepBreakpoints(breakpoints: { condition: string; on: boolean }[]): void {
    this.viewer.set("breaks", textOfBreakpoints(breakpoints));
  }

  mark(): void {
    this.#keep(withBookmark(this.bookmarks, this.viewer.time.at_ns));
    this.open = true;
  }
  rename(at_ns: bigint, name: string): void {
    this.#keep(this.bookmarks.map((bookmark) => (bookmark.at_ns === at_ns ? { at_ns, name } : bookmark)));
  }
  forget(at_ns: bigint): void {
    this.#keep(this.bookmarks.filter((bookmark) => bookmark.at_ns !== at_ns));
  }
  #keep(bookmarks: Bookmark[]): void {
    this.viewer.set("marks", textOfBookmarks(bookmarks));
  }
}

const beginsOf = (searches: Search[]): bigint[] => searches.flatMap((search) => search.begins());
