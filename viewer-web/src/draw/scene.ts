// The scene of a game: the truth and each robot's beliefs, all in the frame `field`.

import type { Memory } from "../memory/memory";
import { topicOfRobot, valueOf, type RobotName } from "../memory/memory_object";
import type { GroundTruth, GroundTruth_TrueBall, GroundTruth_TrueRobot } from "../memory/schema";
import { kSimulation } from "../memory/simulation";
import { fieldsOf, listOf, numberOf, wordOf, type Fields } from "../memory/value";
import { kTruth } from "../memory/vocabulary";
import { beliefsOf, kBeliefs, pointIn, pointOf, type Beliefs, type Pose } from "./beliefs";
import type { Point } from "./field";
import { kLiveries, kUnknownLivery, liveriesOf, type Liveries, type Livery } from "./robot_sign";

export interface Robot extends Beliefs {
  name: RobotName;
  /** Of the page's address: with the server where that is not the page's own. */
  key: string;
  home: boolean;
  livery: Livery;
  /** The opponents' livery. */
  rivals: Livery;
  /** The true pose, or undefined if unknown. */
  truth: Pose | undefined;
  fallen: boolean;
}

export interface Scene {
  ball: (Point & { velocity: Point | undefined }) | undefined;
  robots: Robot[];
}

/** One server's memory and the names of its robots here. */
export interface Told {
  memory: Memory;
  robots: RobotName[];
  /** The rules of the game that the server reports, such as "spl2025"; "" if it reports none. */
  rules?: string;
  keyOf(robot: RobotName): string;
}

/** Returns the offered topics that `sceneOf` reads. */
export function topicsOf(memory: Memory, robots: RobotName[]): string[] {
  const ofRobots = robots.flatMap((robot) =>
    kBeliefs
      // the camera's direction comes 30 times a second, the joints 100 times
      .filter((object) => object !== "joints" || !memory.of(robot, "camera_top_matrix"))
      .map((object) => topicOfRobot(robot, object)),
  );
  return [kTruth, kSimulation, ...ofRobots].filter((topic) => memory.get(topic));
}

/** Returns the servers of one field: the first, and those without a truth of their own. Two truths are two games. */
export const oneWorld = (told: Told[]): Told[] =>
  told.filter(({ memory }, i) => i === 0 || !memory.world(kTruth)?.shown);

/** Merges all servers: the truth of the first that sends it, robots of all. */
export function sceneOf(told: Told[], now: number): Scene {
  const worlds = told.map(({ memory }) => valueOf(memory.world(kTruth)));
  const homeTeam = homeTeamOf(told, worlds);
  const liveries = liveriesIn(told, homeTeam);
  return {
    ball: worlds.map((world) => ballOf(fieldsOf(world, "ball"))).find((ball) => ball),
    robots: told.flatMap((server, i) => robotsOf(server, worlds[i]!, { homeTeam, liveries }, now)),
  };
}

function ballOf(fields: Fields<GroundTruth_TrueBall>): Scene["ball"] {
  const place = pointOf(fields);
  return place && { ...place, velocity: pointIn(fields, "velocity_x", "velocity_y") };
}

/** Returns the home team of the simulation, else the first team of those that send objects, else the first in the truth. */
function homeTeamOf(told: Told[], worlds: Fields<GroundTruth>[]): number {
  const simulations = told.map(({ memory }) => valueOf(memory.world(kSimulation)));
  const numbers = simulations.map((fields) => numberOf(fieldsOf(fields, "home"), "number"));
  const sending = told.flatMap(({ robots }) => robots.map(teamOf));
  const seen = worlds
    .flatMap((world) => listOf(world, "robots").map((robot) => numberOf(robot, "team")))
    .filter(Number.isFinite);
  return numbers.find(Number.isFinite) ?? Math.min(...(sending.length > 0 ? sending : seen));
}

interface Sides {
  homeTeam: number;
  liveries: Liveries;
}

/** Returns the liveries by the jerseys that the GameController reports, or the usual ones. */
function liveriesIn(told: Told[], homeTeam: number): Liveries {
  for (const { memory, robots } of told)
    for (const robot of robots) {
      const game = valueOf(memory.of(robot, "game"));
      const [own, opponent] = (["own", "opponent"] as const).map((side) => fieldsOf(game, side));
      const [mine, theirs] = [own!, opponent!].map((team) => wordOf(team, "field_colour").replace("colour_", ""));
      if (mine && theirs)
        return numberOf(own!, "number") === homeTeam ? liveriesOf(mine, theirs) : liveriesOf(theirs, mine);
    }
  return kLiveries;
}

/** Returns the liveries of the team of `robot` and of its opponents. */
export function liveriesFor(told: Told[], robot: RobotName): { own: Livery; opponent: Livery } {
  const worlds = told.map(({ memory }) => valueOf(memory.world(kTruth)));
  const homeTeam = homeTeamOf(told, worlds);
  const { home, away } = liveriesIn(told, homeTeam);
  return teamOf(robot) === homeTeam ? { own: home, opponent: away } : { own: away, opponent: home };
}

const teamOf = (name: RobotName): number => Number(name.split("/")[0]);

/** Returns "14/2", else the number of the track, "#5": a depth camera sees no jersey. */
function nameOf(robot: Fields<GroundTruth_TrueRobot>, index: number): RobotName {
  const [team, player, track] = (["team", "player", "track"] as const).map((name) => numberOf(robot, name));
  if (Number.isFinite(team) && Number.isFinite(player)) return `${team}/${player}`;
  return Number.isFinite(track) ? `#${track}` : `robot ${index + 1} without a number`;
}

function robotsOf(
  { memory, robots, keyOf }: Told,
  world: Fields<GroundTruth>,
  { homeTeam, liveries }: Sides,
  now: number,
): Robot[] {
  const truths = new Map(listOf(world, "robots").map((robot, i) => [nameOf(robot, i), robot]));
  const names = [...new Set([...robots, ...truths.keys()])].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  return names.map((name) => {
    const truth = truths.get(name);
    const place = truth && pointOf(truth);
    const home = teamOf(name) === homeTeam;
    const livery = home ? liveries.home : liveries.away;
    return {
      ...beliefsOf(memory, name, now),
      name,
      key: keyOf(name),
      home,
      livery: Number.isFinite(teamOf(name)) ? livery : kUnknownLivery,
      rivals: home ? liveries.away : liveries.home,
      truth: place && { ...place, heading: numberOf(truth!, "heading") },
      fallen: truth?.get("fallen") === true,
    };
  });
}
