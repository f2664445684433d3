// The reasons of a decision, as a server computes them: the question with the objects of the shown moment, and the answer.

import { base64Encode } from "@bufbuild/protobuf/wire";
import { listOf, objectOf, textOf, type Json } from "../source/json";
import type { Entry } from "./history";
import type { Memory } from "./memory";
import type { MemoryObject, RobotName } from "./memory_object";
import type { RobotObject } from "./schema";
import { kSimulation } from "./simulation";
import { kTruth } from "./vocabulary";

export const kWhy = "/decision/why";
export const kWhyNot = "/decision/why_not";
export const kSituation = "/decision/situation";

/** The objects that a decision reads, and the decision itself. */
const kRead = [
  "ball",
  "pose",
  "team",
  "opponents",
  "vision",
  "game",
  "motion_status",
  "decision",
] satisfies RobotObject[];

/** A page that has just been opened has only the newest message of an object. It may be a little newer than the decision. */
const kSameMoment_ns = 100_000_000n;

/** The newest message of each object at one decision. */
export interface ReasonsRequest {
  robot: RobotName;
  /** [ns] Capture time of the decision. */
  at_ns: string;
  objects: Record<string, { capture_ns: string; data: string }>;
}

/** The shown decision of a robot, and what it knew then. */
export interface KnownThen {
  robot: RobotName;
  /** [ns] Capture time of the decision. */
  at_ns: bigint;
  /** By the names of a question. */
  entries: [name: string, entry: Entry][];
}

/** Returns undefined if no decision is shown. */
export function knownThen(memory: Memory, robot: RobotName): KnownThen | undefined {
  const decision = memory.of(robot, "decision")?.shown;
  if (!decision) return undefined;
  const at_ns = decision.log_ns;
  const entries: KnownThen["entries"] = [];
  const add = (name: string, object: Pick<MemoryObject, "history" | "shown"> | undefined) => {
    const entry = object?.history.at(at_ns) ?? object?.shown;
    if (entry && entry.log_ns <= at_ns + kSameMoment_ns) entries.push([name, entry]);
  };
  for (const name of kRead) add(name, memory.of(robot, name));
  add("truth", memory.world(kTruth));
  add("simulation", memory.world(kSimulation));
  return { robot, at_ns, entries };
}

/** Returns the question about that decision. */
export const requestOf = ({ robot, at_ns, entries }: KnownThen): ReasonsRequest => ({
  robot,
  at_ns: String(at_ns),
  objects: Object.fromEntries(
    entries.map(([name, { log_ns, data }]) => [name, { capture_ns: String(log_ns), data: base64Encode(data) }]),
  ),
});

/** A part of the tree: all that lies below a name. */
export interface Part {
  path: string;
  name: string;
  depth: number;
  /** Only a leaf has a skill. */
  skill: string | undefined;
  taken: boolean;
}

/** One comparison of the tree. Values are texts with units: "0.35 m". */
export interface Comparison {
  node: number;
  /** Index of the part to which it leads. */
  part: number;
  condition: string;
  result: boolean;
  value: string;
  threshold: string | undefined;
}

/** A comparison on the path. */
export interface Reason {
  comparison: Comparison;
  /** Undefined without a truth. */
  truth: string | undefined;
  /** The true value gives the other answer. */
  misled: boolean;
  margin: string | undefined;
  /** The nearest value that answers otherwise, and the skill and leaf to which it leads. */
  flip: string | undefined;
  other: { skill: string; leaf: string } | undefined;
  sources: { text: string; error: number | undefined }[];
}

export interface Reasons {
  robot: RobotName;
  at_ns: bigint;
  sentence: string;
  skill: string;
  role: string;
  strategy: string;
  plays: boolean;
  parts: Part[];
  comparisons: Comparison[];
  path: Reason[];
  /** The reason with the least margin. */
  narrowest: Reason | undefined;
  /** False if the robot reached another leaf: the memory of its behaviour is not recorded. */
  agrees: boolean;
}

/** The answer to "why not?". */
export interface Alternative {
  kind: "reached" | "changed" | "unreachable" | "unsure";
  leaf: string | undefined;
  features: { name: string; before: string; text: string }[];
  thresholds: { node: number; condition: string; before: string; after: string }[] | undefined;
  beliefs: string[] | undefined;
}

const objectsOf = (value: unknown): Json[] => listOf(value).map(objectOf);
const maybe = (value: unknown): string | undefined => (typeof value === "string" ? value : undefined);
const count = (value: unknown): number => (typeof value === "number" ? value : 0);

/** Reads the answer of kWhy. A part that is missing or of another type becomes empty. */
export function reasonsOf(answer: Json, { robot, at_ns }: Pick<KnownThen, "robot" | "at_ns">): Reasons {
  const told = objectOf(answer["reasons"]);
  const comparisons = objectsOf(told["comparisons"]).map((one): Comparison => ({
    node: count(one["node"]),
    part: count(one["part"]),
    condition: textOf(one["condition"]),
    result: one["result"] === true,
    value: textOf(one["value"]),
    threshold: maybe(one["threshold"]),
  }));
  const byNode = new Map(comparisons.map((comparison) => [comparison.node, comparison]));
  const path = objectsOf(told["path"]).flatMap((one): Reason[] => {
    const comparison = byNode.get(one["node"] as number);
    if (!comparison) return [];
    const other = objectOf(one["other"]);
    return [
      {
        comparison,
        truth: maybe(one["truth"]),
        misled: one["misled"] === true,
        margin: maybe(one["margin"]),
        flip: maybe(one["flip"]),
        other:
          maybe(other["skill"]) === undefined
            ? undefined
            : { skill: textOf(other["skill"]), leaf: textOf(other["leaf"]) },
        sources: objectsOf(one["sources"]).map((source) => ({
          text: textOf(source["text"]),
          error: typeof source["error"] === "number" ? source["error"] : undefined,
        })),
      },
    ];
  });
  return {
    robot,
    at_ns,
    sentence: textOf(told["sentence"]),
    skill: textOf(told["skill"]),
    role: textOf(told["role"]),
    strategy: textOf(told["strategy"]),
    plays: told["plays"] === true,
    parts: objectsOf(told["parts"]).map((part) => ({
      path: textOf(part["path"]),
      name: textOf(part["name"]),
      depth: count(part["depth"]),
      skill: maybe(part["skill"]),
      taken: part["taken"] === true,
    })),
    comparisons,
    path,
    narrowest: typeof told["narrowest"] === "number" ? path[told["narrowest"]] : undefined,
    agrees: answer["agrees"] === true,
  };
}

/** Reads the answer of kWhyNot. */
export function alternativeOf(answer: Json): Alternative {
  const told = objectOf(answer["alternative"]);
  const kinds = ["reached", "changed", "unreachable"] as const;
  const beliefs = told["beliefs"] ? objectOf(told["beliefs"])["changes"] : undefined;
  return {
    kind: kinds.find((kind) => kind === told["kind"]) ?? "unsure",
    leaf: maybe(told["leaf"]),
    features: objectsOf(told["features"]).map((one) => ({
      name: textOf(one["name"]),
      before: textOf(one["before"]),
      text: textOf(one["text"]),
    })),
    thresholds: Array.isArray(told["thresholds"])
      ? objectsOf(told["thresholds"]).map((one) => ({
          node: count(one["node"]),
          condition: textOf(one["condition"]),
          before: textOf(one["before"]),
          after: textOf(one["after"]),
        }))
      : undefined,
    beliefs: Array.isArray(beliefs) ? beliefs.map(textOf) : undefined,
  };
}
