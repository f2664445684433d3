// A slow disk: ext4 in a file, mounted `sync`, so that each write waits for the device. The kernel throttles the device and
// freezes it for a moment from time to time. Needs root; without root, bench_runtime slows its own writes down.
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { slowWrites } from "./control_group.mjs";
import { atEnd, command, scratch } from "./programs.mjs";

function mounted(sizeMb, bytesPerSecond) {
  const image = join(scratch, "disk.ext4");
  const folder = join(scratch, "disk");
  command("truncate", "-s", `${sizeMb}M`, image);
  command("mkfs.ext4", "-q", image);
  mkdirSync(folder);
  const device = command("losetup", "--find", "--show", image).trim();
  atEnd(() => command("losetup", "--detach", device));
  command("mount", "-o", "sync,noatime", device, folder);
  atEnd(() => command("umount", folder));
  const number = command("lsblk", "-dno", "MAJ:MIN", device).trim();
  return { folder, before: slowWrites(number, bytesPerSecond) };
}

/**
 * `words` describe it; `folder` is on it; `before` and `args` are for the program that writes to it; call `stop()`.
 * Stalls take `stallMs` and begin every `stallEvery` seconds.
 */
export function slowDisk({ sizeMb, bytesPerSecond, stallMs, stallEvery }) {
  const rate = `${(bytesPerSecond / 1e6).toFixed(1)} MB/s, ${Math.round(stallMs)} ms stalls every ${stallEvery.toFixed(2)} s`;
  try {
    if (process.getuid() !== 0) throw new Error("it needs root");
    const disk = mounted(sizeMb, bytesPerSecond);
    const freezing = setInterval(() => {
      try {
        command("sh", "-c", `fsfreeze -f ${disk.folder} && sleep ${stallMs / 1000}; fsfreeze -u ${disk.folder}`);
      } catch {
        // the previous stall still froze it
      }
    }, stallEvery * 1000);
    return {
      ...disk,
      args: [],
      words: `ext4 mounted sync on a throttled device: ${rate}`,
      stop: () => clearInterval(freezing),
    };
  } catch (error) {
    const why = error.message.trim().split("\n").at(-1);
    return {
      folder: join(scratch, "disk-made-slow"),
      before: [],
      args: [
        "--disk-mb-per-second",
        bytesPerSecond / 1e6,
        "--disk-stall-ms",
        stallMs,
        "--disk-stall-every",
        stallEvery,
      ],
      words: `this machine's disk, made slow in the program (no throttled device: ${why}): ${rate}`,
      stop: () => {},
    };
  }
}

/** Returns a process's memory [MB] from the kernel, by name, such as VmRSS. */
export const memoryOf = (pid, name) =>
  Number(readFileSync(`/proc/${pid}/status`, "utf8").match(new RegExp(`${name}:\\s+(\\d+)`))[1]) / 1000;
