import { expect, test } from "vitest";
import { colourOfSkill, differencesOf, drawPhases, piecesOf, piecesOfRuns } from "./phases";
import { countOf } from "./timeline";
import { testPen } from "./test_pen";

const phase = (second: number, skill: string, leaf = skill) => ({
  from_ns: BigInt(second) * 1_000_000_000n,
  skill,
  leaf,
  role: "",
});
const seconds = (ns: bigint) => Number(ns) / 1e9;

test("phases become pieces of what is on screen; the same skill from another leaf is one piece", () => {
  const phases = [phase(0, "walk"), phase(2, "kick", "a"), phase(3, "kick", "b"), phase(5, "search")];
  expect(piecesOf(phases, { from: 1, to: 10 }, seconds).map(({ from, to, skill }) => [from, to, skill])).toEqual([
    [1, 2, "walk"],
    [2, 5, "kick"],
    [5, 10, "search"],
  ]);
  expect(piecesOf(phases, { from: 2.5, to: 2.7 }, seconds).map(({ skill }) => skill)).toEqual(["kick"]);
  expect(piecesOf([], { from: 0, to: 1 }, seconds)).toEqual([]);
});

test("a wide enough piece shows its skill", () => {
  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#000" };
  const pieces = piecesOf([phase(0, "walk_to_ball"), phase(9, "kick")], { from: 0, to: 10 }, seconds);
  drawPhases(
    pen,
    400,
    50,
    pieces,
    undefined,
    ["kick", "walk_to_ball"],
    { span: { from: 0, to: 10 }, at: 5, count: countOf({ from: 0, to: 10 }, false) },
    colours,
  );
  expect(pen.texts.map(({ text }) => text)).toContain("walk to ball");
  expect(colourOfSkill(["a", "b"], "a")).not.toBe(colourOfSkill(["a", "b"], "b"));
});

test("runs of a whole recording become pieces with the gaps between them", () => {
  const run = (from: number, to: number, ...words: string[]) => ({ from_ns: BigInt(from), to_ns: BigInt(to), words });
  const runs = [run(0, 10, "stand", "keeper"), run(10, 20, "walk"), run(50, 60, "kick", "striker"), run(90, 95, "x")];
  expect(piecesOfRuns(runs, { from: 5, to: 55 }, Number)).toEqual([
    { from: 5, to: 10, skill: "stand", role: "keeper" },
    { from: 10, to: 20, skill: "walk", role: "" },
    { from: 50, to: 55, skill: "kick", role: "striker" },
  ]);
});

test("two bands differ where both decided, for other skills", () => {
  const piece = (from: number, to: number, skill: string) => ({ from, to, skill, role: "" });
  const recorded = [piece(0, 4, "walk"), piece(4, 6, "kick"), piece(10, 12, "search")];
  const other = [piece(0, 3, "walk"), piece(3, 6, "dribble"), piece(6, 11, "walk")];
  expect(differencesOf(recorded, other)).toEqual([
    { from: 3, to: 6 },
    { from: 10, to: 11 },
  ]);
  expect(differencesOf(recorded, recorded)).toEqual([]);
  expect(differencesOf(recorded, [])).toEqual([]);

  const pen = testPen();
  const colours = { ink: "#000", soft: "#000", line: "#000", fill: "#000", accent: "#000", warn: "#f00" };
  const span = { from: 0, to: 12 };
  drawPhases(
    pen,
    1200,
    92,
    recorded,
    other,
    ["dribble", "kick", "search", "walk"],
    { span, at: 1, count: countOf(span, true) },
    colours,
  );
  expect(pen.texts.map(({ text }) => text)).toEqual(expect.arrayContaining(["kick", "dribble"]));
});
