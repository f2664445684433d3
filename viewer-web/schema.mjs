// Reads our .proto files, and the table of memory objects in robot/memory/memory.h, as we write them: one field, value or
// end of a message per line. Its users are schema_comments.mjs and schema_types.mjs.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const kField = /^(optional |repeated )?([\w.]+) (\w+) = \d+(?: \[packed = true\])?;(?:\s*\/\/\s*(.*))?$/;
const kValue = /^(\w+) = \d+;/;
const kOpened = /^(message|enum|oneof) (\w+) \{/;
const kNoPart = /^(?:$|\/\/|syntax |import |package |reserved )/;

/**
 * Returns the messages and enums of one file, in its order: {messages: [{name, fields}], enums: [{name, values}]}. Names
 * are complete, "foresight.Image.Encoding". A field has name, type, repeated, unit and comment. Throws a sentence about a
 * line that it cannot read.
 */
export function schemaOf(text, file = "a .proto file") {
  const found = { messages: [], enums: [] };
  const scope = [/^package (\w+);/m.exec(text)?.[1] ?? ""];
  const open = []; // for each brace: the message or enum that it opened; for a oneof its message
  for (const [index, line] of text.split("\n").entries()) {
    const code = line.trim();
    const [, kind, name] = kOpened.exec(code) ?? [];
    if (kind === "oneof") open.push(open.at(-1));
    else if (kind) {
      scope.push(name);
      const part = { name: scope.filter(Boolean).join("."), ...(kind === "enum" ? { values: [] } : { fields: [] }) };
      found[kind === "enum" ? "enums" : "messages"].push(part);
      open.push(part);
    } else if (!code.startsWith("}") && !add(open.at(-1), code))
      throw new Error(
        `${file}:${index + 1}: expected a field, a value or the end of a message on one line, got '${code}'`,
      );
    if (!code.startsWith("}") && !(kind && /\}/.test(code.replace(/\/\/.*/, "")))) continue;
    const closed = open.pop();
    if (!closed) throw new Error(`${file}:${index + 1}: a brace closes nothing`);
    if (open.at(-1) !== closed) scope.pop();
  }
  return found;
}

/** Adds a line to the open message or enum. Returns false if it belongs to none. */
function add(open, code) {
  if (kNoPart.test(code)) return true;
  const value = open?.values && kValue.exec(code);
  if (value) return open.values.push(value[1]);
  const field = open?.fields && kField.exec(code);
  if (!field) return false;
  const [, label = "", type, name, remark = ""] = field;
  const [, bracket = "", comment = ""] = /^(?:\[([^\]]+)\])?\s*(.*)$/.exec(remark);
  return open.fields.push({ name, type, repeated: label === "repeated ", unit: unitOf(bracket), comment, remark });
}

/** "m, robot" is metres of a frame; "ns since the epoch, capture time" is a time; ranges and sentences are no units. */
function unitOf(bracket) {
  const unit = bracket.split(",")[0].trim();
  if (/^ns since/.test(unit)) return "ns";
  return /^[\w/²³°%µ·]{1,12}$/.test(unit) && !/^\d+\.\.\d*/.test(unit) ? unit : "";
}

/** Returns the paths of the .proto files of a folder, sorted. */
export const protoFiles = (folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith(".proto"))
    .sort()
    .map((name) => join(folder, name));

/** Returns the messages and enums of several files together. */
export function schemaOfFiles(paths) {
  const parts = paths.map((path) => schemaOf(readFileSync(path, "utf8"), path));
  return { messages: parts.flatMap(({ messages }) => messages), enums: parts.flatMap(({ enums }) => enums) };
}

/**
 * Returns the objects of robot/memory/memory.h: [{topic: "ball", message: "foresight.Ball"}]. A topic that starts with "/"
 * belongs to no robot. Throws a sentence about an object whose member is missing.
 */
export function objectsOf(text) {
  const messages = new Map(
    [...text.matchAll(/MemoryObject<pb::(\w+)> (\w+);/g)].map(([, message, member]) => [member, message]),
  );
  return [...text.matchAll(/\bsee\("([^"]+)", (\w+),/g)].map(([, topic, member]) => {
    const message = messages.get(member);
    if (!message) throw new Error(`memory.h: the object '${topic}' shows '${member}', which is no member of Memory`);
    return { topic, message: `foresight.${message}` };
  });
}
