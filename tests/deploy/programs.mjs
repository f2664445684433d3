// Programs to install: the real one, another "build" of it, and some faulty ones.
import { execFileSync } from "node:child_process";
import { chmodSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { bin } from "../e2e/support.mjs";

const buildOf = (path) => execFileSync(path, ["--version"], { encoding: "utf8" }).trim();

function executable(path, content) {
  writeFileSync(path, content);
  chmodSync(path, 0o755);
  return path;
}

let made;

/**
 * Returns {first, second}, each {path, build}, which differ only in the build that they report. Also returns the paths
 * `crashing` (prints its build, then ends with status 3), `lying` (answers as the version before) and `foreign` (for another
 * processor). They are made once and removed when this process ends.
 */
export function makePrograms() {
  if (!made) {
    const folder = mkdtempSync(join(tmpdir(), "foresight-programs-"));
    process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
    made = makeIn(folder);
  }
  return made;
}

function makeIn(folder) {
  const first = { path: join(folder, "first") };
  execFileSync("strip", ["-o", first.path, join(bin, "foresight-robot")]);
  first.build = buildOf(first.path);

  // compilers make words of eight bytes of it, the last of which may overlap the one before: but not in its first four
  const word = first.build.slice(0, 8);
  const bytes = readFileSync(first.path);
  for (let at = bytes.indexOf(word); at >= 0; at = bytes.indexOf(word, at + 8)) bytes.write("5ec0", at, "latin1");
  const second = { path: executable(join(folder, "second"), bytes), build: `5ec0${first.build.slice(4)}` };
  if (buildOf(second.path) !== second.build)
    throw new Error(`expected a program of build ${second.build}, got ${buildOf(second.path)}`);

  const crashing = executable(
    join(folder, "crashing"),
    '#!/bin/sh\nif [ "$1" = --version ]; then echo crashing1; exit; fi\necho "the horizon is missing" >&2\nexit 3\n',
  );
  const lying = executable(
    join(folder, "lying"),
    '#!/bin/sh\nif [ "$1" = --version ]; then echo lying1; exit; fi\nexec "$HOME/foresight/previous/bin/foresight-robot" "$@"\n',
  );
  const foreign = executable(
    join(folder, "foreign"),
    Buffer.concat([Buffer.from("\x7fELF\x02\x01\x01", "latin1"), Buffer.alloc(200)]),
  );
  return { first, second, crashing, lying, foreign };
}
