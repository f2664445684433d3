// A line per robot: on a terminal it is written over, elsewhere every new word of it is a line.
import { RobotFailed } from "./failure.mjs";

/** Lines for `names`; `out` is a stream. say() shows what a robot is doing, end() what became of it. */
export class Lines {
  #texts = new Map();
  #drawn = 0;

  constructor(names, out = process.stdout) {
    this.out = out;
    this.width = Math.max(...names.map((name) => name.length));
    for (const name of names) this.#texts.set(name, "…");
    if (out.isTTY) this.#draw();
  }

  /** `passing`: not worth a line of its own where lines stay, such as a percentage. */
  say(name, text, { passing = false } = {}) {
    if (this.#texts.get(name) === text) return;
    this.#texts.set(name, text);
    if (this.out.isTTY) this.#draw();
    else if (!passing) this.out.write(`${name.padEnd(this.width)}  ${text}\n`);
  }

  /** Several lines about a robot, above those that change. */
  tell(name, text) {
    if (this.out.isTTY) this.#clear();
    for (const line of text.trimEnd().split("\n")) this.out.write(`${name.padEnd(this.width)}  ${line}\n`);
    if (this.out.isTTY) this.#draw();
  }

  #clear() {
    if (this.#drawn > 0) this.out.write(`\x1b[${this.#drawn}A\x1b[J`);
    this.#drawn = 0;
  }

  #draw() {
    this.#clear();
    const columns = this.out.columns ?? 80;
    for (const [name, text] of this.#texts) this.out.write(`${`${name.padEnd(this.width)}  ${text}`.slice(0, columns - 1)}\n`);
    this.#drawn = this.#texts.size;
  }
}

/**
 * Does `work` for every robot, side by side. A robot that fails says why on its line and keeps nobody from going on.
 * Answers with the robots that did not fail.
 */
export async function sideBySide(lines, robots, work) {
  const outcomes = await Promise.all(
    robots.map(async (robot) => {
      try {
        await work(robot);
        return [robot];
      } catch (error) {
        // what is our own bug tells where it happened
        const [first, ...rest] = (error instanceof RobotFailed ? error.message : error.stack).split("\n");
        if (rest.length > 0) lines.tell(robot.name, rest.join("\n"));
        lines.say(robot.name, `FAILED: ${first}`);
        return [];
      }
    }),
  );
  return outcomes.flat();
}
