// For tests: a schema that the viewer does not know at build time, and channels with it.

import { create, createFileRegistry, fromJson, toBinary, type JsonValue } from "@bufbuild/protobuf";
import { base64Encode } from "@bufbuild/protobuf/wire";
import { FileDescriptorSetSchema } from "@bufbuild/protobuf/wkt";
import type { Channel } from "../source/texts";

const field = (number: number, name: string, type: string, more: object = {}) => ({
  number,
  name,
  type: `TYPE_${type}`,
  label: "LABEL_OPTIONAL",
  ...more,
});
const repeated = { label: "LABEL_REPEATED" };
const optional = (oneofIndex: number) => ({ oneofIndex, proto3Optional: true });

/** The descriptor set of a team's own message `htwk.Percept`, with every kind of field. */
const kSet = fromJson(FileDescriptorSetSchema, {
  file: [
    {
      name: "htwk/percept.proto",
      package: "htwk",
      syntax: "proto3",
      messageType: [
        {
          name: "Percept",
          field: [
            field(1, "seen_ns", "UINT64"),
            field(2, "x", "FLOAT"),
            field(3, "side", "ENUM", { typeName: ".htwk.Side" }),
            field(4, "centre", "MESSAGE", { typeName: ".htwk.Point" }),
            field(5, "outline", "MESSAGE", { typeName: ".htwk.Point", ...repeated }),
            field(6, "weights", "FLOAT", repeated),
            field(7, "data", "BYTES"),
            field(8, "note", "STRING"),
            field(9, "radius", "FLOAT", optional(0)),
            field(10, "sides", "ENUM", { typeName: ".htwk.Side", ...repeated }),
            field(11, "counts", "MESSAGE", { typeName: ".htwk.Percept.CountsEntry", ...repeated }),
            field(12, "offset_ns", "INT64"),
            field(13, "__proto__", "BOOL"),
          ],
          oneofDecl: [{ name: "_radius" }],
          nestedType: [
            {
              name: "CountsEntry",
              field: [field(1, "key", "STRING"), field(2, "value", "UINT32")],
              options: { mapEntry: true },
            },
          ],
        },
        { name: "Point", field: [field(1, "x", "DOUBLE"), field(2, "y", "DOUBLE")] },
      ],
      enumType: [
        {
          name: "Side",
          value: [
            { name: "SIDE_UNSPECIFIED", number: 0 },
            { name: "SIDE_OWN", number: 1 },
          ],
        },
      ],
    },
  ],
} as JsonValue);

export const kPerceptChannel: Channel = {
  id: 1,
  topic: "/14/2/percept",
  encoding: "protobuf",
  schemaName: "htwk.Percept",
  schema: base64Encode(toBinary(FileDescriptorSetSchema, kSet)),
  metadata: {},
};

const schema = createFileRegistry(kSet).getMessage("htwk.Percept")!;

/** Returns the bytes of a percept from protobuf JSON with the schema's field names. */
export const percept = (json?: JsonValue): Uint8Array =>
  toBinary(schema, json === undefined ? create(schema) : fromJson(schema, json));
