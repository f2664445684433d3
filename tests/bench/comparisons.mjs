// foresight-sim compare as the benches run it: to its end, with its duration and memory.
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const program = fileURLToPath(new URL("../../build/release/bin/foresight-sim", import.meta.url));

/** [kB] the most that a process held, or 0 if it has ended. */
function highest(pid) {
  try {
    return Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))?.[1] ?? 0);
  } catch {
    return 0;
  }
}

export const childrenOf = (pid) =>
  readFileSync(`/proc/${pid}/task/${pid}/children`, "utf8").split(" ").filter(Boolean).map(Number);

/**
 * Runs a comparison: {report, seconds, megabytes}. `watch(pid)` is called every `every` seconds while it runs.
 * Every verdict is accepted; bad input throws an Error.
 */
export async function compare(words, { watch = () => {}, every = 0.2 } = {}) {
  const start = performance.now();
  const child = spawn(program, ["compare", ...words.map(String), "--json"], { stdio: ["ignore", "pipe", "pipe"] });
  let [text, said, most] = ["", "", 0];
  child.stdout.on("data", (data) => (text += data));
  child.stderr.on("data", (data) => (said += data));
  const looking = setInterval(() => {
    most = Math.max(most, highest(child.pid));
    watch(child.pid);
  }, every * 1000);
  const status = await new Promise((ended) => child.on("close", ended));
  clearInterval(looking);
  if (![0, 1, 3].includes(status)) throw new Error(said.trim());
  return { report: JSON.parse(text), seconds: (performance.now() - start) / 1000, megabytes: most / 1024 };
}
