// A decoded message as plain values, whatever its schema: what views look into by field name.

/** Fields in the order of the schema. A Map, so that a field named "__proto__" is only a name. */
export type Fields = Map<string, Value>;

/** `undefined`: the field is absent. Integers of 64 bits are bigint. */
export type Value = number | bigint | boolean | string | Uint8Array | EnumValue | Value[] | Fields | undefined;

export class EnumValue {
  constructor(
    readonly number: number,
    /** As in the schema; undefined for a number the schema does not know. */
    readonly name: string | undefined,
  ) {}
}

/** The message in field `name`, or no fields when there is none. */
export const fieldsOf = (fields: Fields, name: string): Fields => {
  const value = fields.get(name);
  return value instanceof Map ? value : new Map();
};

/** The messages in repeated field `name`. */
export const listOf = (fields: Fields, name: string): Fields[] => {
  const value = fields.get(name);
  return Array.isArray(value) ? value.filter((entry): entry is Fields => entry instanceof Map) : [];
};

export const textOf = (fields: Fields, name: string): string => {
  const value = fields.get(name);
  return typeof value === "string" ? value : "";
};

/** A number of any width; NaN when there is none. */
export const numberOf = (fields: Fields, name: string): number => {
  const value = fields.get(name);
  return typeof value === "number" || typeof value === "bigint" ? Number(value) : NaN;
};

/** What an enum or a text calls it, in lower case and without the enum's own prefix: STATE_DISK_FULL of `state` is "disk_full". */
export const wordOf = (fields: Fields, name: string): string => {
  const value = fields.get(name);
  const word = (value instanceof EnumValue ? (value.name ?? "") : typeof value === "string" ? value : "").toLowerCase();
  return word.startsWith(`${name}_`) ? word.slice(name.length + 1) : word;
};
