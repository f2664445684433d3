// Comments and documents are plain English: refuses phrases that STYLE.md refuses, and sentences that are too long.
//
//   node tests/check/run.mjs prose             findings outside of `notYet`
//   node tests/check/run.mjs prose FOLDER…     all findings in these folders and below
//   node tests/check/run.mjs prose --counts    how many findings each folder has
//   node tests/check/run.mjs prose --shrink    takes folders without findings out of `notYet`
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { proseOf } from "./comments.mjs";
import { filesBelow } from "./files.mjs";

/** Folders that are not rewritten yet; their files are passed over, not those of folders below. It shrinks to nothing. */
export const notYet = [
  // first
  // last
];

/** Most words in a sentence. */
const mostWords = 30;

/** Refused phrases: a regular expression, and what to write instead. `sentence` rules look at whole sentences. */
const phrases = [
  {
    found: /^(what|who|whoever|whatever|whichever|that which|of which)\b(?! to )/i,
    instead: "a noun as the subject",
    sentence: true,
  },
  {
    found: /; (what|who|whoever|whatever|that which|of which)\b(?! to )/i,
    instead: "a noun as the subject",
    sentence: true,
  },
  { found: /\bwhoever\b/i, instead: '"anyone who", "a client that" or the noun' },
  { found: /\bso many\b(?!.*\bthat\b)/i, instead: '"this many" or the number\'s name' },
  { found: /\bof late\b/i, instead: '"recently"' },
  { found: /\btells\b(?!.*\b(apart|from)\b)/i, instead: '"reports", "shows" or "sends"' },
  { found: /\bcom(e|es|ing) out as\b/i, instead: '"is"' },
  { found: /\b(has|have|had) the harm\b/i, instead: "the consequence" },
  { found: /\bagain is nothing\b/i, instead: '"a second call has no effect"' },
  { found: /\b(where|wherever|when) nothing is\b/i, instead: "the condition" },
  { found: /\b(has|have) it that\b/i, instead: '"says"' },
  { found: /\b(is|are) had\b/i, instead: '"exists" or "is known"' },
  { found: /\bnobody is here to\b/i, instead: '"there is no terminal"' },
  { found: /\bthe same again\b/i, instead: "the thing itself" },
  { found: /\bthat (is|are) none\b/i, instead: '"no real …" or "a stand-in"' },
  { found: /\b(whereof|wherein|thereof|therein|whereupon)\b/i, instead: '"of it", "in it" or "then"' },
];

/** The same word twice, except for allowed ones. */
const doubled = /\b(?!(?:that|had)\b)([a-z]{2,}) \1\b(?![-'])/i;

const abbreviation = /(?:\b(?:e\.g|i\.e|etc|vs|cf|approx|no|st|fig|p)|\b[A-Z])\.$/i;

/** The sentences of a paragraph. */
export function sentencesOf(text) {
  const sentences = [];
  let sentence = "";
  for (const part of text.split(/(?<=[.!?…][)"'”\]]*)\s+/)) {
    sentence = sentence ? `${sentence} ${part}` : part;
    if (abbreviation.test(sentence)) continue;
    sentences.push(sentence);
    sentence = "";
  }
  if (sentence) sentences.push(sentence);
  return sentences;
}

/** How many words a sentence has; signs and numbers with their unit are no words of their own. */
const wordsIn = (sentence) => sentence.split(/\s+/).filter((word) => /[A-Za-z]{2}|\b[aAI]\b|\d/.test(word)).length;

/** Faults of one block of prose, each without its place. */
export function faultsIn({ kind, text }) {
  const faults = [];
  for (const sentence of sentencesOf(text)) {
    const question = /\?[)"'”]*$/.test(sentence);
    for (const { found, instead, sentence: whole } of phrases) {
      if (whole && (question || kind !== "text")) continue;
      const match = found.exec(sentence);
      if (match) faults.push(`"${sentence.slice(match.index, match.index + 40).trim()}…": write ${instead}`);
    }
    const twice = doubled.exec(sentence);
    if (twice) faults.push(`"${twice[0]}": the same word twice`);
    const words = wordsIn(sentence);
    if (kind === "text" && words > mostWords)
      faults.push(
        `"${sentence.split(" ").slice(0, 5).join(" ")} …": ${words} words in a sentence, at most ${mostWords}`,
      );
  }
  return faults;
}

/** All findings below `root`: {folder, sentence}, in the order of the files. */
export function findings(root, folders = [""]) {
  const within = (path) =>
    folders.some((folder) => folder === "" || folder === "." || path === folder || path.startsWith(`${folder}/`));
  return filesBelow(root)
    .filter((path) => within(path) && !path.startsWith("tests/fuzz/corpus/"))
    .flatMap((path) =>
      proseOf(path, readFileSync(join(root, path), "utf8")).flatMap((block) =>
        faultsIn(block).map((fault) => ({ folder: posix.dirname(path), sentence: `${path}:${block.line}: ${fault}` })),
      ),
    );
}

/** One sentence per finding outside of the folders `passedOver`, and one per folder there that has none. */
export function unplain(root, passedOver = notYet) {
  const all = findings(root);
  const sentences = all.filter(({ folder }) => !passedOver.includes(folder)).map(({ sentence }) => sentence);
  for (const folder of passedOver.filter((folder) => !all.some((finding) => finding.folder === folder)))
    sentences.push(
      `tests/check/prose.mjs: notYet names ${folder}, which has no findings; node tests/check/run.mjs prose --shrink takes it out`,
    );
  return sentences;
}

/** Lines "COUNT FOLDER", and the sum. */
function countsOf(all) {
  const counts = new Map();
  for (const { folder } of all) counts.set(folder, (counts.get(folder) ?? 0) + 1);
  return [
    ...[...counts].sort().map(([folder, count]) => `${String(count).padStart(5)} ${folder}`),
    `${String(all.length).padStart(5)} in all`,
  ];
}

/** Writes `notYet` anew in this file: only the folders of the list that still have findings. */
function shrink(root, folders) {
  const file = fileURLToPath(import.meta.url);
  const list = folders.map((folder) => `  "${folder}",\n`).join("");
  const text = readFileSync(file, "utf8");
  writeFileSync(
    file,
    text.replace(/(\n {2}\/\/ first\n)[\s\S]*?( {2}\/\/ last\n)/, (_, first, last) => first + list + last),
  );
}

/** The command: prints counts and findings, returns the sentences of the check. */
export function prose(root, words = []) {
  const [option] = words;
  if (option === "--counts" || option === "--shrink") {
    const all = findings(root);
    const having = [...new Set(all.map(({ folder }) => folder))].sort();
    if (option === "--shrink")
      shrink(
        root,
        having.filter((folder) => notYet.includes(folder)),
      );
    else console.log(countsOf(all).join("\n"));
    return [];
  }
  if (words.length === 0) return unplain(root);
  const folders = words.map((word) => posix.normalize(word).replace(/\/$/, ""));
  const absent = folders.filter((folder) => !existsSync(join(root, folder)));
  if (absent.length) return absent.map((folder) => `there is no folder or file ${folder}`);
  const all = findings(root, folders);
  console.log(countsOf(all).join("\n"));
  return all.map(({ sentence }) => sentence);
}
