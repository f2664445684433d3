import { expect, test } from "vitest";
import { completionAt } from "./completion";
import { compile } from "./compile";
import { orMistake } from "./expression";
import { gameVocabulary } from "./test_vocabulary";

/** The labels of the proposals at "|". */
function at(marked: string): string[] {
  const caret = marked.indexOf("|");
  return completionAt(marked.replace("|", ""), caret, gameVocabulary()).proposals.map(({ label }) => label);
}
/** The text after the first proposal was taken. */
function taken(marked: string): string {
  const caret = marked.indexOf("|");
  const text = marked.replace("|", "");
  const { from, to, proposals } = completionAt(text, caret, gameVocabulary());
  return text.slice(0, from) + proposals[0]!.insert + text.slice(to);
}

test("objects, functions and “any” are proposed for a word, best first", () => {
  expect(at("|")).toEqual(
    expect.arrayContaining(["ball", "pose", "game", "truth", "distance(a, b)", "field(ball)", "any …"]),
  );
  expect(at("di|")).toEqual(["distance(a, b)"]);
  expect(at("distance(b|")[0]).toBe("ball");
  expect(at("a|")[0]).toBe("abs(a)");
  expect(at("/14/3|")).toEqual(["/14/3/ball", "/14/3/pose"]);
});

test("fields of the object before the point are proposed, also of nested ones and of the truth", () => {
  expect(at("ball.|")).toEqual(["x", "y", "visible", "seen_ns"]);
  expect(at("ball.x > 2 && pose.h|")).toEqual(["heading"]);
  expect(at("/14/3/ball.|")).toEqual(["x", "y", "visible", "seen_ns"]);
  expect(at("truth.|")).toEqual(["pose", "ball", "robots"]);
  expect(at("truth.pose.|")).toEqual(["team", "player", "x", "y", "heading"]);
  expect(at("pose.particles[0].|")).toEqual(["x", "y"]);
  expect(at("ball.x.|")).toEqual([]);
});

test("joints and robots are proposed in brackets, values behind a comparison with an enum", () => {
  expect(at("joints.position[head|")).toEqual(["head_yaw", "head_pitch"]);
  expect(at("truth.robots[|")).toEqual(["team=10,player=1", "team=14,player=2", "team=14,player=3"]);
  expect(at("game.state == |")).toEqual(["unspecified", "ready", "set", "playing"]);
  expect(at("game.state != pl|")).toEqual(["playing"]);
  expect(at("ball.visible == |")).toEqual(["true", "false"]);
});

test("nothing is proposed where a sign must follow, between quotes, or for a finished word", () => {
  for (const text of [
    "ball.x > 2|",
    "ball.x > 2 |",
    "abs(ball.x)|",
    "decision.role == 'cha|",
    "game.state == playing|",
  ])
    expect(at(text), text).toEqual([]);
});

test("a proposal replaces the whole word at the caret, and makes what can be parsed", () => {
  expect(taken("ball.vi|s > 2")).toBe("ball.visible > 2");
  expect(taken("joints.position[l_kn|")).toBe("joints.position[l_knee_pitch]");
  expect(taken("dist|")).toBe("distance(");
  for (const text of ["ball.|", "joints.temperature[|", "truth.pose.|", "game.|", "field(ball).x + pose.|"])
    expect(
      orMistake(() => compile(taken(text), gameVocabulary())),
      taken(text),
    ).not.toHaveProperty("error");
});
