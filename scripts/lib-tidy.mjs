// Lists the files that clang-tidy has not passed yet, for scripts/check.
//
//   node scripts/lib-tidy.mjs BUILD_FOLDER TIDY_FOLDER
//
// Prints a line `MARK FILE` for each file that the compiler reads and that must be checked: one of our sources, or one that
// includes several of them. When clang-tidy passes FILE, make the empty file MARK: then FILE is not printed again. It is
// printed again after a change of the file, a file that it includes, its compile command, the configuration or clang-tidy
// itself. TIDY_FOLDER also receives the compile_commands.json to use.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative, resolve } from "node:path";

const [buildFolder, tidyFolder] = process.argv.slice(2).map((path) => resolve(path));
const root = resolve(".");
mkdirSync(join(tidyFolder, "passed"), { recursive: true });

// tests are left out: checking them takes twice as long as all the rest, and their faults show when they run
const isOurs = (path) => [root, buildFolder].some((folder) => /^(robot|sim)\//.test(relative(folder, path)));
const commands = JSON.parse(readFileSync(join(buildFolder, "compile_commands.json"), "utf8"))
  .filter(({ file }) => isOurs(file))
  // clang does not know these options of gcc
  .map((entry) => ({ ...entry, command: entry.command.replace(/ (-Wno-subobject-linkage|-fno-thread-jumps)\b/g, "") }));
writeFileSync(join(tidyFolder, "compile_commands.json"), JSON.stringify(commands, null, 1));

/** Returns the headers of each object file as ninja recorded them: object → paths. */
function headersOfObjects() {
  const headers = new Map();
  let object;
  const printed = execFileSync("ninja", ["-C", buildFolder, "-t", "deps"], { encoding: "utf8", maxBuffer: 1 << 30 });
  for (const line of printed.split("\n")) {
    const start = /^(\S.*): #deps /.exec(line);
    if (start) headers.set((object = start[1]), []);
    else if (line.startsWith("    ")) headers.get(object)?.push(resolve(buildFolder, line.trim()));
  }
  return headers;
}

const hashes = new Map();
/** Returns the hash of the file's content, or "" if the file is gone. */
function hashOf(path) {
  if (!hashes.has(path))
    hashes.set(path, existsSync(path) ? createHash("sha256").update(readFileSync(path)).digest("hex") : "");
  return hashes.get(path);
}

const headers = headersOfObjects();
const version = execFileSync("clang-tidy", ["--version"], { encoding: "utf8" });
const configuration = readFileSync(join(root, ".clang-tidy"), "utf8");
for (const { file, command, output } of commands) {
  const object = output ?? / -o (\S+)/.exec(command)?.[1];
  // only our own and generated headers count: those of the system change only with its packages
  const used = (headers.get(object) ?? []).filter((path) => path.startsWith(`${root}/`)).sort();
  const key = createHash("sha256").update(
    JSON.stringify([version, configuration, command, ...[file, ...used].map(hashOf)]),
  );
  const mark = join(tidyFolder, "passed", key.digest("hex"));
  if (!existsSync(mark)) console.log(`${mark} ${file}`);
}
