// Decoding by reflection: the viewer knows only the schema that the server announced.

import { createFileRegistry, fromBinary, type DescField, type DescMessage } from "@bufbuild/protobuf";
import { base64Decode } from "@bufbuild/protobuf/wire";
import { reflect, type ReflectList, type ReflectMap, type ReflectMessage } from "@bufbuild/protobuf/reflect";
import { FileDescriptorSetSchema } from "@bufbuild/protobuf/wkt";
import type { Channel } from "../source/texts";
import { EnumValue, type Fields, type Unknown, type Value } from "./value";

/** A decoded message, or a sentence that says why it cannot be decoded. `M` as for Fields. */
export type Decoded<M = Unknown> = { fields: Fields<M>; error?: undefined } | { fields?: undefined; error: string };

export type Decoder = (data: Uint8Array) => Decoded;

/**
 * Returns the decoder for the channel's schema. Neither this function nor the decoder throws: a bad schema or message
 * gives a sentence.
 */
export function decoderOf(channel: Pick<Channel, "encoding" | "schemaName" | "schema">): Decoder {
  if (channel.encoding === "json") return decodeJson;
  let schema: DescMessage;
  try {
    schema = descriptorOf(channel);
  } catch (error) {
    const sentence = `The schema '${channel.schemaName}' cannot be read: ${reason(error)}`;
    return () => ({ error: sentence });
  }
  return (data) => {
    try {
      return { fields: fieldsOf(reflect(schema, fromBinary(schema, data))) };
    } catch (error) {
      return { error: `This message does not fit its schema '${channel.schemaName}': ${reason(error)}` };
    }
  };
}

/** Returns the descriptor of the channel's schema. Throws an Error with the end of a sentence. */
export function descriptorOf({
  encoding,
  schemaName,
  schema,
}: Pick<Channel, "encoding" | "schemaName" | "schema">): DescMessage {
  if (encoding !== "protobuf") throw new Error(`its encoding is '${encoding}', expected protobuf or json`);
  const registry = createFileRegistry(fromBinary(FileDescriptorSetSchema, base64Decode(schema)));
  const message = registry.getMessage(schemaName);
  if (!message) throw new Error("the descriptor set does not contain it");
  return message;
}

const reason = (error: unknown): string => (error instanceof Error ? error.message : String(error));

function fieldsOf(message: ReflectMessage): Fields {
  return new Map(message.fields.map((field) => [field.name, valueOf(message, field)]));
}

function valueOf(message: ReflectMessage, field: DescField): Value {
  switch (field.fieldKind) {
    case "list":
      return [...(message.get(field) as ReflectList)].map((item) =>
        field.listKind === "enum" ? enumOf(field.enum, item as number) : plain(item),
      );
    case "map":
      return new Map(
        [...(message.get(field) as ReflectMap)].map(([key, item]) => [
          String(key),
          field.mapKind === "enum" ? enumOf(field.enum, item as number) : plain(item),
        ]),
      );
    case "enum":
      return present(message, field) ? enumOf(field.enum, message.get(field)) : undefined;
    default:
      return present(message, field) ? plain(message.get(field)) : undefined;
  }
}

/**
 * A field without presence has its default. A field with presence (optional, oneof, message) is absent until it is
 * set.
 */
const present = (message: ReflectMessage, field: DescField): boolean =>
  (field.fieldKind !== "message" && field.presence === kImplicit) || message.isSet(field);
const kImplicit = 2; // FeatureSet_FieldPresence.IMPLICIT; importing the enum would add too much code

const enumOf = (type: { value: Record<number, { name: string }> }, number: number): EnumValue =>
  new EnumValue(number, type.value[number]?.name);

const plain = (value: unknown): Value =>
  typeof value === "object" && value !== null && !(value instanceof Uint8Array)
    ? fieldsOf(value as ReflectMessage)
    : (value as Value);

/** Wraps a value that is no object as the field `value`. */
function decodeJson(data: Uint8Array): Decoded {
  try {
    const value: unknown = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(data));
    const decoded = ofJson(value);
    return { fields: decoded instanceof Map ? decoded : new Map([["value", decoded]]) };
  } catch (error) {
    return { error: `This message is no JSON: ${reason(error)}` };
  }
}

function ofJson(value: unknown): Value {
  if (Array.isArray(value)) return value.map(ofJson);
  if (typeof value === "object" && value !== null)
    return new Map(Object.entries(value).map(([name, inner]) => [name, ofJson(inner)]));
  return value === null ? undefined : (value as string | number | boolean);
}
