// What work takes of a Nao's processor, as far as another machine can tell: its instructions.
import { join } from "node:path";
import { command, scratch, start } from "./programs.mjs";

/** Instructions a second that one core of an Atom of 1.6 GHz is taken to carry out: 0.7 per cycle. */
export const kAtomInstructions = 1.6e9 * 0.7;

let runs = 0;

/** Starts a program of ours that callgrind counts the instructions of; `count()` tells them, once it has ended. */
export function startCounted(name, args, preset) {
  const counts = join(scratch, `callgrind-${++runs}`);
  const program = start(name, args, ["valgrind", "--quiet", "--tool=callgrind", `--callgrind-out-file=${counts}`], preset);
  const count = () => Number(/^(?:summary|totals): (\d+)/m.exec(command("grep", "-E", "^(summary|totals):", counts))[1]);
  return { ...program, count };
}
