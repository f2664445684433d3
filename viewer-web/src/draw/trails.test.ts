import { expect, test } from "vitest";
import { drawScene, type TrailPoint } from "./draw_scene";
import { kFields } from "./field";
import { testPen } from "./test_pen";
import { withLeaps } from "./trails";

const at = (x: number, seconds: number) => ({ x, y: 0, log_ns: BigInt(Math.round(seconds * 1e9)) });

test("a robot that moved faster than it can has a gap in its trail; one that walks has none", () => {
  const walking = Array.from({ length: 20 }, (_, i) => at(0.05 * i, 0.1 * i));
  expect(withLeaps(walking, "robot").some(({ leaps }) => leaps)).toBe(false);
  const placed = [...walking, at(3, 2), at(3.05, 2.1)];
  expect(withLeaps(placed, "robot").findIndex(({ leaps }) => leaps)).toBe(20);
  expect(withLeaps(placed, "robot").filter(({ leaps }) => leaps)).toHaveLength(1);
  // the same way in more time is a way: messages may be rare
  expect(withLeaps([at(0, 0), at(3, 6)], "robot")[1]!.leaps).toBeUndefined();
  // a time that goes back is another game
  expect(withLeaps([at(0, 9), at(0, 0)], "robot")[1]!.leaps).toBe(true);
});

test("a kicked ball has a trail; one that the referee places has a gap", () => {
  expect(withLeaps([at(0, 0), at(0.5, 0.1)], "ball")[1]!.leaps).toBeUndefined();
  expect(withLeaps([at(0, 0), at(4, 0.1)], "ball")[1]!.leaps).toBe(true);
});

test("nothing is drawn over a leap", () => {
  const ends: [number, number][] = [];
  const pen = testPen();
  let from = 0;
  pen.moveTo = (x) => (from = x);
  pen.lineTo = (x) => {
    ends.push([from, x]);
    from = x;
  };
  const field = kFields["spl2012"]!;
  const draw = (points: TrailPoint[]) => {
    ends.length = 0;
    drawScene(
      pen,
      { scale: 100, centreX: 0, centreY: 0 },
      { ball: undefined, robots: [] },
      { field, chosen: "", layers: new Set(["trail"]), trails: [{ key: "", kind: "ball", points }] },
    );
    return ends.filter(([a, b]) => a <= 150 && b >= 250 && b < 300).length;
  };
  const places = [0, 1, 2.5, 2.6].map((x) => ({ x, y: 3.9 }));
  expect(draw(places)).toBe(1);
  expect(draw(places.map((place) => (place.x === 2.5 ? { ...place, leaps: true } : place)))).toBe(0);
});
