import { expect, test } from "vitest";
import type { Situation } from "./forecast";
import {
  believed,
  edited,
  isEdited,
  kNoEdit,
  kUsualQuestion,
  moved,
  movedIn,
  putBack,
  questionOfText,
  requestOf,
  sameEdit,
  strategiesOf,
  textOfQuestion,
  turned,
  type Question,
} from "./question";

const kSituation: Situation = {
  ball: { x: 1, y: 0.5, deviation: 0.2 },
  bodies: [
    { side: "own", player: 2, x: -1, y: 0, heading: 0.5, deviation: 0.1 },
    { side: "opponent", player: 2, x: 2, y: 1, heading: 3, deviation: 0.3 },
  ],
};
const kEdit = moved(moved(kNoEdit, "ball", { x: -0.51234, y: 2, heading: 0 }), "opponent 2", {
  x: 0,
  y: -1,
  heading: 7,
});

test("a moved thing is certainly there, and the rest is as believed", () => {
  const now = edited(kSituation, kEdit);
  expect(now.ball).toEqual({ x: -0.512, y: 2, deviation: 0 });
  expect(now.bodies[0]).toEqual(kSituation.bodies[0]);
  expect(now.bodies[1]).toEqual({ side: "opponent", player: 2, x: 0, y: -1, heading: 0.717, deviation: 0 });
  expect(edited({ ball: undefined, bodies: [] }, kEdit).bodies).toHaveLength(1);
});

test("each thing can be put back separately", () => {
  expect(movedIn(kEdit)).toEqual(["ball", "opponent 2"]);
  expect(movedIn(putBack(kEdit, "ball"))).toEqual(["opponent 2"]);
  expect(putBack(putBack(kEdit, "ball"), "opponent 2")).toEqual(kNoEdit);
  expect([isEdited(kNoEdit), isEdited({ ...kNoEdit, ownScore: 0 }), isEdited(kEdit)]).toEqual([false, true, true]);
});

test("edits are equal only if places, headings, score and time all are", () => {
  const again = moved(moved(kNoEdit, "opponent 2", { x: 0, y: -1, heading: 7 }), "ball", {
    x: -0.51234,
    y: 2,
    heading: 0,
  });
  const two = (first: string, second: string) =>
    [first, second].reduce((edit, thing) => moved(edit, thing, { x: 0, y: 1, heading: 0 }), kNoEdit);
  expect([
    sameEdit(kEdit, again),
    sameEdit(two("own 1", "own 2"), two("own 2", "own 1")),
    sameEdit(kNoEdit, putBack(two("ball", "own 1"), "ball")),
  ]).toEqual([true, true, false]);
  for (const other of [
    { ownScore: 0 },
    { opponentScore: 0 },
    { secondsRemaining: 90 },
    { ball: undefined },
    { robots: new Map() },
  ])
    expect(sameEdit(kEdit, { ...kEdit, ...other }), JSON.stringify(other)).toBe(false);
  expect(sameEdit({ ...kNoEdit, ownScore: 1 }, { ...kNoEdit, opponentScore: 1 })).toBe(false);
});

test("the belief about a moved thing stays as it was before the move", () => {
  const answered = edited(kSituation, kEdit);
  expect(believed(answered, kEdit, kSituation)).toEqual(kSituation);
  expect(believed(answered, kEdit, undefined)).toEqual({ ball: undefined, bodies: [kSituation.bodies[0]] });
  expect(believed(kSituation, kNoEdit, undefined)).toEqual(kSituation);
});

test("headings stay in the service's range, at every angle", () => {
  for (let angle = -20; angle < 20; angle += 0.013) {
    expect(Math.abs(turned(angle))).toBeLessThan(Math.PI);
    expect(Math.cos(turned(angle) - angle)).toBeGreaterThan(0.99999);
  }
  expect(Math.abs(turned(Math.PI))).toBeLessThan(Math.PI);
});

test("the request holds only the settings that the person chose", () => {
  expect(requestOf(kUsualQuestion, "14/2")).toEqual({
    robot: "14/2",
    measure: "goal_difference",
    until: "horizon",
    horizon: 30,
    budget_ms: 1000,
  });
  const question: Question = {
    ...kUsualQuestion,
    strategies: ["a", "b"],
    opponent: "c",
    edit: { ...kEdit, opponentScore: 2, secondsRemaining: 60 },
  };
  expect(requestOf(question, "5/1")).toMatchObject({
    strategies: ["a", "b"],
    opponent: "c",
    edit: {
      ball: { x: -0.512, y: 2 },
      robots: [{ side: "opponent", player: 2, x: 0, y: -1, heading: 0.717 }],
      opponent_score: 2,
      seconds_remaining: 60,
    },
  });
  expect(requestOf(question, "5/1")["edit"]).not.toHaveProperty("own_score");
});

test("a question survives the address, with any names in it", () => {
  const questions: Question[] = [
    kUsualQuestion,
    {
      ...kUsualQuestion,
      strategies: ["base/line", "a,b:c", "ä <b>"],
      opponent: "x/y",
      measure: "concede",
      until: "half",
      horizon: 12.5,
      budgetMs: 200,
    },
    { ...kUsualQuestion, edit: { ...kEdit, ownScore: 3, opponentScore: undefined, secondsRemaining: 90 } },
    { ...kUsualQuestion, edit: { ...kNoEdit, ownScore: undefined, opponentScore: 0 } },
  ];
  expect(textOfQuestion(kUsualQuestion)).toBe("");
  for (const question of questions) expect(questionOfText(textOfQuestion(question))).toEqual(question);
});

test("an invalid address asks the usual question", () => {
  for (const text of [
    "",
    "/",
    "::/:",
    "by:luck/until:never/for:-3/in:1e99/ball:1/own2:1,2/own:1,2,3/opponent999:1,2,3/score:x,-1/left:-5",
    "ball:NaN,1/opponent2:1,2,1e5",
    "play:%E0%A4%A",
    "constructor:1/by:constructor",
  ])
    expect({ ...questionOfText(text), strategies: [] }).toEqual(kUsualQuestion);
  expect(questionOfText(`play:${Array.from({ length: 50 }, (_, i) => `s${i}`).join(",")}`).strategies).toHaveLength(8);
});

test("the offered strategies are the texts of the answer's list, each once", () => {
  expect(strategiesOf({ ok: true, strategies: ["baseline", "a, b", "baseline", "", 7] })).toEqual(["baseline", "a, b"]);
  for (const strategies of [undefined, "baseline", { 0: "baseline" }, null])
    expect(strategiesOf({ ok: true, strategies })).toEqual([]);
});
