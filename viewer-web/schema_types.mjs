// The types of our memory objects for the viewer's code: src/memory/schema.d.ts, which `npm run check` writes before it
// compares. The types leave nothing in the built page, which decodes by the schemas that its server announces.
//
//   node schema_types.mjs

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { objectsOf, protoFiles, schemaOfFiles } from "./schema.mjs";

/** Objects that a service of the runtime announces (robot/app/services) or foresight-lab truth, so memory.h does not have them. */
const kOfServices = [
  { topic: "live_parameters", message: "foresight.LiveParameters" },
  { topic: "/truth/simulated", message: "foresight.GroundTruth" },
];

const kBig = ["int64", "uint64", "sint64", "fixed64", "sfixed64"];
const kSmall = ["int32", "uint32", "sint32", "fixed32", "sfixed32", "float", "double"];
const kPlain = { bool: "boolean", string: "string", bytes: "Uint8Array" };
const kImported = /^google\.protobuf\./;

/** "foresight.Image.Encoding" becomes Image_Encoding, and "foxglove.Log" becomes foxglove_Log. */
const identifierOf = (name) => name.replace(/^foresight\./, "").replaceAll(".", "_");

/** Returns the text of the file. Throws a sentence about a type that no file declares. */
export function typesOf({ messages, enums }, objects) {
  const known = new Set([...messages, ...enums].map(({ name }) => name));
  for (const { topic, message } of objects)
    if (!known.has(message))
      throw new Error(`the object '${topic}' has the message ${message}, which no .proto declares`);
  const entries = (those) => those.map(({ topic, message }) => `  ${JSON.stringify(topic)}: ${identifierOf(message)};`);
  return [
    "// Made by schema_types.mjs from proto/ and robot/memory/memory.h; not to be edited.",
    "// A field may be absent: each type has what a robot may send. Integers of 64 bits are bigint.",
    'import type { EnumValue } from "./value";',
    ...messages.map((message) => typeOf(message, known)),
    ...enums.map(
      ({ name, values }) => `export type ${identifierOf(name)} = EnumValue<${values.map(quoted).join(" | ")}>;`,
    ),
    "/** The objects of a robot by name. */",
    ["export type RobotObjects = {", ...entries(objects.filter(({ topic }) => !topic.startsWith("/"))), "};"].join(
      "\n",
    ),
    "/** The objects that belong to no robot by topic. */",
    ["export type WorldObjects = {", ...entries(objects.filter(({ topic }) => topic.startsWith("/"))), "};"].join("\n"),
    "export type RobotObject = keyof RobotObjects;",
    "export type WorldObject = keyof WorldObjects;",
    "/** The names of all messages in schemas. */",
    `export type MessageName = ${messages.map(({ name }) => quoted(name)).join(" | ")};`,
    "",
  ].join("\n");
}

const quoted = (text) => JSON.stringify(text);

function typeOf({ name, fields }, known) {
  const lines = fields.flatMap(({ name: field, type, repeated, remark }) => [
    ...(remark ? [`  /** ${remark.replaceAll("*/", "* /")} */`] : []),
    `  ${field}?: ${valueOf(type, name, known)}${repeated ? "[]" : ""};`,
  ]);
  return [`export type ${identifierOf(name)} = {`, ...lines, "};"].join("\n");
}

function valueOf(type, message, known) {
  if (kBig.includes(type)) return "bigint";
  if (kSmall.includes(type)) return "number";
  if (Object.hasOwn(kPlain, type)) return kPlain[type];
  if (kImported.test(type)) return "Record<string, unknown>";
  // from the innermost message outwards
  for (let scope = message; ; scope = scope.slice(0, Math.max(0, scope.lastIndexOf(".")))) {
    const name = scope ? `${scope}.${type}` : type;
    if (known.has(name)) return identifierOf(name);
    if (!scope) throw new Error(`${message} has a field of the type ${type}, which no .proto declares`);
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  if (process.argv.length > 2) {
    console.error("usage: node schema_types.mjs");
    process.exit(2);
  }
  const path = (relative) => fileURLToPath(new URL(relative, import.meta.url));
  const files = ["foresight", "foxglove"].flatMap((folder) => protoFiles(path(`../proto/${folder}`)));
  const objects = objectsOf(readFileSync(path("../robot/memory/memory.h"), "utf8"));
  try {
    writeFileSync(path("src/memory/schema.d.ts"), typesOf(schemaOfFiles(files), [...objects, ...kOfServices]));
  } catch (error) {
    console.error(`schema_types: ${error.message}`);
    process.exit(2);
  }
}
