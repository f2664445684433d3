// The debugger's services: a moment with and without a change, and the futures of both.

import { listOf, objectOf, textOf, type Json } from "../source/json";
import type { Body, Path, Place, Side, Situation } from "./forecast";
import { bodyOf, movedIn, thingOf, turned, type Edit, type Standing, type Thing } from "./question";

export const kFutures = "/decision/futures";
export const kEditGame = "/sim/edit";

/** Mean without and with the change, and the 95 % interval of the difference. */
export interface Effect {
  without: number;
  with: number;
  low: number;
  high: number;
}

export interface Futures {
  pairs: number;
  /** Pairs in which anything differs. */
  different: number;
  /** [s] of each future. */
  seconds: number;
  /** Shares of futures. */
  scores: Effect;
  concedes: Effect;
  /** Goal difference. */
  goals: Effect;
  /** With the luck of the game: [s] from the moment to the first difference, and its place in the simulator's state. */
  parting: { seconds: number; field: string } | undefined;
  /** A few futures; those with the same index have the same luck. */
  without: Path[];
  with: Path[];
}

/** A moment that can be changed. All places are in team_field: the own team attacks towards +x. */
export interface ChangeableMoment {
  /** The simulated game itself, with the memories of its agents, at this tick; undefined: what the robot believed. */
  tick: number | undefined;
  robot: string;
  /** The numbers of the two teams. */
  teams: Record<Side, number>;
  /** The own team attacks towards +x of the simulator's field, or towards -x. */
  attacks: 1 | -1;
  places: Situation;
  strategies: string[];
  /** The leaves of the robot's tree. */
  leaves: { path: string; arguments: { name: string; value: string }[] }[];
  futures: Futures | undefined;
}

const amount = (value: unknown): number => (typeof value === "number" ? value : NaN);

const effectOf = (value: unknown): Effect => {
  const told = objectOf(value);
  return {
    without: amount(told["without"]),
    with: amount(told["with"]),
    low: amount(told["low"]),
    high: amount(told["high"]),
  };
};

/** Reads the answer of kFutures. A part that is missing or of another type becomes empty. */
export function changeableOf(answer: Json): ChangeableMoment {
  const attacks = answer["attacks"] === -1 ? -1 : 1;
  const robot = textOf(answer["robot"]);
  const own = textOf(answer["side"]);
  const player = Number(robot.split("/")[1]);
  const teams: Record<Side, number> = { own: Number(robot.split("/")[0]), opponent: 0 };
  const placeOf = (x: unknown, y: unknown): Place => ({
    x: attacks * amount(x) + 0, // + 0: no negative zero
    y: attacks * amount(y) + 0,
  });

  const before = objectOf(answer["before"]);
  const bodies = listOf(before["robots"]).map((one): Body => {
    const told = objectOf(one);
    const [team, number] = textOf(told["name"]).split("/").map(Number);
    const side: Side = told["side"] === own ? "own" : "opponent";
    teams[side] = team ?? 0;
    return {
      side,
      player: number ?? 0,
      ...placeOf(told["x"], told["y"]),
      heading: turned(amount(told["heading"]) + (attacks < 0 ? Math.PI : 0)) + 0,
      deviation: 0,
    };
  });
  const ball = objectOf(before["ball"]);

  const pointsOf = (value: unknown): Place[] => {
    const numbers = listOf(value);
    return Array.from({ length: numbers.length >> 1 }, (_, i) => placeOf(numbers[2 * i], numbers[2 * i + 1]));
  };
  const told = objectOf(answer["futures"]);
  const pathsOf = (value: unknown): Path[] =>
    listOf(value).map((one) => {
      const path = objectOf(one);
      const robots = [{ player, points: pointsOf(path["robot"]) }];
      return { spacing: amount(told["spacing"]), ball: pointsOf(path["ball"]), robots };
    });
  const [paths, parting] = [objectOf(told["paths"]), objectOf(told["parting"])];
  return {
    tick: typeof answer["tick"] === "number" ? answer["tick"] : undefined,
    robot,
    teams,
    attacks,
    places: { ball: { ...placeOf(ball["x"], ball["y"]), deviation: 0 }, bodies },
    strategies: listOf(answer["strategies"]).map(textOf),
    leaves: listOf(answer["leaves"]).map((one) => {
      const leaf = objectOf(one);
      const given = listOf(leaf["arguments"]).map(objectOf);
      return {
        path: textOf(leaf["path"]),
        arguments: given.map(({ name, value }) => ({ name: textOf(name), value: textOf(value) })),
      };
    }),
    futures: answer["futures"]
      ? {
          pairs: amount(told["pairs"]),
          different: amount(told["different"]),
          seconds: amount(told["seconds"]),
          scores: effectOf(told["scores"]),
          concedes: effectOf(told["concedes"]),
          goals: effectOf(told["goals"]),
          parting:
            textOf(parting["field"]) === ""
              ? undefined
              : { seconds: amount(parting["seconds"]), field: textOf(parting["field"]) },
          without: pathsOf(paths["without"]),
          with: pathsOf(paths["with"]),
        }
      : undefined,
  };
}

const metres = (value: number): string => String(Math.round(1000 * value) / 1000 + 0);
const degrees = (heading: number): string => String(Math.round((turned(heading) * 180) / Math.PI));

/** Returns the moves of an edit as lines of the debugger, in its frame. */
export function linesOf(edit: Edit, { teams, attacks }: Pick<ChangeableMoment, "teams" | "attacks">): string[] {
  const at = ({ x, y }: Place) => `${metres(attacks * x)} ${metres(attacks * y)}`;
  return movedIn(edit).flatMap((thing) => {
    if (thing === "ball") return [`set ball ${at(edit.ball!)}`];
    const [body, to] = [bodyOf(thing), edit.robots.get(thing) as Standing];
    if (!body) return [];
    const heading = degrees(to.heading + (attacks < 0 ? Math.PI : 0));
    return [`set ${teams[body.side]}/${body.player} at ${at(to)} ${heading}`];
  });
}

const kMove = /^\s*set\s+(ball|(\d+)\/(\d+)\s+at)\s+(-?[\d.]+)\s+(-?[\d.]+)(?:\s+(-?[\d.]+))?\s*$/;

/** Reads a line that moves a thing of the moment. Undefined for another line. */
export function moveIn(
  line: string,
  { teams, attacks, places }: Pick<ChangeableMoment, "teams" | "attacks" | "places">,
): { thing: Thing; to: Standing } | undefined {
  const found = kMove.exec(line);
  if (!found) return undefined;
  const [, what, team, player, x, y, angle] = found;
  const at: Place = { x: attacks * Number(x) + 0, y: attacks * Number(y) + 0 };
  if (what === "ball") return angle === undefined ? { thing: "ball", to: { ...at, heading: 0 } } : undefined;
  const body = places.bodies.find((one) => teams[one.side] === Number(team) && one.player === Number(player));
  if (!body) return undefined;
  const turn = attacks < 0 ? Math.PI : 0;
  const heading = angle === undefined ? body.heading : turned((Number(angle) * Math.PI) / 180 + turn) + 0;
  return { thing: thingOf(body), to: { ...at, heading } };
}

/** Whether a line changes a tree. A running game keeps its trees. */
export const isOfTree = (line: string): boolean => /^\s*(strategy|set\s+(threshold|argument))\b/.test(line);
