// Ground truth as views read it: the fused truth, and what each sensor beside the field reports.

import type { Memory } from "./memory";
import type { MemoryObject } from "./memory_object";
import type {
  foxglove_RawImage,
  GroundTruth,
  GroundTruth_Covariance,
  GroundTruth_TrueBall,
  GroundTruth_TrueRobot,
  TruthSensor,
  TruthSensor_Pinhole,
  TruthSensor_RefusedTags,
  TruthSensor_SensorPlace,
  WorldObject,
} from "./schema";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields, type NumberIn } from "./value";

/** The true positions of a synthetic sensor's scene. */
export const kSimulatedTruth = "/truth/simulated" satisfies WorldObject;

/** Messages of one image are at most this far apart in their capture times. */
export const kSame_ns = 40_000_000n;

/** A ball or robot on the field. Frame: field. */
export interface TrueThing {
  x: number; // [m]
  y: number;
  /** [m/s] Undefined if not measured. */
  velocity: { x: number; y: number } | undefined;
  /** [m²] Undefined if the system has no measure. */
  covariance: { xx: number; xy: number; yy: number } | undefined;
  /** Undefined if it is not tracked. */
  track: number | undefined;
  /** "14/2", or "" if it was not identified. */
  name: string;
  /** [rad] NaN if not measured. */
  heading: number;
  fallen: boolean;
  /** Count of the sensors that saw it; 0: not reported. */
  sensors: number;
}

export interface Truth {
  ball: TrueThing | undefined;
  robots: TrueThing[];
  /** Sentences about things that two sensors place differently. */
  disagreements: string[];
}

export function truthOf(fields: Fields<GroundTruth>): Truth {
  const disagreements = fields.get("disagreements");
  return {
    ball: thingOf(fieldsOf(fields, "ball")),
    robots: thingsOf(listOf(fields, "robots")),
    disagreements: Array.isArray(disagreements) ? disagreements.map(String) : [],
  };
}

/** Returns the robots and the ball. */
export const thingsIn = (truth: Truth | undefined): TrueThing[] => [
  ...(truth?.robots ?? []),
  ...(truth?.ball ? [truth.ball] : []),
];

type AnyThing = GroundTruth_TrueRobot & GroundTruth_TrueBall;

const thingsOf = (robots: Fields<GroundTruth_TrueRobot>[]): TrueThing[] =>
  robots.flatMap((robot) => thingOf(robot) ?? []);

function thingOf(fields: Fields<AnyThing>): TrueThing | undefined {
  const number = (name: NumberIn<AnyThing>) => numberOf(fields, name);
  const [x, y, track] = [number("x"), number("y"), number("track")];
  if (!Number.isFinite(x) || !Number.isFinite(y)) return undefined;
  const velocity = { x: number("velocity_x"), y: number("velocity_y") };
  const [team, player] = [number("team"), number("player")];
  return {
    x,
    y,
    velocity: Number.isFinite(velocity.x) && Number.isFinite(velocity.y) ? velocity : undefined,
    covariance: covarianceOf(fieldsOf(fields, "covariance")),
    track: Number.isFinite(track) ? track : undefined,
    name: Number.isFinite(team) && Number.isFinite(player) ? `${team}/${player}` : "",
    heading: number("heading"),
    fallen: fields.get("fallen") === true,
    sensors: number("sensors") || 0,
  };
}

function covarianceOf(fields: Fields<GroundTruth_Covariance>): TrueThing["covariance"] {
  const [xx, xy, yy] = [numberOf(fields, "xx"), numberOf(fields, "xy"), numberOf(fields, "yy")];
  return xx > 0 && yy > 0 && Number.isFinite(xy) ? { xx, xy, yy } : undefined;
}

/** The number that a drawing shows of a thing: that of its track; its player's number comes first. */
export const labelOf = ({ name, track }: TrueThing): string =>
  name.split("/").at(-1) || (track === undefined ? "" : `#${track}`);

// the sensors

/** The projection of a sensor's image [px]. */
export interface Pinhole {
  width: number;
  height: number;
  focal: { x: number; y: number };
  centre: { x: number; y: number };
}

/** The pose of a sensor in the frame field. */
export interface SensorPlace {
  /** field_from_sensor, 9 numbers row by row. Frame sensor: +x right in the image, +y down, +z forward. */
  rotation: number[];
  at: { x: number; y: number; z: number }; // [m]
  /** True depth / measured depth. */
  depthScale: number;
}

/** The reasons why a printed tag gives no robot. */
export const kTagRefusals = ["unknown", "repeated", "implausible", "contradictory"] as const;
export type RefusedTags = Record<(typeof kTagRefusals)[number], number>;

export interface Sensor {
  /** "" if it reports none. */
  state: "waiting" | "watching" | "ended" | "";
  address: string;
  /** One sentence, or "". */
  problem: string;
  /** [Hz] of images. */
  rate: number;
  /** [ms] of processor time for one image. */
  detection_ms: number;
  pinhole: Pinhole | undefined;
  /** Undefined if it is not calibrated. */
  place: SensorPlace | undefined;
  /** [m] expected error of a place on the seen field; NaN if not calibrated. */
  errorMean: number;
  /** Counts since the calibration. Undefined of a depth camera, and if it is not calibrated. */
  refusedTags: RefusedTags | undefined;
  /** Counts of images of the empty field: those that depths are compared with, and those to come. */
  background: { images: number; awaited: number };
  robots: TrueThing[];
  ball: TrueThing | undefined;
}

/** Reports whether it compares depths with an empty field: it is calibrated, and no ordinary camera. */
export const comparesDepths = ({ place, refusedTags }: Sensor): boolean => place !== undefined && !refusedTags;

const kSensorTopic = /^\/truth\/(\d{1,6})\/sensor$/;

/** Returns the numbers of the sensors that a server offers, sorted. */
export const sensorNumbers = (memory: Memory): number[] =>
  [...memory.objects()]
    .flatMap(({ channel }) => kSensorTopic.exec(channel.topic)?.[1] ?? [])
    .map(Number)
    .sort((a, b) => a - b);

export const sensorObject = (memory: Memory, number: number) =>
  memory.get(`/truth/${number}/sensor`) as MemoryObject<TruthSensor> | undefined;

/** Returns the object with a sensor's depth or colour images, or undefined if it has none. */
export const sensorImages = (memory: Memory, number: number, kind: "depth" | "color") =>
  memory.get(`/truth/${number}/${kind}`) as MemoryObject<foxglove_RawImage> | undefined;

export function sensorOf(fields: Fields<TruthSensor>): Sensor {
  const place = fieldsOf(fields, "place");
  const state = wordOf(fields, "state");
  return {
    state: state === "unspecified" ? "" : state,
    address: textOf(fields, "address"),
    problem: textOf(fields, "problem"),
    rate: numberOf(fields, "rate_hz"),
    detection_ms: numberOf(fields, "detection_ms"),
    pinhole: pinholeOf(fieldsOf(fields, "pinhole")),
    place: placeOf(place),
    errorMean: numberOf(place, "error_mean"),
    refusedTags: fields.get("refused_tags") ? refusedTagsOf(fieldsOf(fields, "refused_tags")) : undefined,
    background: {
      images: numberOf(fields, "background_images") || 0,
      awaited: numberOf(fields, "background_awaited") || 0,
    },
    robots: thingsOf(listOf(fields, "robots")),
    ball: thingOf(fieldsOf(fields, "ball")),
  };
}

function refusedTagsOf(fields: Fields<TruthSensor_RefusedTags>): RefusedTags {
  const counts = kTagRefusals.map((reason) => [reason, numberOf(fields, reason) || 0]);
  return Object.fromEntries(counts) as RefusedTags;
}

function pinholeOf(fields: Fields<TruthSensor_Pinhole>): Pinhole | undefined {
  const of = (name: NumberIn<TruthSensor_Pinhole>) => numberOf(fields, name);
  const pinhole = {
    width: of("width"),
    height: of("height"),
    focal: { x: of("focal_x"), y: of("focal_y") },
    centre: { x: of("centre_x"), y: of("centre_y") },
  };
  const positive = [pinhole.width, pinhole.height, pinhole.focal.x, pinhole.focal.y];
  const { x, y } = pinhole.centre;
  return positive.every((value) => value > 0) && Number.isFinite(x) && Number.isFinite(y) ? pinhole : undefined;
}

function placeOf(fields: Fields<TruthSensor_SensorPlace>): SensorPlace | undefined {
  const rotation = (fields.get("rotation") as unknown[] | undefined)?.map(Number) ?? [];
  const at = { x: numberOf(fields, "x"), y: numberOf(fields, "y"), z: numberOf(fields, "z") };
  return placeFrom(rotation, at, numberOf(fields, "depth_scale"));
}

/** Returns undefined if a number of the pose is missing. A missing depth scale is 1. */
export function placeFrom(rotation: number[], at: SensorPlace["at"], depthScale: number): SensorPlace | undefined {
  const isWhole = rotation.length === 9 && [...rotation, at.x, at.y, at.z].every(Number.isFinite);
  return isWhole ? { rotation, at, depthScale: depthScale > 0 ? depthScale : 1 } : undefined;
}
