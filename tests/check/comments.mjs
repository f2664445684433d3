// The prose of a file: comments of code and scripts, paragraphs of Markdown.
//
// Each reader returns blocks {line, text, kind}: one paragraph, list item, table row or trailing comment each.
// `kind` is "text", "heading" or "table"; `line` counts from 1.
import { posix } from "node:path";

/** `text` with each piece of code as one word, so that dots within code end no sentence. */
const withoutCode = (text) => text.replace(/``[^`]+``|`[^`]*`/g, (code) => `\`${code.replace(/[^\w]+/g, "_")}\``);

/**
 * Joins lines of one comment or document into blocks. `lines` are {line, text}, the text with its indentation.
 *
 * A blank line, a list item, a tag and a change of indentation begin a new block. Lines that are indented deeper than a
 * list item or table row belong to it.
 */
export function blocksOf(lines) {
  const blocks = [];
  let block;
  for (const { line, text: raw } of lines) {
    const text = raw.trimEnd();
    const words = text.trim();
    if (!words || /^[-=*_#/~+|]{3,}$/.test(words)) {
      block = undefined;
      continue;
    }
    const indent = text.length - text.trimStart().length;
    const item = /^([-*•]|\d+[.)]|@\w+) /.test(words);
    const columns = / {3,}/.test(words);
    const continues = block && !item && (block.hangs ? indent > block.indent : indent === block.indent && !columns);
    if (continues) block.text += ` ${words.replace(/ {3,}/g, " ")}`;
    else {
      const kind = words.split(/ {3,}/).length > 2 ? "table" : "text";
      // the first column is a name, the text stands behind it
      const prose =
        columns && kind === "text" ? words.replace(/^.*? {3,}/, "") : words.replace(/^([-*•]|\d+[.)]) /, "");
      block = { line, indent, hangs: item || columns, kind, text: prose };
      blocks.push(block);
    }
  }
  return blocks.map(({ line, kind, text }) => ({ line, kind, text: withoutCode(text) }));
}

/** Index behind a string that begins at `start` with the quote found there. */
function endOfString(text, start) {
  const quote = text[start];
  let at = start + 1;
  while (at < text.length && text[at] !== quote) {
    if (text[at] === "\\") at += 1;
    else if (text[at] === "\n" && quote !== "`") return at;
    else if (quote === "`" && text.startsWith("${", at)) {
      for (let depth = 1, inner = at + 2; inner < text.length && depth;) {
        if (text[inner] === "{") depth += 1;
        if (text[inner] === "}") depth -= 1;
        inner = depth && /["'`]/.test(text[inner]) ? endOfString(text, inner) : inner + 1;
        at = inner - 1;
      }
    }
    at += 1;
  }
  return at + 1;
}

/** Index behind a regular expression that begins at `start`, or undefined if that is a division. */
function endOfRegex(text, start) {
  const before = text.slice(Math.max(0, start - 20), start).trimEnd();
  if (before && !/[(,=:[!&|?{};>]$|\b(return|case|of|in)$/.test(before)) return undefined;
  let inClass = false;
  for (let at = start + 1; at < text.length && text[at] !== "\n"; at += 1) {
    if (text[at] === "\\") at += 1;
    else if (text[at] === "[") inClass = true;
    else if (text[at] === "]") inClass = false;
    else if (text[at] === "/" && !inClass) return at + 1;
  }
  return undefined;
}

/** Blocks of the comments of C, C++, protobuf, TypeScript and JavaScript, both kinds. */
export function slashComments(text, { regexes = false } = {}) {
  const blocks = [];
  let run = []; // whole-line `//` comments below each other, or one trailing comment and what continues it
  const flush = () => {
    blocks.push(...blocksOf(run));
    run = [];
  };
  let line = 1;
  let lineStart = 0;
  let at = 0;
  const advance = (to) => {
    for (; at < to; at += 1)
      if (text[at] === "\n") {
        line += 1;
        lineStart = at + 1;
      }
  };
  while (at < text.length) {
    if (text.startsWith("//", at)) {
      const end = text.indexOf("\n", at) < 0 ? text.length : text.indexOf("\n", at);
      const column = at - lineStart;
      const trailing = text.slice(lineStart, at).trim() !== "";
      const previous = run.at(-1);
      if (previous && (trailing || previous.line !== line - 1 || previous.column !== column)) flush();
      run.push({ line, column, text: text.slice(at, end).replace(/^\/\/[/!]?<?/, "") });
      advance(end);
    } else if (text.startsWith("/*", at)) {
      const end = text.indexOf("*/", at + 2) < 0 ? text.length : text.indexOf("*/", at + 2);
      flush();
      blocks.push(
        ...blocksOf(
          text
            .slice(at, end)
            .split("\n")
            .map((words, index) => ({ line: line + index, text: words.replace(/^\s*\/?\*+!?/, "") })),
        ),
      );
      advance(end + 2);
    } else if (/R"/.test(text.slice(at, at + 2)) && /^R"[^\s()\\]{0,16}\(/.test(text.slice(at, at + 20))) {
      const close = `)${/^R"([^(]*)\(/.exec(text.slice(at, at + 20))[1]}"`;
      const end = text.indexOf(close, at);
      advance(end < 0 ? text.length : end + close.length);
    } else if (
      text[at] === '"' ||
      (text[at] === "`" && regexes) ||
      (text[at] === "'" && !/[0-9a-fA-F]/.test(text[at - 1] ?? ""))
    ) {
      advance(Math.min(text.length, endOfString(text, at)));
    } else if (text[at] === "/" && regexes) {
      advance(endOfRegex(text, at) ?? at + 1);
    } else advance(at + 1);
  }
  flush();
  return blocks;
}

/** Blocks of the `#` comments of scripts, Python, CMake and lists, and of Python's docstrings. */
export function hashComments(text) {
  const blocks = [];
  let run = [];
  const flush = () => {
    blocks.push(...blocksOf(run));
    run = [];
  };
  let docstring;
  text.split("\n").forEach((line, index) => {
    const number = index + 1;
    if (docstring) {
      const end = line.indexOf('"""');
      docstring.push({ line: number, text: end < 0 ? line : line.slice(0, end) });
      if (end < 0) return;
      blocks.push(...blocksOf(docstring));
      docstring = undefined;
      return;
    }
    const opened = /^(\s*)[rbu]?"""(.*)$/.exec(line);
    const [, whole] = /^\s*#(?!!)(.*)$/.exec(line) ?? [];
    const [, trailing] = /\s{1,}# (.*)$/.exec(line) ?? [];
    if (opened) {
      flush();
      const [, indent, words] = opened;
      const end = words.indexOf('"""');
      if (end >= 0) blocks.push(...blocksOf([{ line: number, text: words.slice(0, end) }]));
      else docstring = [{ line: number, text: indent + words }];
    } else if (whole !== undefined) run.push({ line: number, text: whole });
    else {
      flush();
      if (trailing !== undefined) blocks.push(...blocksOf([{ line: number, text: trailing }]));
    }
  });
  flush();
  return blocks;
}

/** Blocks of a Markdown document; code between ``` is left out, each row of a table is a block. */
export function markdown(text) {
  const blocks = [];
  let run = [];
  const flush = () => {
    blocks.push(...blocksOf(run));
    run = [];
  };
  let fenced = false;
  text.split("\n").forEach((line, index) => {
    if (/^\s*(```|~~~)/.test(line)) fenced = !fenced;
    else if (fenced) return;
    else if (/^#+ /.test(line)) blocks.push({ line: index + 1, kind: "heading", text: line.replace(/^#+ /, "") });
    else if (/^\s*\|/.test(line)) {
      for (const cell of line.split("|").map((cell) => cell.trim()))
        if (/\w/.test(cell)) blocks.push({ line: index + 1, kind: "table", text: withoutCode(cell) });
    } else {
      run.push({
        line: index + 1,
        text: line.replace(/^(\s*)> /, "$1").replace(/<[^>]*>|!?\[([^\]]*)\]\([^)]*\)/g, "$1"),
      });
      return;
    }
    flush();
  });
  flush();
  return blocks;
}

/** Blocks of the file at `path`, or [] for a file without prose. */
export function proseOf(path, text) {
  const name = posix.basename(path);
  if (/\.(h|hpp|c|cc|cpp|proto)$/.test(name)) return slashComments(text);
  if (/\.(ts|js|mjs)$/.test(name)) return slashComments(text, { regexes: true });
  if (name.endsWith(".svelte"))
    // outside the script there are only <!-- --> comments and, in the style, /* */ ones
    return [...text.matchAll(/<(script|style)[^>]*>([\s\S]*?)<\/\1>|<!--([\s\S]*?)-->/g)].flatMap((part) => {
      const inner = part[2] ?? `/*${part[3]}*/`;
      const first = text.slice(0, part.index + (part[2] === undefined ? 0 : part[0].indexOf(">"))).split("\n").length;
      return slashComments(inner, { regexes: part[1] === "script" }).map((block) => ({
        ...block,
        line: block.line + first - 1,
      }));
    });
  if (name.endsWith(".md")) return markdown(text);
  if (
    /\.(py|sh|cmake)$/.test(name) ||
    name === "CMakeLists.txt" ||
    name === "packages.txt" ||
    /^#!.*\b(ba)?sh\b/.test(text)
  )
    return hashComments(text);
  return [];
}
