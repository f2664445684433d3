// Paths to one number: a topic, then steps into its message. /14/2/ball.x, /14/2/vision.robots[0].detection.distance.
// An entry can be selected by its fields, one of a list by joint by its name: /truth/world.robots[team=14,player=2].x,
// /14/2/joints.position[head_yaw].

import { jointIndex } from "./joints";
import { EnumValue, type Fields, type Value } from "./value";

export type Step = string | number | Record<string, number>;

export interface Path {
  topic: string;
  steps: Step[];
}

/** Splits a path. Topics may contain dots, so the longest known topic that fits is used. */
export function pathOf(text: string, topics: Iterable<string>): Path | undefined {
  let topic = "";
  for (const known of topics)
    if (known.length > topic.length && (text.startsWith(`${known}.`) || text === known)) topic = known;
  if (topic === "") return undefined;
  const steps: Step[] = [];
  for (let rest = text.slice(topic.length); rest !== "";) {
    const found = /^\.([^.[\]]+)|^\[(\d+)\]|^\[([^\]]+)\]/.exec(rest);
    if (!found) return undefined;
    const step = stepOf(found, topic);
    if (step === undefined) return undefined;
    steps.push(step);
    rest = rest.slice(found[0].length);
  }
  return { topic, steps };
}

function stepOf([, name, index, filter]: RegExpExecArray, topic: string): Step | undefined {
  if (name !== undefined) return name;
  if (index !== undefined) return Number(index);
  if (!filter!.includes("=")) return jointIndex(topic, filter!.trim());
  const entries = filter!.split(",").map((part) => part.split("=").map((word) => word.trim()));
  if (entries.some(([key, value]) => !key || value === undefined || value === "" || !Number.isFinite(Number(value))))
    return undefined;
  return Object.fromEntries(entries.map(([key, value]) => [key, Number(value)]));
}

/** Writes a path as it is parsed; entries by their numbers. */
export const textOf = ({ topic, steps }: Path): string =>
  topic +
  steps
    .map((step) => {
      if (typeof step === "string") return `.${step}`;
      if (typeof step === "number") return `[${step}]`;
      return `[${Object.entries(step)
        .map(([key, value]) => `${key}=${value}`)
        .join(",")}]`;
    })
    .join("");

/** Returns the value at the path, or undefined if there is none. */
export function valueAt(fields: Fields, steps: Step[]): Value {
  let value: Value = fields;
  for (const step of steps) {
    if (typeof step === "string") value = value instanceof Map ? value.get(step) : undefined;
    else if (!Array.isArray(value)) return undefined;
    else if (typeof step === "number") value = value[step];
    else
      value = value.find(
        (entry) =>
          entry instanceof Map && Object.entries(step).every(([key, wanted]) => numeric(entry.get(key)) === wanted),
      );
  }
  return value;
}

/** Returns the number at the path, or NaN if there is none. True is 1; enums are their numbers. */
export const numberAt = (fields: Fields, steps: Step[]): number => numeric(valueAt(fields, steps));

function numeric(value: Value): number {
  if (typeof value === "number") return value;
  if (typeof value === "bigint" || typeof value === "boolean") return Number(value);
  return value instanceof EnumValue ? value.number : NaN;
}

const kMost = 4000; // [paths] nobody would choose from more
const kEntries = 8; // of a list

/** The name of an entry of a list, or undefined if it has an index alone. */
type EntryName = (index: number, count: number) => string | undefined;

/**
 * Returns all paths to numbers in a message, for search: "ball.velocity_x". Times since the epoch are left out. Lists
 * whose entries have names are told whole, other ones only up to a few entries.
 */
export function numbersIn(fields: Fields, before: string, nameOf?: EntryName, found: string[] = []): string[] {
  for (const [name, value] of fields) {
    if (found.length >= kMost) break;
    if (!name.endsWith("_ns")) collect(value, `${before}.${name}`, nameOf, found);
  }
  return found;
}

function collect(value: Value, path: string, nameOf: EntryName | undefined, found: string[]): void {
  if (value instanceof Map) numbersIn(value, path, nameOf, found);
  else if (Array.isArray(value))
    value.forEach((entry, i) => {
      const name = nameOf?.(i, value.length);
      if (name !== undefined || i < kEntries) collect(entry, `${path}[${name ?? i}]`, nameOf, found);
    });
  else if (!Number.isNaN(numeric(value))) found.push(path);
}
