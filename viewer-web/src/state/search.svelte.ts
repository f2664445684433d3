// One condition, and the moments at which it held: in the whole recording if its server supports that, otherwise in what
// this page has seen.

import { conditionOf, type Condition } from "../memory/condition";
import type { Mistake } from "../memory/expression";
import { Finder, type Match } from "../memory/finder";
import { vocabularyOf } from "../memory/vocabulary";
import { WholeFinder, type FetchPart } from "../memory/whole_finder";
import type { Viewer } from "./viewer.svelte";

export class Search {
  readonly #parsed: Condition | Mistake | undefined = $derived.by(() => {
    const { server, robot } = this.viewer;
    void server.offers;
    const text = this.textOf();
    return text.trim() ? conditionOf(text, vocabularyOf(server.memory, robot)) : undefined;
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

  /** `textOf` returns the condition; "" searches nothing. */
  constructor(
    readonly viewer: Viewer,
    readonly textOf: () => string,
  ) {}

  /** Reads more of the past, for `budget` [ms]. Called before each drawing. */
  update(budget: number): void {
    if (this.#searched) this.#searched.update(budget);
    else this.#finder?.update(budget);
  }

  /** The begins of all matches, in the reference's time. */
  begins(): bigint[] {
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
}
