// The text of expressions: "distance(ball, truth.ball) > 0.5 && any ball.x > 2". Find, the plot and everything else
// that takes one parse it here, into a tree without meaning; compile.ts gives it one.
//
//   or         := and { ("||" | "or") and }
//   and        := not { ("&&" | "and") not }
//   not        := ("!" | "not" | "any") not | comparison
//   comparison := sum [("==" | "!=" | "<=" | ">=" | "<" | ">") sum]
//   sum        := product { ("+" | "-") product }
//   product    := minus { ("*" | "/") minus }
//   minus      := "-" minus | operand
//   operand    := number | text in quotes | true | false | word | path | function "(" or { "," or } ")" { "." name }
//               | "(" or ")"
//
// A path is an object and steps into it: ball.x, /14/3/ball.x, joints.position[head_yaw], truth.robots[team=14,player=2].
// Topics contain slashes, so the parser must know them to tell a topic from a division.

import type { Step } from "./paths";

/** A part of the text: from the character `at` up to, not including, `end`. */
export interface Part {
  at: number;
  end: number;
}

export const kComparisons = ["==", "!=", "<=", ">=", "<", ">"] as const;
export type Comparison = (typeof kComparisons)[number];
export type Arithmetic = "+" | "-" | "*" | "/";
export type Junction = "&&" | "||";

/** A step that is not yet an index: the name of a joint. */
export type PathStep = Part & { step: Step | { name: string } };

export type Node = Part &
  (
    | { kind: "number"; value: number }
    | { kind: "text"; text: string }
    | { kind: "truth"; value: boolean }
    // the name of an enum value, a text without quotes, or a whole object
    | { kind: "word"; text: string }
    | { kind: "path"; object: string; steps: PathStep[] }
    | { kind: "call"; name: string; arguments: Node[] }
    | { kind: "member"; of: Node; name: string }
    | { kind: "minus"; of: Node }
    | { kind: "not"; of: Node }
    | { kind: "any"; of: Node }
    | { kind: "join"; how: Junction; left: Node; right: Node }
    | { kind: "compare"; how: Comparison; left: Node; right: Node }
    | { kind: "compute"; how: Arithmetic; left: Node; right: Node }
  );

/** A mistake and its place in the text. */
export class Complaint extends Error {
  constructor(
    sentence: string,
    readonly part: Part,
  ) {
    super(sentence);
  }
}

export interface Mistake extends Part {
  error: string;
}

/** Returns the result of `run`, or the mistake about which it complains. */
export function orMistake<T>(run: () => T): T | Mistake {
  try {
    return run();
  } catch (error) {
    if (error instanceof Complaint) return { error: error.message, ...error.part };
    throw error;
  }
}

const kMostDeep = 50; // [levels] of brackets and signs
export const kMostCharacters = 2000;

/**
 * Parses a text. Throws a Complaint. `objects` has all names that may contain slashes: topics ("/14/2/ball",
 * "/camera_top/jpeg") and topics without the robot ("ball", "camera_top/jpeg").
 */
export function parse(text: string, objects: Iterable<string>): Node {
  if (text.length > kMostCharacters)
    throw new Complaint(`At most ${kMostCharacters} characters are read.`, { at: kMostCharacters, end: text.length });
  return new Parser(text, [...objects]).whole();
}

class Parser {
  #at = 0;
  #deep = 0;

  constructor(
    readonly text: string,
    readonly objects: string[],
  ) {}

  whole(): Node {
    const node = this.#or();
    if (this.#at < this.text.length) {
      const rest = this.#rest();
      if (rest.text === ")") throw new Complaint("This bracket was never opened.", rest);
      if (rest.text === "=") throw new Complaint("“=” compares nothing: write == for “equals”.", rest);
      throw new Complaint(`Expected a sign such as && or > before “${rest.text}”.`, rest);
    }
    return node;
  }

  /** The next word or sign, for complaints. */
  #rest(): Part & { text: string } {
    const found = /^[\p{L}\d_./]+|^\S/u.exec(this.text.slice(this.#at))?.[0] ?? "";
    return { text: found, at: this.#at, end: Math.max(this.#at + found.length, this.#at + 1) };
  }

  #skip(): void {
    while (/\s/.test(this.text[this.#at] ?? "")) ++this.#at;
  }

  /** Takes what `pattern` (sticky) matches here, and the space behind it. */
  #take(pattern: RegExp): RegExpExecArray | undefined {
    pattern.lastIndex = this.#at;
    const found = pattern.exec(this.text);
    if (!found) return undefined;
    this.#at += found[0].length;
    return found;
  }
  #takeSign(pattern: RegExp): string | undefined {
    this.#skip();
    const found = this.#take(pattern);
    this.#skip();
    return found?.[0];
  }

  /** Runs `parse` one level deeper. */
  #within<T>(parse: () => T): T {
    if (++this.#deep > kMostDeep) throw new Complaint("There are too many brackets within each other.", this.#rest());
    try {
      return parse();
    } finally {
      --this.#deep;
    }
  }

  #chain(next: () => Node, pattern: RegExp, join: (sign: string, left: Node, right: Node) => Node): Node {
    let node = next();
    for (let sign; (sign = this.#takeSign(pattern)) !== undefined;) node = join(sign, node, next());
    return node;
  }

  #or(): Node {
    return this.#chain(
      () => this.#and(),
      /\|\||or(?![\p{L}\d_.])/uy,
      (_, left, right) => ({ kind: "join", how: "||", left, right, at: left.at, end: right.end }),
    );
  }
  #and(): Node {
    return this.#chain(
      () => this.#not(),
      /&&|and(?![\p{L}\d_.])/uy,
      (_, left, right) => ({ kind: "join", how: "&&", left, right, at: left.at, end: right.end }),
    );
  }
  #not(): Node {
    this.#skip();
    const at = this.#at;
    const sign = this.#takeSign(/!(?!=)|(?:not|any)(?![\p{L}\d_.])/uy);
    if (sign === undefined) return this.#comparison();
    const of = this.#within(() => this.#not());
    return { kind: sign === "any" ? "any" : "not", of, at, end: of.end };
  }
  #comparison(): Node {
    const left = this.#sum();
    const how = this.#takeSign(/[=!<>]=|[<>]/y) as Comparison | undefined;
    if (how === undefined) return left;
    const right = this.#sum();
    const again = this.#rest();
    if (/^[<>]$|^[=!]$/.test(again.text) && /^([<>]|[=!]=)/.test(this.text.slice(this.#at)))
      throw new Complaint("Comparisons make no chain: join two of them with &&.", again);
    return { kind: "compare", how, left, right, at: left.at, end: right.end };
  }
  #sum(): Node {
    return this.#chain(() => this.#product(), /[+-]/y, computed);
  }
  #product(): Node {
    return this.#chain(() => this.#minus(), /[*/]/y, computed);
  }
  #minus(): Node {
    this.#skip();
    const at = this.#at;
    if (this.#takeSign(/-/y) === undefined) return this.#operand();
    const of = this.#within(() => this.#minus());
    return { kind: "minus", of, at, end: of.end };
  }

  #operand(): Node {
    this.#skip();
    const at = this.#at;
    if (at === this.text.length) throw new Complaint("The text ends where a value is expected.", { at, end: at + 1 });
    if (this.#take(/\(/y)) {
      const node = this.#within(() => this.#or());
      this.#close(at);
      return { ...node, at, end: this.#at };
    }
    const number = this.#take(/(?:\d+(?:\.\d+)?|\.\d+)(?:e[+-]?\d+)?(?![\p{L}\d_.])/uy);
    if (number) return this.#number(Number(number[0]), at);
    const quoted = this.#take(/"([^"]*)"|'([^']*)'/y);
    if (quoted) return { kind: "text", text: (quoted[1] ?? quoted[2])!, at, end: this.#at };
    return this.#named(at);
  }

  #number(value: number, at: number): Node {
    const part = { at, end: this.#at };
    if (!Number.isFinite(value)) throw new Complaint("This number is too large.", part);
    return { kind: "number", value, ...part };
  }

  #close(opened: number): void {
    this.#skip();
    if (this.#take(/\)/y)) return;
    if (this.#at < this.text.length) {
      const rest = this.#rest();
      throw new Complaint(`Expected ) or a sign such as && before “${rest.text}”.`, rest);
    }
    throw new Complaint("A bracket is not closed.", { at: opened, end: opened + 1 });
  }

  /** Parses what begins with a name: a path, a function, a word. */
  #named(at: number): Node {
    const object = this.#object();
    const name =
      object ?? this.#take(/[\p{L}_][\p{L}\d_]*/uy)?.[0] ?? this.#take(/\/[\p{L}\d_][\p{L}\d_/]*/uy)?.[0] ?? "";
    if (name === "") {
      const rest = this.#rest();
      throw new Complaint(
        /^(?:[<>=!&|*/+,)]|and$|or$)/.test(rest.text)
          ? `Expected a value before “${rest.text}”.`
          : `I cannot read “${this.text.slice(at).trim().slice(0, 12)}”.`,
        rest,
      );
    }
    if (/^(and|or)$/.test(name)) throw new Complaint(`Expected a value before “${name}”.`, { at, end: this.#at });
    if (!name.includes("/") && this.#take(/\s*\(/y)) return this.#call(name, at);
    const steps = this.#steps();
    if (steps.length > 0 || name.includes("/")) return { kind: "path", object: name, steps, at, end: this.#at };
    if (name === "true" || name === "false") return { kind: "truth", value: name === "true", at, end: this.#at };
    return { kind: "word", text: name, at, end: this.#at };
  }

  /** Takes the longest known object that stands here. */
  #object(): string | undefined {
    let found = "";
    for (const name of this.objects)
      if (
        name.length > found.length &&
        this.text.startsWith(name, this.#at) &&
        !/^[\p{L}\d_]/u.test(this.text.slice(this.#at + name.length))
      )
        found = name;
    this.#at += found.length;
    return found || undefined;
  }

  #steps(): PathStep[] {
    const steps: PathStep[] = [];
    for (;;) {
      const at = this.#at;
      if (this.#take(/\./y)) {
        const name = this.#take(/[\p{L}\d_]+/uy)?.[0];
        if (name === undefined)
          throw new Complaint("The name of a field is missing here.", { at: at + 1, end: at + 2 });
        steps.push({ step: name, at, end: this.#at });
      } else if (this.#take(/\[/y)) {
        const inner = this.#take(/[^\]]*/y)![0];
        if (!this.#take(/\]/y)) throw new Complaint("A square bracket is not closed.", { at, end: at + 1 });
        const part = { at, end: this.#at };
        steps.push({ step: this.#index(inner.trim(), part), ...part });
      } else return steps;
    }
  }

  #index(inner: string, part: Part): PathStep["step"] {
    if (/^\d{1,9}$/.test(inner)) return Number(inner);
    if (/^[\p{L}_][\p{L}\d_]*$/u.test(inner)) return { name: inner };
    const entries = inner.split(",").map((one) => /^\s*([\p{L}_][\p{L}\d_]*)\s*=\s*(-?\d+(?:\.\d+)?)\s*$/u.exec(one));
    if (!entries.every((entry) => entry !== null))
      throw new Complaint("Expected a number, a joint or fields here: [0], [head_yaw], [team=14,player=2].", part);
    return Object.fromEntries(entries.map(([, key, value]) => [key!, Number(value)]));
  }

  #call(name: string, at: number): Node {
    const opened = this.#at - 1;
    const list: Node[] = [];
    if (this.#takeSign(/\)/y) === undefined) {
      do list.push(this.#within(() => this.#or()));
      while (this.#takeSign(/,/y) !== undefined);
      this.#close(opened);
    }
    let node: Node = { kind: "call", name, arguments: list, at, end: this.#at };
    for (let found; (found = this.#take(/\.([\p{L}\d_]*)/uy));) {
      const part = { at: this.#at - found[0].length, end: this.#at };
      if (found[1] === "")
        throw new Complaint("The name of a field is missing here.", { at: part.end, end: part.end + 1 });
      node = { kind: "member", of: node, name: found[1]!, at, end: this.#at };
    }
    return node;
  }
}

const computed = (how: string, left: Node, right: Node): Node => ({
  kind: "compute",
  how: how as Arithmetic,
  left,
  right,
  at: left.at,
  end: right.end,
});

const levelOf = (node: Node): number => {
  if (node.kind === "join") return node.how === "||" ? 1 : 2;
  if (node.kind === "not" || node.kind === "any") return 3;
  if (node.kind === "compare") return 4;
  if (node.kind === "compute") return node.how === "+" || node.how === "-" ? 5 : 6;
  return node.kind === "minus" ? 7 : 8;
};

/**
 * Writes a tree as text, from which parse() makes the same tree. With the gap "" the text has no spaces, except
 * between quotes.
 */
export function print(node: Node, gap: "" | " " = " "): string {
  const inner = (child: Node, least: number) => (levelOf(child) < least ? `(${print(child, gap)})` : print(child, gap));
  switch (node.kind) {
    case "number":
      return String(node.value);
    case "truth":
      return String(node.value);
    case "word":
      return node.text;
    case "text":
      return node.text.includes('"') ? `'${node.text}'` : `"${node.text}"`;
    case "path":
      return node.object + node.steps.map(({ step }) => textOfStep(step)).join("");
    case "call":
      return `${node.name}(${node.arguments.map((argument) => print(argument, gap)).join(`,${gap}`)})`;
    case "member":
      return `${print(node.of, gap)}.${node.name}`;
    case "minus":
      return `-${inner(node.of, 7)}`;
    case "not":
      return `!${inner(node.of, 3)}`;
    case "any":
      return `any(${print(node.of, gap)})`;
    default: {
      const level = levelOf(node);
      const left = inner(node.left, node.kind === "compare" ? level + 1 : level);
      return `${left}${gap}${node.how}${gap}${inner(node.right, level + 1)}`;
    }
  }
}

function textOfStep(step: PathStep["step"]): string {
  if (typeof step === "string") return `.${step}`;
  if (typeof step === "number") return `[${step}]`;
  if (typeof step["name"] === "string") return `[${step["name"]}]`;
  return `[${Object.entries(step)
    .map(([key, value]) => `${key}=${value}`)
    .join(",")}]`;
}
