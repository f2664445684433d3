// The values that can be plotted: expressions, such as a path or distance(ball, truth.ball), and the former way to write
// the error of a belief: /14/2/pose~truth.

import { compile, numberOf, type Expression } from "./compile";
import { orMistake } from "./expression";
import type { Entry } from "./history";
import { isByJoint, jointName } from "./joints";
import type { Memory } from "./memory";
import { topicOfRobot, type MemoryObject } from "./memory_object";
import { numberAt, numbersIn, pathOf, type Path, type Step } from "./paths";
import { Series } from "./series";
import type { Shape } from "./shape";
import type { Fields } from "./value";
import { kTruth, vocabularyOf } from "./vocabulary";

const kError = "~truth";

/**
 * The series of a chosen measure, or the sentence that says why there is none. `message` and `field` lead to the
 * schema's comment. `path` is set if the measure is a single value of a message. `words` has the names of an enum's values; `truth`: 1 is true and 0 is false.
 */
export type Measure =
  | {
      series: Series;
      field: { message: string; name: string } | undefined;
      path: Path | undefined;
      unit: string;
      words?: ReadonlyMap<number, string> | undefined;
      truth?: boolean;
    }
  | { why: string };

/**
 * Returns the measure with the given text. Objects without a topic are those of `robot`. The curve has one point for
 * each message of the object that the text names first; other objects have their newest value of that time.
 */
export function measureOf(memory: Memory, text: string, robot = ""): Measure {
  const expression = expressionOf(memory, text, robot);
  if ("why" in expression) return expression;
  const [first] = expression.topics;
  const objects = expression.topics.flatMap((topic) => memory.get(topic) ?? []);
  // an object of which nothing has come gives no points
  const object = objects.find(({ newest }) => newest !== undefined) ?? objects[0];
  if (first === undefined || !object) return { why: "this never changes: name a path such as ball.x" };
  if (expression.kind === "text" && !expression.path) return { why: "a text cannot be drawn" };
  const read = (fields: Fields, { log_ns }: Entry) =>
    numberOf(
      expression.value((topic) => (topic === object.channel.topic ? fields : fieldsAt(memory.get(topic), log_ns))),
    );
  return {
    series: new Series(object, read),
    field: expression.path && fieldOf(object, expression.path.steps),
    path: expression.path,
    unit: unitOf(expression),
    words: expression.words,
    truth: expression.kind === "truth",
  };
}

type Found = Pick<Expression, "topics" | "kind" | "path" | "words" | "value"> & { node?: Expression["node"] };

function expressionOf(memory: Memory, text: string, robot: string): Found | { why: string } {
  const rewritten = text.endsWith(kError) ? ofError(text.slice(0, -kError.length)) : text;
  if (rewritten === undefined)
    return { why: "only /team/player/pose and /team/player/ball can be compared with the truth" };
  const vocabulary = vocabularyOf(memory, robot);
  const expression = orMistake(() => compile(rewritten, vocabulary));
  if (!("error" in expression)) return expression;
  const path = pathOf(text, vocabulary.topics);
  return path && leadsToValue(vocabulary.shapeOf(path.topic), path.steps) ? ofPath(path) : { why: expression.error };
}

/** The error of a belief, as it was written before there were expressions. */
function ofError(topic: string): string | undefined {
  const [, team, player, what] = /^\/(\d+)\/(\d+)\/(pose|ball)$/.exec(topic) ?? [];
  if (what === undefined) return undefined;
  return `distance(${topic}, ${what === "ball" ? "truth.ball" : `truth.robots[team=${team},player=${player}]`})`;
}

/** A field whose name is no name in an expression, such as "a-b", can be plotted by its path alone. */
const ofPath = (path: Path): Found => ({
  topics: [path.topic],
  kind: "unknown",
  path,
  words: undefined,
  value: (look) => {
    const fields = look(path.topic);
    return fields && numberAt(fields, path.steps);
  },
});

function leadsToValue(shape: Shape, steps: Step[]): boolean {
  let at: Shape | undefined = shape;
  for (const step of steps) {
    if (typeof step !== "string") at = at?.kind === "list" ? at.of : undefined;
    else at = at?.kind === "message" ? at.field(step) : undefined;
  }
  return steps.length > 0 && at !== undefined;
}

/** "m", "rad", or "" if only the schema can tell the unit. */
function unitOf({ node }: Found): string {
  if (node?.kind === "member") return node.name === "heading" ? "rad" : "m";
  if (node?.kind !== "call") return "";
  return node.name === "distance" ? "m" : node.name === "angle" ? "rad" : "";
}

function fieldOf(object: MemoryObject, steps: Step[]): { message: string; name: string } | undefined {
  if (steps.length === 1 && typeof steps[0] === "string") return { message: object.channel.schemaName, name: steps[0] };
  // nested fields are identified by their name alone
  const name = steps.findLast((step): step is string => typeof step === "string");
  return name === undefined ? undefined : { message: "", name };
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
    ? (["pose", "ball"] as const)
        .map((what) => topicOfRobot(robot, what))
        .filter((topic) => memory.get(topic))
        .map((topic) => `${topic}${kError}`)
    : [];
  const numbers = objects.flatMap(numbersOf);
  return [...errors, ...numbers];
}

function numbersOf(object: MemoryObject): string[] {
  const fields = object.decoded()?.fields;
  const { topic } = object.channel;
  return fields
    ? numbersIn(fields, topic, isByJoint(topic) ? (index, count) => jointName(topic, index, count) : undefined)
    : [];
}

/** Lists the topics that a measure needs. */
export function topicsOfMeasure(memory: Memory, text: string, robot = ""): string[] {
  const expression = expressionOf(memory, text, robot);
  return "why" in expression ? [] : expression.topics;
}
