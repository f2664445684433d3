// Calls of the standard library that throw where a function with a Result or an error code does the same: files, folders and
// threads. A missing file or a full process table must not end a program.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow } from "./files.mjs";

/** The folders of the programs. Tests may throw. */
const folders = ["robot", "sim"];

/** Files that may call them: start_thread() turns the exception into a Result. */
const allowed = ["robot/core/thread.cpp", "sim/contest/series.cpp"];

const functions =
  "absolute|canonical|weakly_canonical|copy|copy_file|create_directory|create_directories|create_symlink|current_path|equivalent|" +
  "exists|file_size|hard_link_count|is_block_file|is_character_file|is_directory|is_empty|is_fifo|is_other|is_regular_file|" +
  "is_socket|is_symlink|last_write_time|permissions|proximate|read_symlink|relative|remove|remove_all|rename|resize_file|space|" +
  "status|symlink_status|temp_directory_path|(?:recursive_)?directory_iterator";
const call = new RegExp(`\\b(?:std::filesystem|fs)::(${functions})(?: \\w+)?[({]`, "g");

/** Functions of std::filesystem::directory_entry, called without an error code. */
const ofEntry =
  /\b(?:entry|file|folder|item)(?:\.|->)(is_directory|is_regular_file|is_symlink|is_fifo|is_socket|is_other|file_size|last_write_time|symlink_status|hard_link_count)\(\)/g;

const phrases = [
  {
    found: /\bfor \((?:const )?auto&* \w+ : [^;]*directory_iterator/g,
    instead: "list_folder() of robot/core/folder.h",
  },
  { found: /\bstd::j?thread(?: \w+)?[({]|\bstd::jthread\b/g, instead: "start_thread() of robot/core/thread.h" },
  { found: /\bstd::async\((?!kPolicy\b)/g, instead: "start_thread(), or a policy that includes std::launch::deferred" },
];

/** The text without comments; lines keep their numbers. */
const codeOf = (text) => text.replace(/"(?:[^"\\\n]|\\.)*"|\/\/.*/g, (part) => (part.startsWith("//") ? "" : '""'));

/** The last argument of the call whose parenthesis opens just before `from`. */
function lastArgument(code, from) {
  let depth = 1;
  let begin = from;
  for (let at = from; at < code.length; ++at) {
    const letter = code[at];
    if ("({[".includes(letter)) ++depth;
    else if (")}]".includes(letter) && --depth === 0) return code.slice(begin, at).trim();
    else if (letter === "," && depth === 1) begin = at + 1;
  }
  return "";
}

/** A file_status that was read before: a question about it throws nothing. */
const readStatus = /^(?:status|(?:std::filesystem|fs)::(?:symlink_)?status\(.*\))$/;

/** Names of all error codes in the file. */
const errorCodesOf = (code) =>
  new Set([...code.matchAll(/\berror_code&? ((?:\w+)(?:, \w+)*)/g)].flatMap(([, names]) => names.split(", ")));

/** Findings in one file, each [offset, sentence]. */
export function throwingCalls(text) {
  const code = codeOf(text);
  const codes = errorCodesOf(code);
  const findings = [];
  for (const match of code.matchAll(call)) {
    const last = lastArgument(code, match.index + match[0].length);
    if (!codes.has(last) && !readStatus.test(last))
      findings.push([match.index, `${match[1]}() throws: expected a std::error_code as its last argument`]);
  }
  for (const match of code.matchAll(ofEntry))
    findings.push([match.index, `${match[1]}() throws: expected a std::error_code as its argument`]);
  for (const { found, instead } of phrases)
    for (const match of code.matchAll(found)) findings.push([match.index, `'${match[0]}' throws: expected ${instead}`]);
  const lineOf = (offset) => code.slice(0, offset).split("\n").length;
  return findings.sort(([a], [b]) => a - b).map(([offset, sentence]) => [lineOf(offset), sentence]);
}

/** A sentence per throwing call in the programs. */
export function throwing(root) {
  return folders
    .flatMap((folder) => filesBelow(root, folder))
    .filter((path) => /\.(cpp|h)$/.test(path) && !allowed.includes(path))
    .flatMap((path) =>
      throwingCalls(readFileSync(join(root, path), "utf8")).map(([line, sentence]) => `${path}:${line}: ${sentence}`),
    );
}
