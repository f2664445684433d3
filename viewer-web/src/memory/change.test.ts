import { expect, test } from "vitest";
import { changeableOf, isOfTree, linesOf, moveIn } from "./change";
import { kNoEdit, moved } from "./question";

const kAnswer = {
  ok: true,
  from: "game",
  tick: 900,
  robot: "5/3",
  side: "away",
  attacks: -1,
  before: {
    ball: { x: 1, y: -0.5 },
    robots: [
      { name: "14/2", side: "home", x: -1, y: 0, heading: 0 },
      { name: "5/3", side: "away", x: 2, y: 1, heading: Math.PI },
    ],
  },
  after: {},
  strategies: ["baseline", "passing"],
  leaves: [{ path: "baseline/kick", arguments: [{ name: "tolerance", value: "15 deg" }] }],
  futures: {
    pairs: 200,
    different: 150,
    seconds: 30,
    scores: { without: 0.12, with: 0.31, low: 0.11, high: 0.27 },
    concedes: { without: 0.1, with: 0.1, low: -0.02, high: 0.02 },
    goals: { without: 0, with: 0.2, low: 0.1, high: 0.3 },
    parting: { seconds: 0.5, field: "world.ball.position.x" },
    spacing: 0.5,
    paths: { without: [{ ball: [1, -0.5, 2, 0], robot: [2, 1] }], with: [{ ball: [], robot: [] }] },
  },
};

test("a moment is read so that the own team attacks to the right", () => {
  const moment = changeableOf(kAnswer);
  expect(moment.tick).toBe(900);
  expect(moment.teams).toEqual({ own: 5, opponent: 14 });
  expect(moment.places.ball).toEqual({ x: -1, y: 0.5, deviation: 0 });
  expect(moment.places.bodies).toEqual([
    { side: "opponent", player: 2, x: 1, y: 0, heading: 3.141, deviation: 0 },
    { side: "own", player: 3, x: -2, y: -1, heading: 0, deviation: 0 },
  ]);
  expect(moment.leaves).toEqual([{ path: "baseline/kick", arguments: [{ name: "tolerance", value: "15 deg" }] }]);
  const { futures } = moment;
  expect(futures?.scores).toEqual({ without: 0.12, with: 0.31, low: 0.11, high: 0.27 });
  expect(futures?.parting).toEqual({ seconds: 0.5, field: "world.ball.position.x" });
  expect(futures?.without).toEqual([
    {
      spacing: 0.5,
      ball: [
        { x: -1, y: 0.5 },
        { x: -2, y: 0 },
      ],
      robots: [{ player: 3, points: [{ x: -2, y: -1 }] }],
    },
  ]);
});

test("an answer of another form is empty", () => {
  const moment = changeableOf({ robot: 7, before: [], strategies: "all", leaves: [3], futures: null });
  expect(moment.robot).toBe("");
  expect(moment.tick).toBeUndefined();
  expect(moment.places.bodies).toEqual([]);
  expect(moment.strategies).toEqual([]);
  expect(moment.futures).toBeUndefined();
});

test("moves become lines in the frame of the game", () => {
  const edit = moved(moved(kNoEdit, "ball", { x: 1, y: 0, heading: 0 }), "own 3", { x: -2, y: -1, heading: 0 });
  expect(linesOf(edit, { teams: { own: 5, opponent: 14 }, attacks: -1 })).toEqual([
    "set ball -1 0",
    "set 5/3 at 2 1 180",
  ]);
  expect(linesOf(edit, { teams: { own: 5, opponent: 14 }, attacks: 1 })).toEqual([
    "set ball 1 0",
    "set 5/3 at -2 -1 0",
  ]);
});

test("a typed move is a move", () => {
  const moment = changeableOf(kAnswer);
  expect(moveIn("set ball -1 0.25", moment)).toEqual({ thing: "ball", to: { x: 1, y: -0.25, heading: 0 } });
  expect(moveIn(" set 5/3  at 1 0 ", moment)).toEqual({ thing: "own 3", to: { x: -1, y: 0, heading: 0 } });
  expect(moveIn("set 14/2 at 1 0 180", moment)).toEqual({ thing: "opponent 2", to: { x: -1, y: 0, heading: 0 } });
  for (const other of ["set ball 1", "set ball 1 2 3", "set 14/3 at 0 0", "set 5/3 believes at 0 0", "strategy set"])
    expect(moveIn(other, moment)).toBeUndefined();
});

test("lines that change a tree are told apart", () => {
  expect(["set threshold 3 0.5", "strategy passing", "set  argument aim goal of kick"].map(isOfTree)).toEqual([
    true,
    true,
    true,
  ]);
  expect(["set ball 1 0", "set luck 3", "set 14/2 at 0 0"].map(isOfTree)).toEqual([false, false, false]);
});
