// The object tree as rows: which nodes are open, which match the search, and the text of each line.

import { jointName } from "../memory/joints";
import { EnumValue, type Value } from "../memory/value";
import { bytes, hex, number } from "./format";

/** A longer list is closed until somebody opens it. */
const kOpenUpTo = 8;
/** Maximum depth and size of a search, so that it does not block the page. */
const kSearchDepth = 12;
const kSearchEntries = 64;
/** Maximum rows of one list. */
const kMostEntries = 10000;

/** One memory object at the top of the tree. */
export interface Root {
  /** The topic: paths begin with it, as in Foxglove's message paths: /14/2/vision.robots[0].x */
  path: string;
  name: string;
  /** Undefined: no message yet. A sentence: it cannot be decoded. */
  value: Value | { error: string };
}

export interface Row {
  path: string;
  name: string;
  depth: number;
  /** Undefined: there is nothing inside to open. */
  open: boolean | undefined;
  kind: "root" | "message" | "list" | "leaf" | "absent" | "note";
  value: Value;
}

const isNode = (value: Value): value is Map<string, Value> | Value[] => value instanceof Map || Array.isArray(value);

/**
 * The tree's rows from top to bottom. `opened` has the nodes that somebody opened (true) or closed (false), by path.
 * Other nodes are open, except roots and long lists. With `words`, only paths that contain all words stay, with the
 * open nodes above them.
 */
export function rowsOf(roots: Root[], opened: ReadonlyMap<string, boolean>, words: string[]): Row[] {
  const rows: Row[] = [];
  for (const root of roots) {
    const { value } = root;
    const broken = typeof value === "object" && "error" in value ? value.error : undefined;
    const within = broken === undefined ? (value as Value) : undefined;
    const node: Row = { ...root, depth: 0, open: undefined, kind: "root", value: within };
    if (broken !== undefined) {
      if (!matches(root.path, words)) continue;
      rows.push(node, noteBelow(node, "error", broken));
    } else add(rows, node, opened, words);
  }
  return rows;
}

const matches = (path: string, words: string[]): boolean => {
  if (words.length === 0) return true;
  const lower = path.toLowerCase();
  return words.every((word) => lower.includes(word));
};

/** The words of the search text. */
export const wordsOf = (search: string): string[] =>
  search
    .toLowerCase()
    .split(/\s+/)
    .filter((word) => word !== "");

function add(rows: Row[], row: Row, opened: ReadonlyMap<string, boolean>, words: string[]): void {
  const self = matches(row.path, words);
  const below = isNode(row.value) && sizeOf(row.value) > 0;
  const empty = row.kind === "root" && row.value === undefined;
  if (!self && !(below && searchFinds(row, words, kSearchDepth))) return;

  if (below || empty) row.open = !self || (opened.get(row.path) ?? opensItself(row));
  rows.push(row);
  if (!row.open) return;
  if (empty) rows.push(noteBelow(row, "empty", "Nothing has come yet."));
  let entries = 0;
  for (const child of childrenOf(row)) {
    if (++entries > kMostEntries) {
      const left = sizeOf(row.value) - kMostEntries;
      rows.push(noteBelow(row, "rest", `${left} more`));
      break;
    }
    add(rows, child, opened, self ? [] : words);
  }
}

const noteBelow = (row: Row, what: string, sentence: string): Row => ({
  path: `${row.path}#${what}`,
  name: "",
  depth: row.depth + 1,
  open: undefined,
  kind: "note",
  value: sentence,
});

const opensItself = (row: Row): boolean => row.kind !== "root" && sizeOf(row.value) <= kOpenUpTo;

const sizeOf = (value: Value): number => (value instanceof Map ? value.size : Array.isArray(value) ? value.length : 0);

function searchFinds(row: Row, words: string[], depth: number): boolean {
  if (depth === 0) return false;
  let entries = 0;
  for (const child of childrenOf(row)) {
    if (++entries > kSearchEntries) return false;
    if (matches(child.path, words) || (isNode(child.value) && searchFinds(child, words, depth - 1))) return true;
  }
  return false;
}

function* childrenOf(row: Row): Generator<Row> {
  const { value, path } = row;
  const child = (step: string, name: string, inner: Value): Row => ({
    path: path + step,
    name,
    depth: row.depth + 1,
    open: undefined,
    kind: inner === undefined ? "absent" : Array.isArray(inner) ? "list" : inner instanceof Map ? "message" : "leaf",
    value: inner,
  });
  if (value instanceof Map) for (const [name, inner] of value) yield child(`.${name}`, name, inner);
  if (Array.isArray(value))
    for (const [index, inner] of value.entries()) {
      const joint = jointOf(path, index, value.length);
      yield child(`[${joint ?? index}]`, joint ? `[${index}] ${joint}` : `[${index}]`, inner);
    }
}

/** The joint of an entry, in a list "…/joints.position". */
const jointOf = (path: string, index: number, count: number): string | undefined =>
  jointName(/^(.*)\.[^.[\]]+$/.exec(path)?.[1] ?? "", index, count);

/** Returns the text of the value column: the value, or a glimpse of the contents. */
export function textOfRow(row: Row): string {
  if (row.kind === "note") return String(row.value);
  if (row.kind === "root" && row.value === undefined) return "";
  return textOfValue(row.value, row.open !== true);
}

/** Returns a value as one line. With `glimpse`, a message or list shows its beginning. */
export function textOfValue(value: Value, glimpse: boolean): string {
  if (value === undefined) return "absent";
  if (typeof value === "number") return number(value);
  if (typeof value === "string") return JSON.stringify(value.length > 200 ? `${value.slice(0, 200)}…` : value);
  if (value instanceof Uint8Array) return `${bytes(value.length)}${value.length > 0 ? ` · ${hex(value, 8)}` : ""}`;
  if (value instanceof EnumValue) return value.name ?? `unknown (${value.number})`;
  if (Array.isArray(value)) {
    const size = value.length === 1 ? "1 entry" : `${value.length} entries`;
    if (!glimpse || value.length === 0 || isNode(value[0])) return size;
    const first = value.slice(0, 6).map((entry) => textOfValue(entry, false));
    return `${size} · ${glimpseOf(first, value.length > 6)}`;
  }
  if (value instanceof Map) return glimpse ? messageGlimpse(value) : "";
  return String(value);
}

/** Returns the first plain fields of a message, or the names of its contents, so that a closed node is informative. */
function messageGlimpse(fields: Map<string, Value>): string {
  const shown: string[] = [];
  for (const [name, value] of fields) {
    // times are long and give little information
    if (value === undefined || typeof value === "bigint" || isNode(value) || value instanceof Uint8Array) continue;
    if (shown.length === 4) return glimpseOf(shown, true);
    shown.push(`${name} ${textOfValue(value, false)}`);
  }
  if (shown.length > 0) return glimpseOf(shown, false);
  const names = [...fields].filter(([, value]) => sizeOf(value) > 0).map(([name]) => name);
  return glimpseOf(names.slice(0, 4), names.length > 4);
}

const glimpseOf = (parts: string[], more: boolean): string => parts.join(", ") + (more ? ", …" : "");
