// Robots on one machine: each has a network, a home, users, processes and an ssh server of its own, in namespaces. They are
// joined with a lab, from which the commands run, by a switch.
//
// Everything lives in processes that are killed when this one ends, whatever it ends of; namespaces, mounts and devices go
// with their last process. Needs root.
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { chmodSync, chownSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const kUser = 1001; // nao, on the robots only
export const kPassword = "nao";

const kSshd = "/usr/sbin/sshd";

/** Runs a command of the system to its end; returns its output, or throws an Error with it. */
const command = (name, ...args) =>
  execFileSync(name, args.map(String), { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

const kPatience_ms = 30000; // room for a busy machine; only a failure takes this long
const sleep_ms = (time) => Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, time);

/** Waits for the process that `pid` starts, and returns it. */
function childOf(pid) {
  for (const end = performance.now() + kPatience_ms; performance.now() < end;) {
    const [child] = readFileSync(`/proc/${pid}/task/${pid}/children`, "utf8").trim().split(" ");
    if (child) return Number(child);
    sleep_ms(5);
  }
  throw new Error(`waited ${kPatience_ms / 1000} s in vain for a process in namespaces of its own`);
}

/** Keeps namespaces alive by a shell that does `script`; `pid` is its process, seen from here. */
function hold(script) {
  const unshare = ["unshare", "--net", "--mount", "--pid", "--mount-proc", "--fork", "--kill-child"];
  const holder = spawn("setpriv", ["--pdeathsig", "KILL", ...unshare, "sh", "-euc", script], {
    stdio: ["ignore", "ignore", "pipe"],
  });
  const place = { talk: "" };
  holder.stderr.on("data", (text) => (place.talk += text));
  place.ended = new Promise((done) => holder.on("close", done));
  place.pid = childOf(holder.pid);
  place.kill = () => holder.kill("SIGKILL");
  return place;
}

const tbf = (rate) => ["tbf", "rate", rate, "burst", "64kbit", "latency", "100ms"];

/** Words before a command that shall run at `place`: in its network, or as one of its own. */
export const inNetwork = ({ pid }) => ["nsenter", "-t", String(pid), "--net"];
const inside = ({ pid }) => ["nsenter", "-t", String(pid), "--net", "--mount", "--pid"];

/** Returns the reason why such robots cannot run here, or false. */
export function whyNoField() {
  if (process.getuid() !== 0) return "robots in namespaces need root";
  for (const tool of [kSshd, "/usr/bin/ssh", "/usr/bin/rsync", "/usr/sbin/ip"])
    try {
      command("test", "-x", tool);
    } catch {
      return `robots in namespaces need ${tool}`;
    }
  try {
    const tryOut =
      "mount -t tmpfs tmpfs /mnt && ip link add switch type bridge && ip link add name lab type veth peer name robot";
    command("unshare", "--net", "--mount", "--pid", "--mount-proc", "--fork", "sh", "-euc", tryOut);
    return false;
  } catch (error) {
    return `namespaces do not work here: ${error.message.trim().split("\n").at(-1)}`;
  }
}

/** sshd insists on a configuration and users of its own; it gets what a Nao has: user nao, its password, sftp, no PAM. */
function writeSystem(folder, { release }) {
  const write = (name, text, mode = 0o644) => {
    writeFileSync(join(folder, name), text);
    chmodSync(join(folder, name), mode);
  };
  const hash = command("openssl", "passwd", "-6", kPassword).trim();
  write(
    "passwd",
    `root:x:0:0:root:/root:/bin/sh\nsshd:x:100:65534::/run/sshd:/usr/sbin/nologin\nnao:x:${kUser}:${kUser}::/home/nao:/bin/sh\n`,
  );
  write("shadow", `root:*:1::::::\nnao:${hash}:1::::::\n`, 0o600);
  write("group", `root:x:0:\nnao:x:${kUser}:\n`);
  write("os-release", release);
  command("ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", join(folder, "host_key"));
  const settings = [
    "HostKey /run/host_key",
    "UsePAM no",
    "PidFile none",
    "PermitRootLogin no",
    "PasswordAuthentication yes",
    "MaxStartups 50",
  ];
  write("sshd_config", `${settings.join("\n")}\n`);
}

/** Where processes are put that belong to the systemd of a robot's user: a folder of each hierarchy that counts them. */
const kHierarchies = ["/sys/fs/cgroup", "/sys/fs/cgroup/systemd", "/sys/fs/cgroup/unified"];
const groupName = (folder) => folder.split("/").slice(-2).join("-");

/** The systemd of user nao, as with enabled lingering, and a sudo that only records its arguments. */
const userSystemd = (folder) => `
mount -t tmpfs tmpfs /usr/local/bin
printf '#!/bin/sh\\necho "$*" >>/tmp/sudo.log\\n' >/usr/local/bin/sudo && chmod +x /usr/local/bin/sudo
mkdir -p /run/systemd/system /run/user/${kUser} && chown ${kUser} /run/user/${kUser} && chmod 700 /run/user/${kUser}
groups=
for hierarchy in ${kHierarchies.join(" ")}; do
  if [ ! -e $hierarchy/cgroup.procs ]; then continue; fi
  mkdir -p $hierarchy/${groupName(folder)} && chown -R ${kUser} $hierarchy/${groupName(folder)}
  groups="$groups $hierarchy/${groupName(folder)}/cgroup.procs"
done
(
  for group in $groups; do echo 0 >$group; done
  cd /
  exec setpriv --reuid ${kUser} --regid ${kUser} --clear-groups env -i HOME=/home/nao PATH=/usr/bin:/bin XDG_RUNTIME_DIR=/run/user/${kUser} \\
    setsid /usr/lib/systemd/systemd --user >/run/user.log 2>&1 </dev/null
) &`;

/** Removes the folders of kHierarchies; the last processes in them may still be ending. */
async function removeGroups(folder) {
  const groups = kHierarchies
    .map((hierarchy) => join(hierarchy, groupName(folder)))
    .filter((group) => existsSync(group));
  for (
    const end = performance.now() + kPatience_ms;
    groups.some((group) => existsSync(group)) && performance.now() < end;
  ) {
    spawnSync("find", [...groups, "-depth", "-type", "d", "-exec", "rmdir", "{}", ";"]);
    await new Promise((done) => setTimeout(done, 20));
  }
}

/** The first process of a robot: mounts the robot's files over the machine's, then serves ssh. */
const bootScript = (folder, systemd) => `
mount --bind ${folder}/home /home
for name in passwd shadow group; do mount --bind ${folder}/run/$name /etc/$name; done
mount --bind ${folder}/run/os-release "$(readlink -f /etc/os-release)"
mount --bind ${folder}/run /run
mkdir -p /run/sshd
mount -t tmpfs tmpfs /dev/shm
mount -t tmpfs tmpfs /tmp
ip link set lo up
until ip -br address show eth0 2>/dev/null | grep -q 10.; do sleep 0.02; done
${systemd ? userSystemd(folder) : ""}
exec ${kSshd} -D -f /run/sshd_config -E /run/sshd.log`;

const kRelease = 'PRETTY_NAME="Ubuntu 22.04.4 LTS"\nID=ubuntu\n';

export class Field {
  #places = [];

  /** A switch and a lab. */
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), "foresight-field-"));
    this.#switch = hold("ip link add switch type bridge; ip link set switch up; exec sleep infinity");
    this.lab = hold("ip link set lo up; exec sleep infinity");
    this.#places.push(this.#switch, this.lab);
    this.#ip(this.#switch, "link", "show", "switch");
    this.#plug(this.lab, "lab", "10.14.0.1");
    this.robots = [];
  }

  #switch;

  /** ip in the network of `place`, repeated until its first process has made the device. */
  #ip(place, ...words) {
    for (const end = performance.now() + kPatience_ms; ;)
      try {
        return command(...inNetwork(place), "ip", ...words);
      } catch (error) {
        if (performance.now() > end) throw error;
        sleep_ms(10);
      }
  }

  #plug(place, name, address) {
    this.#ip(this.#switch, "link", "add", "name", name, "type", "veth", "peer", "name", "eth0", "netns", place.pid);
    this.#ip(this.#switch, "link", "set", name, "master", "switch", "up");
    this.#ip(place, "link", "set", "eth0", "up");
    this.#ip(place, "address", "add", `${address}/16`, "broadcast", "10.14.255.255", "dev", "eth0");
  }

  /** Limits the rate of the lab's cable, which all robots share, in both directions. */
  shape(rate) {
    command(...inNetwork(this.#switch), "tc", "qdisc", "replace", "dev", "lab", "root", ...tbf(rate));
    command(...inNetwork(this.lab), "tc", "qdisc", "replace", "dev", "eth0", "root", ...tbf(rate));
  }

  /**
   * Switches a robot on: {name, address, home, folder}. `release`: its /etc/os-release; `systemd`: its user has one, unless
   * this machine cannot.
   */
  addRobot(name, { release = kRelease, systemd = false } = {}) {
    const robot = { name, address: `10.14.1.${this.robots.length + 1}`, folder: join(this.folder, name) };
    robot.home = join(robot.folder, "home/nao");
    for (const folder of [robot.home, join(robot.folder, "run")]) mkdirSync(folder, { recursive: true });
    chmodSync(this.folder, 0o755);
    chmodSync(robot.home, 0o755);
    chownSync(robot.home, kUser, kUser);
    writeSystem(join(robot.folder, "run"), { release });
    Object.assign(robot, hold(bootScript(robot.folder, systemd)));
    this.#places.push(robot);
    this.#plug(robot, name, robot.address);
    this.robots.push(robot);
    return robot;
  }

  /** Limits the rate of a robot's cable towards it, in tc's notation. */
  slow({ name }, rate) {
    command(...inNetwork(this.#switch), "tc", "qdisc", "replace", "dev", name, "root", ...tbf(rate));
  }

  /** Pulls the robot's cable, or plugs it in again. */
  pull({ name }) {
    this.#ip(this.#switch, "link", "set", name, "down");
  }
  plug({ name }) {
    this.#ip(this.#switch, "link", "set", name, "up");
  }

  /** Runs a line of shell on the robot as root, or as its user. */
  runOn(robot, line, { as = "nao" } = {}) {
    const words =
      as === "root"
        ? ["sh", "-c", line]
        : [
            "setpriv",
            "--reuid",
            kUser,
            "--regid",
            kUser,
            "--clear-groups",
            "env",
            "HOME=/home/nao",
            "sh",
            "-c",
            `cd && ${line}`,
          ];
    return command(...inside(robot), ...words);
  }

  kill() {
    for (const place of this.#places) place.kill();
  }

  async end() {
    this.kill();
    await Promise.all(this.#places.map(({ ended }) => ended));
    for (const { folder } of this.robots) await removeGroups(folder);
    rmSync(this.folder, { recursive: true, force: true });
  }
}
