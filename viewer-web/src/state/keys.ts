// The keys of the whole page and of single views, with the texts of the help on `?`.

import { kPresets } from "./panes";
import { kViews, type View } from "./route";
import type { Viewer } from "./viewer.svelte";

export interface Key {
  keys: string[];
  does: string;
  act(
    viewer: Pick<
      Viewer,
      | "time"
      | "moments"
      | "view"
      | "go"
      | "chooseNeighbour"
      | "split"
      | "close"
      | "focusNeighbour"
      | "maximise"
      | "arrangeAs"
      | "setFollows"
    >,
    event: Pick<KeyboardEvent, "key" | "shiftKey">,
  ): void;
}

/**
 * The keys that choose one of `views`, in their order. The digits 1 .. 9 choose the first nine; `v` and `V` go through
 * all of them, so that a tenth view has a way by keyboard too.
 */
export function keysOfViews(views: readonly View[]): Key[] {
  const withDigit = views.slice(0, 9);
  const neighbour = (view: View, step: 1 | -1) => views[(views.indexOf(view) + step + views.length) % views.length]!;
  return [
    {
      keys: withDigit.map((_, i) => String(i + 1)),
      does: `choose a view: ${withDigit.join(", ")}`,
      act: (viewer, { key }) => viewer.go({ view: withDigit[Number(key) - 1]! }),
    },
    {
      keys: ["v", "V"],
      does: "next or previous view",
      act: (viewer, { key }) => viewer.go({ view: neighbour(viewer.view, key === "v" ? 1 : -1) }),
    },
  ];
}

export const kPageKeys: Key[] = [
  { keys: [" "], does: "pause, or play on from there", act: ({ time }) => time.toggle() },
  {
    keys: ["ArrowLeft", "ArrowRight"],
    does: "one second back or forward; ten with Shift",
    act: ({ time }, { key, shiftKey }) => time.skip((key === "ArrowLeft" ? -1 : 1) * (shiftKey ? 10 : 1)),
  },
  { keys: [",", "."], does: "one frame back or forward", act: ({ time }, { key }) => time.step(key === "," ? -1 : 1) },
  {
    keys: ["<", ">"],
    does: "slower or faster; slowest is backwards",
    act: ({ time }, { key }) => time.pace(key === "<" ? -1 : 1),
  },
  {
    keys: ["Home", "End"],
    does: "oldest moment, or now (a recording: its end)",
    act: ({ time }, { key }) => (key === "Home" ? time.begin() : time.now()),
  },
  {
    keys: ["p", "n"],
    does: "previous or next goal, kick, penalty, fall, phase, error or bookmark",
    act: ({ time, moments }, { key }) =>
      time.jump(
        key === "p" ? -1 : 1,
        moments.bookmarks.map(({ at_ns }) => at_ns),
      ),
  },
  {
    keys: ["w"],
    does: "find moments by a condition such as ball.x > 2",
    act: ({ moments }) => (moments.open = !moments.open),
  },
  {
    keys: ["P", "N"],
    does: "previous or next match of the condition, or of a breakpoint",
    act: ({ moments }, { key }) => moments.jump(key === "P" ? -1 : 1),
  },
  { keys: ["b"], does: "bookmark this moment", act: ({ moments }) => moments.mark() },
  {
    keys: ["[", "]"],
    does: "begin or end of a loop (or drag along the timeline with Shift)",
    act: ({ time }, { key }) => time.edge(key === "[" ? "begin" : "end"),
  },
  { keys: ["o"], does: "remove the loop", act: ({ time }) => time.endLoop() },
  {
    keys: ["t"],
    does: "follow the shared playback of a recording, or go on in your own time",
    act: (viewer) => viewer.setFollows(!viewer.time.shared),
  },
  {
    keys: ["k", "j"],
    does: "previous or next robot",
    act: (viewer, { key }) => viewer.chooseNeighbour(key === "k" ? -1 : 1),
  },
  ...keysOfViews(kViews),
  {
    keys: ["a", "A"],
    does: "add a pane to the right, or below",
    act: (viewer, { key }) => viewer.split(key === "a" ? "row" : "col"),
  },
  { keys: ["q"], does: "close the pane", act: (viewer) => viewer.close() },
  {
    keys: ["e", "E"],
    does: "next or previous pane; keys and the choice of a view are for the marked one",
    act: (viewer, { key }) => viewer.focusNeighbour(key === "e" ? 1 : -1),
  },
  {
    keys: ["z"],
    does: "the pane alone, or all again (or double-click its title)",
    act: (viewer) => viewer.maximise(),
  },
  ...kPresets.map((preset): Key => ({
    keys: [preset.key],
    does: `${preset.name}: ${preset.does}`,
    act: (viewer) => viewer.arrangeAs(preset),
  })),
];

/** Keys of a single view. */
export const kViewKeys: { view: View; keys: string; does: string }[] = [
  { view: "field", keys: "+ −", does: "zoom in or out (or the wheel, or two fingers)" },
  { view: "field", keys: "0", does: "the whole field" },
  { view: "field", keys: "f", does: "follow the chosen robot" },
  { view: "field", keys: "m", does: "view from the other side" },
  { view: "camera", keys: "d h l", does: "show detections, horizon, field lines over the image" },
  { view: "objects", keys: "↑ ↓ ← →", does: "move through the tree, once it has the focus" },
  { view: "objects", keys: "Enter c x g", does: "open; copy the path; pin; plot" },
  {
    view: "plot",
    keys: "+ −",
    does: "shorter or longer time span, as the wheel does; a double click: the whole recording",
  },
  { view: "what-if", keys: "Enter", does: "ask" },
  { view: "what-if", keys: "↑ ↓", does: "show another strategy's rollouts" },
  { view: "what-if", keys: "f", does: "play or stop the rollouts" },
  { view: "what-if", keys: "r", does: "put everything back to its believed place" },
  { view: "what-if", keys: "Esc", does: "close your question and show the robot's own forecast" },
  {
    view: "ground-truth",
    keys: "← → ↑ ↓",
    does: "in a calibration: move the chosen click by 0.25 px; by 2 px with Shift",
  },
  { view: "ground-truth", keys: "Del Esc", does: "in a calibration: remove the chosen click; choose none" },
];

const kNames: Record<string, string> = { " ": "Space", ArrowLeft: "←", ArrowRight: "→" };
export const nameOf = (key: string): string => kNames[key] ?? key;

/** Whether the focused element uses the key itself. */
export function belongsElsewhere(
  event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "defaultPrevented" | "target">,
): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  const element = event.target instanceof Element ? event.target : undefined;
  if (element?.matches("input:not([type=checkbox]):not([type=range]), textarea, select, [contenteditable]"))
    return true;
  if (
    element?.matches("input[type=range], input[type=checkbox], summary, button") &&
    [" ", "Enter"].includes(event.key)
  )
    return true;
  if (element?.matches("input[type=range]") && /^(Arrow|Home$|End$|Page)/.test(event.key)) return true;
  // a dialog that has just been closed keeps the focus until the next frame
  return Boolean(element?.closest("dialog[open]"));
}

/** Runs the key's action. Returns false if the key has none. */
export function press(viewer: Viewer, event: KeyboardEvent): boolean {
  const known = kPageKeys.find(({ keys }) => keys.includes(event.key));
  known?.act(viewer, event);
  return known !== undefined;
}
