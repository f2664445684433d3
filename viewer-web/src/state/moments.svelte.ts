// Interesting moments: the matches of a condition, and bookmarks. Both are in the page's address.

import { conditionOf, type Condition } from "../memory/condition";
import type { Mistake } from "../memory/expression";
import { Finder, type Match } from "../memory/finder";
import { vocabularyOf } from "../memory/vocabulary";
import { WholeFinder, type FetchPart } from "../memory/whole_finder";
import { Breakpoint } from "./breakpoint";
import { bookmarksOf, textOfBookmarks, withBookmark, type Bookmark } from "./bookmarks";
import type { Viewer } from "./viewer.svelte";

const kBudget = 4; // [ms] of a frame for reading the past

export class Moments {
  open = $state(false);

  query: string = $derived.by(() => this.viewer.get("find"));
  readonly #parsed: Condition | Mistake | undefined = $derived.by(() => {
    const { server, robot } = this.viewer;
    void server.offers;
    return this.query.trim() ? conditionOf(this.query, vocabularyOf(server.memory, robot)) : undefined;
  });
  /** The mistake in the condition and its place. */
  mistake: Mistake | undefined = $derived(this.#parsed && "error" in this.#parsed ? this.#parsed : undefined);
  condition: Condition | undefined = $derived(this.#parsed && !("error" in this.#parsed) ? this.#parsed : undefined);
  #finder: Finder | undefined = $derived.by(() => {
    const { memory } = this.viewer.server;
    const { condition } = this;
    return (
      condition &&
      new Finder(
        condition,
        new Map([...memory.objects()].map((object) => [object.channel.topic, object])),
        memory.played !== undefined,
      )
    );
  });
  /**
   * The search in the whole recording, if its server supports it. Until then, and otherwise, the seen part is
   * searched.
   */
  #whole: WholeFinder | undefined = $derived.by(() => {
    const { memory, target, played } = this.viewer.server;
    const { condition } = this;
    // the page cannot reach the HTTP interface of other servers
    if (!condition || !played || !target.ownHost) return undefined;
    const fetch: FetchPart = async (...part) => (await import("../source/played_parts")).fetchPlayed(...part);
    const decoders = new Map(
      [...memory.objects()].map((object) => [object.channel.topic, (data: Uint8Array) => object.decode(data)]),
    );
    return new WholeFinder(condition, decoders, played, fetch);
  });
  /** Whether time stops when the condition begins to hold. */
  stops: boolean = $derived.by(() => this.viewer.get("stop") === "yes");
  #breakpoint = new Breakpoint();
  bookmarks: Bookmark[] = $derived.by(() => bookmarksOf(this.viewer.get("marks")));

  constructor(readonly viewer: Viewer) {
    this.open = viewer.get("find") !== "" || viewer.get("marks") !== "";
  }

  /** Called before each drawing. */
  update(): void {
    if (this.#searched) this.#searched.update(kBudget);
    else this.#finder?.update(kBudget);
    if (!this.stops || !this.condition) return this.#breakpoint.clear();
    const { time } = this.viewer;
    const stop_ns = this.#breakpoint.stopAt(time.at_ns, time.runs, this.#begins());
    if (stop_ns === undefined) return;
    time.seek(stop_ns);
    time.hold();
  }

  /** The begins of all matches, in the reference's time. */
  #begins(): bigint[] {
    const shift_ns = this.viewer.time.shiftOf(this.viewer.server);
    return this.matches.map(({ from_ns }) => from_ns - shift_ns);
  }

  get #searched(): WholeFinder | undefined {
    return this.#whole?.problem ? undefined : this.#whole;
  }

  /** In the chosen robot's time. */
  get matches(): readonly Match[] {
    return (this.#searched ?? this.#finder)?.matches ?? [];
  }

  /** The searched range, for people: "in the whole recording". */
  get scope(): string {
    const whole = this.#searched;
    if (!whole) return "in what was seen";
    return whole.done ? "in the whole recording" : `in ${Math.floor(100 * whole.share)} % of the recording`;
  }

  /** True if there are more matches than these. */
  get more(): boolean {
    return this.#searched?.full ?? false;
  }

  /** The reason why only the seen part is searched, or "". */
  get problem(): string {
    return this.#whole?.problem ?? "";
  }

  stopThere(stops: boolean): void {
    this.viewer.set("stop", stops ? "yes" : "");
  }

  find(query: string): void {
    this.viewer.set("find", query);
  }

  /** Goes to the next or previous begin of a match. */
  jump(by: 1 | -1): void {
    this.viewer.time.jumpAmong(by, this.#begins());
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
