// The arrangement of the views on the page: a tree of rows and columns of panes, and its text in the address.
//
// "row(field:3,col(decision,plot):2)": the field beside the decision over the plot, with the weights 3 and 2. A pane may
// name its number ("plot.4") and may fill the page ("plot!"). Numbers identify panes: the settings of pane 4 stay its
// own when pane 2 is closed.

import type { FieldPath } from "../memory/value";
import { kViews, type View } from "./route";

export const kMostPanes = 6;
const kDeepest = kMostPanes - 1; // splits inside each other
const kHeaviest = 999;
const kLeastShare = 0.1; // of a row or column: a narrower pane shows nothing

export interface Leaf {
  /** 1 … kMostPanes. */
  number: number;
  view: View;
}
/** `row`: beside each other; `col`: one above the other. */
export type Way = "row" | "col";
export interface Split {
  way: Way;
  /** At least two; their weights are whole numbers from 1. */
  parts: { node: Tree; weight: number }[];
}
export type Tree = Leaf | Split;

export interface Panes {
  tree: Tree;
  /** The number of the pane that fills the page, if any. */
  full?: number | undefined;
}

/** A pane's share of the page, from 0 to 1 to the right and down. */
export interface Place {
  leaf: Leaf;
  left: number;
  top: number;
  width: number;
  height: number;
}
/** The border behind the part `index` of the split at `path`. */
export interface Border {
  path: number[];
  index: number;
  way: Way;
  left: number;
  top: number;
  /** Along the border. */
  length: number;
  /** Both parts together, across the border, from `begin`; `share` of it belongs to the first. */
  begin: number;
  span: number;
  share: number;
}

const isLeaf = (tree: Tree): tree is Leaf => "view" in tree;
export const onePane = (view: View): Panes => ({ tree: { number: 1, view } });

/** In reading order. */
export const leavesOf = (tree: Tree): Leaf[] =>
  isLeaf(tree) ? [tree] : tree.parts.flatMap(({ node }) => leavesOf(node));
export const leafOf = (tree: Tree, number: number): Leaf | undefined =>
  leavesOf(tree).find((leaf) => leaf.number === number);

/** Replaces each pane by that of `change`. */
const mapped = (tree: Tree, change: (leaf: Leaf) => Tree): Tree =>
  isLeaf(tree)
    ? change(tree)
    : { ...tree, parts: tree.parts.map(({ node, weight }) => ({ node: mapped(node, change), weight })) };

// changes

/** Shows another view in a pane. */
export const showing = ({ tree, full }: Panes, number: number, view: View): Panes => ({
  tree: mapped(tree, (leaf) => (leaf.number === number ? { number, view } : leaf)),
  full,
});

/** Splits a pane into halves; the new one is to the right or below. Returns undefined if there are kMostPanes. */
export function split({ tree }: Panes, at: number, way: Way, view: View): { panes: Panes; number: number } | undefined {
  const numbers = leavesOf(tree).map(({ number }) => number);
  if (numbers.length >= kMostPanes || !numbers.includes(at)) return undefined;
  const number = freeAmong(numbers);
  const added = { number, view };
  /** A pane in a row that is split to the right stays in that row. */
  const within = (node: Tree): Tree => {
    if (isLeaf(node))
      return node.number !== at ? node : { way, parts: [node, added].map((leaf) => ({ node: leaf, weight: 1 })) };
    const isHere = node.way === way && node.parts.some(({ node: part }) => isLeaf(part) && part.number === at);
    const parts = node.parts.flatMap(({ node: part, weight }) =>
      isHere && isLeaf(part) && part.number === at
        ? [part, added].map((leaf) => ({ node: leaf, weight }))
        : [{ node: within(part), weight: isHere ? 2 * weight : weight }],
    );
    return { way: node.way, parts: lightened(parts) };
  };
  return { panes: { tree: within(tree) }, number };
}

/** Closes a pane; its neighbours take its room. The last pane stays. */
export function close({ tree, full }: Panes, at: number): Panes {
  const without = (node: Tree): Tree | undefined => {
    if (isLeaf(node)) return node.number === at ? undefined : node;
    const parts = node.parts.flatMap(({ node: part, weight }) => {
      const left = without(part);
      return left ? [{ node: left, weight }] : [];
    });
    return parts.length > 1 ? { way: node.way, parts: lightened(parts) } : parts[0]?.node;
  };
  return { tree: without(tree) ?? tree, full: full === at ? undefined : full };
}

/** Moves a border: the part before it gets `share` of both parts' room. */
export function resize({ tree, full }: Panes, { path, index }: Pick<Border, "path" | "index">, share: number): Panes {
  const within = (node: Tree, [step, ...rest]: number[]): Tree => {
    if (isLeaf(node)) return node;
    if (step !== undefined)
      return {
        ...node,
        parts: node.parts.map((part, i) => (i === step ? { ...part, node: within(part.node, rest) } : part)),
      };
    if (index < 0 || index + 1 >= node.parts.length) return node;
    const shares = sharesOf(node);
    const both = shares[index]! + shares[index + 1]!;
    const least = Math.min(kLeastShare, both / 2);
    const first = Math.min(both - least, Math.max(least, share * both));
    const all = shares.map((old, i) => (i === index ? first : i === index + 1 ? both - first : old));
    return {
      ...node,
      parts: lightened(node.parts.map((part, i) => ({ ...part, weight: Math.max(1, Math.round(100 * all[i]!)) }))),
    };
  };
  return { tree: within(tree, path), full };
}

/** Lets a pane fill the page; again: not any more. A single pane fills it anyway. */
export const maximise = ({ tree, full }: Panes, number: number): Panes => ({
  tree,
  full: full === number || isLeaf(tree) ? undefined : number,
});

/** Returns the number of the pane `by` steps after `number` in reading order, round the end. */
export function neighbour({ tree }: Panes, number: number, by: 1 | -1): number {
  const leaves = leavesOf(tree);
  const at = leaves.findIndex((leaf) => leaf.number === number);
  return leaves[(at + by + leaves.length) % leaves.length]!.number;
}

const freeAmong = (numbers: number[]): number => {
  let free = 1;
  while (numbers.includes(free)) ++free;
  return free;
};

/** Equal weights become 1, and no weight exceeds kHeaviest. */
function lightened(parts: Split["parts"]): Split["parts"] {
  const heaviest = Math.max(...parts.map(({ weight }) => weight));
  const isEven = parts.every(({ weight }) => weight === heaviest);
  const scale = Math.min(1, kHeaviest / heaviest);
  return parts.map(({ node, weight }) => ({ node, weight: isEven ? 1 : Math.max(1, Math.round(weight * scale)) }));
}

/** Returns the shares of the parts of a row or column, each at least kLeastShare. */
function sharesOf({ parts }: Split): number[] {
  const total = parts.reduce((sum, { weight }) => sum + weight, 0);
  const wide = parts.map(({ weight }) => Math.max(kLeastShare, weight / total));
  const all = wide.reduce((sum, share) => sum + share, 0);
  return wide.map((share) => share / all);
}

// places

const kPage = { left: 0, top: 0, width: 1, height: 1 };
type Box = typeof kPage;

/** The box of each part of a split. */
function boxesOf(tree: Split, { left, top, width, height }: Box): Box[] {
  let before = 0;
  return sharesOf(tree).map((share) => {
    const box =
      tree.way === "row"
        ? { left: left + before * width, top, width: share * width, height }
        : { left, top: top + before * height, width, height: share * height };
    before += share;
    return box;
  });
}

/** The panes that are shown, with their places. */
export function placesOf({ tree, full }: Panes): Place[] {
  const filling = full === undefined ? undefined : leafOf(tree, full);
  if (filling) return [{ leaf: filling, ...kPage }];
  const within = (node: Tree, box: Box): Place[] =>
    isLeaf(node)
      ? [{ leaf: node, ...box }]
      : boxesOf(node, box).flatMap((part, i) => within(node.parts[i]!.node, part));
  return within(tree, kPage);
}

/** The borders that can be dragged. */
export function bordersOf({ tree, full }: Panes): Border[] {
  const within = (node: Tree, box: Box, path: number[]): Border[] => {
    if (isLeaf(node)) return [];
    const boxes = boxesOf(node, box);
    const isRow = node.way === "row";
    const own = boxes.slice(0, -1).map((first, index): Border => {
      const second = boxes[index + 1]!;
      const [begin, one, two] = isRow
        ? [first.left, first.width, second.width]
        : [first.top, first.height, second.height];
      return {
        path,
        index,
        way: node.way,
        left: isRow ? second.left : box.left,
        top: isRow ? box.top : second.top,
        length: isRow ? box.height : box.width,
        begin,
        span: one + two,
        share: one / (one + two),
      };
    });
    return [...own, ...boxes.flatMap((part, i) => within(node.parts[i]!.node, part, [...path, i]))];
  };
  return full === undefined ? within(tree, kPage, []) : [];
}

/** The room on a screen: all panes, two above each other, or one. */
export type Room = "all" | "two" | "one";

/** The panes that a screen shows: those around `number`. */
export function seenOn(room: Room, panes: Panes, number: number): Panes {
  const { tree, full } = panes;
  if (room === "all" || isLeaf(tree) || full !== undefined) return panes;
  const leaves = leavesOf(tree);
  const at = Math.max(
    0,
    leaves.findIndex((leaf) => leaf.number === number),
  );
  if (room === "one") return { tree: leaves[at]! };
  if (leaves.length === 2) return { tree: { ...tree, way: "col" } };
  const begin = 2 * Math.floor(at / 2); // always the same pairs, whichever of them is chosen
  const pair = leaves.slice(begin, begin + 2);
  return {
    tree: pair.length === 1 ? pair[0]! : { way: "col", parts: pair.map((node) => ({ node, weight: 1 })) },
  };
}

// text

export function textOfPanes({ tree, full }: Panes): string {
  const inOrder = leavesOf(tree).every(({ number }, i) => number === i + 1);
  const text = (node: Tree): string => {
    if (isLeaf(node)) return `${node.view}${inOrder ? "" : `.${node.number}`}${node.number === full ? "!" : ""}`;
    const parts = lightened(node.parts);
    return `${node.way}(${parts.map(({ node: part, weight }) => text(part) + (weight === 1 ? "" : `:${weight}`)).join()})`;
  };
  return text(tree);
}

/** Parses any text. Returns undefined if it is no arrangement. */
export function panesOf(text: string): Panes | undefined {
  let at = 0;
  let full: number | undefined;
  let sound = true;
  const eat = (pattern: RegExp): string[] | undefined => {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    if (found) at += found[0].length;
    return found ?? undefined;
  };
  const leaves: Leaf[] = [];
  const node = (depth: number): Tree | undefined => {
    const way = depth < kDeepest ? eat(/(row|col)\(/y)?.[1] : undefined;
    if (!way) return leaf();
    const parts: Split["parts"] = [];
    do {
      const part = node(depth + 1);
      if (!part) return undefined;
      parts.push({ node: part, weight: Number(eat(/:([1-9]\d{0,2})(?!\d)/y)?.[1] ?? 1) });
    } while (eat(/,/y));
    return eat(/\)/y) && parts.length > 1 ? { way: way as Way, parts: lightened(parts) } : undefined;
  };
  const leaf = (): Leaf | undefined => {
    const [all, name, number, fills] = eat(/([a-z-]+)(?:\.([1-6]))?(!)?/y) ?? [];
    const view = kViews.find((view) => view === name);
    if (!all || !view || leaves.length >= kMostPanes) return undefined;
    const made = { number: number ? Number(number) : freeAmong(leaves.map((leaf) => leaf.number)), view };
    if (leaves.some((leaf) => leaf.number === made.number)) sound = false;
    if (fills && full !== undefined) sound = false;
    if (fills) full = made.number;
    leaves.push(made);
    return made;
  };
  const tree = node(0);
  if (!tree || at !== text.length || !sound) return undefined;
  return isLeaf(tree) ? { tree } : { tree, full };
}

// settings of panes, and arrangements of them

/** The settings of the address that each pane has for itself, and the views that read them. */
const kPaneSettings: Record<string, readonly View[]> = {
  robot: kViews,
  layers: ["field"],
  look: ["field"],
  follow: ["field"],
  over: ["camera"],
  camera: ["camera"],
  plot: ["plot"],
  span: ["plot"],
  pin: ["objects", "plot"],
  ask: ["what-if"],
  pick: ["what-if"],
  parameters: ["parameters"],
  sensor: ["ground-truth"],
  part: ["ground-truth"],
  picture: ["ground-truth"],
  lines: ["ground-truth"],
  found: ["ground-truth"],
  calibrate: ["ground-truth"],
};
export const isOfPane = (name: string): boolean => Object.hasOwn(kPaneSettings, name);

/** The setting's name in the address. Pane 1 has the plain names, as links of a page with one view. */
export const settingOf = (number: number, name: string): string =>
  number === 1 || !isOfPane(name) ? name : `${number}.${name}`;

/** The pane and the plain name of a setting of the address; number 0 for one of the whole page. */
export function ownerOf(setting: string): { number: number; name: string } {
  const [, number, name] = /^([2-6])\.(.*)$/s.exec(setting) ?? [];
  if (name !== undefined && isOfPane(name)) return { number: Number(number), name };
  return { number: isOfPane(setting) ? 1 : 0, name: setting };
}

type Settings = ReadonlyMap<string, string>;

/** Removes all settings of panes that do not exist, and gives a single pane the number 1. */
export function tidied({ tree, full }: Panes, settings: Settings): { panes: Panes; settings: Map<string, string> } {
  const leaves = leavesOf(tree);
  const [only] = leaves.length === 1 ? leaves : [];
  const kept = [...settings].flatMap(([setting, value]): [string, string][] => {
    const { number, name } = ownerOf(setting);
    if (number === 0) return [[setting, value]];
    if (!leaves.some((leaf) => leaf.number === number)) return [];
    return [[only ? name : setting, value]];
  });
  return { panes: only ? onePane(only.view) : { tree, full }, settings: new Map(kept) };
}

/**
 * Gives a new pane the settings that its view reads: those of the first pane with the same view, else of `donor`. Its
 * robot stays the page's.
 */
export function inherited({ tree }: Panes, donor: number, view: View, settings: Settings): [string, string][] {
  const from = leavesOf(tree).find((leaf) => leaf.view === view)?.number ?? donor;
  return Object.entries(kPaneSettings).flatMap(([name, views]): [string, string][] => {
    const value = name !== "robot" && views.includes(view) ? settings.get(settingOf(from, name)) : undefined;
    return value ? [[name, value]] : [];
  });
}

/** Views for a new pane, the most useful first. */
const kNext: View[] = [
  ...(["field", "decision", "plot", "camera", "log", "objects", "health", "what-if", "sessions"] as const),
  "parameters",
];
/** The view of a new pane: one that is not shown yet. */
export function nextView({ tree }: Panes): View {
  const shown = new Set(leavesOf(tree).map(({ view }) => view));
  return kNext.find((view) => !shown.has(view)) ?? "field";
}

export interface Preset {
  name: string;
  key: string;
  does: string;
  panes: string;
  /** Names of the address, unless the panes before had settings for the same views. */
  settings: Record<string, string>;
  /** The pane that shows another robot than the page's, if there is one. */
  other?: number;
}

const kUsualPlot = (["ball.x", "ball.y"] satisfies FieldPath[]).join(" "); // of the pane's robot

export const kPresets: Preset[] = [
  {
    name: "Match",
    key: "M",
    does: "the field, the log and the health",
    panes: "row(field:2,col(log,health))",
    settings: {},
  },
  {
    name: "Why",
    key: "W",
    does: "the field beside the decision over the plot",
    panes: "row(field:3,col(decision:3,plot:2):2)",
    settings: { "3.plot": kUsualPlot },
  },
  {
    name: "Seeing",
    key: "S",
    does: "the camera beside the field over the plot",
    panes: "row(camera,col(field:3,plot:2))",
    settings: { "3.plot": kUsualPlot },
  },
  {
    name: "Compare",
    key: "C",
    does: "the field of one robot beside that of another over the plot",
    panes: "row(field,col(field:3,plot:2))",
    settings: { "3.plot": kUsualPlot },
    other: 2,
  },
  {
    name: "Debug",
    key: "D",
    does: "the field beside the tree of the decision, with the reasons",
    panes: "row(field:2,debug:3)",
    settings: {},
  },
];
