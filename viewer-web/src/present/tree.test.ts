import { expect, test } from "vitest";
import { EnumValue, type Value } from "../memory/value";
import { Changes } from "./changes";
import { rowsOf, textOfRow, wordsOf, type Root } from "./tree";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const kBall: Root = {
  path: "/14/2/ball",
  name: "ball",
  value: fields({
    x: 1.5,
    seen_ns: 12n,
    centre: fields({ x: 3 }),
    side: new EnumValue(1, "SIDE_OWN"),
    radius: undefined,
  }),
};
const kJoints: Root = {
  path: "/14/2/joints",
  name: "joints",
  value: fields({ angles: Array.from({ length: 25 }, (_, i) => i / 10), robots: [fields({ x: 1 }), fields({ x: 2 })] }),
};
const open = (...paths: string[]) => new Map(paths.map((path) => [path, true]));
const paths = (roots: Root[], opened = open(), search = "") =>
  rowsOf(roots, opened, wordsOf(search)).map(({ path }) => path);
const textAt = (root: Root, opened: ReturnType<typeof open>, path: string) =>
  textOfRow(rowsOf([root], opened, []).find((row) => row.path === path)!);

test("objects are closed at first and show a glimpse", () => {
  expect(paths([kBall, kJoints])).toEqual(["/14/2/ball", "/14/2/joints"]);
  expect(textAt(kBall, open(), "/14/2/ball")).toBe("x 1.5, side SIDE_OWN");
  expect(textAt(kJoints, open(), "/14/2/joints")).toBe("angles, robots");
});

test("an open object shows every field, nested fields, and absent ones", () => {
  expect(paths([kBall], open("/14/2/ball"))).toEqual(
    ["", ".x", ".seen_ns", ".centre", ".centre.x", ".side", ".radius"].map((step) => `/14/2/ball${step}`),
  );
  expect(textAt(kBall, open("/14/2/ball"), "/14/2/ball.radius")).toBe("absent");
  expect(textAt(kBall, open("/14/2/ball"), "/14/2/ball.seen_ns")).toBe("12");
});

test("a long list is closed until opened, a short one is open, entries have an index", () => {
  const shown = paths([kJoints], open("/14/2/joints"));
  expect(shown).not.toContain("/14/2/joints.angles[0]");
  expect(shown).toContain("/14/2/joints.robots[1].x");
  expect(textAt(kJoints, open("/14/2/joints"), "/14/2/joints.angles")).toBe(
    "25 entries · 0, 0.1, 0.2, 0.3, 0.4, 0.5, …",
  );
  expect(paths([kJoints], open("/14/2/joints", "/14/2/joints.angles"))).toContain("/14/2/joints.angles[r_hand]");
});

test("the entries of a list by joint have the names of the joints, by which they are found", () => {
  const rows = rowsOf([kJoints], open(), wordsOf("l_knee"));
  expect(rows.at(-1)).toMatchObject({ path: "/14/2/joints.angles[l_knee_pitch]", name: "[10] l_knee_pitch", value: 1 });
});

test("a search keeps the fields that match all words and the nodes above them, also closed ones", () => {
  expect(paths([kBall, kJoints], open(), "CENTRE x")).toEqual([
    "/14/2/ball",
    "/14/2/ball.centre",
    "/14/2/ball.centre.x",
  ]);
  expect(paths([kBall, kJoints], open(), "robots[1]")).toEqual([
    "/14/2/joints",
    "/14/2/joints.robots",
    "/14/2/joints.robots[1]",
    "/14/2/joints.robots[1].x",
  ]);
  const closed = new Map([["/14/2/ball.centre", false]]);
  expect(paths([kBall], closed, "centre.x")).toContain("/14/2/ball.centre.x");
  expect(paths([kBall, kJoints], open(), "joints")).toEqual(["/14/2/joints"]);
  expect(paths([kBall, kJoints], open(), "nothing such")).toEqual([]);
});

test("every row found by a search is also a row of the whole tree", () => {
  const all = paths([kBall, kJoints], open("/14/2/ball", "/14/2/joints", "/14/2/joints.angles"));
  for (const search of ["x", "a", "robots", "14", "[2"])
    for (const path of paths([kBall, kJoints], open("/14/2/joints.angles"), search)) expect(all).toContain(path);
});

test("an object that cannot be decoded has a sentence below it, and the others stay", () => {
  const broken: Root = { path: "/14/2/odd", name: "odd", value: { error: "This message does not fit." } };
  const rows = rowsOf([broken, kBall], open(), []);
  expect(rows.map(({ kind }) => kind)).toEqual(["root", "note", "root"]);
  expect(textOfRow(rows[1]!)).toBe("This message does not fit.");
});

test("an object without a message can be opened, which may subscribe it", () => {
  const silent: Root = { path: "/14/2/camera_top", name: "camera_top", value: undefined };
  expect(rowsOf([silent], open(), [])).toMatchObject([{ open: false }]);
  expect(rowsOf([silent], open("/14/2/camera_top"), []).map(textOfRow)).toEqual(["", "Nothing has come yet."]);
});

test("values are one line of text: bytes by length and beginning, hostile strings quoted, unknown enums by number", () => {
  const text = (value: Value) => textAt({ path: "r", name: "r", value: fields({ f: value }) }, open("r"), "r.f");
  expect(text(new Uint8Array(614400))).toBe("614 kB · 00 00 00 00 00 00 00 00 …");
  expect(text(new Uint8Array())).toBe("0 B");
  expect(text("<b>\n</b>")).toBe('"<b>\\n</b>"');
  expect(text("x".repeat(1000)).length).toBeLessThan(210);
  expect(text(new EnumValue(9, undefined))).toBe("unknown (9)");
  expect(text(false)).toBe("false");
  expect(text([])).toBe("0 entries");
});

test("a list without end shows its beginning and how much is left", () => {
  const huge: Root = { path: "h", name: "h", value: fields({ list: new Array<Value>(12000).fill(1) }) };
  const rows = rowsOf([huge], open("h", "h.list"), []);
  expect(rows).toHaveLength(10003);
  expect(textOfRow(rows.at(-1)!)).toBe("2000 more");
});

test("a row has changed when its text differs from before", () => {
  const changes = new Changes();
  expect(changes.sinceChange("a", "1", 0)).toBe(Infinity);
  expect(changes.sinceChange("a", "1", 1)).toBe(Infinity);
  expect(changes.sinceChange("a", "2", 2)).toBe(0);
  expect(changes.sinceChange("a", "2", 5)).toBe(3);
});
