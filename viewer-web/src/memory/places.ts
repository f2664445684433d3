// Places in messages, and their way into the frame `field`: belief against truth.

import { valueAt, type Step } from "./paths";
import { isTopicOf, topicOfRobot } from "./memory_object";
import type { GameState, MessageName } from "./schema";
import { kTruth } from "./vocabulary";
import { numberOf, type Fields } from "./value";

/** Returns the newest message of a topic, or undefined before the first one. */
export type Look = (topic: string) => Fields | undefined;

export interface Place {
  x: number;
  y: number;
  /** [rad] NaN where only a point is known. */
  heading: number;
}

/** As in proto/: seen from the robot; the field as the own team attacks; the field as it is. */
export type Frame = "robot" | "team_field" | "field";

/** Messages inside others, by their frames in proto/foresight/. */
const kNested: Record<string, Frame> = {
  "foresight.Pose": "team_field",
  "foresight.Pose.Particle": "team_field",
  "foresight.Opponents.Opponent": "team_field",
  "foresight.SharedBall": "team_field",
} satisfies Partial<Record<MessageName, Frame>>;

/** Returns the frame of a message in an object, or undefined if the frame is not known. `inside`: it is not the whole object. */
export function frameOf(topic: string, inside: boolean, message: string): Frame | undefined {
  if (topic === kTruth) return "field";
  if (!inside && isTopicOf(topic, "ball")) return "robot";
  if (!inside && isTopicOf(topic, "pose")) return "team_field";
  return kNested[message];
}

/** Returns the place at the path, or undefined if there is none. */
export function placeAt(fields: Fields | undefined, steps: Step[]): Place | undefined {
  const value = fields && valueAt(fields, steps);
  if (!(value instanceof Map)) return undefined;
  const place = { x: numberOf(value, "x"), y: numberOf(value, "y"), heading: numberOf(value, "heading") };
  return Number.isFinite(place.x) && Number.isFinite(place.y) ? place : undefined;
}

/** Lists the objects that toField() reads for a place in `frame`. */
export const topicsOfFrame = (frame: Frame, robot: string): string[] => [
  ...(frame === "robot" ? [topicOfRobot(robot, "pose")] : []),
  ...(frame === "field" ? [] : [topicOfRobot(robot, "game")]),
];

/** Reports whether `team_field` is `field` turned by π, because the own team attacks towards -x. */
export const isTurned = (game: Fields<GameState> | undefined): boolean => game?.get("attacks_positive_x") === false;

/**
 * Converts a place of a robot to `field`. Undefined if the robot's pose is not known. While the direction of play is not
 * known, `team_field` counts as `field`.
 */
export function toField(place: Place | undefined, frame: Frame, robot: string, look: Look): Place | undefined {
  if (!place || frame === "field") return place;
  const seen = frame === "team_field" ? place : seenFrom(placeAt(look(topicOfRobot(robot, "pose")), []), place);
  if (!seen || !isTurned(look(topicOfRobot(robot, "game")))) return seen;
  return { x: -seen.x, y: -seen.y, heading: seen.heading + Math.PI };
}

function seenFrom(pose: Place | undefined, { x, y, heading }: Place): Place | undefined {
  if (!pose || !Number.isFinite(pose.heading)) return undefined;
  const [cos, sin] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  return { x: pose.x + cos * x - sin * y, y: pose.y + sin * x + cos * y, heading: pose.heading + heading };
}

/** [m] */
export const distanceOf = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

/** [rad] The turn from `b` to `a`, in (-π, π]. */
export function turnOf(a: number, b: number): number {
  const turn = Math.atan2(Math.sin(a - b), Math.cos(a - b));
  return turn === -Math.PI ? Math.PI : turn;
}
