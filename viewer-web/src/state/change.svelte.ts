// A change of the shown moment, made by a person: the edits, and the futures without and with them.

import { changeableOf, isOfTree, kEditGame, kFutures, linesOf, moveIn, type ChangeableMoment } from "../memory/change";
import type { Situation } from "../memory/forecast";
import { isEdited, kNoEdit, moved, putBack, type Edit, type Standing, type Thing } from "../memory/question";
import type { Memory } from "../memory/memory";
import { knownThen, requestOf } from "../memory/reasons";
import { kSimulation, simulationOf, tickAt } from "../memory/simulation";
import type { Pane } from "./pane.svelte";
import type { Server } from "./server.svelte";

const kLate = 5; // [ticks] an older decision is not that of the shown moment: the robot is penalised
const kPatienceMs = 60_000; // a slow machine plays a thousand games a minute

/** The moment that is changed, as the service is asked about it. */
interface Taken {
  server: Server;
  robot: string;
  request: object;
  /** Its tick in the simulated game that the server plays; undefined for beliefs. */
  tick: number | undefined;
}

export class Change {
  /** The moment without the change. Undefined until the server has told it. */
  moment = $state.raw<ChangeableMoment>();
  /** The moved things. */
  edit = $state.raw<Edit>(kNoEdit);
  /** The other edits, as lines of the debugger. */
  lines = $state.raw<string[]>([]);
  pairs = $state(200);
  /** [s] of each future. */
  seconds = $state(30);
  /** The answer, and the edits that it is about. */
  answered = $state.raw<{ moment: ChangeableMoment; edits: string }>();
  /** One sentence; "" while all is well. */
  problem = $state("");
  asking = $state(false);
  #taken = $state.raw<Taken>();

  constructor(readonly viewer: Pane) {}

  get offered(): boolean {
    return this.viewer.server.serviceNames.includes(kFutures);
  }
  get robot(): string {
    return this.#taken?.robot ?? "";
  }
  /** Whether the server plays the game, so that it can go on with the change. */
  get plays(): boolean {
    return this.#taken?.tick !== undefined;
  }
  get places(): Situation {
    return this.moment?.places ?? { ball: undefined, bodies: [] };
  }
  /** All edits, as lines of the debugger. */
  edits: string[] = $derived(this.moment ? [...linesOf(this.edit, this.moment), ...this.lines] : []);
  /** The futures belong to other edits than these. */
  stale: boolean = $derived(this.answered !== undefined && this.answered.edits !== this.edits.join("\n"));

  /** Takes the shown moment as the one to be changed, and keeps the edits unless it is that of another robot. */
  async take(): Promise<void> {
    const { server, robot } = this.viewer;
    const known = knownThen(server.memory, robot);
    const game = server.serviceNames.includes(kEditGame) ? simulationOf(server.memory) : undefined;
    if (!game && !known) return void (this.problem = "no decision is shown");
    const tick = game && this.#tickOf(server.memory, game.tick, known?.at_ns);
    const asked = game ? { robot, seed: game.seed, tick } : requestOf(known!);
    if (robot !== this.#taken?.robot) [this.edit, this.lines] = [kNoEdit, []];
    this.#taken = { server, robot, request: asked, tick };
    this.answered = undefined;
    const moment = await this.#ask([], 0);
    if (moment) this.moment = moment;
  }

  /** Returns the tick at which the shown decision was made, so that it is made again with the change. */
  #tickOf(memory: Memory, shown: number, decided_ns: bigint | undefined): number {
    if (decided_ns === undefined) return shown;
    // a page that was just opened has no earlier state
    const before = decided_ns < (memory.world(kSimulation)?.shown?.log_ns ?? 0n) ? Math.max(0, shown - 1) : shown;
    const tick = tickAt(memory, decided_ns) ?? before;
    return tick > shown - kLate ? tick : shown;
  }

  move(thing: Thing, to: Standing): void {
    this.edit = moved(this.edit, thing, to);
  }
  putBack(thing: Thing): void {
    this.edit = putBack(this.edit, thing);
  }

  /** Adds a line, if the server accepts it. Returns whether it did. */
  async add(line: string): Promise<boolean> {
    if (!this.moment || !(await this.#ask([...this.edits, line], 0))) return false;
    const move = moveIn(line, this.moment);
    if (move) this.move(move.thing, move.to);
    else if (!this.lines.includes(line.trim())) this.lines = [...this.lines, line.trim()];
    return true;
  }
  remove(line: string): void {
    this.lines = this.lines.filter((one) => one !== line);
  }
  reset(): void {
    [this.edit, this.lines, this.answered, this.problem] = [kNoEdit, [], undefined, ""];
  }
  get isEdited(): boolean {
    return isEdited(this.edit) || this.lines.length > 0;
  }

  /** Plays the futures. */
  async run(): Promise<void> {
    const edits = this.edits;
    const moment = await this.#ask(edits, this.pairs);
    if (moment) this.answered = { moment, edits: edits.join("\n") };
  }

  /** Why the game cannot be played on with the edits; "" if it can. */
  get refusal(): string {
    if (!this.isEdited) return "nothing is changed";
    const ofTree = this.lines.find(isOfTree);
    return ofTree ? `a running game keeps its trees: without “${ofTree}”` : "";
  }

  /** Returns the game to the moment, changes it there, and lets it stand. Returns whether it did. */
  async playOn(): Promise<boolean> {
    const { server, robot, tick } = this.#taken!;
    this.problem = "";
    try {
      await server.standAt(tick!);
      await server.client.call(kEditGame, { robot, edits: this.edits, tick });
      return true;
    } catch (error) {
      this.problem = (error as Error).message.replace(`${kEditGame}: `, "");
      return false;
    }
  }

  async #ask(edits: string[], pairs: number): Promise<ChangeableMoment | undefined> {
    const taken = this.#taken;
    if (!taken) return undefined;
    this.asking = true;
    this.problem = "";
    try {
      const request = { ...taken.request, edits, pairs, seconds: this.seconds };
      const answer = changeableOf(await taken.server.client.call(kFutures, request, kPatienceMs));
      return this.#taken === taken ? answer : undefined;
    } catch (error) {
      if (this.#taken === taken) this.problem = (error as Error).message.replace(`${kFutures}: `, "");
      return undefined;
    } finally {
      this.asking = false;
    }
  }
}
