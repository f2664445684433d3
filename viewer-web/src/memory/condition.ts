// Conditions on memory objects: "ball.x > 2 && pose.deviation_x < 0.3", "game.state == playing || !game.ball_seen". A
// path is an object of the chosen robot and steps into it, or begins with a topic: "/14/3/ball.x". A word without a dot
// is a text or the name of an enum value. Case and the enum's prefix do not matter. An absent value is neither true nor
// equal to anything.

import { pathOf, valueAt, type Path, type Step } from "./paths";
import { EnumValue, type Fields, type Value } from "./value";

type Literal = number | boolean | string;

interface Reference {
  topic: string;
  steps: Step[];
}
type Operand = { literal: Literal } | { reference: Reference };
const kComparisons = ["==", "!=", "<=", ">=", "<", ">"] as const;
type Comparison = (typeof kComparisons)[number];

type Node =
  | { kind: "and" | "or"; left: Node; right: Node }
  | { kind: "not"; of: Node }
  | { kind: "compare"; how: Comparison; left: Operand; right: Operand }
  | { kind: "holds"; of: Operand };

/** Returns the newest message of a topic, or undefined before the first one. */
export type Look = (topic: string) => Fields | undefined;

export interface Condition {
  /** All topics that the condition reads, each once. */
  topics: string[];
  holds(look: Look): boolean;
}

class Complaint extends Error {}

interface Token {
  kind: "sign" | "number" | "text" | "name" | "end";
  text: string;
  at: number;
}

function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  const pattern =
    /\s*(?:(&&|\|\||[=!<>]=|[<>!()])|(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w./]))|"([^"]*)"|'([^']*)'|([\p{L}_/][\p{L}\d_./]*(?:\[[^\]]*\](?:\.[\p{L}\d_.]+)?)*))/uy;
  for (let at = 0; text.slice(at).trim() !== ""; at = pattern.lastIndex) {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    if (!found) throw new Complaint(`I cannot read “${text.slice(at).trim().slice(0, 12)}”.`);
    const [, sign, number, quoted, single, name] = found;
    const kind = sign !== undefined ? "sign" : number !== undefined ? "number" : name !== undefined ? "name" : "text";
    tokens.push({ kind, text: (sign ?? number ?? name ?? quoted ?? single)!, at });
  }
  return [...tokens, { kind: "end", text: "", at: text.length }];
}

const kMostDeep = 50; // [levels] of brackets and "!"

class Parser {
  #next = 0;
  #deep = 0;
  readonly topics = new Set<string>();

  constructor(
    readonly tokens: Token[],
    readonly robot: string,
    readonly known: string[],
  ) {}

  parse(): Node {
    const node = this.#or();
    const left = this.#peek();
    if (left.kind !== "end") throw new Complaint(`Expected && or || before “${left.text}”.`);
    return node;
  }

  #peek(): Token {
    return this.tokens[this.#next]!;
  }
  #take(...signs: string[]): string | undefined {
    const { kind, text } = this.#peek();
    if (kind !== "sign" || !signs.includes(text)) return undefined;
    ++this.#next;
    return text;
  }

  #or(): Node {
    let node = this.#and();
    while (this.#take("||")) node = { kind: "or", left: node, right: this.#and() };
    return node;
  }
  #and(): Node {
    let node = this.#single();
    while (this.#take("&&")) node = { kind: "and", left: node, right: this.#single() };
    return node;
  }
  #single(): Node {
    if (++this.#deep > kMostDeep) throw new Complaint("There are too many brackets within each other.");
    try {
      if (this.#take("!")) return { kind: "not", of: this.#single() };
      if (this.#take("(")) {
        const node = this.#or();
        if (!this.#take(")")) throw new Complaint("A bracket is not closed.");
        return node;
      }
      return this.#comparison();
    } finally {
      --this.#deep;
    }
  }
  #comparison(): Node {
    const left = this.#operand();
    const how = this.#take(...kComparisons) as Comparison | undefined;
    if (!how) {
      if ("literal" in left && typeof left.literal !== "boolean")
        throw new Complaint(`“${left.literal}” must be compared with something.`);
      return { kind: "holds", of: left };
    }
    const right = this.#operand();
    if ("literal" in left && "literal" in right)
      throw new Complaint(
        `“${left.literal}” and “${right.literal}” never change: one side must be a path such as ball.x.`,
      );
    return { kind: "compare", how, left, right };
  }
  #operand(): Operand {
    const { kind, text } = this.#peek();
    if (kind === "end") throw new Complaint("The condition ends where a value is expected.");
    if (kind === "sign") throw new Complaint(`Expected a value before “${text}”.`);
    ++this.#next;
    if (kind === "number") return { literal: Number(text) };
    if (kind === "text") return { literal: text };
    if (text === "true" || text === "false") return { literal: text === "true" };
    if (!/[./[]/.test(text)) return { literal: text };
    return { reference: this.#reference(text) };
  }
  #reference(text: string): Reference {
    const full = text.startsWith("/") ? text : `/${this.robot}/${text}`;
    const path: Path | undefined = pathOf(full, this.known) ?? pathOf(`/${text}`, this.known);
    if (!path)
      throw new Complaint(
        text.startsWith("/")
          ? `Nobody tells “${text}”.`
          : `Robot ${this.robot || "–"} has no object “${text.split(/[.[]/)[0]}”.`,
      );
    if (path.steps.length === 0)
      throw new Complaint(`“${text}” is a whole object: name a field of it, such as ${text}.x.`);
    this.topics.add(path.topic);
    return path;
  }
}

/** Parses a condition, or returns a sentence about the mistake. `known`: all existing topics. */
export function conditionOf(text: string, robot: string, known: Iterable<string>): Condition | { error: string } {
  try {
    const parser = new Parser(tokensOf(text), robot, [...known]);
    const node = parser.parse();
    if (parser.topics.size === 0) throw new Complaint("The condition never changes: name a path such as ball.x.");
    return { topics: [...parser.topics], holds: (look) => holds(node, look) };
  } catch (error) {
    if (error instanceof Complaint) return { error: error.message };
    throw error;
  }
}

function holds(node: Node, look: Look): boolean {
  switch (node.kind) {
    case "and":
      return holds(node.left, look) && holds(node.right, look);
    case "or":
      return holds(node.left, look) || holds(node.right, look);
    case "not":
      return !holds(node.of, look);
    case "compare":
      return compares(node.how, valueOf(node.left, look), valueOf(node.right, look));
    case "holds":
      return isTrue(valueOf(node.of, look));
  }
}

function valueOf(operand: Operand, look: Look): Value {
  if ("literal" in operand) return operand.literal;
  const fields = look(operand.reference.topic);
  return fields && valueAt(fields, operand.reference.steps);
}

const isTrue = (value: Value): boolean =>
  value === true || (typeof value !== "boolean" && Boolean(value instanceof EnumValue ? value.number : value));

function compares(how: Comparison, left: Value, right: Value): boolean {
  if (left === undefined || right === undefined) return false;
  if (how === "==") return same(left, right);
  if (how === "!=") return !same(left, right);
  const [one, other] = [numeric(left), numeric(right)];
  if (how === "<") return one < other;
  if (how === ">") return one > other;
  return how === "<=" ? one <= other : one >= other;
}

/** Returns NaN for a value that is no number, so that every comparison with it is false. */
function numeric(value: Value): number {
  if (typeof value === "number" || typeof value === "bigint" || typeof value === "boolean") return Number(value);
  return value instanceof EnumValue ? value.number : NaN;
}

function same(left: Value, right: Value): boolean {
  if (left instanceof EnumValue && typeof right === "string") return isCalled(left, right);
  if (right instanceof EnumValue && typeof left === "string") return isCalled(right, left);
  if (typeof left === "string" || typeof right === "string") return left === right;
  return numeric(left) === numeric(right);
}

/** STATE_PLAYING matches "STATE_PLAYING", "state_playing" and "playing". */
function isCalled({ name }: EnumValue, word: string): boolean {
  const [full, wanted] = [name?.toLowerCase(), word.toLowerCase()];
  return full !== undefined && (full === wanted || full.endsWith(`_${wanted}`));
}
