// The Naos whose builds are tested: their processors as the emulator knows them, and the words that run a program there.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "../e2e/support.mjs";

// the emulator has no Silvermont: the model below it, and the two instructions it lacks; nothing has AVX
const silvermont = { emulator: ["qemu-x86_64", "-cpu", "Westmere,+movbe,+rdrand"], kernel: "4.4" };
const bonnell = { emulator: ["qemu-i386", "-cpu", "n270"], kernel: "2.6.33" };

/** preset -> {emulator, kernel}: the words that run a program as on that robot, and how old its kernel is. */
export const robots = { "nao-v6": silvermont, "nao-v5": bonnell, "nao-v4": bonnell };

/** The robots whose builds are tested. */
export const chosen = (process.env.FORESIGHT_NAO ?? "nao-v6").split(" ");
for (const preset of chosen)
  if (!(preset in robots))
    throw new Error(`FORESIGHT_NAO: expected ${Object.keys(robots).join(", ")}, got '${preset}'`);

/** Returns the path of the program that was built for that robot. */
export const built = (preset, program = "foresight-robot") => join(root, "build", preset, "bin", program);

/** Option of a test that runs what was built for a Nao on this machine, at full speed. */
export const needsMovbe = {
  skip: / movbe /.test(readFileSync("/proc/cpuinfo", "utf8"))
    ? false
    : "this processor lacks MOVBE, which the Naos' have",
};

const kInterpreter = 3,
  kDynamic = 2,
  kSymbols = 2;

/** Reads an ELF file: its word size, whether it needs shared libraries, whether it has symbols. */
export function readElf(file) {
  const bytes = readFileSync(file);
  const bits = bytes[4] === 2 ? 64 : 32;
  const wide = bits === 64;
  const table = (offset, size, count) => Array.from({ length: count }, (_, i) => offset + i * size);
  const offset = (at) => (wide ? Number(bytes.readBigUInt64LE(at)) : bytes.readUInt32LE(at));
  const halves = (at) => [bytes.readUInt16LE(at), bytes.readUInt16LE(at + 2)];
  const segments = table(offset(wide ? 32 : 28), ...halves(wide ? 54 : 42)).map((at) => bytes.readUInt32LE(at));
  const sections = table(offset(wide ? 40 : 32), ...halves(wide ? 58 : 46)).map((at) => bytes.readUInt32LE(at + 4));
  return {
    bits,
    size_bytes: bytes.length,
    isStatic: !segments.includes(kInterpreter) && !segments.includes(kDynamic),
    isStripped: !sections.includes(kSymbols),
  };
}

/** Returns the resident memory of a process, now and at most [MB]. */
export function memoryOf(pid) {
  const status = readFileSync(`/proc/${pid}/status`, "utf8");
  const mb = (name) => (Number(new RegExp(`^${name}:\\s+(\\d+) kB$`, "m").exec(status)[1]) * 1024) / 1e6;
  return { now: mb("VmRSS"), most: mb("VmHWM") };
}
