// The drawing of a decision tree: a column for each depth, a row for each leaf.

import type { Comparison, Part, Reasons } from "../memory/reasons";

/** How far the decision came: it went through the part, asked for it in vain, or never asked. */
export type Reach = "taken" | "refused" | "unasked";

/** The place of a part, in columns and rows. The whole tree has none, unless it is a single leaf. */
export interface Box {
  part: Part;
  index: number;
  column: number;
  /** A whole number for a leaf; otherwise in the middle of what lies in it. */
  row: number;
  reach: Reach;
  /** The comparisons that lead to it. */
  comparisons: Comparison[];
  /** Index of the part in which it lies, or undefined at the outermost. */
  parent: number | undefined;
}

export interface TreeLayout {
  boxes: Box[];
  columns: number;
  rows: number;
}

/** With `whole` false, parts that were not taken show nothing of what lies in them. */
export function layoutOf(
  { parts, comparisons, path }: Pick<Reasons, "parts" | "comparisons" | "path">,
  whole: boolean,
): TreeLayout {
  const asked = new Set(path.map(({ comparison }) => comparison.part));
  const boxes: Box[] = [];
  const around: Box[] = []; // the parts in which the next one lies
  let rows = 0;
  const isHidden = (depth: number) => !whole && around.slice(0, depth).some(({ reach }) => reach !== "taken");
  const outermost = parts.length > 1 ? 1 : 0; // depth
  parts.forEach((part, index) => {
    const depth = part.depth - outermost;
    if (depth < 0) return;
    around.length = Math.min(around.length, depth);
    if (isHidden(depth)) return;
    const parent = around.at(-1);
    const box: Box = {
      part,
      index,
      column: depth,
      row: 0,
      reach: part.taken ? "taken" : asked.has(index) ? "refused" : "unasked",
      comparisons: comparisons.filter((comparison) => comparison.part === index),
      parent: parent?.index,
    };
    boxes.push(box);
    around.push(box);
  });
  for (const box of boxes) if (!boxes.some(({ parent }) => parent === box.index)) box.row = rows++;
  for (const box of boxes.toReversed()) {
    const inside = boxes.filter(({ parent }) => parent === box.index);
    if (inside.length > 0) box.row = (inside[0]!.row + inside.at(-1)!.row) / 2;
  }
  return { boxes, columns: 1 + Math.max(-1, ...boxes.map(({ column }) => column)), rows };
}
