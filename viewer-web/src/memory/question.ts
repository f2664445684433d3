// A person's question to foresight: the service's request and the text in the page's address.

import {
  kMeasures,
  kUntils,
  type Body,
  type Measure,
  type Place,
  type Side,
  type Situation,
  type Until,
} from "./forecast";

/** "ball", "own 2", "opponent 3" */
export type Thing = string;

export interface Standing extends Place {
  /** [rad] */
  heading: number;
}

/** The changes to the robot's beliefs. */
export interface Edit {
  ball: Place | undefined;
  robots: ReadonlyMap<Thing, Standing>;
  ownScore: number | undefined;
  opponentScore: number | undefined;
  /** [s] remaining of the half. */
  secondsRemaining: number | undefined;
}

export interface Question {
  /** All are compared with the first. Empty: all strategies of the robot. */
  strategies: string[];
  opponent: string;
  measure: Measure;
  until: Until;
  /** [s] of game time. */
  horizon: number;
  budgetMs: number;
  edit: Edit;
}

export const kNoEdit: Edit = {
  ball: undefined,
  robots: new Map(),
  ownScore: undefined,
  opponentScore: undefined,
  secondsRemaining: undefined,
};
export const kUsualQuestion: Question = {
  strategies: [],
  opponent: "",
  measure: "goal_difference",
  until: "horizon",
  horizon: 30,
  budgetMs: 1000,
  edit: kNoEdit,
};

export const kMostStrategies = 8;
const kLongestName = 100; // [letters]

export const thingOf = ({ side, player }: Pick<Body, "side" | "player">): Thing => `${side} ${player}`;
export function bodyOf(thing: Thing): { side: Side; player: number } | undefined {
  const [side, player] = thing.split(" ");
  return (side === "own" || side === "opponent") && /^\d{1,2}$/.test(player ?? "")
    ? { side, player: Number(player) }
    : undefined;
}

export const isEdited = ({ ball, robots, ownScore, opponentScore, secondsRemaining }: Edit): boolean =>
  robots.size > 0 || [ball, ownScore, opponentScore, secondsRemaining].some((part) => part !== undefined);

/** Whether two edits are equal. The order of the moves does not matter. */
export function sameEdit(one: Edit, other: Edit): boolean {
  const whole = ({ ball, robots, ownScore, opponentScore, secondsRemaining }: Edit) =>
    JSON.stringify([
      ball?.x,
      ball?.y,
      ownScore,
      opponentScore,
      secondsRemaining,
      ...[...robots].sort(([a], [b]) => (a < b ? -1 : 1)).map(([thing, { x, y, heading }]) => [thing, x, y, heading]),
    ]);
  return whole(one) === whole(other);
}

/** All moved things. */
export const movedIn = ({ ball, robots }: Edit): Thing[] => [...(ball ? ["ball"] : []), ...robots.keys()];

const thousandth = (value: number): number => Math.round(1000 * value) / 1000;

/** [rad] Wraps to (-π, π], also after rounding. */
export function turned(heading: number): number {
  const within = Math.atan2(Math.sin(heading), Math.cos(heading));
  return Math.max(-3.141, Math.min(3.141, thousandth(within)));
}

/** Returns the edit with the thing moved. The ball has no heading. */
export function moved(edit: Edit, thing: Thing, to: Standing): Edit {
  const place = { x: thousandth(to.x), y: thousandth(to.y) };
  if (thing === "ball") return { ...edit, ball: place };
  return { ...edit, robots: new Map([...edit.robots, [thing, { ...place, heading: turned(to.heading) }]]) };
}

/** Returns the edit with the thing back at its believed place. */
export const putBack = (edit: Edit, thing: Thing): Edit =>
  thing === "ball"
    ? { ...edit, ball: undefined }
    : { ...edit, robots: new Map([...edit.robots].filter(([name]) => name !== thing)) };

/** Returns the situation with the edit. Places from the edit are certain. */
export function edited({ ball, bodies }: Situation, edit: Edit): Situation {
  const isThere = new Set(bodies.map(thingOf));
  const come = [...edit.robots].flatMap(([thing, to]) => {
    const body = bodyOf(thing);
    return body && !isThere.has(thing) ? [{ ...body, ...to, deviation: 0 }] : [];
  });
  return {
    ball: edit.ball ? { ...edit.ball, deviation: 0 } : ball,
    bodies: [
      ...bodies.map((body) => ({
        ...body,
        ...(edit.robots.has(thingOf(body)) && { ...edit.robots.get(thingOf(body)), deviation: 0 }),
      })),
      ...come,
    ],
  };
}

/**
 * Returns the robot's own beliefs, from an answer to a question with that edit. An edited thing keeps its last
 * believed place.
 */
export function believed(answered: Situation, edit: Edit, before: Situation | undefined): Situation {
  const known = new Map(before?.bodies.map((body) => [thingOf(body), body]));
  return {
    ball: edit.ball ? before?.ball : answered.ball,
    bodies: answered.bodies.flatMap((body) =>
      edit.robots.has(thingOf(body)) ? (known.get(thingOf(body)) ?? []) : body,
    ),
  };
}

/** Returns the service's request. The robot fills in missing settings. */
export function requestOf(
  { strategies, opponent, measure, until, horizon, budgetMs, edit }: Question,
  robot: string,
): Record<string, unknown> {
  return {
    robot,
    ...(strategies.length > 0 && { strategies }),
    ...(opponent && { opponent }),
    measure,
    until,
    horizon,
    budget_ms: budgetMs,
    ...(isEdited(edit) && { edit: requestOfEdit(edit) }),
  };
}

function requestOfEdit({ ball, robots, ownScore, opponentScore, secondsRemaining }: Edit): Record<string, unknown> {
  return {
    ...(ball && { ball }),
    ...(robots.size > 0 && { robots: [...robots].map(([thing, to]) => ({ ...bodyOf(thing), ...to })) }),
    ...(ownScore !== undefined && { own_score: ownScore }),
    ...(opponentScore !== undefined && { opponent_score: opponentScore }),
    ...(secondsRemaining !== undefined && { seconds_remaining: secondsRemaining }),
  };
}

/** The names in an answer of /foresight/strategies: {"ok": true, "strategies": ["baseline", "passing"]}. */
export function strategiesOf(answer: Record<string, unknown>): string[] {
  const { strategies } = answer;
  return Array.isArray(strategies)
    ? [...new Set(strategies.filter((name) => typeof name === "string" && name !== ""))]
    : [];
}

// in the address: "play:baseline,passing/until:half/for:60/ball:1.2,-0.5/own2:1,0,0.3/score:1,0/left:300"

const coded = (name: string): string => encodeURIComponent(name);
const numbersOf = (text: string): number[] => text.split(",").map((part) => (part === "" ? NaN : Number(part)));

/** Returns "" for the usual question. */
export function textOfQuestion({ strategies, opponent, measure, until, horizon, budgetMs, edit }: Question): string {
  const { ball, robots, ownScore, opponentScore, secondsRemaining } = edit;
  const usual = kUsualQuestion;
  const parts: [string, unknown][] = [];
  if (strategies.length > 0) parts.push(["play", strategies.map(coded)]);
  if (opponent !== usual.opponent) parts.push(["others", coded(opponent)]);
  if (measure !== usual.measure) parts.push(["by", measure]);
  if (until !== usual.until) parts.push(["until", until]);
  if (horizon !== usual.horizon) parts.push(["for", horizon]);
  if (budgetMs !== usual.budgetMs) parts.push(["in", budgetMs]);
  if (ball) parts.push(["ball", [ball.x, ball.y]]);
  for (const [thing, { x, y, heading }] of robots) parts.push([thing.replace(" ", ""), [x, y, heading]]);
  if (ownScore !== undefined || opponentScore !== undefined)
    parts.push(["score", [ownScore ?? "", opponentScore ?? ""]]);
  if (secondsRemaining !== undefined) parts.push(["left", secondsRemaining]);
  return parts.map(([name, value]) => `${name}:${String(value)}`).join("/");
}

/** Parses any text. Invalid parts become the usual ones. */
export function questionOfText(text: string): Question {
  const parts = new Map(
    text.split("/").map((part) => [part.slice(0, part.indexOf(":")), part.slice(part.indexOf(":") + 1)] as const),
  );
  const word = <Word extends string>(words: Record<Word, string>, name: string, otherwise: Word): Word =>
    Object.hasOwn(words, parts.get(name) ?? "") ? (parts.get(name) as Word) : otherwise;
  const number = (name: string, least: number, most: number) => {
    const [value] = numbersOf(parts.get(name) ?? "");
    return value! >= least && value! <= most ? value : undefined;
  };
  const strategies = (parts.get("play") ?? "").split(",").filter(Boolean).map(decoded);
  return {
    strategies: [...new Set(strategies)].slice(0, kMostStrategies),
    opponent: decoded(parts.get("others") ?? ""),
    measure: word(kMeasures, "by", kUsualQuestion.measure),
    until: word(kUntils, "until", kUsualQuestion.until),
    horizon: number("for", 1, 1200) ?? kUsualQuestion.horizon,
    budgetMs: number("in", 10, 10000) ?? kUsualQuestion.budgetMs,
    edit: editOf(parts, number("left", 0, 3600)),
  };
}

function editOf(parts: ReadonlyMap<string, string>, secondsRemaining: number | undefined): Edit {
  const places = (text: string, count: number) => {
    const values = numbersOf(text);
    return values.length === count && values.every((value) => Math.abs(value) < 100) ? values : undefined;
  };
  let edit: Edit = { ...kNoEdit, secondsRemaining };
  for (const [name, text] of parts) {
    const thing = name.replace(/^(own|opponent)(?=\d)/, "$1 ");
    const values = thing === "ball" ? places(text, 2) : bodyOf(thing) && places(text, 3);
    if (values) edit = moved(edit, thing, { x: values[0]!, y: values[1]!, heading: values[2] ?? 0 });
  }
  const [own, opponent] = numbersOf(parts.get("score") ?? "").map((goals) =>
    Number.isInteger(goals) && goals >= 0 && goals <= 255 ? goals : undefined,
  );
  return { ...edit, ownScore: own, opponentScore: opponent };
}

function decoded(name: string): string {
  try {
    return decodeURIComponent(name).slice(0, kLongestName);
  } catch {
    return name.slice(0, kLongestName);
  }
}
