// Foresight's forecast of each strategy, from the object `forecast` or from the service /foresight/what_if.

import type {
  Forecast as ForecastMessage,
  Forecast_Path,
  Forecast_Situation,
  Forecast_Situation_Body,
  Forecast_StrategyForecast,
} from "./schema";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields, type NumberIn, type Value } from "./value";

export const kMeasures = {
  goal_difference: "goal difference",
  score_next: "scoring next",
  concede: "not conceding next",
};
export type Measure = keyof typeof kMeasures;

export const kUntils = {
  horizon: "for some seconds",
  next_goal: "to the next goal",
  half: "to the end of the half",
  game: "to the end of the game",
};
export type Until = keyof typeof kUntils;

/** The asker whom a question without a name has: only a team's process asks so. */
const kTeam = "the team's code";

export type Side = "own" | "opponent";
export type Advice = "none" | "keep" | "change";

/** [m] in team_field: the own team attacks towards +x. */
export interface Place {
  x: number;
  y: number;
}

/** One robot at the start of the rollouts. */
export interface Body extends Place {
  side: Side;
  player: number;
  /** [rad] */
  heading: number;
  /** [m] one standard deviation; 0: certain. */
  deviation: number;
}

export interface Situation {
  ball: (Place & { deviation: number }) | undefined;
  bodies: Body[];
}

/** One simulated continuation. */
export interface Path {
  /** [s] between points. */
  spacing: number;
  ball: Place[];
  /** Of the own team. */
  robots: { player: number; points: Place[] }[];
}

/** How often the ball was in each cell. Row by row from (-length/2, -width/2), x first. */
export interface Heat {
  columns: number;
  counts: number[];
}

/** Values are in the unit of the measure. */
export interface StrategyForecast {
  name: string;
  rollouts: number;
  mean: number;
  /** One standard error of the mean. */
  error: number;
  /** [0..1] */
  score: number;
  concede: number;
  /** Compared with the first strategy, with its 95 % interval. */
  gain: number;
  gainLow: number;
  gainHigh: number;
  /** [0..1] Probability that it is the best of all. */
  best: number;
  /** False if its rollouts were stopped early, because it fell behind. */
  racedOn: boolean;
  paths: Path[];
  heat: Heat | undefined;
}

export interface Forecast {
  measure: Measure;
  until: Until;
  opponent: string;
  /** "people", "captain: " and a reason, or the name of a team's process. Older recordings may lack it. */
  askedBy: string;
  advice: Advice;
  choice: string;
  reason: string;
  strategies: StrategyForecast[];
  /** [ms] From the question to the answer; of processor time. */
  answeredMs: number;
  computedMs: number;
  /** [s] of game time: of all rollouts together; at most of each one. */
  simulated: number;
  horizon: number;
  models: string;
  situation: Situation;
  /**
   * [0..1] Share of the rollouts that start with the ball elsewhere on the field, because nobody has seen it for a
   * while.
   */
  ballElsewhere: number;
  /** At the start of the rollouts: goals, own first, and remaining seconds of the half. Undefined if unknown. */
  standing: { score: [number, number]; remaining: number } | undefined;
}

const finite = <M>(fields: Fields<M>, name: NumberIn<M>): number => {
  const value = numberOf(fields, name);
  return Number.isFinite(value) ? value : 0;
};

const known = <Word extends string>(words: Record<Word, unknown>, word: string, otherwise: Word): Word =>
  Object.hasOwn(words, word) ? (word as Word) : otherwise;
const kAdvice = { none: 0, keep: 0, change: 0 };

/** The object, or the answer of the service, in which some parts of the situation have other names. */
export type ForecastAnswer = Omit<ForecastMessage, "situation"> & { situation?: AnswerSituation };
type AnswerSituation = Forecast_Situation & {
  ball?: { x?: number; y?: number; deviation?: number; elsewhere?: number };
  robots?: (Forecast_Situation_Body & { side?: string })[];
};

/** Reads an object or an answer. Missing values become empty or 0. */
export function forecastOf(fields: Fields<ForecastAnswer>): Forecast {
  const question = fieldsOf(fields, "question");
  const count = (name: NumberIn<ForecastAnswer>) => finite(fields, name);
  const situation = fieldsOf(fields, "situation");
  return {
    measure: known(kMeasures, wordOf(question, "measure"), "goal_difference"),
    until: known(kUntils, wordOf(question, "until"), "horizon"),
    opponent: textOf(question, "opponent"),
    askedBy: textOf(question, "asked_by") || kTeam,
    advice: known(kAdvice, wordOf(fields, "advice"), "none"),
    choice: textOf(fields, "choice"),
    reason: textOf(fields, "reason") || textOf(fields, "refusal"),
    strategies: listOf(fields, "strategies").map(strategyOf),
    answeredMs: count("answered_ms"),
    computedMs: count("computed_ms"),
    simulated: count("simulated"),
    horizon: count("horizon") || finite(question, "horizon"),
    models: textOf(fields, "models"),
    situation: situationOf(situation),
    ballElsewhere: finite(situation, "ball_elsewhere") || finite(fieldsOf(situation, "ball"), "elsewhere"),
    standing: standingOf(situation),
  };
}

/** Converts a service's JSON object to the fields of a message. */
export function fieldsOfJson(value: unknown): Fields {
  const read = (part: unknown): Value => {
    if (Array.isArray(part)) return part.map(read);
    if (typeof part === "object" && part !== null)
      return new Map(Object.entries(part).map(([name, entry]) => [name, read(entry)]));
    return typeof part === "number" || typeof part === "string" || typeof part === "boolean" ? part : undefined;
  };
  const fields = read(value);
  return fields instanceof Map ? fields : new Map();
}

function strategyOf(fields: Fields<Forecast_StrategyForecast>): StrategyForecast {
  const of = (name: NumberIn<Forecast_StrategyForecast>) => finite(fields, name);
  return {
    name: textOf(fields, "strategy"),
    rollouts: of("rollouts"),
    mean: of("mean"),
    error: of("error"),
    score: of("score"),
    concede: of("concede"),
    gain: of("gain"),
    gainLow: of("gain_low"),
    gainHigh: of("gain_high"),
    best: of("best"),
    racedOn: fields.get("raced_on") === true,
    paths: listOf(fields, "paths").map(pathOf),
    heat: heatOf(fields),
  };
}

const pathOf = (fields: Fields<Forecast_Path>): Path => ({
  spacing: finite(fields, "spacing"),
  ball: pointsOf(fields.get("ball")),
  robots: listOf(fields, "robots").map((robot) => ({
    player: finite(robot, "player"),
    points: pointsOf(robot.get("points")),
  })),
});

/** Returns x, y of each point, up to the first invalid one. */
function pointsOf(list: Value): Place[] {
  const points: Place[] = [];
  if (!Array.isArray(list)) return points;
  for (let i = 0; i + 1 < list.length; i += 2) {
    const [x, y] = [list[i], list[i + 1]];
    if (typeof x !== "number" || typeof y !== "number" || !Number.isFinite(x) || !Number.isFinite(y)) break;
    points.push({ x, y });
  }
  return points;
}

function heatOf(fields: Fields<Forecast_StrategyForecast>): Heat | undefined {
  const columns = numberOf(fields, "heat_columns");
  const counts = fields.get("heat");
  const fits =
    Array.isArray(counts) &&
    counts.length > 0 &&
    Number.isInteger(columns) &&
    columns > 0 &&
    counts.length % columns === 0;
  return fits
    ? { columns, counts: counts.map((count) => (typeof count === "number" && count > 0 ? count : 0)) }
    : undefined;
}

/** Reads the situation. The object has ball_x and bodies, the service has ball.x and robots. */
function situationOf(fields: Fields<AnswerSituation>): Situation {
  const ball = fieldsOf(fields, "ball");
  const [x, y, deviation] = (["x", "y", "deviation"] as const).map((name) =>
    ball.size > 0 ? numberOf(ball, name) : numberOf(fields, `ball_${name}`),
  );
  const bodies: Fields<Forecast_Situation_Body & { side?: string }>[] = [
    ...listOf(fields, "bodies"),
    ...listOf(fields, "robots"),
  ];
  return {
    ball: Number.isFinite(x) && Number.isFinite(y) ? { x: x!, y: y!, deviation: deviation || 0 } : undefined,
    bodies: bodies.map((body) => ({
      side: body.get("opponent") === true || body.get("side") === "opponent" ? "opponent" : "own",
      player: finite(body, "player"),
      x: finite(body, "x"),
      y: finite(body, "y"),
      heading: finite(body, "heading"),
      deviation: finite(body, "deviation"),
    })),
  };
}

function standingOf(situation: Fields<Forecast_Situation>): Forecast["standing"] {
  const remaining = numberOf(situation, "seconds_remaining");
  return Number.isFinite(remaining)
    ? { score: [finite(situation, "own_score"), finite(situation, "opponent_score")], remaining }
    : undefined;
}

/** Whether the situation has neither ball nor robots, as in a refused forecast. */
export const isEmpty = ({ ball, bodies }: Situation): boolean => !ball && bodies.length === 0;

/** Returns the strategy `name`, else the advised one, else the first. */
export const chosenOf = ({ strategies, choice }: Forecast, name: string): StrategyForecast | undefined =>
  strategies.find((strategy) => strategy.name === name) ??
  strategies.find((strategy) => strategy.name === choice) ??
  strategies[0];
