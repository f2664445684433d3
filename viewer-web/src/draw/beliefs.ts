// One robot's beliefs and intentions, in the frame `field`.

import type { Memory } from "../memory/memory";
import { valueOf, type MemoryObject, type RobotName } from "../memory/memory_object";
import { isTurned } from "../memory/places";
import type {
  Ball,
  CameraMatrix,
  Joints,
  Kick,
  MotionCommand,
  Opponents,
  Pose as PoseMessage,
  RobotObject,
  Team,
  WalkTo,
} from "../memory/schema";
import { fieldsOf, listOf, numberOf, textOf, type Fields, type NumberIn, type Value } from "../memory/value";
import type { Ellipse, Point } from "./field";

export interface Pose extends Point {
  /** [rad] counter-clockwise from +x; NaN if unknown. */
  heading: number;
}

/** [s] since the robot formed this belief. */
interface Aged {
  age: number;
}

export interface PoseBelief extends Pose, Aged {
  /** [m] One standard deviation, in the less certain direction. */
  deviation: number;
  uncertainty: Ellipse;
  /** [rad] */
  headingDeviation: number;
}

export interface BallBelief extends Point, Aged {
  /** [m] One standard deviation. */
  deviation: number;
  uncertainty: Ellipse;
  /** [m/s] */
  velocity: Point;
}

export interface Teammate extends Pose, Aged {
  player: number;
  /** It said that it lies on the ground. */
  fallen: boolean;
}

export interface OpponentBelief extends Point, Aged {
  /** Undefined if the robot does not distinguish the opponents. */
  player: number | undefined;
  /** [m] One standard deviation; 0 if not estimated. */
  deviation: number;
}

export interface Beliefs {
  /** The robot's pose as it believes. Undefined without a recent belief. */
  pose: PoseBelief | undefined;
  ball: BallBelief | undefined;
  teammates: Teammate[];
  opponents: OpponentBelief[];
  /** [rad] Direction of the camera, and half of its field of view. */
  view: { angle: number; half: number } | undefined;
  /** The target of its walk. */
  target: Pose | undefined;
  /** Start and end of the kick that it is about to make. */
  kick: { from: Point; to: Point } | undefined;
  role: string;
  skill: string;
}

/** The objects that are read. */
export const kBeliefs: readonly RobotObject[] = [
  "pose",
  "ball",
  "game",
  "team",
  "opponents",
  "motion_command",
  "camera_top_matrix",
  "joints",
  "decision",
];

const kForgotten = 10; // [s] an older belief is not shown
const kHalfView = 0.53; // [rad] of the Nao's cameras, 61° in all (Aldebaran's documentation); a camera matrix has precedence
const kKickLength = 1; // [m] of an arrow if the command has no distance

export const pointOf = (fields: Fields<{ x?: number; y?: number }>): Point | undefined => pointIn(fields, "x", "y");

/** Returns the point in two fields with other names than x and y. */
export function pointIn<M>(fields: Fields<M>, x: NumberIn<M>, y: NumberIn<M>): Point | undefined {
  const point = { x: numberOf(fields, x), y: numberOf(fields, y) };
  return Number.isFinite(point.x) && Number.isFinite(point.y) ? point : undefined;
}

export function beliefsOf(memory: Memory, name: RobotName, now: number): Beliefs {
  const object = <Name extends RobotObject>(what: Name) => memory.of(name, what);
  const age = (what: RobotObject) => object(what)?.shown && (memory.age(object(what)!, now) ?? 0);
  const turned = isTurned(valueOf(object("game")));
  const pose = poseOf(valueOf(object("pose")), age("pose"), turned);
  const command = valueOf(object("motion_command"));
  const current = (age("motion_command") ?? Infinity) < 1;
  const decision = valueOf((age("decision") ?? Infinity) < 1 ? object("decision") : undefined);
  const ball = pose && ballOf(object("ball"), pose, age("ball"));
  return {
    pose,
    ball,
    teammates: teammatesOf(object("team"), turned),
    opponents: opponentsOf(object("opponents"), age("opponents"), turned),
    view: pose && viewOf(valueOf(object("joints")), command, valueOf(object("camera_top_matrix")), pose),
    target: pose && current ? targetOf(fieldsOf(command, "walk_to"), pose) : undefined,
    kick: pose && current ? kickOf(fieldsOf(command, "kick"), pose, ball) : undefined,
    role: textOf(decision, "role"),
    skill: textOf(decision, "skill"),
  };
}

/** Converts from `team_field`. It is `field`, turned by π if the own team attacks towards -x. */
export function inField(
  fields: Fields<{ x?: number; y?: number; heading?: number }>,
  turned: boolean,
): Pose | undefined {
  const point = pointOf(fields);
  const sign = turned ? -1 : 1;
  return (
    point && { x: sign * point.x, y: sign * point.y, heading: numberOf(fields, "heading") + (turned ? Math.PI : 0) }
  );
}

function poseOf(fields: Fields<PoseMessage>, age: number | undefined, turned: boolean): PoseBelief | undefined {
  const pose = inField(fields, turned);
  if (!pose || age === undefined || age > kForgotten) return undefined;
  const [a, b] = [numberOf(fields, "deviation_x") || 0, numberOf(fields, "deviation_y") || 0];
  return {
    ...pose,
    age,
    deviation: Math.max(a, b),
    uncertainty: { a, b, angle: 0 },
    headingDeviation: numberOf(fields, "deviation_heading") || 0,
  };
}

/** Converts a point from the robot's own frame. */
const seenFrom = ({ x, y, heading }: Pose, seen: Point): Point => ({
  x: x + Math.cos(heading) * seen.x - Math.sin(heading) * seen.y,
  y: y + Math.sin(heading) * seen.x + Math.cos(heading) * seen.y,
});

/** Returns the ball relative to the robot's believed pose. The errors of both add up, as in its decisions. */
function ballOf(
  object: MemoryObject<Ball> | undefined,
  pose: Pose,
  writtenAge: number | undefined,
): BallBelief | undefined {
  const fields = valueOf(object);
  const seen = pointOf(fields);
  const seen_ns = fields.get("seen_ns");
  if (!object?.shown || !seen || typeof seen_ns !== "bigint") return undefined;
  const age = Number(object.shown.log_ns - seen_ns) / 1e9 + (writtenAge ?? 0);
  if (age > 3 * kForgotten) return undefined;
  const deviation = numberOf(fields, "deviation");
  const ground = pointIn(fields, "velocity_x", "velocity_y") ?? { x: 0, y: 0 };
  return {
    ...seenFrom(pose, seen),
    age,
    deviation,
    uncertainty: ellipseOf(fields, deviation, pose.heading),
    velocity: seenFrom({ x: 0, y: 0, heading: pose.heading }, ground),
  };
}

/** Returns the half axes of a covariance, turned with the robot. Without a covariance it is a circle of `deviation`. */
export function ellipseOf(fields: Fields<Ball>, deviation: number, heading: number): Ellipse {
  const [xx, xy, yy] = (["xx", "xy", "yy"] as const).map((name) => numberOf(fields, `covariance_${name}`)) as [
    number,
    number,
    number,
  ];
  if (!(xx > 0 && yy > 0) || !Number.isFinite(xy)) return { a: deviation, b: deviation, angle: 0 };
  const { a, b, angle } = axesOf({ xx, xy, yy });
  return { a, b, angle: heading + angle };
}

/** Returns the half axes of a covariance: one standard deviation. */
export function axesOf({ xx, xy, yy }: { xx: number; xy: number; yy: number }): Ellipse {
  const [mean, half] = [(xx + yy) / 2, Math.hypot((xx - yy) / 2, xy)];
  return {
    a: Math.sqrt(mean + half),
    b: Math.sqrt(Math.max(0, mean - half)),
    angle: Math.atan2(2 * xy, xx - yy) / 2,
  };
}

function teammatesOf(object: MemoryObject<Team> | undefined, turned: boolean): Teammate[] {
  const told_ns = object?.shown?.log_ns;
  return listOf(valueOf(object), "teammates").flatMap((mate) => {
    const pose = inField(fieldsOf(mate, "pose"), turned);
    const received_ns = mate.get("received_ns");
    if (!pose || told_ns === undefined || typeof received_ns !== "bigint") return [];
    const age = Number(told_ns - received_ns) / 1e9;
    return age > 3 * kForgotten
      ? []
      : [{ ...pose, player: numberOf(mate, "player"), fallen: mate.get("fallen") === true, age }];
  });
}

function opponentsOf(
  object: MemoryObject<Opponents> | undefined,
  writtenAge: number | undefined,
  turned: boolean,
): OpponentBelief[] {
  const told_ns = object?.shown?.log_ns;
  return listOf(valueOf(object), "opponents").flatMap((opponent) => {
    const place = inField(opponent, turned);
    const seen_ns = opponent.get("seen_ns");
    if (!place || told_ns === undefined || typeof seen_ns !== "bigint") return [];
    const age = Number(told_ns - seen_ns) / 1e9 + (writtenAge ?? 0);
    const player = numberOf(opponent, "player");
    return age > 3 * kForgotten
      ? []
      : [
          {
            x: place.x,
            y: place.y,
            player: Number.isFinite(player) ? player : undefined,
            deviation: numberOf(opponent, "deviation") || 0,
            age,
          },
        ];
  });
}

/** Returns the camera's direction: from its matrix, else from the measured head joints, else from the commanded ones. */
function viewOf(
  joints: Fields<Joints>,
  command: Fields<MotionCommand>,
  camera: Fields<CameraMatrix>,
  pose: Pose,
): Beliefs["view"] {
  const bearing = ({ x, y }: Point) => Math.atan2(y, x);
  const entry = (list: Value, index: number) =>
    Array.isArray(list) && typeof list[index] === "number" ? list[index] : NaN;
  const place = pointOf(fieldsOf(command, "look_to"));
  const yaw = [
    bearing({ x: entry(camera.get("rotation"), 2), y: entry(camera.get("rotation"), 5) }), // the optical axis
    entry(joints.get("position"), 0),
    numberOf(fieldsOf(command, "head_angles"), "yaw"),
    place ? bearing(place) : NaN,
  ].find(Number.isFinite);
  if (yaw === undefined) return undefined;
  const [width, focal] = [numberOf(camera, "width"), numberOf(camera, "focal_x")];
  // the head turns at most 119.5°
  return {
    angle: pose.heading + Math.max(-2.09, Math.min(2.09, yaw)),
    half: width > 0 && focal > 0 ? Math.atan(width / (2 * focal)) : kHalfView,
  };
}

function targetOf(walkTo: Fields<WalkTo>, pose: Pose): Pose | undefined {
  const point = pointOf(walkTo);
  return point && { ...seenFrom(pose, point), heading: pose.heading + (numberOf(walkTo, "heading") || 0) };
}

function kickOf(kick: Fields<Kick>, pose: Pose, ball: Point | undefined): Beliefs["kick"] {
  if (kick.size === 0) return undefined;
  const place = pointIn(kick, "ball_x", "ball_y");
  const from = place ? seenFrom(pose, place) : (ball ?? seenFrom(pose, { x: 0.2, y: 0 }));
  const angle = pose.heading + (numberOf(kick, "direction") || 0);
  const length = numberOf(kick, "distance") || kKickLength;
  return { from, to: { x: from.x + length * Math.cos(angle), y: from.y + length * Math.sin(angle) } };
}
