// A moment of a game as a situation file of foresight-sim (sim/io/situation.h).

import { valueOf } from "../memory/memory_object";
import type { GameState } from "../memory/schema";
import { kSimulation } from "../memory/simulation";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "../memory/value";
import type { Pose } from "./beliefs";
import type { Field, Point } from "./field";
import type { Robot, Scene, Told } from "./scene";

const kMostPlayers = 7; // of the simulator, a side
const kWaiting = 0.5; // [m] beyond the touch line, where a penalised robot waits

interface Standing {
  side: "home" | "away";
  player: number;
  x: number;
  y: number;
  heading: number;
  /** [s] until it returns. */
  penalised?: number;
}

/**
 * Returns the text of the file, or the reason why the moment cannot be saved. Robots and ball are at their true places, or
 * where they believe to be. Robots beside the field are listed with the rest of their penalty. A robot of unknown heading
 * faces the ball.
 */
export function situationOf(
  scene: Scene,
  told: Told[],
  field: Field,
  about: string,
): { text: string } | { missing: string } {
  const ball = scene.ball ?? believedBall(scene);
  if (!ball) return { missing: "The place of the ball is unknown at this moment." };
  const game = gameOf(scene, told);
  const turned = turnsHome(told, game);
  const robots = standing(scene, ball, turned);
  if (robots.length === 0) return { missing: "The place of no robot is known at this moment." };
  const teams = { home: teamOf(scene, true), away: teamOf(scene, false) };
  const list = [...robots, ...penalised(game, field, robots)].sort(
    (a, b) => a.side.localeCompare(b.side) * -1 || a.player - b.player,
  );
  const place = placed(ball, turned);
  const speed = ball.velocity && placed(ball.velocity, turned);
  const lines = {
    about,
    ...(teams.home > 0 && teams.away > 0 && { teams }),
    ...wordsOf(game, scene),
    ball: { ...place, ...(speed && { velocity_x: speed.x, velocity_y: speed.y }) },
    robots: list,
  };
  return { text: `${JSON.stringify(lines, null, 2)}\n` };
}

const rounded = (value: number): number => Math.round(10_000 * value) / 10_000 + 0; // + 0: no negative zero
const placed = ({ x, y }: Point, turned: boolean): Point => ({
  x: rounded(turned ? -x : x),
  y: rounded(turned ? -y : y),
});

/** [rad] Wraps into what a situation may hold, after rounding too. */
const wrapped = (heading: number): number =>
  Math.max(-3.1415, Math.min(3.1415, rounded(Math.atan2(Math.sin(heading), Math.cos(heading)))));

const numberIn = (name: string): number => Number(name.split("/")[1]);
const teamIn = (name: string): number => Number(name.split("/")[0]);
const teamOf = ({ robots }: Scene, home: boolean): number =>
  teamIn(robots.find((robot) => robot.home === home)?.name ?? "0");

/** Returns the ball of the robot that saw it last. */
function believedBall({ robots }: Scene): Scene["ball"] {
  const balls = robots.flatMap(({ ball }) => ball ?? []).sort((a, b) => a.age - b.age);
  return balls[0] && { x: balls[0].x, y: balls[0].y, velocity: balls[0].velocity };
}

/** The GameController's state as one robot heard it, and that robot. */
interface Heard {
  fields: Fields<GameState>;
  robot: Robot;
}

/** Returns the game of a robot of the home side, or else of any. */
function gameOf(scene: Scene, told: Told[]): Heard | undefined {
  const heard = scene.robots.flatMap((robot) =>
    told.flatMap(({ memory }) => ({ fields: valueOf(memory.of(robot.name, "game")), robot })),
  );
  const games = heard.filter(({ fields }) => fields.size > 0);
  return games.find(({ robot }) => robot.home) ?? games[0];
}

const halfOf = (game: Heard | undefined): number => (game && numberOf(game.fields, "half")) || 1;

/** Reports whether the home side attacks against the direction that a situation of this half has: then it is turned by π. */
function turnsHome(told: Told[], game: Heard | undefined): boolean {
  const attacks = game?.fields.get("attacks_positive_x");
  if (!game || typeof attacks !== "boolean" || told.some(({ memory }) => memory.world(kSimulation)?.shown))
    return false;
  return (attacks === game.robot.home) !== (halfOf(game) % 2 === 1);
}

/** Gives each robot a number of the simulator: its own, or a free one for a larger number. */
function numbered(robots: Robot[]): [Robot, number][] {
  const taken = new Set(robots.map(({ name }) => numberIn(name)));
  // the goalkeeper's number comes last
  const free = [2, 3, 4, 5, 6, kMostPlayers, 1].filter((player) => !taken.has(player));
  return robots.flatMap((robot): [Robot, number][] => {
    const player = numberIn(robot.name) <= kMostPlayers ? numberIn(robot.name) : free.shift();
    return player ? [[robot, player]] : [];
  });
}

function standing(scene: Scene, ball: Point, turned: boolean): Standing[] {
  const placeOf = (robot: Robot): Pose | undefined =>
    robot.truth ?? (scene.robots.some(({ truth }) => truth) ? undefined : robot.pose);
  return [true, false].flatMap((home) =>
    numbered(scene.robots.filter((robot) => robot.home === home && placeOf(robot))).map(([robot, player]) => {
      const { x, y, heading } = placeOf(robot)!;
      const facing = Number.isFinite(heading) ? heading : Math.atan2(ball.y - y, ball.x - x);
      return {
        side: home ? "home" : "away",
        player,
        ...placed({ x, y }, turned),
        heading: wrapped(facing + (turned ? Math.PI : 0)),
      };
    }),
  );
}

/** Returns the penalised robots that are not on the field, beside the touch line in front of their own goal. */
function penalised(game: Heard | undefined, { length, width }: Field, there: Standing[]): Standing[] {
  if (!game) return [];
  return (["own", "opponent"] as const).flatMap((team) => {
    const side = (team === "own") === game.robot.home ? "home" : "away";
    const attack = (side === "home") === (halfOf(game) % 2 === 1) ? 1 : -1;
    return listOf(fieldsOf(game.fields, team), "players").flatMap((state, i): Standing[] => {
      const [player, seconds] = [i + 1, numberOf(state, "seconds_till_unpenalised")];
      const known = there.some((robot) => robot.side === side && robot.player === player);
      if (known || state.get("penalised") !== true || !(seconds > 0) || player > kMostPlayers) return [];
      return [
        {
          side,
          player,
          x: rounded((-attack * length) / 4),
          y: rounded(width / 2 + kWaiting),
          heading: -1.5708,
          penalised: rounded(Math.min(3600, seconds)),
        },
      ];
    });
  });
}

/** Set plays of the GameController that the simulator has. It plays every other one like a kick-in. */
const kSetPlays = ["goal_kick", "corner_kick"];

function setPlayOf(fields: Fields<GameState>): string {
  const word = wordOf(fields, "set_play");
  if (kSetPlays.includes(word)) return word;
  if (word && word !== "unspecified") return "kick_in";
  const state = wordOf(fields, "state");
  const coming = ["ready", "set"].includes(state);
  const on =
    state === "playing" &&
    numberOf(fields, "secondary_seconds") > 0 &&
    Number.isFinite(numberOf(fields, "kicking_team"));
  return coming || on ? "kick_off" : "none";
}

/** Returns phase, set play, half, time and score. */
function wordsOf(game: Heard | undefined, scene: Scene): object {
  if (!game) return {};
  const { fields, robot } = game;
  const state = wordOf(fields, "state");
  const phase = ["ready", "set", "playing", "finished"].includes(state) ? state : "initial";
  const [own, opponent] = (["own", "opponent"] as const).map((team) =>
    Math.min(255, numberOf(fieldsOf(fields, team), "score") || 0),
  );
  const kicking = numberOf(fields, "kicking_team");
  const remaining = numberOf(fields, "seconds_remaining");
  return {
    phase: state === "playing" && fields.get("stopped") === true ? "set" : phase,
    set_play: setPlayOf(fields),
    ...(Number.isFinite(kicking) && { kicking: kicking === teamOf(scene, true) ? "home" : "away" }),
    half: halfOf(game),
    ...(remaining >= 0 && { remaining: rounded(remaining) }),
    score: robot.home ? { home: own, away: opponent } : { home: opponent, away: own },
  };
}

/** Returns the words that tell where the moment is from. */
export function originOf(told: Told[], moment: string): string {
  const simulation = told.map(({ memory }) => valueOf(memory.world(kSimulation))).find((fields) => fields.size > 0);
  if (!simulation) return `the moment ${moment} of a recording`;
  const [home, away] = (["home", "away"] as const).map((side) => textOf(fieldsOf(simulation, side), "strategy"));
  return `${home} against ${away}, ${textOf(simulation, "rules")}, seed ${numberOf(simulation, "seed")}, moment ${(numberOf(simulation, "tick") / 30).toFixed(1)}`;
}
