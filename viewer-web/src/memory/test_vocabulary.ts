// For tests: names of which nothing but the topic is known, and names with the fields of a game.

import type { Shape } from "./shape";
import type { Vocabulary } from "./vocabulary";

/** The fields are not known. */
export const topicsOnly = (robot: string, topics: Iterable<string>): Vocabulary => ({
  robot,
  topics: new Set(topics),
  shapeOf: () => ({ kind: "unknown" }),
});

const number: Shape = { kind: "number" };
const truth: Shape = { kind: "truth" };
const text: Shape = { kind: "text" };
const list = (of: Shape): Shape => ({ kind: "list", of });
function message(name: string, fields: Record<string, Shape>): Shape {
  const all = new Map(Object.entries(fields));
  return { kind: "message", name, open: false, field: (field) => all.get(field), names: () => [...all.keys()] };
}

const kState: Shape = {
  kind: "enum",
  values: new Map([
    [0, "STATE_UNSPECIFIED"],
    [3, "STATE_READY"],
    [4, "STATE_SET"],
    [5, "STATE_PLAYING"],
  ]),
};
const kShapes: Record<string, Shape> = {
  ball: message("foresight.Ball", { x: number, y: number, visible: truth, seen_ns: number }),
  pose: message("foresight.Pose", {
    x: number,
    y: number,
    heading: number,
    particles: list(message("foresight.Pose.Particle", { x: number, y: number })),
  }),
  game: message("foresight.GameState", { state: kState, attacks_positive_x: truth }),
  decision: message("foresight.DecisionTrace", { role: text, skill: text }),
  joints: message("foresight.Joints", { position: list(number), temperature: list(number) }),
  spot: message("htwk.Spot", { x: number, y: number }),
  world: message("foresight.GroundTruth", {
    ball: message("foresight.GroundTruth.TrueBall", { x: number, y: number }),
    robots: list(
      message("foresight.GroundTruth.TrueRobot", {
        team: number,
        player: number,
        x: number,
        y: number,
        heading: number,
      }),
    ),
  }),
};

/** Robot 14/2 with all objects, 14/3 with ball and pose alone, 10/1 with a ball alone, and the truth. */
export function gameVocabulary(robot = "14/2"): Vocabulary {
  const own = ["ball", "pose", "game", "decision", "joints", "spot"].map((name) => `/14/2/${name}`);
  return {
    robot,
    topics: new Set([...own, "/14/3/ball", "/14/3/pose", "/10/1/ball", "/truth/world"]),
    shapeOf: (topic) => kShapes[topic.split("/").at(-1)!] ?? { kind: "unknown" },
  };
}
