// The comments of the schemas' fields for the viewer: descriptors on the wire carry no comments.
//
// A plugin for Vite: `import comments from "virtual:schema_comments"` gives {message: {field: [unit, comment]}}.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** Reads one .proto file as we write them: a field and its comment on one line, the unit in brackets at its beginning. */
export function commentsOf(text) {
  const found = {};
  const scope = []; // names of messages, "" for what is none
  const package_name = /^package (\w+);/m.exec(text)?.[1] ?? "";
  for (const line of text.split("\n")) {
    const code = line.replace(/\/\/.*/, "");
    const opened = /^\s*(message|enum|oneof)\s+(\w+)\s*\{/.exec(code);
    if (opened) scope.push({ kind: opened[1], name: opened[2] });
    const field = /^\s*(?:optional |repeated )?[\w.]+\s+(\w+)\s*=\s*\d+\s*;\s*(?:\/\/\s*(.*))?$/.exec(line);
    const within = scope.filter(({ kind }) => kind === "message");
    if (field && within.length > 0 && scope.at(-1).kind !== "enum") {
      const [, name, comment = ""] = field;
      const [, unit = "", words = ""] = /^(?:\[([^\]]+)\])?\s*(.*)$/.exec(comment);
      if (comment)
        (found[[package_name, ...within.map((message) => message.name)].join(".")] ??= {})[name] = [
          unitOf(unit),
          words,
        ];
    }
    for (
      let closed = (code.match(/\}/g) ?? []).length - (code.match(/\{/g) ?? []).length + (opened ? 1 : 0);
      closed > 0;
      --closed
    )
      scope.pop();
  }
  return found;
}

/** "m, robot" is metres of a frame; "ns since the epoch, capture time" is a time; ranges and sentences are no units. */
function unitOf(bracket) {
  const unit = bracket.split(",")[0].trim();
  if (/^ns since/.test(unit)) return "ns";
  return /^[\w/²³°%µ·]{1,12}$/.test(unit) && !/^\d+\.\.\d*/.test(unit) ? unit : "";
}

export function schemaComments(folder) {
  const id = "virtual:schema_comments";
  return {
    name: "schema-comments",
    resolveId: (source) => (source === id ? `\0${id}` : undefined),
    load(source) {
      if (source !== `\0${id}`) return undefined;
      const files = readdirSync(folder)
        .filter((name) => name.endsWith(".proto"))
        .sort();
      for (const name of files) this.addWatchFile?.(join(folder, name));
      const all = Object.assign({}, ...files.map((name) => commentsOf(readFileSync(join(folder, name), "utf8"))));
      return `export default ${JSON.stringify(all)};`;
    },
  };
}
