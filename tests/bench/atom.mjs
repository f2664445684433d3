// The load of work on a Nao's processor, computed on another machine from its instructions.
import { join } from "node:path";
import { command, scratch, start } from "./programs.mjs";

/** Assumed instructions a second of one Atom core of 1.6 GHz: 0.7 per cycle. */
export const kAtomInstructions = 1.6e9 * 0.7;

let runs = 0;

/**
 * Starts a program under callgrind; `count()` returns its instructions after its end. `within` limits them to the calls of
 * functions with such a name.
 */
export function startCounted(name, args, preset, within) {
  const counts = join(scratch, `callgrind-${++runs}`);
  const program = start(
    name,
    args,
    [
      "valgrind",
      "--quiet",
      "--tool=callgrind",
      `--callgrind-out-file=${counts}`,
      ...(within ? [`--toggle-collect=${within}`] : []),
    ],
    preset,
  );
  const count = () =>
    Number(/^(?:summary|totals): (\d+)/m.exec(command("grep", "-E", "^(summary|totals):", counts))[1]);
  return { ...program, count };
}
