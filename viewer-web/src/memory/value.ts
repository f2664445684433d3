// A decoded message of any schema as plain values, which views read by field name. Names of fields of our own messages are
// checked against proto/: `npm run check` refuses one that no .proto has.

import type { RobotObject, RobotObjects } from "./schema";

/** A message of an unknown schema, for example a team's own. */
export type Unknown = Record<string, unknown>;

/** The names of the fields of a message; any text for an unknown message. */
export type NameOf<M> = keyof M & string;

/** The names of the fields with values of the type `T`; any text for an unknown message. */
export type NameWith<M, T> = string extends keyof M
  ? string
  : { [Name in NameOf<M>]-?: NonNullable<M[Name]> extends T ? Name : never }[NameOf<M>];

/** The names of the fields with numbers of any width. */
export type NumberIn<M> = NameWith<M, number | bigint>;

/** Paths to fields of our objects, as expressions write them: "ball.x", "joints.position[head_yaw]". */
export type FieldPath = { [Name in RobotObject]: FieldPathIn<Name> }[RobotObject];
type FieldPathIn<Name extends RobotObject> = `${Name}.${NameOf<RobotObjects[Name]>}${"" | `[${string}]`}`;

/** The message in a field, or in each entry of a repeated field. */
export type Inner<M, Name> = string extends keyof M
  ? Unknown
  : Name extends keyof M
    ? EntryOf<NonNullable<M[Name]>>
    : never;
type EntryOf<T> = T extends (infer Entry)[] ? Entry : T;

declare const kMessage: unique symbol;

/**
 * The fields of a message of the type `M`, in the schema's order. A Map, so that a field named "__proto__" is harmless. The
 * values are not trusted: `M` checks names alone, and a server may send anything. An unknown message may be read as any.
 */
export interface Fields<M = Unknown> extends Map<string, Value> {
  readonly [kMessage]?: M;
  get(name: NameOf<M>): Value;
  has(name: NameOf<M>): boolean;
}

/** `undefined`: the field is absent. Integers of 64 bits are bigint. */
export type Value = number | bigint | boolean | string | Uint8Array | EnumValue | Value[] | Fields | undefined;

export class EnumValue<Name extends string = string> {
  constructor(
    readonly number: number,
    /** The name in the schema. Undefined for a number that the schema does not know. */
    readonly name: Name | undefined,
  ) {}
}

/** Returns the message in field `name`, or no fields if there is none. */
export const fieldsOf = <M, Name extends NameWith<M, Unknown>>(
  fields: Fields<M>,
  name: Name,
): Fields<Inner<M, Name>> => {
  const value = fields.get(name as NameOf<M>);
  return value instanceof Map ? (value as Fields<Inner<M, Name>>) : new Map();
};

/** Returns the messages in the repeated field `name`. */
export const listOf = <M, Name extends NameWith<M, Unknown[]>>(
  fields: Fields<M>,
  name: Name,
): Fields<Inner<M, Name>>[] => {
  const value = fields.get(name as NameOf<M>);
  const entries = Array.isArray(value) ? value.filter((entry) => entry instanceof Map) : [];
  return entries as Fields<Inner<M, Name>>[];
};

export const textOf = <M>(fields: Fields<M>, name: NameWith<M, string>): string => {
  const value = fields.get(name as NameOf<M>);
  return typeof value === "string" ? value : "";
};

/** Returns a number of any width, or NaN if there is none. */
export const numberOf = <M>(fields: Fields<M>, name: NumberIn<M>): number => {
  const value = fields.get(name as NameOf<M>);
  return typeof value === "number" || typeof value === "bigint" ? Number(value) : NaN;
};

/** The words for an enum's values; any text for a text. "" if there is none. */
export type WordOf<M, Name> = Name extends keyof M
  ? NonNullable<M[Name]> extends EnumValue<infer Value>
    ? WithoutPrefix<Lowercase<Value>, Name & string> | ""
    : string
  : string;
type WithoutPrefix<Word extends string, Name extends string> = Word extends `${Name}_${infer Rest}` ? Rest : Word;

/**
 * Returns the name of an enum value or a text in lower case, without the enum's prefix: STATE_DISK_FULL of `state` is
 * "disk_full".
 */
export const wordOf = <M, Name extends NameWith<M, string | EnumValue>>(
  fields: Fields<M>,
  name: Name,
): WordOf<M, Name> => {
  const value = fields.get(name as NameOf<M>);
  const word = (value instanceof EnumValue ? (value.name ?? "") : typeof value === "string" ? value : "").toLowerCase();
  return (word.startsWith(`${name}_`) ? word.slice(name.length + 1) : word) as WordOf<M, Name>;
};
