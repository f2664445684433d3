// The meaning of an expression: which objects it reads, and its value at a moment. Mistakes that the schemas reveal are
// found here, with their place in the text.

import { Complaint, parse, type Comparison, type Node, type Part, type PathStep } from "./expression";
import { jointIndex } from "./joints";
import { valueAt, type Step } from "./paths";
import {
  distanceOf,
  frameOf,
  placeAt,
  toField,
  topicsOfFrame,
  turnOf,
  type Frame,
  type Look,
  type Place,
} from "./places";
import type { GroundTruth } from "./schema";
import { wordsOfEnum, type Shape } from "./shape";
import { objectNames, robotOfTopic, robotsOf, topicOf, type Vocabulary } from "./vocabulary";
import { EnumValue, type Value } from "./value";

const kRobots = "robots" satisfies keyof GroundTruth;

export type Kind = "number" | "truth" | "text" | "enum" | "unknown";

export interface Expression {
  node: Node;
  kind: Kind;
  /** All topics that are read, each once; the first one that the text names comes first. */
  topics: string[];
  /** The only path, if the expression is one. */
  path: { topic: string; steps: Step[] } | undefined;
  /** For an enum: the words for its values. */
  words: ReadonlyMap<number, string> | undefined;
  /** Undefined: absent. */
  value(look: Look): Value;
}

export interface Function {
  name: string;
  /** As it is written, for people. */
  form: string;
  does: string;
  /** Least and greatest number of arguments. */
  takes: [number, number];
}

export const kFunctions: readonly Function[] = [
  { name: "abs", form: "abs(a)", does: "the number without its sign", takes: [1, 1] },
  { name: "min", form: "min(a, b, …)", does: "the least of some numbers", takes: [2, 20] },
  { name: "max", form: "max(a, b, …)", does: "the greatest of some numbers", takes: [2, 20] },
  { name: "angle", form: "angle(a, b)", does: "difference of two directions, -π … π; of headings too", takes: [2, 2] },
  { name: "distance", form: "distance(a, b)", does: "metres between two places: belief and truth", takes: [2, 2] },
  { name: "field", form: "field(ball)", does: "a believed place in coordinates of the field", takes: [1, 1] },
];

/** Compiles a text. Throws a Complaint. */
export function compile(text: string, vocabulary: Vocabulary): Expression {
  const node = parse(text, objectNames(vocabulary));
  const compiler = new Compiler(vocabulary);
  const made = compiler.value(node, vocabulary.robot);
  return {
    node,
    kind: made.kind,
    topics: [...compiler.topics],
    path: made.path,
    words: made.values && wordsOfEnum(made.values),
    value: made.read,
  };
}

interface Made {
  kind: Kind;
  /** It is written in the text and never changes. */
  constant: boolean;
  read: (look: Look) => Value;
  path?: { topic: string; steps: Step[] };
  values?: ReadonlyMap<number, string>;
}

interface MadePlace {
  frame: Frame | undefined;
  robot: string;
  topic: string;
  read: (look: Look) => Place | undefined;
}

/** A path leads to a message, list or value. */
interface Found {
  topic: string;
  steps: Step[];
  shape: Shape;
}

class Missing extends Complaint {}

const quoted = (text: string): string => `“${text}”`;

class Compiler {
  readonly topics = new Set<string>();

  constructor(readonly vocabulary: Vocabulary) {}

  value(node: Node, robot: string): Made {
    switch (node.kind) {
      case "number":
        return { kind: "number", constant: true, read: () => node.value };
      case "truth":
        return { kind: "truth", constant: true, read: () => node.value };
      case "text":
      case "word":
        return { kind: "text", constant: true, read: () => node.text };
      case "path":
        return this.#path(node, robot);
      case "member":
        return this.#member(node, robot);
      case "call":
        return this.#call(node, robot);
      case "minus":
        return this.#minus(node, robot);
      case "compute":
        return this.#compute(node, robot);
      case "compare":
        return this.#compare(node, robot);
      case "not": {
        const of = this.#truth(node.of, robot);
        return { kind: "truth", constant: false, read: (look) => !of(look) };
      }
      case "join": {
        const [left, right] = [this.#truth(node.left, robot), this.#truth(node.right, robot)];
        const read =
          node.how === "&&" ? (look: Look) => left(look) && right(look) : (look: Look) => left(look) || right(look);
        return { kind: "truth", constant: false, read };
      }
      case "any":
        return this.#any(node);
    }
  }

  /** Compiles what is true or false. */
  #truth(node: Node, robot: string): (look: Look) => boolean {
    const made = this.value(node, robot);
    if (node.kind === "word") this.#refuseObject(node, robot);
    checkTruth(node, made);
    return (look) => isTrue(made.read(look));
  }

  /** Compiles a number. */
  #number(node: Node, robot: string): (look: Look) => number | undefined {
    const made = this.value(node, robot);
    if (made.kind === "text") {
      this.#refuseObject(node, robot);
      const name = node.kind === "word" ? quoted(node.text) : "A text";
      throw new Complaint(`${name} is no number: name a path such as ball.x.`, node);
    }
    return (look) => {
      const number = numberOf(made.read(look));
      return Number.isNaN(number) ? undefined : number;
    };
  }

  /** Complains about a word that is the name of an object. */
  #refuseObject(node: Node, robot: string): void {
    if (node.kind === "word" && topicOf(this.vocabulary, robot, node.text) !== undefined)
      throw new Complaint(wholeObject(node.text), node);
  }

  #find(object: string, steps: PathStep[], part: Part, robot: string): Found {
    const topic = topicOf(this.vocabulary, robot, object);
    if (topic === undefined) {
      const place = { at: part.at, end: part.at + object.length };
      if (object.startsWith("/")) throw new Missing(`Nobody tells ${quoted(object)}.`, place);
      if (object === "truth") throw new Missing("Nobody tells the truth here: there is no object /truth/world.", place);
      throw new Missing(`Robot ${robot || "–"} has no object ${quoted(object)}.`, place);
    }
    this.topics.add(topic);
    let shape = this.vocabulary.shapeOf(topic);
    const taken: Step[] = [];
    let so_far = object;
    for (const [i, one] of steps.entries()) {
      // truth.pose is the chosen robot's entry among all true robots
      if (i === 0 && object === "truth" && one.step === "pose" && fieldOf(shape, "pose") === undefined) {
        const [team, player] = robot.split("/").map(Number) as [number, number];
        taken.push(kRobots, { team, player });
        const robots = fieldOf(shape, kRobots);
        shape = robots?.kind === "list" ? robots.of : { kind: "unknown" };
      } else {
        const step = indexOf(topic, one);
        shape = within(shape, step, so_far, one);
        taken.push(step);
      }
      so_far += typeof one.step === "string" ? `.${one.step}` : "[…]";
    }
    return { topic, steps: taken, shape };
  }

  #path(node: Node & { kind: "path" }, robot: string): Made {
    const { topic, steps, shape } = this.#find(node.object, node.steps, node, robot);
    const text = node.object + node.steps.map(({ step }) => (typeof step === "string" ? `.${step}` : "[…]")).join("");
    if (steps.length === 0) throw new Complaint(wholeObject(node.object), node);
    if (shape.kind === "message" && !shape.open) throw new Complaint(wholePart(text, shape), node);
    if (shape.kind === "list")
      throw new Complaint(`${quoted(text)} is a list: name one entry, such as ${text}[0].`, node);
    if (shape.kind === "bytes") throw new Complaint(`${quoted(text)} is a row of bytes, which has no value.`, node);
    return {
      kind: shape.kind === "message" ? "unknown" : shape.kind,
      constant: false,
      path: { topic, steps },
      ...(shape.kind === "enum" ? { values: shape.values } : {}),
      read: (look) => {
        const fields = look(topic);
        return fields && valueAt(fields, steps);
      },
    };
  }

  /** Compiles a place: an object or message with x and y, or field(…) of one. */
  #place(node: Node, robot: string, user: string): MadePlace {
    if (node.kind === "call" && node.name === "field") {
      const inner = this.#fieldPlace(this.#place(this.#only(node), robot, "field"), node.arguments[0]!);
      return { frame: "field", robot: "", topic: "", read: inner };
    }
    if (node.kind !== "word" && node.kind !== "path")
      throw new Complaint(`${user}() needs a place here, such as ball or truth.ball.`, node);
    const object = node.kind === "word" ? node.text : node.object;
    const { topic, steps, shape } = this.#find(object, node.kind === "word" ? [] : node.steps, node, robot);
    const [x, y] = [fieldOf(shape, "x"), fieldOf(shape, "y")];
    if ((shape.kind !== "message" && shape.kind !== "unknown") || (shape.kind === "message" && (!x || !y)))
      throw new Complaint(
        shape.kind === "message"
          ? "This has no x and y, so it is no place."
          : `${user}() needs a place here, not a value.`,
        node,
      );
    if (user === "angle" && shape.kind === "message" && !shape.open && !shape.field("heading"))
      throw new Complaint("This place has no heading.", node);
    const frame = frameOf(topic, steps.length > 0, shape.kind === "message" ? shape.name : "");
    return { frame, robot: robotOfTopic(topic), topic, read: (look) => placeAt(look(topic), steps) };
  }

  /** Converts a place to the frame `field`. */
  #fieldPlace({ frame, robot, read }: MadePlace, node: Node): (look: Look) => Place | undefined {
    if (!frame)
      throw new Complaint("Nothing tells in which frame this place is, so it cannot be put on the field.", node);
    for (const topic of topicsOfFrame(frame, robot))
      if (this.vocabulary.topics.has(topic)) this.topics.add(topic);
      else if (topic.endsWith("/pose"))
        throw new Missing(`Robot ${robot || "–"} reports no pose, so this place is not known on the field.`, node);
    return (look) => toField(read(look), frame, robot, look);
  }

  /** Compiles two places in one frame. */
  #places(
    node: Node & { kind: "call" },
    robot: string,
  ): [(look: Look) => Place | undefined, (look: Look) => Place | undefined] {
    const [left, right] = node.arguments as [Node, Node];
    const [a, b] = [this.#place(left, robot, node.name), this.#place(right, robot, node.name)];
    const together = a.frame === b.frame && (a.frame ? a.robot === b.robot : a.topic === b.topic);
    return together ? [a.read, b.read] : [this.#fieldPlace(a, left), this.#fieldPlace(b, right)];
  }

  #only(node: Node & { kind: "call" }): Node {
    checkCount(
      node,
      kFunctions.find(({ name }) => name === node.name)!,
    );
    return node.arguments[0]!;
  }

  #member(node: Node & { kind: "member" }, robot: string): Made {
    const { of, name } = node;
    const place = { at: of.end, end: node.end };
    if (of.kind !== "call" || of.name !== "field") throw new Complaint("A number has no fields.", place);
    if (name !== "x" && name !== "y" && name !== "heading")
      throw new Complaint("A place on the field has x, y and heading.", place);
    const { read } = this.#place(of, robot, "field");
    return { kind: "number", constant: false, read: (look) => finite(read(look)?.[name]) };
  }

  #call(node: Node & { kind: "call" }, robot: string): Made {
    const known = kFunctions.find(({ name }) => name === node.name);
    if (!known)
      throw new Complaint(
        `There is no function ${quoted(node.name)}, only ${kFunctions.map(({ name }) => name).join(", ")}.`,
        { at: node.at, end: node.at + node.name.length },
      );
    checkCount(node, known);
    if (node.name === "field")
      throw new Complaint("A place is not one value: write .x, .y or .heading behind it.", node);
    if (
      node.name === "distance" ||
      (node.name === "angle" && node.arguments.some((one) => this.#isPlace(one, robot)))
    ) {
      const [a, b] = this.#places(node, robot);
      const between =
        node.name === "distance" ? distanceOf : (one: Place, other: Place) => turnOf(one.heading, other.heading);
      const read = (look: Look) => {
        const [one, other] = [a(look), b(look)];
        return one && other && finite(between(one, other));
      };
      return { kind: "number", constant: false, read };
    }
    const parts = node.arguments.map((argument) => this.#number(argument, robot));
    const compute = kOfNumbers[node.name]!;
    const read = (look: Look) => {
      const numbers = parts.map((part) => part(look));
      return numbers.every((number) => number !== undefined) ? compute(...numbers) : undefined;
    };
    return { kind: "number", constant: false, read };
  }

  #isPlace(node: Node, robot: string): boolean {
    if (node.kind === "call") return node.name === "field";
    if (node.kind === "word") return topicOf(this.vocabulary, robot, node.text) !== undefined;
    return node.kind === "path" && this.#find(node.object, node.steps, node, robot).shape.kind === "message";
  }

  #minus(node: Node & { kind: "minus" }, robot: string): Made {
    const of = this.#number(node.of, robot);
    const read = (look: Look) => {
      const number = of(look);
      return number === undefined ? undefined : -number;
    };
    return { kind: "number", constant: node.of.kind === "number", read };
  }

  #compute(node: Node & { kind: "compute" }, robot: string): Made {
    const [left, right] = [this.#number(node.left, robot), this.#number(node.right, robot)];
    const compute = kArithmetic[node.how];
    const read = (look: Look) => {
      const [a, b] = [left(look), right(look)];
      return a === undefined || b === undefined ? undefined : finite(compute(a, b));
    };
    return { kind: "number", constant: false, read };
  }

  #compare(node: Node & { kind: "compare" }, robot: string): Made {
    const [left, right] = [this.value(node.left, robot), this.value(node.right, robot)];
    for (const [side, other] of [
      [node.left, right],
      [node.right, left],
    ] as const)
      if (other.constant || other.kind === "number" || other.kind === "truth") this.#refuseObject(side, robot);
    if (left.constant && right.constant)
      throw new Complaint("Both sides never change: one must be a path such as ball.x.", node);
    const { how } = node;
    checkKinds(how, node.left, left, right);
    checkKinds(how, node.right, right, left);
    return { kind: "truth", constant: false, read: (look) => compares(how, left.read(look), right.read(look)) };
  }

  /** Compiles the inner part once for each robot that has all objects in it. */
  #any(node: Node & { kind: "any" }): Made {
    const parts: ((look: Look) => boolean)[] = [];
    let missing: Missing | undefined;
    for (const robot of robotsOf(this.vocabulary)) {
      const inner = new Compiler(this.vocabulary);
      try {
        parts.push(inner.#truth(node.of, robot));
        inner.topics.forEach((topic) => this.topics.add(topic));
      } catch (error) {
        if (!(error instanceof Missing)) throw error;
        missing ??= error;
      }
    }
    if (parts.length === 0) throw missing ?? new Complaint("No robot is known here.", node);
    return { kind: "truth", constant: false, read: (look) => parts.some((part) => part(look)) };
  }
}

const kArithmetic = {
  "+": (a: number, b: number) => a + b,
  "-": (a: number, b: number) => a - b,
  "*": (a: number, b: number) => a * b,
  "/": (a: number, b: number) => a / b,
};
const kOfNumbers: Record<string, (...numbers: number[]) => number> = {
  abs: (a) => Math.abs(a!),
  min: Math.min,
  max: Math.max,
  angle: (a, b) => turnOf(a!, b!),
};

const finite = (value: number | undefined): number | undefined => (Number.isFinite(value) ? value : undefined);

const wholeObject = (name: string): string =>
  `${quoted(name)} is a whole object: name a field of it, such as ${name}.x.`;

function wholePart(text: string, shape: Shape & { kind: "message" }): string {
  const [first] = shape.names();
  return `${quoted(text)} has fields of its own: name one of them${first ? `, such as ${text}.${first}` : ""}.`;
}

const fieldOf = (shape: Shape, name: string): Shape | undefined =>
  shape.kind === "message" ? shape.field(name) : undefined;

function checkCount(node: Node & { kind: "call" }, { form, takes: [least, most] }: Function): void {
  const count = node.arguments.length;
  if (count >= least && count <= most) return;
  const place = count < least ? { at: node.end - 1, end: node.end } : node.arguments[most]!;
  throw new Complaint(`${count < least ? "A value is missing" : "This is one value too many"}: ${form}.`, place);
}

/** Returns the step with the index of a named joint. */
function indexOf(topic: string, { step, at, end }: PathStep): Step {
  if (typeof step !== "object" || typeof step["name"] !== "string") return step as Step;
  const index = jointIndex(topic, step["name"]);
  if (index === undefined)
    throw new Complaint(
      topic.endsWith("/joints")
        ? `No joint is called ${quoted(step["name"])}.`
        : "Only lists by joint take a name here.",
      { at: at + 1, end: end - 1 },
    );
  return index;
}

/** Returns the shape behind one more step. */
function within(shape: Shape, step: Step, so_far: string, part: Part): Shape {
  if (shape.kind === "unknown") return shape;
  if (typeof step === "string") {
    if (shape.kind === "list")
      throw new Complaint(`${quoted(so_far)} is a list: name one entry before the field, such as ${so_far}[0].`, part);
    if (shape.kind !== "message") throw new Complaint(`${quoted(so_far)} is one value and has no fields.`, part);
    const field = shape.field(step);
    if (field) return field;
    if (shape.open) return { kind: "unknown" };
    const names = shape.names();
    const some = names.slice(0, 6).join(", ") + (names.length > 6 ? " and others" : "");
    throw new Complaint(`${quoted(so_far)} has no field ${quoted(step)}, only ${some || "none"}.`, {
      at: part.at + 1,
      end: part.end,
    });
  }
  if (shape.kind === "list") return shape.of;
  throw new Complaint(`${quoted(so_far)} is no list.`, part);
}

/** Complains about what is neither true nor false. A path may stand alone: it holds if it is not zero or empty. */
export function checkTruth(
  node: Node,
  { kind, constant, path }: { kind: Kind; constant: boolean; path?: unknown },
): void {
  if (kind === "truth" || path) return;
  if (constant && kind === "text")
    throw new Complaint(`${quoted("text" in node ? node.text : "")} must be compared with something.`, node);
  throw new Complaint("This is a number: compare it with something, such as > 0.", node);
}

/** Complains if `one` cannot be compared so with `other`. */
function checkKinds(how: Comparison, node: Node, one: Made, other: Made): void {
  if (one.kind !== "text") return;
  const name = "text" in node ? quoted(node.text) : "A text";
  if (how !== "==" && how !== "!=") throw new Complaint(`${name} has no order: compare it with == or !=.`, node);
  if (other.kind === "number") throw new Complaint(`${name} is no number, but the other side is one.`, node);
  if (other.kind === "truth") throw new Complaint(`The other side is true or false, never ${name}.`, node);
  if (!one.constant || other.kind !== "enum" || !other.values || !("text" in node)) return;
  const { text } = node;
  if ([...other.values.values()].some((value) => isCalled(value, text))) return;
  const words = [...wordsOfEnum(other.values).values()].join(", ");
  throw new Complaint(`${name} is none of its values: ${words}.`, node);
}

export const isTrue = (value: Value): boolean =>
  value === true || (typeof value !== "boolean" && Boolean(value instanceof EnumValue ? value.number : value));

function compares(how: Comparison, left: Value, right: Value): boolean {
  if (left === undefined || right === undefined) return false;
  if (how === "==") return same(left, right);
  if (how === "!=") return !same(left, right);
  const [one, other] = [numberOf(left), numberOf(right)];
  if (how === "<") return one < other;
  if (how === ">") return one > other;
  return how === "<=" ? one <= other : one >= other;
}

/** Returns NaN for a value that is no number, so that every comparison with it is false. True is 1. */
export function numberOf(value: Value): number {
  if (typeof value === "number" || typeof value === "bigint" || typeof value === "boolean") return Number(value);
  return value instanceof EnumValue ? value.number : NaN;
}

function same(left: Value, right: Value): boolean {
  if (left instanceof EnumValue && typeof right === "string") return isCalled(left.name, right);
  if (right instanceof EnumValue && typeof left === "string") return isCalled(right.name, left);
  if (typeof left === "string" || typeof right === "string") return left === right;
  return numberOf(left) === numberOf(right);
}

/** STATE_PLAYING matches "STATE_PLAYING", "state_playing" and "playing". */
function isCalled(name: string | undefined, word: string): boolean {
  const [full, wanted] = [name?.toLowerCase(), word.toLowerCase()];
  return full !== undefined && (full === wanted || full.endsWith(`_${wanted}`));
}
