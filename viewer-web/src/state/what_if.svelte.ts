// A person's question to foresight: the question, the edit, the answer and the problem.

import { believedBy } from "../draw/believed";
import { forecastOf, fieldsOfJson, type Forecast, type Situation } from "../memory/forecast";
import {
  believed,
  kMostStrategies,
  kNoEdit,
  moved,
  putBack,
  questionOfText,
  requestOf,
  strategiesOf,
  textOfQuestion,
} from "../memory/question";
import type { Edit, Question, Standing, Thing } from "../memory/question";
import { causeOf } from "../source/calls";
import { now } from "./frame.svelte";
import type { Server } from "./server.svelte";
import type { Pane } from "./pane.svelte";

export const kService = "/foresight/what_if";
export const kStrategiesService = "/foresight/strategies";

const kPatienceMs = 15_000; // beyond the budget: another question may run first
const kSettleMs = 3000; // until a recording has reached the page's moment
const kNoteMs = 300; // delay until the address is updated

export interface Answered {
  forecast: Forecast;
  /** The edit of this question. */
  edit: Edit;
  /** The robot's beliefs, without the edit. */
  believed: Situation;
  /** [ns] capture time on the server's clock. */
  at_ns: bigint;
}

export class WhatIf {
  question = $state.raw<Question>(questionOfText(""));
  answered = $state.raw<Answered>();
  /** One sentence; "" while all is well. */
  problem = $state("");
  /** [s] Time of the question and its minimum duration. Undefined if no question is under way. */
  asking = $state.raw<{ since: number; lasts: number }>();
  /** The strategies that the robot offers, in its order; empty until its answer has come. */
  offeredNames = $state.raw<string[]>([]);
  /** The strategies to choose from: first those that the robot offers, then others of the question, such as a link's. */
  names: string[] = $derived([...new Set([...this.offeredNames, ...this.question.strategies])]);
  #noted: string | undefined;
  #note: ReturnType<typeof setTimeout> | undefined;

  constructor(
    readonly viewer: Pane,
    readonly server: Server,
    readonly robot: string,
  ) {}

  get offered(): boolean {
    return this.server.serviceNames.includes(kService);
  }

  /** Takes the question from the page's address, unless this object wrote it there. */
  follow(text: string): void {
    if (text === this.#noted) return;
    this.#noted = text;
    this.question = questionOfText(text);
  }

  change(to: Partial<Question>): void {
    this.question = { ...this.question, ...to };
    clearTimeout(this.#note);
    this.#note = setTimeout(() => this.viewer.set("ask", (this.#noted = textOfQuestion(this.question))), kNoteMs);
  }

  edit(to: Partial<Edit>): void {
    this.change({ edit: { ...this.question.edit, ...to } });
  }
  move(thing: Thing, to: Standing): void {
    this.change({ edit: moved(this.question.edit, thing, to) });
  }
  putBack(thing: Thing): void {
    this.change({ edit: putBack(this.question.edit, thing) });
  }
  reset(): void {
    this.change({ edit: kNoEdit });
  }

  /** Asks the robot for the names of its strategies. A robot without that service chooses the strategies by itself. */
  async learnNames(): Promise<void> {
    if (!this.server.serviceNames.includes(kStrategiesService)) return;
    try {
      this.offeredNames = strategiesOf(await this.server.client.call(kStrategiesService, {}));
    } catch (error) {
      this.problem = (error as Error).message;
    }
  }

  /** The strategies to compare: those of the question, or all offered ones with `playing` first. */
  compared(playing: string): string[] {
    const { strategies } = this.question;
    if (strategies.length > 0) return strategies;
    return [...new Set([playing, ...this.offeredNames])].filter(Boolean).slice(0, kMostStrategies);
  }

  /** Asks, unless a question is on its way. `playing`: the strategy to compare with when the question names none. */
  async ask(playing: string): Promise<void> {
    if (this.asking) return;
    const { question } = this;
    this.problem = "";
    this.asking = { since: now(), lasts: question.budgetMs / 1000 };
    try {
      await this.#settled();
      const before = this.answered?.believed ?? this.believes();
      const at_ns = this.viewer.time.at_ns + this.viewer.time.shiftOf(this.server);
      const request = requestOf({ ...question, strategies: this.compared(playing) }, this.robot);
      const answer = await this.server.client.call(kService, request, question.budgetMs + kPatienceMs);
      this.#answered(forecastOf(fieldsOfJson(answer["forecast"])), question.edit, at_ns, before);
    } catch (error) {
      this.problem = (error as Error).message.replace(`${kService}: `, "");
      this.server.refusedBecause(causeOf(error));
    } finally {
      this.asking = undefined;
    }
  }

  #answered(forecast: Forecast, edit: Edit, at_ns: bigint, before: Situation): void {
    this.answered = { forecast, edit, at_ns, believed: believed(forecast.situation, edit, before) };
  }

  /** The robot's own beliefs at the shown moment. */
  believes(): Situation {
    return believedBy(this.server.memory, this.robot, now());
  }

  /** Waits until a played recording has reached the page's moment, from which it answers. */
  async #settled(): Promise<void> {
    const { memory, played } = this.server;
    const end = now() + kSettleMs / 1000;
    const isThere = () =>
      !this.server.asked && (memory.moment_ns === undefined || played!.at(now()) === memory.moment_ns);
    while (played && !isThere() && now() < end) await new Promise((done) => setTimeout(done, 30));
  }

  /** Shows the robot's own forecast again. */
  close(): void {
    this.answered = undefined;
    this.problem = "";
  }
}
