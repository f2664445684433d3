// What a game looks like now: the truth, and what each robot believes, all in the frame `field`.

import type { Memory } from "../memory/memory";
import type { MemoryObject, RobotName } from "../memory/memory_object";
import { kSimulation } from "../memory/simulation";
import { fieldsOf, listOf, numberOf, type Fields } from "../memory/value";
import { kUsualField, type Field, type Point } from "./field";

export interface Pose extends Point {
  /** [rad] counter-clockwise from +x; NaN when not known. */
  heading: number;
}

export interface BallBelief extends Point {
  /** [m] one standard deviation. */
  deviation: number;
  /** [s] since it was last seen, of the robot's own time. */
  age: number;
}

export interface Robot {
  name: RobotName;
  home: boolean;
  /** Where it truly is; undefined when that is not known. */
  truth: Pose | undefined;
  fallen: boolean;
  /** Where it believes to be; undefined when it believes nothing (any more). */
  pose: (Pose & { deviation: number }) | undefined;
  ball: BallBelief | undefined;
}

export interface Scene {
  field: Field;
  ball: Point | undefined;
  robots: Robot[];
}

export const kTruth = "/truth/world";
const kStale_ns = 1_000_000_000n; // a belief so much older than the newest truth is not one any more

/** The topics that `sceneOf` reads; only those that are offered. */
export const topicsOf = (memory: Memory, robots: RobotName[]): string[] =>
  [kTruth, kSimulation, ...robots.flatMap((robot) => ["pose", "ball", "game"].map((object) => `/${robot}/${object}`))].filter((topic) =>
    memory.get(topic),
  );

/** What is not known is undefined, and the field the usual one. */
export function sceneOf(memory: Memory, robots: RobotName[]): Scene {
  const truth = memory.get(kTruth);
  const world = valueOf(truth);
  const trueRobots = new Map(listOf(world, "robots").map((robot) => [`${numberOf(robot, "team")}/${numberOf(robot, "player")}`, robot]));
  const names = [...new Set([...robots, ...trueRobots.keys()])].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  const homeTeam = homeTeamOf(memory, names);
  return {
    field: fieldOf(fieldsOf(valueOf(memory.get(kSimulation)), "field")),
    ball: pointOf(fieldsOf(world, "ball")),
    robots: names.map((name) => robotOf(memory, name, truth?.newest?.log_ns, trueRobots.get(name), name.startsWith(`${homeTeam}/`))),
  };
}

const valueOf = (object: MemoryObject | undefined): Fields => object?.decoded()?.fields ?? new Map();

function pointOf(fields: Fields): Point | undefined {
  const [x, y] = [numberOf(fields, "x"), numberOf(fields, "y")];
  return Number.isFinite(x) && Number.isFinite(y) ? { x, y } : undefined;
}

/** The simulation says who plays at home; else it is the team that comes first. */
function homeTeamOf(memory: Memory, names: RobotName[]): string {
  const number = numberOf(fieldsOf(valueOf(memory.get(kSimulation)), "home"), "number");
  return Number.isFinite(number) ? String(number) : (names[0]?.split("/")[0] ?? "");
}

function robotOf(memory: Memory, name: RobotName, truth_ns: bigint | undefined, truth: Fields | undefined, home: boolean): Robot {
  const pose = poseOf(memory, name, truth_ns);
  return {
    name,
    home,
    truth: truth && withHeading(truth),
    fallen: truth?.get("fallen") === true,
    pose,
    ball: pose && ballOf(memory.get(`/${name}/ball`), pose),
  };
}

function withHeading(fields: Fields): Pose | undefined {
  const point = pointOf(fields);
  return point && { ...point, heading: numberOf(fields, "heading") };
}

/** A belief is in `team_field`: that is `field`, or turned by π where the own team attacks towards -x. */
function poseOf(memory: Memory, name: RobotName, truth_ns: bigint | undefined): Robot["pose"] {
  const object = memory.get(`/${name}/pose`);
  const believed = withHeading(valueOf(object));
  if (!object?.newest || !believed) return undefined;
  if (truth_ns !== undefined && truth_ns - object.newest.log_ns > kStale_ns) return undefined;
  const turned = valueOf(memory.get(`/${name}/game`)).get("attacks_positive_x") === false;
  return {
    x: turned ? -believed.x : believed.x,
    y: turned ? -believed.y : believed.y,
    heading: turned ? believed.heading + Math.PI : believed.heading,
    deviation: Math.max(numberOf(valueOf(object), "deviation_x"), numberOf(valueOf(object), "deviation_y")),
  };
}

/** Seen from where the robot believes to stand: its errors of both add up, as they do in its decisions. */
function ballOf(object: MemoryObject | undefined, pose: Pose): BallBelief | undefined {
  const fields = valueOf(object);
  const seen = pointOf(fields);
  const seen_ns = fields.get("seen_ns");
  if (!object?.newest || !seen || typeof seen_ns !== "bigint") return undefined;
  const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  return {
    x: pose.x + cos * seen.x - sin * seen.y,
    y: pose.y + sin * seen.x + cos * seen.y,
    deviation: numberOf(fields, "deviation"),
    age: Number(object.newest.log_ns - seen_ns) / 1e9,
  };
}

function fieldOf(fields: Fields): Field {
  if (!(numberOf(fields, "length") > 0 && numberOf(fields, "width") > 0)) return kUsualField;
  const size = (name: string) => numberOf(fields, name) || 0;
  return {
    length: size("length"),
    width: size("width"),
    border: size("border"),
    lineWidth: size("line_width"),
    centreCircleRadius: size("centre_circle_radius"),
    goalAreaLength: size("goal_area_length"),
    goalAreaWidth: size("goal_area_width"),
    penaltyAreaLength: size("penalty_area_length"),
    penaltyAreaWidth: size("penalty_area_width"),
    penaltyMark: size("penalty_mark"),
    goalWidth: size("goal_width"),
    goalDepth: size("goal_depth"),
  };
}
