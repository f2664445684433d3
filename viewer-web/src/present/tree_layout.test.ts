import { expect, test } from "vitest";
import type { Comparison, Part, Reason } from "../memory/reasons";
import { layoutOf } from "./tree_layout";

const part = (path: string, taken: boolean, skill?: string): Part => {
  const names = path.split("/");
  return { path, name: names.at(-1)!, depth: names.length - 1, skill, taken };
};
const kParts = [
  part("tree", true),
  part("tree/lost", false, "search_ball"),
  part("tree/keeper", false),
  part("tree/keeper/save", false, "keep_goal"),
  part("tree/keeper/stay", false, "keep_goal"),
  part("tree/chaser", true),
  part("tree/chaser/near", true, "kick"),
  part("tree/chaser/far", false, "walk_to_ball"),
];
const comparison = (node: number, at: number, result: boolean): Comparison => ({
  node,
  part: at,
  condition: `feature ${node} < 1`,
  result,
  value: "2 m",
  threshold: "1 m",
});
const kComparisons = [
  comparison(4, 1, false),
  comparison(3, 2, false),
  comparison(2, 3, true),
  comparison(1, 5, true),
  comparison(0, 6, true),
];
const reason = (comparison: Comparison): Reason => ({
  comparison,
  truth: undefined,
  misled: false,
  margin: undefined,
  flip: undefined,
  other: undefined,
  sources: [],
});
const kPath = kComparisons.filter(({ node }) => node !== 2).map(reason);
const kReasons = { parts: kParts, comparisons: kComparisons, path: kPath };
const named = (whole: boolean) => new Map(layoutOf(kReasons, whole).boxes.map((box) => [box.part.name, box]));

test("each leaf has a row, in the order of the tree, and other parts stand in the middle of theirs", () => {
  const boxes = named(true);
  const rows = [...boxes].filter(([, { part }]) => part.skill).map(([, { row }]) => row);
  expect(rows).toEqual([0, 1, 2, 3, 4]);
  expect(boxes.get("keeper")!.row).toBe(1.5);
  expect(boxes.get("chaser")!.row).toBe(3.5);
});

test("a column is a depth, and the whole tree needs none", () => {
  const { boxes, columns, rows } = layoutOf(kReasons, true);
  expect([columns, rows, boxes.length]).toEqual([2, 5, kParts.length - 1]);
  for (const { part, column, parent } of boxes) {
    expect(column).toBe(part.depth - 1);
    expect(parent === undefined ? "tree" : kParts[parent]!.path).toBe(part.path.slice(0, part.path.lastIndexOf("/")));
  }
});

test("a part was taken, asked in vain, or never asked", () => {
  const boxes = named(true);
  expect(["lost", "keeper", "save", "stay", "chaser", "near", "far"].map((name) => boxes.get(name)!.reach)).toEqual([
    "refused",
    "refused",
    "unasked",
    "unasked",
    "taken",
    "taken",
    "unasked",
  ]);
  expect(boxes.get("save")!.comparisons.map(({ node }) => node)).toEqual([2]);
});

test("without the whole tree, only what was taken shows what lies in it", () => {
  expect([...named(false).keys()]).toEqual(["lost", "keeper", "chaser", "near", "far"]);
});

test("a tree of one leaf is that leaf, and no tree is nothing", () => {
  const [only] = layoutOf({ parts: [part("tree", true, "stand")], comparisons: [], path: [] }, true).boxes;
  expect([only!.column, only!.row, only!.reach]).toEqual([0, 0, "taken"]);
  expect(layoutOf({ parts: [], comparisons: [], path: [] }, true)).toEqual({ boxes: [], columns: 0, rows: 0 });
});
