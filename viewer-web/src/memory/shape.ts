// The shape of a message by its schema: names and kinds of fields, before any message has come.

import type { DescField, DescMessage, DescEnum } from "@bufbuild/protobuf";
import type { Channel } from "../source/texts";
import { descriptorOf } from "./decoder";
import { EnumValue, type Fields, type Value } from "./value";

export type Shape =
  | { kind: "number" | "truth" | "text" | "bytes" | "unknown" }
  /** The names of the values by number, as in the schema. */
  | { kind: "enum"; values: ReadonlyMap<number, string> }
  | { kind: "list"; of: Shape }
  /** With `open`, other fields may come too. */
  | { kind: "message"; name: string; open: boolean; field(name: string): Shape | undefined; names(): string[] };

const kUnknown: Shape = { kind: "unknown" };

const known = new WeakMap<Channel, Shape>();

/** Returns the shape of a channel's messages, or "unknown" if it has no schema that can be read. */
export function shapeOf(channel: Channel): Shape {
  let shape = known.get(channel);
  if (!shape) {
    shape = kUnknown;
    try {
      if (channel.encoding === "protobuf") shape = ofMessage(descriptorOf(channel));
    } catch {
      // an unreadable schema: the decoder says why
    }
    known.set(channel, shape);
  }
  return shape;
}

function ofMessage(message: DescMessage): Shape {
  const byName = new Map(message.fields.map((field) => [field.name, field]));
  return {
    kind: "message",
    name: message.typeName,
    open: false,
    field: (name) => {
      const field = byName.get(name);
      return field && ofField(field);
    },
    names: () => [...byName.keys()],
  };
}

function ofField(field: DescField): Shape {
  if (field.fieldKind === "map") return { ...ofFields(new Map(), ""), open: true } as Shape;
  if (field.fieldKind === "list") {
    if (field.listKind === "enum") return { kind: "list", of: ofEnum(field.enum) };
    return { kind: "list", of: field.listKind === "message" ? ofMessage(field.message) : ofScalar(field.scalar) };
  }
  if (field.fieldKind === "enum") return ofEnum(field.enum);
  return field.fieldKind === "message" ? ofMessage(field.message) : ofScalar(field.scalar);
}

const ofEnum = ({ values }: DescEnum): Shape => ({
  kind: "enum",
  values: new Map(values.map(({ number, name }) => [number, name])),
});

/** ScalarType of protobuf: BOOL 8, STRING 9, BYTES 12; all others are numbers. */
const ofScalar = (type: number): Shape => ({
  kind: type === 8 ? "truth" : type === 9 ? "text" : type === 12 ? "bytes" : "number",
});

/** Returns the shape that a message without a schema shows. Later ones may have other fields. */
export function ofFields(fields: Fields, name: string): Shape {
  return {
    kind: "message",
    name,
    open: true,
    field: (field) => (fields.has(field) ? ofValue(fields.get(field), field) : undefined),
    names: () => [...fields.keys()],
  };
}

function ofValue(value: Value, name: string): Shape {
  if (typeof value === "number" || typeof value === "bigint") return { kind: "number" };
  if (typeof value === "boolean") return { kind: "truth" };
  if (typeof value === "string") return { kind: "text" };
  if (value instanceof EnumValue || value === undefined) return kUnknown;
  if (value instanceof Uint8Array) return { kind: "bytes" };
  if (Array.isArray(value)) return { kind: "list", of: ofValue(value[0], name) };
  return ofFields(value, name);
}

/**
 * Returns the words for the values of an enum: in lower case, without the prefix that all names share. STATE_READY and
 * STATE_SET are "ready" and "set".
 */
export function wordsOfEnum(values: ReadonlyMap<number, string>): Map<number, string> {
  const prefix = prefixOf([...values.values()]);
  return new Map([...values].map(([number, name]) => [number, name.slice(prefix.length).toLowerCase()]));
}

/** The longest common beginning of the names that ends with "_". A single name loses nothing. */
function prefixOf(names: string[]): string {
  const [first] = names;
  if (first === undefined || names.length < 2) return "";
  for (let end = first.lastIndexOf("_") + 1; end > 0; end = first.lastIndexOf("_", end - 2) + 1) {
    const prefix = first.slice(0, end);
    // the rest is a word, not empty
    if (names.every((name) => name.startsWith(prefix) && name.length > end)) return prefix;
  }
  return "";
}
