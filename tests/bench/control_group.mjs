// Programs with a limited share of the disk or of the processor. Needs root.
import { existsSync, mkdirSync, rmdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { atEnd } from "./programs.mjs";

const kRoot = "/sys/fs/cgroup";
let groups = 0;

/** Words that start a program in a group of its own. `first`, `second`: {controller, files} in cgroup version 1 and 2. */
function group(first, second) {
  if (process.getuid() !== 0) throw new Error("it needs root");
  const unified = existsSync(join(kRoot, "cgroup.controllers"));
  const { controller, files } = unified ? second : first;
  const folder = join(kRoot, unified ? "" : controller, `foresight-bench-${process.pid}-${++groups}`);
  if (unified) writeFileSync(join(kRoot, "cgroup.subtree_control"), `+${controller}`);
  mkdirSync(folder);
  atEnd(() => rmdirSync(folder));
  for (const [file, value] of Object.entries(files)) writeFileSync(join(folder, file), String(value));
  return ["sh", "-c", `echo $$ > ${folder}/cgroup.procs && exec "$@"`, "sh"];
}

/** Words that start a program that writes to the device `number`, such as "7:0", no faster than this. */
export const slowWrites = (number, bytesPerSecond) =>
  group(
    { controller: "blkio", files: { "blkio.throttle.write_bps_device": `${number} ${bytesPerSecond}` } },
    { controller: "io", files: { "io.max": `${number} wbps=${bytesPerSecond}` } },
  );

const kPeriod = 100_000; // [us] in which a share is given

/** Words that start a program that gets `share` [0..1] of one core. */
export const shareOfCore = (share) =>
  group(
    { controller: "cpu", files: { "cpu.cfs_period_us": kPeriod, "cpu.cfs_quota_us": share * kPeriod } },
    { controller: "cpu", files: { "cpu.max": `${share * kPeriod} ${kPeriod}` } },
  );
