// Descriptions of the things under the pointer on the field.

import type { Point } from "./field";
import { duration } from "../present/format";
import type { Robot, Scene } from "./scene";

export interface Facts {
  title: string;
  lines: string[];
}

const kReach = 0.25; // [m] radius of a hit
const metres = (value: number): string => `${value.toFixed(2)} m`;
const place = ({ x, y }: Point): string => `x ${x.toFixed(2)}, y ${y.toFixed(2)} m`;
const degrees = (angle: number): string =>
  `${Math.round((Math.atan2(Math.sin(angle), Math.cos(angle)) * 180) / Math.PI)}°`;
const apart = (a: Point, b: Point): number => Math.hypot(a.x - b.x, a.y - b.y);
const speedOf = ({ x, y }: Point): string => `${Math.hypot(x, y).toFixed(2)} m/s`;

/**
 * Describes the nearest visible thing at `point`. Undefined if there is none. `chosen` is the key of the robot in
 * front.
 */
export function factsAt(scene: Scene, point: Point, chosen: string, reach = kReach): Facts | undefined {
  const found: { distance: number; facts: () => Facts }[] = [];
  const add = (at: Point | undefined, handicap: number, facts: () => Facts) => {
    const distance = at ? apart(at, point) + handicap : Infinity;
    if (distance < reach) found.push({ distance, facts });
  };
  add(scene.ball, 0, () => ballFacts(scene));
  for (const robot of scene.robots) {
    add(robot.truth, 0, () => robotFacts(robot));
    // other robots' beliefs are drawn behind
    const handicap = robot.key === chosen ? 0 : reach / 4;
    add(robot.pose, handicap + 0.01, () => robotFacts(robot));
    add(robot.ball, handicap, () => believedBallFacts(robot, scene));
    if (robot.key !== chosen) continue;
    for (const mate of robot.teammates)
      add(mate, 0.02, () => ({
        title: `Teammate ${mate.player}, as ${robot.key} believes`,
        lines: [`${place(mate)}, ${degrees(mate.heading)}`, `heard ${duration(mate.age)} ago`],
      }));
    for (const { age, deviation, player, ...at } of robot.opponents)
      add(at, 0.02, () => ({
        title: `Opponent${player === undefined ? "" : ` ${player}`}, as ${robot.key} believes`,
        lines: [`${place(at)}${deviation > 0 ? ` ± ${metres(deviation)}` : ""}`, `seen ${duration(age)} ago`],
      }));
    add(robot.target, 0.02, () => ({
      title: `Target of ${robot.key}’s walk`,
      lines: [`${place(robot.target!)}, ${degrees(robot.target!.heading)}`],
    }));
  }
  return found.sort((a, b) => a.distance - b.distance)[0]?.facts();
}

/** Returns the robot nearest to `point` within `reach`. */
export function robotAt(scene: Scene, point: Point, reach = kReach): Robot | undefined {
  const distance = ({ truth, pose }: Robot) =>
    Math.min(...[truth, pose].map((at) => (at ? apart(at, point) : Infinity)));
  const [nearest] = [...scene.robots].sort((a, b) => distance(a) - distance(b));
  return nearest && distance(nearest) < reach ? nearest : undefined;
}

function ballFacts({ ball }: Scene): Facts {
  return {
    title: "Ball, as it is",
    lines: [place(ball!), ...(ball!.velocity ? [`rolls ${speedOf(ball!.velocity)}`] : [])],
  };
}

function robotFacts({ key, truth, pose, fallen, role, skill }: Robot): Facts {
  const lines: string[] = [];
  if (role || skill) lines.push([role, skill.replaceAll("_", " ")].filter(Boolean).join(" · "));
  if (truth)
    lines.push(
      `is at ${place(truth)}${Number.isFinite(truth.heading) ? `, ${degrees(truth.heading)}` : ""}${fallen ? ", fallen" : ""}`,
    );
  if (pose)
    lines.push(
      `believes ${place(pose)}, ${degrees(pose.heading)} ± ${metres(pose.deviation)} · ${duration(pose.age)} old`,
    );
  if (truth && pose) {
    const turn = Number.isFinite(truth.heading) ? `, ${degrees(pose.heading - truth.heading)}` : "";
    lines.push(`wrong by ${metres(apart(truth, pose))}${turn}`);
  }
  return { title: `Robot ${key}`, lines };
}

function believedBallFacts({ key, ball }: Robot, scene: Scene): Facts {
  const lines = [
    `${place(ball!)} ± ${metres(ball!.deviation)}`,
    `rolls ${speedOf(ball!.velocity)}`,
    `seen ${duration(ball!.age)} ago`,
  ];
  if (scene.ball) lines.push(`wrong by ${metres(apart(ball!, scene.ball))}`);
  return { title: `Ball, as ${key} believes`, lines };
}
