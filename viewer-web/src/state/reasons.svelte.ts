// The reasons of the shown decision: asked for anew when the page shows another one.

import {
  alternativeOf,
  knownThen,
  kSituation,
  kWhy,
  kWhyNot,
  reasonsOf,
  requestOf,
  type Alternative,
  type Reasons,
} from "../memory/reasons";
import type { Pane } from "./pane.svelte";

/** An answer to "why not?", with its question. */
export interface WhyNot {
  /** The part of the tree, by its path, and its name. */
  path: string;
  title: string;
  /** [ns] Capture time of the decision. */
  at_ns: bigint;
  alternative: Alternative | undefined;
  problem: string;
}

export class ReasonsAsker {
  reasons = $state.raw<Reasons>();
  /** One sentence; "" while all is well. */
  problem = $state("");
  whyNot = $state.raw<WhyNot>();
  #asking = false;
  #asked = ""; // robot and times of the objects that were asked about last

  constructor(readonly viewer: Pane) {}

  get offered(): boolean {
    return this.viewer.server.serviceNames.includes(kWhy);
  }

  /** Asks if another decision is shown. Questions never wait in a row: the next one is about what is shown then. */
  async follow(): Promise<void> {
    if (this.#asking || !this.offered) return;
    const { server, robot } = this.viewer;
    const known = knownThen(server.memory, robot);
    if (!known) return;
    // after a seek some objects arrive later than the decision
    const shown = [robot, ...known.entries.map(([name, { log_ns }]) => `${name} ${log_ns}`)].join(" ");
    if (shown === this.#asked) return;
    this.#asked = shown;
    this.#asking = true;
    try {
      this.reasons = reasonsOf(await server.client.call(kWhy, requestOf(known)), known);
      this.problem = "";
    } catch (error) {
      this.reasons = undefined;
      this.problem = (error as Error).message.replace(`${kWhy}: `, "");
    } finally {
      this.#asking = false;
    }
  }

  /** Asks why the shown decision did not reach a part of the tree. */
  async askWhyNot(path: string, title: string): Promise<void> {
    const { server, robot } = this.viewer;
    const known = knownThen(server.memory, robot);
    if (!known) return;
    const asked = { path, title, at_ns: known.at_ns, alternative: undefined, problem: "" };
    this.whyNot = asked;
    try {
      const answer = await server.client.call(kWhyNot, { ...requestOf(known), what: path });
      if (this.whyNot === asked) this.whyNot = { ...asked, alternative: alternativeOf(answer) };
    } catch (error) {
      if (this.whyNot === asked)
        this.whyNot = { ...asked, problem: (error as Error).message.replace(`${kWhyNot}: `, "") };
    }
  }

  /** Whether moments can be saved. */
  get saves(): boolean {
    return this.viewer.server.serviceNames.includes(kSituation);
  }

  /** Returns what the robot believed at the shown decision, as a situation of the simulator, or the reason why not. */
  async situation(): Promise<{ text: string } | { problem: string }> {
    const { server, robot } = this.viewer;
    const known = knownThen(server.memory, robot);
    if (!known) return { problem: "no decision is shown" };
    try {
      const { situation } = await server.client.call(kSituation, requestOf(known));
      return { text: String(situation) };
    } catch (error) {
      return { problem: (error as Error).message.replace(`${kSituation}: `, "") };
    }
  }

  closeWhyNot(): void {
    this.whyNot = undefined;
  }
}
