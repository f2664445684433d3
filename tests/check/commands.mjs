// Commands in the documents exist: each program, sub-command and option of the ```sh blocks of every README.md.
//
//   node tests/check/run.mjs commands     needs the programs in build/dev/bin, or in the folder FORESIGHT_BIN
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { filesBelow } from "./files.mjs";

/** The words of each command line of a document: {line, words}. Comments and continued lines are resolved. */
export function commandsIn(text) {
  const commands = [];
  let fenced = false;
  let begun;
  text.split("\n").forEach((line, index) => {
    if (/^\s*```/.test(line)) fenced = !fenced && /^\s*```(sh|bash)\b/.test(line);
    else if (fenced) {
      begun = { line: begun?.line ?? index + 1, text: `${begun?.text ?? ""}${line.replace(/\\$/, " ")}` };
      if (line.endsWith("\\")) return;
      for (const words of wordsOf(begun.text)) commands.push({ line: begun.line, words });
      begun = undefined;
    }
  });
  return commands;
}

/** The commands of a shell line, between `;`, `|`, `&` and `&&`, each as words without quotes and settings. */
function wordsOf(text) {
  const commands = [[]];
  let word;
  const close = () => {
    if (word !== undefined) commands.at(-1).push(word);
    word = undefined;
  };
  for (const [piece, quoted] of text.matchAll(/'([^']*)'|"[^"]*"|\s+|#.*$|[;|&]+|[^\s'";|&]+/g))
    if (/^\s/.test(piece)) close();
    else if (piece.startsWith("#") && word === undefined) break;
    else if (/^[;|&]/.test(piece)) {
      close();
      commands.push([]);
    } else word = (word ?? "") + (quoted ?? piece.replace(/^"|"$/g, ""));
  close();
  return commands
    .map((words) =>
      words.slice(words.findIndex((each) => !/^[A-Z_]+=/.test(each) && !["nice", "sudo", "env"].includes(each))),
    )
    .filter((words) => words.length && words[0]);
}

/** Returns the names of the sub-commands in a help text. */
const subcommandsIn = (text) =>
  [...(/^Sub-?commands:\n([\s\S]*)/im.exec(text)?.[1] ?? "").matchAll(/^ {2}([a-z][\w-]*)/gm)].map(([, name]) => name);

/** Finds the text that says what a command takes, and whether it has sub-commands. `help(program, subcommand)` is given. */
export function wrongCommands(root, help) {
  const sentences = [];
  for (const path of filesBelow(root).filter((path) => posix.basename(path) === "README.md"))
    for (const { line, words } of commandsIn(readFileSync(join(root, path), "utf8"))) {
      const program = words[0].replace(/^\.\//, "").replace(/^build\/[\w-]+\/bin\//, "");
      const ours = /^(scripts|toolchain)\/[\w-]+$/.test(program) || /^foresight-[a-z]+$/.test(program);
      if (!ours) continue;
      const say = (sentence) => sentences.push(`${path}:${line}: ${sentence}`);
      const general = help(program);
      if (general === undefined) {
        say(`there is no program ${program}`);
        continue;
      }
      // a program with a list of sub-commands wants one of them first
      const names = subcommandsIn(general);
      let text = general;
      if (names.length && words.length > 1 && !words[1].startsWith("-")) {
        if (!names.includes(words[1])) {
          say(`${program} has no command '${words[1]}'; there are ${names.join(", ")}`);
          continue;
        }
        const own = help(program, words[1]) ?? "";
        text += own;
        // a sub-command may have its own
        if (subcommandsIn(own).includes(words[2])) text += help(program, `${words[1]} ${words[2]}`) ?? "";
      }
      const end = words.indexOf("--");
      // scripts/fresh-root runs another command, whose options are its own
      const nested = words.findIndex((word, index) => index > 0 && /^(scripts|toolchain)\//.test(word));
      const own = words.slice(1, [end, nested].filter((index) => index > 0).sort((a, b) => a - b)[0]);
      for (const option of own.filter((word) => /^--?[a-z]/.test(word)).map((word) => word.split("=")[0]))
        if (!new RegExp(`(^|[^\\w-])${option}(?![\\w-])`, "m").test(text))
          say(`${words.slice(0, names.length ? 2 : 1).join(" ")} has no option ${option}`);
    }
  return sentences;
}

/** The check, with the programs of build/dev/bin and the scripts' own help. */
export function commands(root) {
  const bin = process.env.FORESIGHT_BIN ?? join(root, "build/dev/bin");
  const texts = new Map();
  const help = (program, subcommand) => {
    const key = `${program} ${subcommand ?? ""}`;
    if (!texts.has(key)) {
      const file = program.includes("/") ? join(root, program) : join(bin, program);
      const words = [...(subcommand?.split(" ") ?? []), "--help"];
      const { stdout, stderr } = existsSync(file) ? spawnSync(file, words, { encoding: "utf8", timeout: 60_000 }) : {};
      texts.set(key, stdout === undefined ? undefined : `${stdout}\n${stderr}`);
    }
    return texts.get(key);
  };
  return wrongCommands(root, help);
}
