// One line of output per robot. A terminal overwrites it; elsewhere each change is a new line.
import { RobotFailed } from "./failure.mjs";

/** The lines of `names` on the stream `out`. say() shows the present step or the result of a robot. */
export class Lines {
  #texts = new Map();
  #drawn = 0;

  constructor(names, out = process.stdout) {
    this.out = out;
    this.width = Math.max(...names.map((name) => name.length));
    for (const name of names) this.#texts.set(name, "…");
    if (out.isTTY) this.#draw();
  }

  /** Sets the line of a robot. A `passing` text, such as a percentage, is shown on terminals only. */
  say(name, text, { passing = false } = {}) {
    if (this.#texts.get(name) === text) return;
    this.#texts.set(name, text);
    if (this.out.isTTY) this.#draw();
    else if (!passing) this.out.write(`${name.padEnd(this.width)}  ${text}\n`);
  }

  /** Prints several lines about a robot, above the changing lines. */
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
 * Does `work` for all robots at the same time. The line of a failed robot shows the reason; the others continue.
 * Returns the robots that did not fail.
 */
export async function sideBySide(lines, robots, work) {
  const outcomes = await Promise.all(
    robots.map(async (robot) => {
      try {
        await work(robot);
        return [robot];
      } catch (error) {
        // a bug of ours is shown with its stack
        const [first, ...rest] = (error instanceof RobotFailed ? error.message : error.stack).split("\n");
        if (rest.length > 0) lines.tell(robot.name, rest.join("\n"));
        lines.say(robot.name, `FAILED: ${first}`);
        return [];
      }
    }),
  );
  return outcomes.flat();
}
