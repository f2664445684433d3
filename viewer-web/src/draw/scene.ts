// The scene of a game: the truth and each robot's beliefs, all in the frame `field`.

import type { Memory } from "../memory/memory";
import type { RobotName } from "../memory/memory_object";
import { kSimulation } from "../memory/simulation";
import { fieldsOf, listOf, numberOf, type Fields } from "../memory/value";
import { beliefsOf, kBeliefs, pointOf, valueOf, type Beliefs, type Pose } from "./beliefs";
import { kUsualField, type Field, type Point } from "./field";

export interface Robot extends Beliefs {
  name: RobotName;
  /** Of the page's address: with the server where that is not the page's own. */
  key: string;
  home: boolean;
  /** The true pose, or undefined if unknown. */
  truth: Pose | undefined;
  fallen: boolean;
}

export interface Scene {
  /** Undefined if unknown. */
  field: Field | undefined;
  ball: (Point & { velocity: Point | undefined }) | undefined;
  robots: Robot[];
}

/** One server's memory and the names of its robots here. */
export interface Told {
  memory: Memory;
  robots: RobotName[];
  keyOf(robot: RobotName): string;
}

export const kTruth = "/truth/world";

/** Returns the offered topics that `sceneOf` reads. */
export function topicsOf(memory: Memory, robots: RobotName[]): string[] {
  const topics = [kTruth, kSimulation, ...robots.flatMap((robot) => kBeliefs.map((object) => `/${robot}/${object}`))];
  // the camera's direction comes 30 times a second, the joints 100 times
  const needless = (topic: string) => topic.endsWith("/joints") && memory.get(topic.replace("joints", "camera_top_matrix"));
  return topics.filter((topic) => memory.get(topic) && !needless(topic));
}

/** Returns the servers of one field: the first, and those without a truth of their own. Two truths are two games. */
export const oneWorld = (told: Told[]): Told[] => told.filter(({ memory }, i) => i === 0 || !memory.get(kTruth)?.shown);

/** Merges all servers: truth and field of the first that sends them, robots of all. */
export function sceneOf(told: Told[], now: number): Scene {
  const worlds = told.map(({ memory }) => valueOf(memory.get(kTruth)));
  const simulations = told.map(({ memory }) => valueOf(memory.get(kSimulation)));
  const homeTeam = homeTeamOf(simulations, told, worlds);
  return {
    field: simulations.map((fields) => fieldOf(fieldsOf(fields, "field"))).find((field) => field),
    ball: worlds.map((world) => ballOf(fieldsOf(world, "ball"))).find((ball) => ball),
    robots: told.flatMap((server, i) => robotsOf(server, worlds[i]!, homeTeam, now)),
  };
}

function ballOf(fields: Fields): Scene["ball"] {
  const place = pointOf(fields);
  return place && { ...place, velocity: pointOf(fields, "velocity_x", "velocity_y") };
}

/** Returns the home team of the simulation, else the first team of those that send objects, else the first in the truth. */
function homeTeamOf(simulations: Fields[], told: Told[], worlds: Fields[]): number {
  const numbers = simulations.map((fields) => numberOf(fieldsOf(fields, "home"), "number"));
  const sending = told.flatMap(({ robots }) => robots.map(teamOf));
  const seen = worlds.flatMap((world) => listOf(world, "robots").map((robot) => numberOf(robot, "team")));
  return numbers.find(Number.isFinite) ?? Math.min(...(sending.length > 0 ? sending : seen));
}

const teamOf = (name: RobotName): number => Number(name.split("/")[0]);

function robotsOf({ memory, robots, keyOf }: Told, world: Fields, homeTeam: number, now: number): Robot[] {
  const truths = new Map(listOf(world, "robots").map((robot) => [`${numberOf(robot, "team")}/${numberOf(robot, "player")}`, robot]));
  const names = [...new Set([...robots, ...truths.keys()])].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  return names.map((name) => {
    const truth = truths.get(name);
    const place = truth && pointOf(truth);
    return {
      ...beliefsOf(memory, name, now),
      name,
      key: keyOf(name),
      home: teamOf(name) === homeTeam,
      truth: place && { ...place, heading: numberOf(truth!, "heading") },
      fallen: truth?.get("fallen") === true,
    };
  });
}

/** Reads the field of /sim/state, or returns undefined. */
export function fieldOf(fields: Fields): Field | undefined {
  if (!(numberOf(fields, "length") > 0 && numberOf(fields, "width") > 0)) return undefined;
  const size = (name: string) => numberOf(fields, name) || 0;
  return {
    length: size("length"),
    width: size("width"),
    border: size("border"),
    lineWidth: size("line_width"),
    centreCircleRadius: size("centre_circle_radius"),
    goalAreaLength: size("goal_area_length"),
    goalAreaWidth: size("goal_area_width"),
    penaltyAreaLength: size("penalty_area_length"),
    penaltyAreaWidth: size("penalty_area_width"),
    penaltyMark: size("penalty_mark"),
    goalWidth: size("goal_width"),
    goalDepth: size("goal_depth"),
  };
}

export const fieldIn = ({ field }: Scene): Field => field ?? kUsualField;
