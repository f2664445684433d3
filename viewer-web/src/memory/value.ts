// A decoded message of any schema as plain values, which views read by field name.

/** Fields in the schema's order. A Map, so that a field named "__proto__" is harmless. */
export type Fields = Map<string, Value>;

/** `undefined`: the field is absent. Integers of 64 bits are bigint. */
export type Value = number | bigint | boolean | string | Uint8Array | EnumValue | Value[] | Fields | undefined;

export class EnumValue {
  constructor(
    readonly number: number,
    /** The name in the schema. Undefined for a number that the schema does not know. */
    readonly name: string | undefined,
  ) {}
}

/** Returns the message in field `name`, or no fields if there is none. */
export const fieldsOf = (fields: Fields, name: string): Fields => {
  const value = fields.get(name);
  return value instanceof Map ? value : new Map();
};

/** Returns the messages in the repeated field `name`. */
export const listOf = (fields: Fields, name: string): Fields[] => {
  const value = fields.get(name);
  return Array.isArray(value) ? value.filter((entry): entry is Fields => entry instanceof Map) : [];
};

export const textOf = (fields: Fields, name: string): string => {
  const value = fields.get(name);
  return typeof value === "string" ? value : "";
};

/** Returns a number of any width, or NaN if there is none. */
export const numberOf = (fields: Fields, name: string): number => {
  const value = fields.get(name);
  return typeof value === "number" || typeof value === "bigint" ? Number(value) : NaN;
};

/**
 * Returns the name of an enum value or a text in lower case, without the enum's prefix: STATE_DISK_FULL of `state` is
 * "disk_full".
 */
export const wordOf = (fields: Fields, name: string): string => {
  const value = fields.get(name);
  const word = (value instanceof EnumValue ? (value.name ?? "") : typeof value === "string" ? value : "").toLowerCase();
  return word.startsWith(`${name}_`) ? word.slice(name.length + 1) : word;
};
