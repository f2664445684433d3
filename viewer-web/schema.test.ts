import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { objectsOf, protoFiles, schemaOf, schemaOfFiles } from "./schema.mjs";
import { commentsOf } from "./schema_comments.mjs";
import { typesOf } from "./schema_types.mjs";

const kText = `syntax = "proto3";
package them;

import "them/other.proto";

// A ball. message Not { is none
message Ball {
  reserved 4, 5;
  uint64 seen_ns = 1;    // [ns since the epoch, capture time] image time
  float x = 2;           // [m, robot] centre
  optional float heat = 8;  // [0..1] how likely
  float bare = 9;
  enum Kind {
    KIND_ROUND = 0;  // [m] no field
    KIND_OVAL = 1;
  }
  message Inner {
    repeated float speed = 1 [packed = true];  // [m/s]
    Kind kind = 2;
  }
  oneof what {
    bool yes = 3;  // agreed
    Inner inner = 6;
  }
  float last = 7;  // [rad/s] turning
}
message Other { }
message Third {
  uint32 size_bytes = 1;  // [bytes] on disk
  repeated Ball.Inner parts = 2;
  google.protobuf.Timestamp at = 3;
}`;

test("units and comments of fields are found, also of inner messages", () => {
  expect(commentsOf(schemaOf(kText))).toEqual({
    "them.Ball": {
      seen_ns: ["ns", "image time"],
      x: ["m", "centre"],
      heat: ["", "how likely"],
      yes: ["", "agreed"],
      last: ["rad/s", "turning"],
    },
    "them.Ball.Inner": { speed: ["m/s", ""] },
    "them.Third": { size_bytes: ["bytes", "on disk"] },
  });
});

test("each message and enum has a type with its fields, and each object has its message", () => {
  const objects = [
    { topic: "ball", message: "them.Ball" },
    { topic: "/truth/third", message: "them.Third" },
  ];
  const lines = typesOf(schemaOf(kText), objects).split("\n");
  expect(lines).toContain("export type them_Ball = {");
  expect(lines).toContain("  /** [m, robot] centre */");
  expect(lines.filter((line) => line.startsWith("  ") && line.includes(":"))).toEqual([
    "  seen_ns?: bigint;",
    "  x?: number;",
    "  heat?: number;",
    "  bare?: number;",
    "  yes?: boolean;",
    "  inner?: them_Ball_Inner;",
    "  last?: number;",
    "  speed?: number[];",
    "  kind?: them_Ball_Kind;",
    "  size_bytes?: number;",
    "  parts?: them_Ball_Inner[];",
    "  at?: Record<string, unknown>;",
    '  "ball": them_Ball;',
    '  "/truth/third": them_Third;',
  ]);
  expect(lines).toContain('export type them_Ball_Kind = EnumValue<"KIND_ROUND" | "KIND_OVAL">;');
  expect(lines).toContain('export type MessageName = "them.Ball" | "them.Ball.Inner" | "them.Other" | "them.Third";');
});

test("a line that cannot be read is named, so that no field is left out", () => {
  const refused = (line: string) => () => schemaOf(`package them;\nmessage Ball {\n  ${line}\n}`, "ball.proto");
  for (const line of ["float x =", "map<string, float> x = 1;", "float x = 1; float y = 2;", "KIND_ROUND = 0;"])
    expect(refused(line)).toThrow(
      `ball.proto:3: expected a field, a value or the end of a message on one line, got '${line}'`,
    );
  expect(() => schemaOf("}", "ball.proto")).toThrow("ball.proto:1: a brace closes nothing");
});

test("a type that no file declares is named", () => {
  const { messages } = schemaOf("package them;\nmessage Ball {\n  Lost place = 1;\n}");
  expect(() => typesOf({ messages, enums: [] }, [])).toThrow("them.Ball has a field of the type Lost");
  expect(() => typesOf({ messages: [], enums: [] }, [{ topic: "ball", message: "them.Ball" }])).toThrow(
    "the object 'ball' has the message them.Ball, which no .proto declares",
  );
});

test("objects are those of the table with the messages of its members", () => {
  const members = "  MemoryObject<pb::Ball> ball;\n  MemoryObject<pb::GroundTruth> truth;\n";
  expect(objectsOf(`${members}  see("ball", ball, latest);\n  see("/truth/world", truth, latest);`)).toEqual([
    { topic: "ball", message: "foresight.Ball" },
    { topic: "/truth/world", message: "foresight.GroundTruth" },
  ]);
  expect(() => objectsOf('see("pose", pose, latest);')).toThrow(
    "memory.h: the object 'pose' shows 'pose', which is no member of Memory",
  );
});

test("all our schemas and objects can be read", () => {
  const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));
  const { messages, enums } = schemaOfFiles(protoFiles(path("../proto/foresight")));
  const objects = objectsOf(readFileSync(path("../robot/memory/memory.h"), "utf8"));
  expect(objects).toContainEqual({ topic: "/sim/state", message: "foresight.Simulation" });
  expect(typesOf({ messages, enums }, objects)).toContain("export type Ball = {");
});
