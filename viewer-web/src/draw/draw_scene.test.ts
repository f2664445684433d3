import { expect, test } from "vitest";
import { drawScene, freshness, kUsualLayers, type Layer } from "./draw_scene";
import { kFields, toScreen } from "./field";
import { factsAt, robotAt } from "./hover";
import { kLiveries } from "./robot_sign";
import type { Robot, Scene } from "./scene";
import { testPen } from "./test_pen";

const kField = kFields["spl2012"]!;
const kCamera = { scale: 100, centreX: 400, centreY: 300 };
const liveries = (home: boolean) => ({
  home,
  livery: home ? kLiveries.home : kLiveries.away,
  rivals: home ? kLiveries.away : kLiveries.home,
});
const robot = (name: string, x: number, more: Partial<Robot> = {}): Robot => ({
  name,
  key: name,
  ...liveries(name.startsWith("14/")),
  truth: { x, y: 1, heading: 0 },
  fallen: false,
  pose: undefined,
  ball: undefined,
  teammates: [],
  opponents: [],
  view: undefined,
  target: undefined,
  kick: undefined,
  role: "",
  skill: "",
  ...more,
});
const kPose = {
  x: 0,
  y: 1,
  heading: 0,
  deviation: 0.3,
  uncertainty: { a: 0.3, b: 0.1, angle: 0 },
  headingDeviation: 0.1,
  age: 0,
};
const scene = (...robots: Robot[]): Scene => ({ ball: { x: 0.5, y: -0.25, velocity: undefined }, robots });
const drawn = (what: Scene, chosen = "", layers: Layer[] = kUsualLayers) => {
  const pen = testPen();
  drawScene(pen, kCamera, what, { field: kField, chosen, layers: new Set(layers), trails: [] });
  return pen;
};

test("each robot is drawn at its place with its number", () => {
  const pen = drawn(scene(robot("14/2", -1), robot("5/3", 2)));
  expect(pen.texts).toEqual([
    { text: "2", ...toScreen(kCamera, { x: -1, y: 1 }) },
    { text: "3", ...toScreen(kCamera, { x: 2, y: 1 }) },
  ]);
  expect(pen.circles.find(({ filled, x, y }) => filled && x === pen.texts[0]!.x && y === pen.texts[0]!.y)!.style).toBe(
    kLiveries.home.colour,
  );
  expect(pen.polygons).toHaveLength(1);
  expect(pen.polygons[0]).toMatchObject({ style: kLiveries.away.colour, alpha: 1 });
  for (const { x, y } of pen.polygons[0]!.corners)
    expect(Math.hypot(x - pen.texts[1]!.x, y - pen.texts[1]!.y)).toBeCloseTo(18.75);
});

test("a fallen robot is as strong as a standing one, has a bold sign, and is named", () => {
  for (const name of ["14/2", "5/3"]) {
    const [standing, fallen] = [false, true].map((is) => drawn(scene(robot(name, -1, { fallen: is }))));
    const bodies = (pen: typeof standing) =>
      [...pen!.circles, ...pen!.polygons].filter(
        ({ filled, style }) => filled && [kLiveries.home.colour, kLiveries.away.colour].includes(style),
      );
    expect(bodies(fallen).map(({ alpha }) => alpha)).toEqual(bodies(standing).map(({ alpha }) => alpha));
    expect(fallen!.texts.map(({ text }) => text)).toContain("fallen");
    expect(standing!.texts.map(({ text }) => text)).not.toContain("fallen");
    expect(fallen!.circles.some(({ filled, alpha, radius }) => !filled && alpha === 1 && radius > 20)).toBe(true);
  }
  const mate = { x: 0, y: 0, heading: 0, age: 0, player: 4, fallen: true };
  expect(
    drawn(scene(robot("14/2", -1, { teammates: [mate] })), "14/2", ["team"]).texts.map(({ text }) => text),
  ).toContain("fallen");
});

test("the ball is drawn at its place, and not at all without a ball", () => {
  const place = toScreen(kCamera, { x: 0.5, y: -0.25 });
  const balls = (what: Scene) =>
    drawn(what).circles.filter(({ x, y, filled }) => filled && x === place.x && y === place.y);
  expect(balls(scene())).toHaveLength(1);
  expect(balls({ ...scene(), ball: undefined })).toHaveLength(0);
});

test("a believed ball fades while unseen, and the chosen robot's ball shows its error", () => {
  const believed = (age: number): Robot =>
    robot("14/2", 0, {
      pose: kPose,
      ball: {
        x: 1.5,
        y: 1.5,
        deviation: 0.4,
        uncertainty: { a: 0.4, b: 0.4, angle: 0 },
        velocity: { x: 0, y: 0 },
        age,
      },
    });
  const place = toScreen(kCamera, { x: 1.5, y: 1.5 });
  const at = (age: number, chosen: string) =>
    drawn(scene(believed(age)), chosen).circles.filter(({ x, y }) => x === place.x && y === place.y);
  const strongest = (age: number, chosen: string) =>
    Math.max(
      ...at(age, chosen)
        .filter(({ filled }) => filled)
        .map(({ alpha }) => alpha),
    );
  expect(strongest(0, "14/2")).toBe(1);
  expect(strongest(2, "14/2")).toBeLessThan(strongest(1, "14/2"));
  expect(strongest(0, "")).toBeLessThan(strongest(0, "14/2"));
  expect(at(0, "14/2").find(({ filled, radius }) => !filled && radius > 10)!.radius).toBeCloseTo(40);
  expect(at(0, "")).toHaveLength(1);
});

test("freshness falls from 1 and never reaches 0", () => {
  expect([freshness(-0.1), freshness(0)]).toEqual([1, 1]);
  for (let age = 0; age < 20; age += 0.5) expect(freshness(age + 0.5)).toBeLessThanOrEqual(freshness(age));
  expect(freshness(1e6)).toBeGreaterThan(0.1);
});

test("the nearest robot is hit, if it is near enough", () => {
  const what = scene(robot("14/2", -1), robot("5/3", -0.8));
  expect(robotAt(what, { x: -0.85, y: 1 })?.name).toBe("5/3");
  expect(robotAt(what, { x: -1.1, y: 1 })?.name).toBe("14/2");
  expect(robotAt(what, { x: 1, y: 1 })).toBeUndefined();
  expect(robotAt(scene(), { x: 0, y: 0 })).toBeUndefined();
});

test("a hidden layer draws nothing, and the field stays", () => {
  const what = scene(robot("14/2", -1, { pose: kPose }));
  expect(drawn(what, "14/2", []).circles.filter(({ filled, radius }) => filled && radius > 10)).toEqual([]);
  expect(drawn(what, "14/2", []).points.length).toBeGreaterThan(20);
  for (const layer of ["truth", "belief", "uncertainty"] as const)
    expect(drawn(what, "14/2", [layer]).points.length).toBeGreaterThan(drawn(what, "14/2", []).points.length);
});

test("without the truth, the belief gets the disc", () => {
  const pen = drawn({ ball: undefined, robots: [robot("14/2", 0, { truth: undefined, pose: kPose })] }, "14/2");
  expect(pen.texts).toEqual([{ text: "2", ...toScreen(kCamera, kPose) }]);
});

test("hovering shows the truth, the belief and its error", () => {
  const ball = {
    x: 0.5,
    y: 0,
    deviation: 0.4,
    uncertainty: { a: 0.4, b: 0.4, angle: 0 },
    velocity: { x: 0.3, y: 0.4 },
    age: 2,
  };
  const what = scene(robot("14/2", 0.3, { pose: kPose, ball, role: "chaser", skill: "walk_to_ball" }));
  expect(factsAt(what, { x: 0.3, y: 1 }, "")).toEqual({
    title: "Robot 14/2",
    lines: [
      "chaser · walk to ball",
      "is at x 0.30, y 1.00 m, 0°",
      "believes x 0.00, y 1.00 m, 0° ± 0.30 m · 0 ms old",
      "wrong by 0.30 m, 0°",
    ],
  });
  expect(factsAt(what, { x: 0.5, y: 0 }, "")!.lines).toEqual([
    "x 0.50, y 0.00 m ± 0.40 m",
    "rolls 0.50 m/s",
    "seen 2.00 s ago",
    "wrong by 0.25 m",
  ]);
  expect(factsAt(what, { x: 0.5, y: -0.25 }, "")!.title).toBe("Ball, as it is");
  expect(factsAt(what, { x: -2, y: -1 }, "")).toBeUndefined();
});

test("opponents are drawn at their believed places, fade while unseen, and are described on hovering", () => {
  const believing = (age: number) =>
    scene(robot("14/2", -2, { opponents: [{ x: 1.5, y: 1.5, player: 3, deviation: 0.4, age }] }));
  const place = toScreen(kCamera, { x: 1.5, y: 1.5 });
  const circle = (age: number, layers: Layer[] = ["opponents"]) =>
    drawn(believing(age), "14/2", layers).circles.find(({ x, y }) => x === place.x && y === place.y);
  expect(circle(0)!.radius).toBeCloseTo(40);
  expect(circle(9)!.alpha).toBeLessThan(circle(1)!.alpha);
  expect(circle(0, ["truth"])).toBeUndefined();
  expect(factsAt(believing(2), { x: 1.5, y: 1.5 }, "14/2")).toEqual({
    title: "Opponent 3, as 14/2 believes",
    lines: ["x 1.50, y 1.50 m ± 0.40 m", "seen 2.00 s ago"],
  });
});

test("rollouts are drawn along their paths, and only if the layer is on", () => {
  const foreseen = {
    colour: kLiveries.home.colour,
    paths: [
      {
        spacing: 1,
        ball: [
          { x: 0, y: 0 },
          { x: 2.5, y: -1.5 },
        ],
        robots: [],
      },
    ],
  };
  const end = toScreen(kCamera, { x: 2.5, y: -1.5 });
  const leads = (layers: Layer[]) => {
    const pen = testPen();
    drawScene(pen, kCamera, scene(), { field: kField, chosen: "", layers: new Set(layers), trails: [], foreseen });
    return pen.points.some(({ x, y }) => x === end.x && y === end.y);
  };
  expect([leads(["forecast"]), leads(kUsualLayers)]).toEqual([true, false]);
});
