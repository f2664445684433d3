// The values that can be plotted: a number in a message by its path, or the error of a belief against the truth:
// /14/2/pose~truth.

import type { Entry } from "./history";
import type { Memory } from "./memory";
import type { MemoryObject } from "./memory_object";
import { numberAt, numbersIn, pathOf, type Step } from "./paths";
import { Series } from "./series";
import { listOf, numberOf, type Fields } from "./value";

const kTruth = "/truth/world";
const kError = "~truth";

/**
 * The series of a chosen measure, or the sentence that says why there is none. `message` and `field` lead to the
 * schema's comment.
 */
export type Measure =
  { series: Series; field: { message: string; name: string } | undefined; unit: string } | { why: string };

export function measureOf(memory: Memory, text: string): Measure {
  if (text.endsWith(kError)) return errorOf(memory, text.slice(0, -kError.length));
  const topics = [...memory.objects()].map(({ channel }) => channel.topic);
  const path = pathOf(text, topics);
  const object = path && memory.get(path.topic);
  if (!path || !object) return { why: "nothing of this name is offered" };
  if (path.steps.length === 0) return { why: "this is an object: choose a number in it" };
  const series = new Series(object, (fields) => numberAt(fields, path.steps));
  const steps = path.steps.filter((step): step is string => typeof step === "string");
  const field =
    steps.length === path.steps.length && steps.length === 1
      ? { message: object.channel.schemaName, name: steps[0]! }
      : lastField(path.steps);
  return { series, field, unit: "" };
}

/** Nested fields are identified by their name alone. */
const lastField = (steps: Step[]) => {
  const name = steps.findLast((step): step is string => typeof step === "string");
  return name === undefined ? undefined : { message: "", name };
};

/** [m] Distance between a robot's belief and the truth at the same moment, both in the frame `field`. */
function errorOf(memory: Memory, topic: string): Measure {
  const [, robot, what] = /^\/(\d+\/\d+)\/(pose|ball)$/.exec(topic) ?? [];
  const [object, truth] = [memory.get(topic), memory.get(kTruth)];
  if (!robot || !object) return { why: "only /team/player/pose and /team/player/ball can be compared with the truth" };
  if (!truth) return { why: "nobody tells the truth here: /truth/world is missing" };
  const [team, player] = robot.split("/").map(Number) as [number, number];
  const read = (fields: Fields, { log_ns }: Entry) => {
    const world = fieldsAt(truth, log_ns);
    const turned = fieldsAt(memory.get(`/${robot}/game`), log_ns)?.get("attacks_positive_x") === false;
    const pose = what === "pose" ? fields : fieldsAt(memory.get(`/${robot}/pose`), log_ns);
    if (!world || !pose) return NaN;
    const believed = what === "pose" ? placeOf(fields) : seenFrom(pose, placeOf(fields));
    const isIt = (entry: Fields) => numberOf(entry, "team") === team && numberOf(entry, "player") === player;
    const true_place = what === "pose" ? listOf(world, "robots").find(isIt) : world.get("ball");
    if (!(true_place instanceof Map)) return NaN;
    const [sign, so] = [turned ? -1 : 1, placeOf(true_place)];
    return Math.hypot(sign * believed.x - so.x, sign * believed.y - so.y);
  };
  return { series: new Series(object, read), field: undefined, unit: "m" };
}

const placeOf = (fields: Fields) => ({ x: numberOf(fields, "x"), y: numberOf(fields, "y") });

function seenFrom(pose: Fields, { x, y }: { x: number; y: number }) {
  const heading = numberOf(pose, "heading");
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  const { x: px, y: py } = placeOf(pose);
  return { x: px + cos * x - sin * y, y: py + sin * x + cos * y };
}

const decoded = new WeakMap<MemoryObject, { index: number; generation: number; fields: Fields | undefined }>();

/** Returns the fields of the object at a moment. Repeated requests for one message decode it once. */
function fieldsAt(object: MemoryObject | undefined, log_ns: bigint): Fields | undefined {
  if (!object) return undefined;
  const { history } = object;
  const index = history.indexAt(log_ns);
  const before = decoded.get(object);
  if (before?.index === index && before.generation === history.generation) return before.fields;
  const entry = history.get(index);
  const fields = entry && object.decode(entry.data).fields;
  decoded.set(object, { index, generation: history.generation, fields });
  return fields;
}

/** Lists everything that can be plotted now, of a robot and of objects without a robot. */
export function measuresOf(memory: Memory, robot: string): string[] {
  const objects = memory.objectsOf(robot).filter(({ derived, isImage }) => !derived && !isImage);
  const errors = memory.get(kTruth)
    ? ["pose", "ball"].filter((what) => memory.get(`/${robot}/${what}`)).map((what) => `/${robot}/${what}${kError}`)
    : [];
  const numbers = objects.flatMap((object) => {
    const fields = object.decoded()?.fields;
    return fields ? numbersIn(fields, object.channel.topic) : [];
  });
  return [...errors, ...numbers];
}

/** Lists the topics that a measure needs. */
export const topicsOfMeasure = (memory: Memory, text: string): string[] => {
  if (!text.endsWith(kError))
    return [
      pathOf(
        text,
        [...memory.objects()].map(({ channel }) => channel.topic),
      )?.topic ?? "",
    ].filter(Boolean);
  const robot = /^\/(\d+\/\d+)\//.exec(text)?.[1];
  return [text.slice(0, -kError.length), kTruth, `/${robot}/pose`, `/${robot}/game`].filter((topic) =>
    memory.get(topic),
  );
};
