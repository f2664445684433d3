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
  { keys: ["<", ">"], does: "slower or faster, down to backwards", act: ({ time }, { key }) => time.pace(key === "<" ? -1 : 1) },
  { keys: ["Home", "End"], does: "to the oldest moment, and back to now or to a recording's end", act: ({ time }, { key }) => (key === "Home" ? time.begin() : time.now()) },
  { keys: ["p", "n"], does: "to the previous or next goal, penalty, fall, change of state, error or bookmark", act: ({ time, moments }, { key }) => time.jump(key === "p" ? -1 : 1, moments.bookmarks.map(({ at_ns }) => at_ns)) },
  { keys: ["w"], does: "find when a condition held, such as ball.x > 2", act: ({ moments }) => (moments.open = !moments.open) },
  { keys: ["P", "N"], does: "to where it held before, or holds next", act: ({ moments }, { key }) => moments.jump(key === "P" ? -1 : 1) },
  { keys: ["b"], does: "mark this moment with a name", act: ({ moments }) => moments.mark() },
  { keys: ["[", "]"], does: "a loop begins or ends here (also drag along the strip with Shift)", act: ({ time }, { key }) => time.edge(key === "[" ? "begin" : "end") },
  { keys: ["o"], does: "no loop any more", act: ({ time }) => time.endLoop() },
  { keys: ["k", "j"], does: "the robot before or after", act: (viewer, { key }) => viewer.chooseNeighbour(key === "k" ? -1 : 1) },
  { keys: kViews.map((_, i) => String(i + 1)), does: `the views: ${kViews.join(", ")}`, act: (viewer, { key }) => viewer.go({ view: kViews[Number(key) - 1] as View }) },
];

/** Keys that only one view knows. */
export const kViewKeys: { view: View; keys: string; does: string }[] = [
  { view: "field", keys: "+ −", does: "nearer, farther (also the wheel, or two fingers)" },
  { view: "field", keys: "0", does: "the whole field" },
  { view: "field", keys: "f", does: "follow the chosen robot" },
  { view: "field", keys: "m", does: "look from the other side" },
  { view: "camera", keys: "d h l", does: "what was found, the horizon, the field's lines over the picture" },
  { view: "objects", keys: "↑ ↓ ← →", does: "through the tree, once it is focused" },
  { view: "objects", keys: "Enter c x g", does: "open; copy the path; pin; plot" },
  { view: "plot", keys: "+ −", does: "a shorter, a longer time" },
  { view: "what-if", keys: "Enter", does: "ask" },
  { view: "what-if", keys: "↑ ↓", does: "the futures of another strategy" },
  { view: "what-if", keys: "f", does: "play the futures, or stop" },
  { view: "what-if", keys: "r", does: "put everything back to where it is believed to be" },
  { view: "what-if", keys: "Esc", does: "close the own question: what the robot asked itself is shown" },
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
