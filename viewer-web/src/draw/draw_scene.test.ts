import { expect, test } from "vitest";
import { drawScene, freshness, robotAt } from "./draw_scene";
import { kUsualField, toScreen } from "./field";
import type { Robot, Scene } from "./scene";
import { testPen } from "./test_pen";

const kCamera = { scale: 100, centreX: 400, centreY: 300 };
const robot = (name: string, x: number, more: Partial<Robot> = {}): Robot => ({
  name, home: name.startsWith("14/"), truth: { x, y: 1, heading: 0 }, fallen: false, pose: undefined, ball: undefined, ...more,
});
const scene = (...robots: Robot[]): Scene => ({ field: kUsualField, ball: { x: 0.5, y: -0.25 }, robots });
const drawn = (what: Scene, chosen = "") => {
  const pen = testPen();
  drawScene(pen, kCamera, what, chosen);
  return pen;
};

test("everybody stands where he is, with his number", () => {
  const pen = drawn(scene(robot("14/2", -1), robot("5/3", 2)));
  expect(pen.texts).toEqual([
    { text: "2", ...toScreen(kCamera, { x: -1, y: 1 }) },
    { text: "3", ...toScreen(kCamera, { x: 2, y: 1 }) },
  ]);
  const [home, away] = pen.texts.map(({ x, y }) => pen.circles.find((circle) => circle.filled && circle.x === x && circle.y === y)!);
  expect(home!.style).not.toBe(away!.style);
});

test("the ball is where it is; without one there is none", () => {
  const place = toScreen(kCamera, { x: 0.5, y: -0.25 });
  const balls = (what: Scene) => drawn(what).circles.filter(({ x, y, filled }) => filled && x === place.x && y === place.y);
  expect(balls(scene())).toHaveLength(1);
  expect(balls({ ...scene(), ball: undefined })).toHaveLength(0);
});

test("a believed ball fades while it is not seen, and the chosen robot's shows its error", () => {
  const believed = (age: number): Robot =>
    robot("14/2", 0, { pose: { x: 0, y: 1, heading: 0, deviation: 0.3 }, ball: { x: 1.5, y: 1.5, deviation: 0.4, age } });
  const place = toScreen(kCamera, { x: 1.5, y: 1.5 });
  const at = (age: number, chosen: string) => drawn(scene(believed(age)), chosen).circles.filter(({ x, y }) => x === place.x && y === place.y);
  const strength = (age: number, chosen: string) => at(age, chosen).find(({ filled }) => filled)!.alpha;
  expect(strength(0, "14/2")).toBe(1);
  expect(strength(2, "14/2")).toBeLessThan(strength(1, "14/2"));
  expect(strength(0, "")).toBeLessThan(strength(0, "14/2"));
  expect(at(0, "14/2").find(({ filled }) => !filled)!.radius).toBeCloseTo(40);
  expect(at(0, "")).toHaveLength(1);
});

test("freshness falls from 1 and never quite to nothing", () => {
  expect([freshness(-0.1), freshness(0)]).toEqual([1, 1]);
  for (let age = 0; age < 20; age += 0.5) expect(freshness(age + 0.5)).toBeLessThanOrEqual(freshness(age));
  expect(freshness(1e6)).toBeGreaterThan(0.1);
});

test("the nearest robot is meant, if it is near", () => {
  const what = scene(robot("14/2", -1), robot("5/3", -0.8));
  expect(robotAt(what, { x: -0.85, y: 1 })?.name).toBe("5/3");
  expect(robotAt(what, { x: -1.1, y: 1 })?.name).toBe("14/2");
  expect(robotAt(what, { x: 1, y: 1 })).toBeUndefined();
  expect(robotAt(scene(), { x: 0, y: 0 })).toBeUndefined();
});
