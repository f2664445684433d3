// Descriptors of our .proto files without a compiler, for servers that tests write. Reads them as we write them: one field,
// value or end of a message per line.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { require, root } from "./support.mjs";

const { create, createFileRegistry, fromJson, toBinary } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema, file_google_protobuf_timestamp } = require("@bufbuild/protobuf/wkt");

const kScalars = "double float int64 uint64 int32 fixed64 fixed32 bool string bytes uint32".split(" ");

/** The messages and enums of one file, as a FileDescriptorProto in JSON. */
function fileOf(path) {
  const text = readFileSync(join(root, "proto", path), "utf8");
  const file = {
    name: path,
    package: /^package (\w+);/m.exec(text)[1],
    syntax: "proto3",
    dependency: [...text.matchAll(/^import "([^"]+)";/gm)].map(([, name]) => name),
    messageType: [],
    enumType: [],
  };
  const scope = [];
  for (const line of text.split("\n")) {
    const code = line.replace(/\/\/.*/, "").trim();
    const [, kind, name] = /^(message|enum) (\w+) \{/.exec(code) ?? [];
    const inner = scope.at(-1);
    if (kind === "message") {
      scope.push({ name, field: [], nestedType: [], enumType: [], oneofDecl: [] });
      (inner?.nestedType ?? file.messageType).push(scope.at(-1));
    } else if (kind === "enum") {
      scope.push({ name, value: [] });
      (inner?.enumType ?? file.enumType).push(scope.at(-1));
    } else if (code === "}") scope.pop();
    else if (inner?.value) {
      const [, value, number] = /^(\w+) = (\d+);/.exec(code) ?? [];
      if (value) inner.value.push({ name: value, number: Number(number) });
    } else if (inner) addField(inner, code);
  }
  return file;
}

function addField(message, code) {
  const [, label, type, name, number] = /^(optional |repeated )?([\w.]+) (\w+) = (\d+)/.exec(code) ?? [];
  if (!name) return;
  const field = {
    name,
    jsonName: name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase()),
    number: Number(number),
    label: label === "repeated " ? "LABEL_REPEATED" : "LABEL_OPTIONAL",
  };
  if (kScalars.includes(type)) field.type = `TYPE_${type.toUpperCase()}`;
  else field.typeName = type; // the names of the files are unique, so that the scope says which it is
  if (label === "optional ") {
    Object.assign(field, { proto3Optional: true, oneofIndex: message.oneofDecl.length });
    message.oneofDecl.push({ name: `_${name}` });
  }
  message.field.push(field);
}

/** Gives each field of a message or enum its type's complete name, from the innermost scope outwards. */
function resolve(file) {
  const kinds = new Map();
  const walk = (part, scope, act) => {
    const name = `${scope}.${part.name}`;
    act(part, name);
    for (const kind of part.enumType ?? []) kinds.set(`${name}.${kind.name}`, "TYPE_ENUM");
    for (const nested of part.nestedType ?? []) walk(nested, name, act);
  };
  const all = (act) => file.messageType.forEach((part) => walk(part, `.${file.package}`, act));
  all((_, name) => kinds.set(name, "TYPE_MESSAGE"));
  for (const kind of file.enumType) kinds.set(`.${file.package}.${kind.name}`, "TYPE_ENUM");
  all((message, name) => {
    for (const field of message.field.filter(({ typeName }) => typeName)) {
      let scope = name;
      while (scope && !kinds.has(`${scope}.${field.typeName}`)) scope = scope.slice(0, scope.lastIndexOf("."));
      field.type = scope ? kinds.get(`${scope}.${field.typeName}`) : "TYPE_MESSAGE";
      field.typeName = `${scope}.${field.typeName}`;
    }
  });
  return file;
}

/** A message of a file without imports, except that of the time: its schema for a channel, and its bytes from JSON. */
export function messageOf(path, name) {
  const set = fromJson(FileDescriptorSetSchema, { file: [resolve(fileOf(path))] });
  if (set.file[0].dependency.length > 0) set.file.unshift(file_google_protobuf_timestamp.proto);
  const registry = createFileRegistry(set);
  const schema = registry.getMessage(name);
  return {
    schemaName: name,
    schema: Buffer.from(toBinary(FileDescriptorSetSchema, set)).toString("base64"),
    bytes: (json) => toBinary(schema, fromJson(schema, json, { registry })),
    /** From values as protobuf-es has them, for bytes that JSON would blow up. */
    bytesOf: (values) => toBinary(schema, create(schema, values)),
  };
}
