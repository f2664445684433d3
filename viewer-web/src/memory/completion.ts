// Proposals for the word at the caret while somebody types an expression.

import { kFunctions } from "./compile";
import { isByJoint, jointIndex, kJoints } from "./joints";
import { pathOf } from "./paths";
import { wordsOfEnum, type Shape } from "./shape";
import { kTruth, robotOfTopic, topicOf, type Vocabulary } from "./vocabulary";

export interface Proposal {
  /** The text that replaces the word at the caret. */
  insert: string;
  /** For people: "field", "distance(a, b)". */
  label: string;
  about: string;
}

export interface Completion {
  /** The word at the caret, which a proposal replaces. */
  from: number;
  to: number;
  proposals: Proposal[];
}

const kMost = 40;

/** Returns the proposals for the caret's place, best first. */
export function completionAt(text: string, caret: number, vocabulary: Vocabulary): Completion {
  const before = text.slice(0, caret);
  const path = /(?:\/|[\p{L}_])[\p{L}\d_/]*(?:\.[\p{L}\d_]*|\[[^\]]*\])*(?:\[[^\]]*)?$/u.exec(before)?.[0] ?? "";
  const quoted = (before.match(/["']/g) ?? []).length % 2 === 1;
  if (quoted || (path === "" && /[\d"')\]]\s*$/.test(before))) return { from: caret, to: caret, proposals: [] };
  const opened = path.lastIndexOf("[") > path.lastIndexOf("]");
  const cut = opened ? path.lastIndexOf("[") : path.lastIndexOf(".");
  if (cut >= 0) {
    const [object, word] = [path.slice(0, cut), path.slice(cut + 1)];
    const behind = /^[\p{L}\d_]*/u.exec(text.slice(caret))![0].length;
    const all = opened ? entriesOf(object, vocabulary) : fieldsOf(object, vocabulary);
    return { from: caret - word.length, to: caret + behind, proposals: fitting(all, word) };
  }
  const values = valuesBefore(before.slice(0, before.length - path.length), vocabulary);
  const all = values ?? [...namesIn(vocabulary, path), ...kWords];
  const behind = /^[\p{L}\d_]*/u.exec(text.slice(caret))![0].length;
  return { from: caret - path.length, to: caret + behind, proposals: fitting(all, path) };
}

const kWords: Proposal[] = [
  ...kFunctions.map(({ name, form, does }) => ({ insert: `${name}(`, label: form, about: does })),
  { insert: "any ", label: "any …", about: "true for at least one robot: any ball.x > 2" },
];

/** Those that begin with the word come first, then those that contain it. A word that is complete needs no proposal. */
function fitting(all: Proposal[], word: string): Proposal[] {
  const wanted = word.toLowerCase();
  const rankOf = ({ label }: Proposal) => {
    const at = label.toLowerCase().indexOf(wanted);
    return at < 0 ? 2 : at === 0 ? 0 : 1;
  };
  const found = [0, 1].flatMap((rank) => all.filter((proposal) => rankOf(proposal) === rank));
  return found.length === 1 && found[0]!.insert === word ? [] : found.slice(0, kMost);
}

/** The objects of the chosen robot, or for a word that begins with "/" all topics. */
function namesIn(vocabulary: Vocabulary, word: string): Proposal[] {
  const { robot, topics } = vocabulary;
  const named = [...topics].map((topic) =>
    word.startsWith("/") ? topic : robotOfTopic(topic) === robot && robot ? topic.slice(robot.length + 2) : "",
  );
  const proposals = named
    .filter((name) => name !== "" && name.includes("/") === word.startsWith("/"))
    .sort()
    .map((name) => ({ insert: name, label: name, about: "object" }));
  const truth = topics.has(kTruth) && !word.startsWith("/");
  return truth ? [...proposals, { insert: "truth.", label: "truth", about: "the real ball and robots" }] : proposals;
}

/** The shape behind a path that is written so far. */
function shapeBehind(path: string, vocabulary: Vocabulary): { topic: string; shape: Shape | undefined } | undefined {
  const { robot } = vocabulary;
  const name = /^\/?[\p{L}\d_/]+/u.exec(path)?.[0] ?? "";
  const topic = topicOf(vocabulary, robot, name);
  if (topic === undefined) return undefined;
  const rest = path.slice(name.length).replace(/^\.pose(?=$|\.)/, (all) => (name === "truth" ? ".robots[0]" : all));
  const steps = rest === "" ? [] : pathOf(topic + rest, [topic])?.steps;
  let shape: Shape | undefined = steps && vocabulary.shapeOf(topic);
  for (const step of steps ?? [])
    if (typeof step === "string") shape = shape?.kind === "message" ? shape.field(step) : undefined;
    else shape = shape?.kind === "list" ? shape.of : undefined;
  return { topic, shape };
}

function fieldsOf(object: string, vocabulary: Vocabulary): Proposal[] {
  const found = shapeBehind(object, vocabulary);
  if (found?.shape?.kind !== "message") return [];
  const { shape } = found;
  const own = object === "truth" ? [{ insert: "pose", label: "pose", about: "the chosen robot's true pose" }] : [];
  return [
    ...own,
    ...shape.names().map((name) => {
      const field = shape.field(name);
      return { insert: name, label: name, about: field ? kKinds[field.kind] : "" };
    }),
  ];
}

const kKinds: Record<Shape["kind"], string> = {
  number: "number",
  truth: "true or false",
  text: "text",
  bytes: "bytes",
  unknown: "",
  enum: "one of some names",
  list: "list",
  message: "fields",
};

function entriesOf(object: string, vocabulary: Vocabulary): Proposal[] {
  const found = shapeBehind(object, vocabulary);
  if (found?.shape?.kind !== "list") return [];
  if (isByJoint(found.topic))
    return kJoints.map((name) => ({
      insert: `${name}]`,
      label: name,
      about: `joint ${jointIndex(found.topic, name)}`,
    }));
  const { of } = found.shape;
  const byRobot = of.kind === "message" && of.field("team") && of.field("player");
  return byRobot
    ? robotsAmong(vocabulary).map(([team, player]) => ({
        insert: `team=${team},player=${player}]`,
        label: `team=${team},player=${player}`,
        about: "this robot",
      }))
    : [{ insert: "0]", label: "0", about: "the first entry" }];
}

const robotsAmong = ({ topics }: Vocabulary): string[][] =>
  [...new Set([...topics].map(robotOfTopic).filter(Boolean))].sort().map((robot) => robot.split("/"));

/** The values of the enum that stands before a comparison at the end of `before`, or undefined. */
function valuesBefore(before: string, vocabulary: Vocabulary): Proposal[] | undefined {
  const path = /([/\p{L}_][\p{L}\d_/]*(?:\.[\p{L}\d_]+|\[[^\]]*\])+)\s*[=!]=\s*$/u.exec(before)?.[1];
  const shape = path === undefined ? undefined : shapeBehind(path, vocabulary)?.shape;
  if (shape?.kind === "enum")
    return [...wordsOfEnum(shape.values)].map(([number, word]) => ({
      insert: word,
      label: word,
      about: `value ${number}`,
    }));
  if (shape?.kind !== "truth") return undefined;
  return ["true", "false"].map((word) => ({ insert: word, label: word, about: "" }));
}
