import { expect, test } from "vitest";
import {
  bordersOf,
  close,
  inherited,
  kMostPanes,
  kPresets,
  leavesOf,
  maximise,
  neighbour,
  nextView,
  onePane,
  ownerOf,
  panesOf,
  placesOf,
  resize,
  seenOn,
  settingOf,
  showing,
  split,
  textOfPanes,
  tidied,
  type Panes,
} from "./panes";
import { kViews } from "./route";

const panes = (text: string): Panes => {
  const found = panesOf(text);
  if (!found) throw new Error(`no arrangement: ${text}`);
  return found;
};
const numbers = ({ tree }: Panes) => leavesOf(tree).map(({ number }) => number);
const why = "row(field:3,col(decision,plot):2)";

/** A generator of the same numbers each time. */
function drawer(seed: number): (below: number) => number {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

/** Any arrangement that a person can make by `steps` random changes. */
function anyPanes(seed: number, steps: number): Panes {
  const draw = drawer(seed);
  let made = onePane("field");
  for (let step = 0; step < steps; ++step) {
    const all = numbers(made);
    const number = all[draw(all.length)]!;
    const view = kViews[draw(kViews.length)]!;
    const borders = bordersOf(made);
    const change = [
      () => split(made, number, draw(2) ? "row" : "col", view)?.panes ?? made,
      () => close(made, number),
      () => showing(made, number, view),
      () => maximise(made, number),
      () => (borders.length > 0 ? resize(made, borders[draw(borders.length)]!, draw(100) / 100) : made),
      () => split(made, number, draw(2) ? "row" : "col", view)?.panes ?? made,
    ];
    made = change[draw(change.length)]!();
  }
  return made;
}

test("a text read again is the same arrangement, for any arrangement that can be made", () => {
  for (let seed = 0; seed < 300; ++seed) {
    const made = anyPanes(seed, 1 + (seed % 30));
    const text = textOfPanes(made);
    const again = panes(text);
    expect(textOfPanes(again), text).toBe(text);
    expect(placesOf(again), text).toEqual(placesOf(made));
  }
});

test("the panes fill the page without gap or overlap", () => {
  for (let seed = 0; seed < 100; ++seed) {
    const places = placesOf(anyPanes(seed, 25));
    expect(places.reduce((sum, { width, height }) => sum + width * height, 0)).toBeCloseTo(1);
    for (const [i, a] of places.entries())
      for (const b of places.slice(i + 1)) {
        const wide = Math.min(a.left + a.width, b.left + b.width) - Math.max(a.left, b.left);
        const high = Math.min(a.top + a.height, b.top + b.height) - Math.max(a.top, b.top);
        expect(Math.min(wide, high)).toBeLessThan(1e-9);
      }
  }
});

test("there are one to six panes, each with a number of its own, whatever is changed", () => {
  for (let seed = 0; seed < 300; ++seed) {
    const all = numbers(anyPanes(seed, 40));
    expect(all.length).toBeGreaterThanOrEqual(1);
    expect(all.length).toBeLessThanOrEqual(kMostPanes);
    expect(new Set(all).size).toBe(all.length);
    expect(all.every((number) => number >= 1 && number <= kMostPanes)).toBe(true);
  }
});

test("hostile text is no arrangement", () => {
  const cases = [
    "",
    "nothing",
    "row",
    "row()",
    "row(field)",
    "row(field,)",
    "row(field,plot",
    "row(field,plot))",
    "row(field,plot)x",
    "row(field plot)",
    "col(field:0,plot)",
    "col(field:1000,plot)",
    "col(field:-1,plot)",
    "col(field:1e9,plot)",
    "row(field.7,plot)",
    "row(field.2,plot.2)",
    "row(field!,plot!)",
    "row(constructor,__proto__)",
    `row(${Array(7).fill("field").join()})`,
    `${"row(field,".repeat(5000)}field${")".repeat(5000)}`,
    "row(".repeat(100_000),
    "<img src=x onerror=1>",
  ];
  for (const text of cases) expect(panesOf(text), text.slice(0, 40)).toBeUndefined();
});

test("every truncation of an arrangement is none, unless it is one pane", () => {
  for (let length = 0; length < why.length; ++length) expect(panesOf(why.slice(0, length))).toBeUndefined();
});

test("a split halves a pane, and panes in a row share it", () => {
  const two = split(onePane("field"), 1, "row", "plot")!;
  expect([textOfPanes(two.panes), two.number]).toEqual(["row(field,plot)", 2]);
  const three = split(two.panes, 2, "row", "log")!.panes;
  expect(textOfPanes(three)).toBe("row(field:2,plot,log)");
  const below = split(panes(why), 1, "col", "camera")!;
  expect(textOfPanes(below.panes)).toBe("row(col(field.1,camera.4):3,col(decision.2,plot.3):2)");
  expect(split(panes(`row(${Array(6).fill("field").join()})`), 1, "row", "log")).toBeUndefined();
});

test("a split anywhere leaves the room of all other panes as it is", () => {
  for (let seed = 0; seed < 100; ++seed) {
    const before = { tree: anyPanes(seed, 12).tree };
    const made = split(before, numbers(before)[0]!, seed % 2 ? "row" : "col", "log");
    if (!made || placesOf(made.panes).some(({ width, height }) => Math.min(width, height) < 0.12)) continue;
    for (const place of placesOf(before)) {
      if (place.leaf.number === numbers(before)[0]) continue;
      const after = placesOf(made.panes).find(({ leaf }) => leaf.number === place.leaf.number)!;
      expect(Math.abs(after.width - place.width)).toBeLessThan(0.12);
      expect(Math.abs(after.height - place.height)).toBeLessThan(0.12);
    }
  }
});

test("a closed pane's room goes to its neighbours; the last pane stays", () => {
  expect(textOfPanes(close(panes(why), 2))).toBe("row(field.1:3,plot.3:2)");
  expect(textOfPanes(close(panes(why), 1))).toBe("col(decision.2,plot.3)");
  expect(close(onePane("log"), 1)).toEqual(onePane("log"));
});

test("a border moves as far as both panes keep some room", () => {
  const two = panes("row(field,plot)");
  const [border] = bordersOf(two);
  expect(border).toMatchObject({ way: "row", left: 0.5, top: 0, length: 1, begin: 0, span: 1, share: 0.5 });
  expect(textOfPanes(resize(two, border!, 0.75))).toBe("row(field:75,plot:25)");
  for (const share of [-5, 0, 1, Infinity])
    for (const { width } of placesOf(resize(two, border!, share))) expect(width).toBeGreaterThan(0.09);
  const inner = bordersOf(panes(why))[1]!;
  expect(inner).toMatchObject({ path: [1], index: 0, way: "col", left: 0.6, share: 0.5 });
  expect(textOfPanes(resize(panes(why), inner, 0.25))).toBe("row(field:3,col(decision:25,plot:75):2)");
});

test("a maximised pane fills the page, in the text too, until all are shown again", () => {
  const full = maximise(panes(why), 2);
  expect(textOfPanes(full)).toBe("row(field:3,col(decision!,plot):2)");
  expect(placesOf(panes(textOfPanes(full)))).toEqual([
    { leaf: { number: 2, view: "decision" }, left: 0, top: 0, width: 1, height: 1 },
  ]);
  expect(bordersOf(full)).toEqual([]);
  expect(textOfPanes(maximise(full, 2))).toBe(why);
  expect(close(full, 2).full).toBeUndefined();
  expect(maximise(onePane("log"), 1).full).toBeUndefined();
});

test("the next and previous panes go round", () => {
  const all = panes(why);
  expect([1, 2, 3].map((number) => neighbour(all, number, 1))).toEqual([2, 3, 1]);
  expect([1, 2, 3].map((number) => neighbour(all, number, -1))).toEqual([3, 1, 2]);
});

test("an upright tablet shows two panes above each other, a phone one: always with the chosen one", () => {
  const all = panes(why);
  expect(seenOn("all", all, 2)).toBe(all);
  expect([1, 2, 3].map((number) => numbers(seenOn("two", all, number)))).toEqual([[1, 2], [1, 2], [3]]);
  expect([1, 2, 3].map((number) => numbers(seenOn("one", all, number)))).toEqual([[1], [2], [3]]);
  expect(textOfPanes(seenOn("two", panes("row(field:2,plot)"), 1))).toBe("col(field:2,plot)");
  for (const { width } of placesOf(seenOn("two", all, 1))) expect(width).toBe(1);
});

test("a setting belongs to a pane or to the whole page; links of one view belong to pane 1", () => {
  for (const name of ["layers", "plot", "robot", "at", "with", "panes"])
    for (const number of [1, 2, 6]) {
      const setting = settingOf(number, name);
      const isPage = ["at", "with", "panes"].includes(name);
      expect(setting).toBe(isPage || number === 1 ? name : `${number}.${name}`);
      expect(ownerOf(setting)).toEqual({ number: isPage ? 0 : number, name });
    }
  for (const odd of ["7.layers", "2.with", "2.", "constructor", "2.constructor", "-1.plot"])
    expect(ownerOf(odd).number).toBe(0);
});

test("settings of closed panes go, and the last pane takes the plain names", () => {
  const settings = new Map([
    ["at", "7"],
    ["layers", "truth"],
    ["2.layers", "belief"],
    ["3.plot", "ball.x"],
  ]);
  expect([...tidied(close(panes(why), 1), settings).settings.keys()]).toEqual(["at", "2.layers", "3.plot"]);
  const last = tidied(close(close(panes(why), 1), 2), settings);
  expect(last.panes).toEqual(onePane("plot"));
  expect([...last.settings]).toEqual([
    ["at", "7"],
    ["plot", "ball.x"],
  ]);
});

test("a new pane shows something else, with the settings that its view had", () => {
  const settings = new Map([
    ["layers", "truth"],
    ["3.plot", "ball.x"],
    ["3.robot", "14/3"],
    ["plot", "old"],
  ]);
  expect(nextView(panes(why))).toBe("camera");
  expect(nextView(onePane("field"))).toBe("decision");
  expect(inherited(panes(why), 2, "plot", settings)).toEqual([["plot", "ball.x"]]);
  expect(inherited(onePane("log"), 1, "plot", settings)).toEqual([["plot", "old"]]);
  expect(inherited(panes(why), 2, "log", settings)).toEqual([]);
});

test("the ready arrangements are arrangements, with a key each", () => {
  for (const { panes: text, settings, other } of kPresets) {
    expect(textOfPanes(panes(text))).toBe(text);
    for (const name of Object.keys(settings)) expect(numbers(panes(text))).toContain(ownerOf(name).number);
    if (other) expect(numbers(panes(text))).toContain(other);
  }
  expect(new Set(kPresets.map(({ key }) => key)).size).toBe(kPresets.length);
});
