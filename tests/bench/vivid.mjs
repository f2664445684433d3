// Does the program for the Nao V6 stream from cameras of the kernel's own? In an emulated machine, with the processor that
// stands in for the robot's, Debian's kernel and two of its virtual cameras (the driver "vivid"), and nothing else.
import { spawnSync } from "node:child_process";
import {
  chmodSync,
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { basename, join } from "node:path";
import { root } from "../e2e/support.mjs";
import { built, robots } from "../nao/robots.mjs";
import { command, scratch } from "./programs.mjs";
import { Report } from "./report.mjs";

const kCpu = robots["nao-v6"].emulator.at(-1);
const kDriverHz = 25; // vivid knows no 30 Hz at 640x480
const kTopics = ["camera_top", "camera_bottom"];
const kMark = "sessions: ";

const packages = join(root, "build/vivid");

/** Unpacks a Debian package of this machine's release without installing it; returns the folder. */
function unpacked(name) {
  const folder = join(packages, name);
  if (existsSync(folder)) return folder;
  mkdirSync(packages, { recursive: true });
  spawnSync("apt-get", ["download", "-qq", name], { cwd: packages, stdio: "inherit" });
  const file = readdirSync(packages).find((entry) => entry.startsWith(`${name}_`));
  if (!file) throw new Error(`the package ${name} cannot be downloaded; run apt-get update`);
  command("dpkg-deb", "-x", join(packages, file), folder);
  return folder;
}

/** Debian's kernel: its image, and the modules in the order in which vivid needs them. */
function kernel(busybox) {
  const name = /linux-image-\d\S*/.exec(command("apt-cache", "depends", "linux-image-amd64"))?.[0];
  if (!name) throw new Error("this machine's APT sources have no linux-image-amd64");
  const folder = unpacked(name);
  const version = name.slice("linux-image-".length);
  const modules = join(folder, "lib/modules", version);
  command(busybox, "depmod", "-b", folder, version);
  const needs = new Map(
    readFileSync(join(modules, "modules.dep"), "utf8")
      .trim()
      .split("\n")
      .map((line) => {
        const [path, rest = ""] = line.split(":");
        return [path, rest.trim().split(/\s+/).filter(Boolean)];
      }),
  );
  const vivid = [...needs.keys()].find((path) => basename(path).startsWith("vivid.ko"));
  const order = [];
  const add = (path) => {
    if (order.includes(path)) return;
    needs.get(path).forEach(add);
    order.push(path);
  };
  add(vivid);
  return { image: join(folder, "boot", `vmlinuz-${version}`), modules: order.map((path) => join(modules, path)) };
}

/** The script of the machine from start to end; the robot's recording goes to the console. */
const init = (modules, seconds) => `#!/bin/busybox sh
b=/bin/busybox
$b mount -t proc p /proc
$b mount -t sysfs s /sys
$b mount -t devtmpfs d /dev
$b mkdir -p /dev/shm
$b mount -t tmpfs -o size=4g t /dev/shm
$b ip link set lo up
${modules.map((module) => `$b insmod /modules/${module}${module.startsWith("vivid") ? " n_devs=2 node_types=0x1,0x1" : ""}`).join("\n")}
$b ln -s video0 /dev/video-top
$b ln -s video1 /dev/video-bottom
robot="/bin/foresight-robot --team 14 --player 2 --log-dir /dev/shm/logs --state-dir /dev/shm/state"
$robot --body nao --record --profile full --port 8765 &
$b sleep ${seconds}
$b kill -TERM $!
wait $!
$robot --body attached --port 8766 &
while ! $b wget -q -O /dev/shm/sessions http://127.0.0.1:8766/api/sessions; do $b sleep 1; done
echo "${kMark}$($b cat /dev/shm/sessions)"
$b poweroff -f
`;

/** The file system that the machine starts with. */
function initramfs(busybox, modules, seconds) {
  const folder = join(scratch, "machine");
  for (const path of ["bin", "modules", "proc", "sys", "dev", "tmp"])
    mkdirSync(join(folder, path), { recursive: true });
  cpSync(busybox, join(folder, "bin/busybox"));
  symlinkSync("busybox", join(folder, "bin/sh"));
  cpSync(built("nao-v6"), join(folder, "bin/foresight-robot"));
  for (const module of modules) cpSync(module, join(folder, "modules", basename(module)));
  writeFileSync(
    join(folder, "init"),
    init(
      modules.map((module) => basename(module)),
      seconds,
    ),
  );
  chmodSync(join(folder, "init"), 0o755);
  const archive = join(scratch, "machine.cpio");
  command("sh", "-c", `cd ${folder} && find . | ${busybox} cpio -o -H newc > ${archive}`);
  return archive;
}

export async function vivid({ seconds = 20 }) {
  const report = new Report("vivid", "does the Nao V6's program stream from the kernel's own cameras?");
  const busybox = join(unpacked("busybox-static"), "bin/busybox");
  const { image, modules } = kernel(busybox);
  const { stdout, error } = spawnSync(
    "qemu-system-x86_64",
    [
      "-accel",
      "tcg",
      "-cpu",
      kCpu,
      "-m",
      "5120",
      "-smp",
      "2",
      "-nographic",
      "-no-reboot",
      "-nic",
      "none",
      "-kernel",
      image,
      "-initrd",
      initramfs(busybox, modules, seconds),
      "-append",
      "console=ttyS0 quiet panic=-1",
    ],
    { encoding: "utf8", timeout: (seconds + 300) * 1000, maxBuffer: 1 << 26 },
  );
  if (error) throw new Error(`qemu-system-x86_64: ${error.message}`);
  const told = stdout.split(kMark)[1]?.split("\n")[0];
  const [session] = told ? JSON.parse(told).sessions : [];
  if (!session) throw new Error(`the emulated machine ended without a recording:\n${stdout.slice(-3000)}`);
  report.figure("emulated processor", kCpu);
  for (const topic of kTopics) {
    const stream = session.streams.find((each) => each.topic.endsWith(`/${topic}`));
    const span = Number(BigInt(stream.end_ns) - BigInt(stream.start_ns)) / 1e9;
    report.figure(`${topic}: images of 640x480, recorded as they are`, stream.messages, "", { above: 0 });
    report.figure(
      `${topic}: of the ${kDriverHz} a second that the driver makes`,
      (100 * (stream.messages - 1)) / span / kDriverHz,
      "%",
      { atLeast: 95 },
    );
  }
  return report.finish();
}
