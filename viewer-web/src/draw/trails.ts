// The last seconds of ball and robots, from the histories of their objects.

import type { MemoryObject } from "../memory/memory_object";
import { Trail } from "../memory/trail";
import { fieldsOf, listOf, numberOf, type Fields } from "../memory/value";
import { pointOf, valueOf } from "./beliefs";
import type { Drawing } from "./draw_scene";
import type { Point } from "./field";
import { kTruth, type Told } from "./scene";

const kSeconds = 6;

interface World {
  ball: Point | undefined;
  robots: Map<string, Point>;
}

const worldOf = (fields: Fields): World => ({
  ball: pointOf(fieldsOf(fields, "ball")),
  robots: new Map(
    listOf(fields, "robots").flatMap((robot) => {
      const place = pointOf(robot);
      return place ? [[`${numberOf(robot, "team")}/${numberOf(robot, "player")}`, place] as const] : [];
    }),
  ),
});

export class Trails {
  #worlds = new Map<MemoryObject, Trail<World>>();
  #poses = new Map<MemoryObject, Trail<Point>>();

  /** Returns the trails of the ball, of the chosen robot, and with `everyone` of all others. */
  of(told: Told[], chosen: string, everyone: boolean): Drawing["trails"] {
    const trails: Drawing["trails"] = [];
    for (const { memory, robots, keyOf } of told) {
      const truth = memory.get(kTruth);
      const worlds = truth ? trailOf(this.#worlds, truth, worldOf).points(kSeconds) : [];
      if (worlds.length > 0) trails.push({ key: "", kind: "ball", points: worlds.flatMap(({ ball }) => ball ?? []) });
      for (const robot of robots.filter((robot) => everyone || keyOf(robot) === chosen)) {
        const key = keyOf(robot);
        trails.push({ key, kind: "truth", points: worlds.flatMap(({ robots }) => robots.get(robot) ?? []) });
        const pose = memory.get(`/${robot}/pose`);
        const sign = valueOf(memory.get(`/${robot}/game`)).get("attacks_positive_x") === false ? -1 : 1;
        const points = pose ? trailOf(this.#poses, pose, pointOf).points(kSeconds) : [];
        trails.push({ key, kind: "belief", points: points.map(({ x, y }) => ({ x: sign * x, y: sign * y })) });
      }
    }
    return trails;
  }
}

const kMost = 64; // [objects] with a kept trail; beyond it all are dropped

function trailOf<T>(
  trails: Map<MemoryObject, Trail<T>>,
  object: MemoryObject,
  read: (fields: Fields) => T | undefined,
): Trail<T> {
  if (!trails.has(object)) {
    if (trails.size >= kMost) trails.clear();
    trails.set(object, new Trail(object, (fields) => read(fields)));
  }
  return trails.get(object)!;
}
