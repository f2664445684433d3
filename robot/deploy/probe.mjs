// Facts about a robot: system, processor, disk, clock, owner of LoLA, permissions of our user. The probe changes nothing.

/** Shell commands that print sections "== name"; a section is empty if the system lacks it. */
export const kProbe = `
section() { echo; echo "== $1"; }
section clock; date +%s
section release; cat /etc/os-release /etc/*release /etc/*-version 2>/dev/null | head -n 60
section kernel; uname -sr
section machine; uname -m
section flags; sed -n '/^flags/{p;q;}' /proc/cpuinfo
section disk; df -Pk . | tail -n 1
section init; if [ -d /run/systemd/system ]; then echo systemd; elif [ -e /sbin/openrc ] || [ -e /sbin/rc ]; then echo OpenRC; fi
section user; XDG_RUNTIME_DIR=\${XDG_RUNTIME_DIR:-/run/user/$(id -u)} systemctl --user show-environment >/dev/null 2>&1 && echo systemd
section linger; ls /var/lib/systemd/linger 2>/dev/null
section me; id -un
section priority; ulimit -r 2>/dev/null || { ulimit -a | sed -n 's/.*real-time priority.* //p'; }
section lola; [ -S /tmp/robocup ] && ls -l /tmp/robocup
section programs; cat /proc/[0-9]*/comm 2>/dev/null | sort -u
section folders; ls -d Config bin naoqi robocup.conf hulk nbites 2>/dev/null
section head; cat /sys/qi/head_id 2>/dev/null
section rsync; command -v rsync
:`;

/** Returns the sections of kProbe's output: name -> text. */
function sectionsOf(text) {
  const sections = new Map();
  for (const [, name, body] of text.matchAll(/^== (\w+)\n([^]*?)(?=\n== |$(?![^]))/gm)) sections.set(name, body.trim());
  return (name) => sections.get(name) ?? "";
}

const kFrameworks = ["bhuman", "hulk", "hula", "naodevilsbase", "naodevils", "naoqi-bin", "naoqi-service", "lola", "lola_adaptor", "naoth", "runswift", "nao"];

/** Returns the name of the system, from its release files and its kernel. */
function imageOf(release, kernel, folders) {
  const pretty = /^PRETTY_NAME="?([^"\n]*)"?$/m.exec(release)?.[1] || release.split("\n")[0] || kernel;
  if (/naoqi|opennao|aldebaran|softbank/i.test(`${release} ${kernel}`)) return `stock NAOqi OS (${pretty})`;
  if (/^ID="?ubuntu/m.test(release)) return folders.includes("Config") ? `B-Human's image (${pretty})` : `an Ubuntu (${pretty})`;
  if (/yocto|poky|hulks|openembedded/i.test(release)) return `a Yocto image (${pretty})`;
  return `an unknown image (${pretty})`;
}

// target processors of the programs: toolchain/nao-v6.cmake and the files beside it
const kNeeds = { "nao-v6": ["sse4_2", "movbe", "popcnt", "rdrand"], "nao-v5": ["ssse3", "movbe"], "nao-v4": ["ssse3", "movbe"] };

/** Returns the reason why the program for `model` cannot run on that processor, or undefined. */
export function whyNotModel(model, { machine, flags }) {
  if (model === "nao-v6" && machine !== "x86_64") return `expected a 64-bit kernel for ${model}, got '${machine}'`;
  if (!/^(x86_64|i[3-6]86)$/.test(machine)) return `expected an Intel processor for ${model}, got '${machine}'`;
  const lacking = kNeeds[model].filter((flag) => !flags.includes(flag));
  return lacking.length === 0 ? undefined : `expected the processor of a ${model}, got one without ${lacking.join(", ")}`;
}

/**
 * Parses the output of kProbe. `before_s` and `after_s` are this machine's clock [s since the epoch] before and after the
 * probe, so the robot's clock is known to about a second.
 */
export function readProbe(text, before_s, after_s) {
  const section = sectionsOf(text);
  const programs = section("programs").split("\n");
  const clock = Number(section("clock"));
  const folders = section("folders").split("\n");
  return {
    image: imageOf(section("release"), section("kernel"), folders),
    kernel: section("kernel"),
    machine: section("machine"),
    flags: section("flags").replace(/^.*:/, "").trim().split(/\s+/),
    free_mb: Math.floor(Number(section("disk").split(/\s+/)[3] ?? 0) / 1000),
    init: section("init") || "neither systemd nor OpenRC",
    hasUserSystemd: section("user") === "systemd",
    lingers: section("linger").split("\n").includes(section("me")),
    priority: section("priority") === "unlimited" ? 99 : Number(section("priority")) || 0,
    lolaOwner: section("lola").split(/\s+/)[2],
    frameworks: kFrameworks.filter((program) => programs.includes(program)),
    head_id: section("head") || undefined,
    hasRsync: section("rsync") !== "",
    behind_s: Math.round((before_s + after_s) / 2 - clock),
  };
}

/** Returns the facts for the user, one line each. */
export function described(probe) {
  const { image, kernel, machine, free_mb, init, lolaOwner, frameworks, head_id, behind_s } = probe;
  const clock = Math.abs(behind_s) <= 2 ? "as here" : `${Math.abs(behind_s)} s ${behind_s > 0 ? "behind" : "ahead of"} this machine's: recordings carry its dates`;
  return [
    `image: ${image}, ${init}`,
    `processor: ${machine}, ${kernel}`,
    ...(head_id ? [`head: ${head_id}`] : []),
    `disk: ${free_mb} MB free`,
    `LoLA: ${lolaOwner ? `its socket belongs to ${lolaOwner}` : "no socket /tmp/robocup"}${frameworks.length > 0 ? `; there runs ${frameworks.join(", ")}` : ""}; we leave it alone`,
    `clock: ${clock}`,
  ];
}
