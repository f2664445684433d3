import { expect, test } from "vitest";
import type { Path, Situation } from "../memory/forecast";
import { kNoEdit, moved } from "../memory/question";
import { kFields, toScreen } from "./field";
import { drawForeseen, fieldRound, gripAt, kEditColour, onCarpet, standingOf, warmth, type Foreseen } from "./foreseen";
import { lengthOf, placeAt } from "./futures";
import { kLiveries } from "./robot_sign";
import { testPen } from "./test_pen";

const kField = kFields["spl2012"]!;
const kCamera = { scale: 100, centreX: 400, centreY: 300 };
const kSituation: Situation = {
  ball: { x: 1, y: 0.5, deviation: 0.2 },
  bodies: [
    { side: "own", player: 2, x: -1, y: 0, heading: 0, deviation: 0.1 },
    { side: "opponent", player: 2, x: 1.2, y: 0.5, heading: 0, deviation: 0 },
  ],
};
const kPath: Path = {
  spacing: 0.5,
  ball: [
    { x: 0, y: 0 },
    { x: 1, y: 0 },
    { x: 1, y: 2 },
  ],
  robots: [
    {
      player: 2,
      points: [
        { x: -1, y: 0 },
        { x: -1, y: 1 },
      ],
    },
  ],
};
const kSides = { own: kLiveries.home, opponent: kLiveries.away };
const drawn = (more: Partial<Foreseen>) => {
  const pen = testPen();
  drawForeseen(pen, kCamera, {
    field: kField,
    liveries: kSides,
    believed: kSituation,
    edit: kNoEdit,
    heat: undefined,
    paths: [],
    at: 0,
    held: undefined,
    stale: false,
    ...more,
  });
  return pen;
};

test("both sides look as on the field, also when the robot that foresees plays away", () => {
  for (const liveries of [kSides, { own: kLiveries.away, opponent: kLiveries.home }]) {
    const pen = drawn({ liveries });
    const disc = toScreen(
      kCamera,
      kSituation.bodies.find(({ side }) => liveries[side].shape === "disc")!,
    );
    expect(pen.circles.filter(({ filled, radius }) => filled && radius === 15)).toMatchObject([
      { ...disc, style: kLiveries.home.colour },
    ]);
    expect(pen.polygons.map(({ style }) => style)).toEqual([kLiveries.away.colour]);
  }
});

test("deviations are circles of their size, and certain things have none", () => {
  const radii = (x: number, y: number) =>
    drawn({})
      .circles.filter((circle) => !circle.filled && circle.x === x && circle.y === y)
      .map(({ radius }) => Math.round(radius));
  const [ball, own, opponent] = [kSituation.ball!, ...kSituation.bodies].map((at) => toScreen(kCamera, at));
  expect(radii(ball!.x, ball!.y)).toContain(20);
  expect(radii(own!.x, own!.y)).toEqual([10, 15]);
  expect(radii(opponent!.x, opponent!.y)).toEqual([]);
});

test("a moved thing is marked at its new place and shows its believed place", () => {
  const marks = (pen: ReturnType<typeof testPen>) => pen.circles.filter(({ style }) => style === kEditColour);
  expect(marks(drawn({}))).toHaveLength(0);
  const [was, is] = marks(drawn({ edit: moved(kNoEdit, "own 2", { x: 2, y: 1, heading: 0 }) }));
  expect(was).toMatchObject(toScreen(kCamera, { x: -1, y: 0 }));
  expect(is).toMatchObject(toScreen(kCamera, { x: 2, y: 1 }));
});

test("a robot that was moved onto another one is drawn on top", () => {
  const { texts } = drawn({
    believed: {
      ...kSituation,
      bodies: [
        { ...kSituation.bodies[0]!, player: 7 },
        { ...kSituation.bodies[0]!, player: 8 },
      ],
    },
    edit: moved(kNoEdit, "own 7", { x: -1, y: 0, heading: 0 }),
  });
  expect(texts.map(({ text }) => text)).toEqual(["8", "7"]);
});

test("a rollout's marker moves from point to point and stays at the end", () => {
  expect([0, 0.25, 0.5, 0.75, 1, 9].map((at) => placeAt(kPath.ball, 0.5, at))).toEqual([
    { x: 0, y: 0 },
    { x: 0.5, y: 0 },
    { x: 1, y: 0 },
    { x: 1, y: 1 },
    { x: 1, y: 2 },
    { x: 1, y: 2 },
  ]);
  expect(placeAt([], 0.5, 1)).toBeUndefined();
  expect(placeAt(kPath.ball, 0, 1)).toEqual({ x: 0, y: 0 });
  expect([lengthOf([kPath]), lengthOf([])]).toEqual([1, 0]);
  const then = drawn({ paths: [kPath], at: 0.75 }).circles.filter(({ filled }) => filled);
  for (const place of [
    { x: 1, y: 1 },
    { x: -1, y: 1 },
  ])
    expect(then.some(({ x, y }) => x === toScreen(kCamera, place).x && y === toScreen(kCamera, place).y)).toBe(true);
});

test("only part of a long rollout is drawn in full: its beginning, or the part before the shown time", () => {
  const long: Path = { spacing: 1, ball: Array.from({ length: 121 }, (_, i) => ({ x: i / 50, y: 0 })), robots: [] };
  const full = (at: number) => {
    const ticks = drawn({ believed: { ball: undefined, bodies: [] }, paths: [long], at }).circles.filter(
      ({ filled, style, radius }) => filled && style === "#ffffff" && Math.round(radius) === 3,
    );
    return ticks.filter(({ alpha }) => alpha === 1).map(({ x }) => Math.round((x - kCamera.centreX) / 2));
  };
  expect(full(0)).toEqual([5, 10, 15, 20, 25, 30]);
  expect(full(72)).toEqual([45, 50, 55, 60, 65, 70]);
});

test("paths with no point or one point are drawn without an error", () => {
  for (const ball of [[], [{ x: 0, y: 0 }]])
    drawn({ paths: [{ spacing: 0.5, ball, robots: [{ player: 1, points: ball }] }], at: 0.3 });
});

test("heat is strongest where the ball was most often, and zero where it never was", () => {
  const { columns, rows, values } = warmth({ columns: 3, counts: [0, 0, 0, 0, 9, 0, 0, 0, 0] });
  expect(values).toHaveLength(columns * rows);
  const at = (x: number, y: number) => values[Math.floor(y * rows) * columns + Math.floor(x * columns)]!;
  expect(at(0.5, 0.5)).toBeGreaterThan(0.8);
  expect(at(0, 0)).toBe(0);
  expect(at(0.4, 0.5)).toBeCloseTo(at(0.59, 0.5));
  expect(Math.max(...warmth({ columns: 2, counts: [0, 0, 0, 0] }).values)).toBe(0);
  // of row 0, at -width/2: below the middle
  const lower = drawn({ heat: { columns: 1, counts: [5, 0] } }).boxes.slice(1);
  expect(lower.length).toBeGreaterThan(0);
  for (const { y, height } of lower) expect(y + height).toBeGreaterThan(kCamera.centreY - 100);
});

test("the nearest thing is gripped, the ball before the robot behind it, and the handle turns", () => {
  const at = (x: number, y: number, held?: string) => gripAt(kCamera, kSituation, held, toScreen(kCamera, { x, y }));
  expect(at(1, 0.5)).toEqual({ thing: "ball", turns: false });
  expect(at(1.35, 0.5)).toEqual({ thing: "opponent 2", turns: false });
  expect(at(-1.1, 0.1)).toEqual({ thing: "own 2", turns: false });
  expect(at(-0.58, 0)).toBeUndefined();
  expect(at(-0.58, 0, "own 2")).toEqual({ thing: "own 2", turns: true });
  expect(at(0, -1.5)).toBeUndefined();
  expect(standingOf(kSituation, "own 9")).toBeUndefined();
});

test("nothing can be dragged off the carpet, and things believed beyond it are visible", () => {
  expect(onCarpet(kField, { x: 99, y: -99 })).toEqual({ x: 3.71, y: -2.71 });
  expect(onCarpet(kField, { x: 1, y: 1 })).toEqual({ x: 1, y: 1 });
  const away = (x: number) =>
    fieldRound(kField, {
      ball: undefined,
      bodies: [{ side: "opponent", player: 1, x, y: 0, heading: 0, deviation: 0 }],
    }).border;
  expect([away(0), away(1e9)]).toEqual([kField.border, 2]);
  expect(away(4)).toBeCloseTo(1.3);
});
