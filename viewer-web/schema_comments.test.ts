import { expect, test } from "vitest";
import { commentsOf } from "./schema_comments.mjs";

const kText = `syntax = "proto3";
package them;

// A ball. message Not { is none
message Ball {
  uint64 seen_ns = 1;    // [ns since the epoch, capture time] image time
  float x = 2;           // [m, robot] centre
  optional float heat = 8;  // [0..1] how likely
  float bare = 9;
  enum Kind {
    KIND_ROUND = 0;  // [m] no field
  }
  message Inner {
    repeated float speed = 1;  // [m/s]
  }
  oneof what {
    bool yes = 3;  // agreed
  }
  float last = 4;  // [rad/s] turning
}
message Other { }
message Third {
  uint32 size_bytes = 1;  // [bytes] on disk
}`;

test("units and comments of fields are found, also of inner messages", () => {
  expect(commentsOf(kText)).toEqual({
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

test("text that is no schema gives no comments", () => {
  for (const text of ["", "}}}}", "message {", "float x = 1; // [m]"]) expect(commentsOf(text)).toEqual({});
});
