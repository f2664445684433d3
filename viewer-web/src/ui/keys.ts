// The keys of the whole page, and the words of the help on `?`.

import { kViews, type View } from "./route";
import type { Viewer } from "./viewer.svelte";

export interface Key {
  keys: string[];
  does: string;
  act(viewer: Viewer, event: KeyboardEvent): void;
}

export const kPageKeys: Key[] = [
  { keys: [" "], does: "pause, or play on from there", act: ({ time }) => time.toggle() },
  { keys: ["ArrowLeft", "ArrowRight"], does: "a second back or on; with Shift ten", act: ({ time }, { key, shiftKey }) => time.skip((key === "ArrowLeft" ? -1 : 1) * (shiftKey ? 10 : 1)) },
  { keys: [",", "."], does: "a frame back or on", act: ({ time }, { key }) => time.step(key === "," ? -1 : 1) },
  { keys: ["Home", "End"], does: "to the oldest moment kept, and back to now", act: ({ time }, { key }) => (key === "Home" ? time.begin() : time.now()) },
  { keys: ["p", "n"], does: "to the previous or next goal, penalty, change of state or error", act: ({ time }, { key }) => time.jump(key === "p" ? -1 : 1) },
  { keys: ["[", "]"], does: "the robot before or after", act: (viewer, { key }) => viewer.chooseNeighbour(key === "[" ? -1 : 1) },
  { keys: kViews.map((_, i) => String(i + 1)), does: `the views: ${kViews.join(", ")}`, act: (viewer, { key }) => viewer.go({ view: kViews[Number(key) - 1] as View }) },
];

/** Keys that only one view knows. */
export const kViewKeys: { view: View; keys: string; does: string }[] = [
  { view: "field", keys: "+ −", does: "nearer, farther (also the wheel, or two fingers)" },
  { view: "field", keys: "0", does: "the whole field" },
  { view: "field", keys: "f", does: "follow the chosen robot" },
  { view: "field", keys: "m", does: "look from the other side" },
  { view: "objects", keys: "↑ ↓ ← →", does: "through the tree, once it is focused" },
  { view: "objects", keys: "Enter c x g", does: "open; copy the path; pin; plot" },
  { view: "plot", keys: "+ −", does: "a shorter, a longer time" },
];

const kNames: Record<string, string> = { " ": "Space", ArrowLeft: "←", ArrowRight: "→" };
export const nameOf = (key: string): string => kNames[key] ?? key;

/** Whether a key pressed there is meant for what has the focus. */
export function belongsElsewhere(event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "defaultPrevented" | "target">): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  const element = event.target instanceof Element ? event.target : undefined;
  if (element?.matches("input:not([type=checkbox]):not([type=range]), textarea, select, [contenteditable]")) return true;
  if (element?.matches("input[type=range], input[type=checkbox], summary, button") && [" ", "Enter"].includes(event.key)) return true;
  return element?.closest("dialog") !== null && element !== undefined;
}

/** Does what a key means on the page; false when it means nothing. */
export function press(viewer: Viewer, event: KeyboardEvent): boolean {
  const known = kPageKeys.find(({ keys }) => keys.includes(event.key));
  known?.act(viewer, event);
  return known !== undefined;
}
