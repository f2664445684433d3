import { expect, test } from "vitest";
import type { ChangeableMoment } from "../memory/change";
import { reasonsOf } from "../memory/reasons";
import { suggestionsOf } from "./edit_suggestions";

test("thresholds of the path and arguments of the taken leaf come first, with their present values", () => {
  const reasons = reasonsOf(
    {
      reasons: {
        parts: [
          { path: "t", name: "t", depth: 0, taken: true },
          { path: "t/near", name: "near", depth: 1, skill: "kick", taken: true },
          { path: "t/far", name: "far", depth: 1, skill: "walk_to_ball", taken: false },
        ],
        comparisons: [
          { node: 7, part: 1, condition: "ball_distance < 0.5", result: true, value: "0.3 m", threshold: "0.5 m" },
          { node: 6, part: 1, condition: "ball_known", result: true, value: "yes", threshold: null },
        ],
        path: [{ node: 6 }, { node: 7 }],
      },
    },
    { robot: "14/2", at_ns: 0n },
  );
  const moment = {
    robot: "14/2",
    leaves: [
      { path: "t/near/kick", arguments: [{ name: "tolerance", value: "15 deg" }] },
      { path: "t/far/walk_to_ball", arguments: [{ name: "gain", value: "1" }] },
    ],
    strategies: ["passing"],
  } as unknown as ChangeableMoment;
  expect(suggestionsOf(reasons, moment).slice(0, 3)).toEqual([
    { text: "set threshold 7 0.5 m", about: "ball_distance < 0.5" },
    { text: "set argument tolerance 15 deg of t/near/kick", about: "tolerance of kick" },
    { text: "strategy passing", about: "another tree" },
  ]);
});
