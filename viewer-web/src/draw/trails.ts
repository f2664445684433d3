// The last seconds of ball and robots, from the histories of their objects.

import { valueOf, type MemoryObject } from "../memory/memory_object";
import { isTurned } from "../memory/places";
import type { GroundTruth, Pose } from "../memory/schema";
import { Trail } from "../memory/trail";
import { fieldsOf, listOf, numberOf, type Fields } from "../memory/value";
import { kTruth } from "../memory/vocabulary";
import { pointOf } from "./beliefs";
import type { Drawing, TrailPoint } from "./draw_scene";
import type { Point } from "./field";
import type { Told } from "./scene";

const kSeconds = 6;

/** A place at a capture time. */
export interface Timed extends Point {
  log_ns: bigint;
}

interface World {
  ball: Timed | undefined;
  robots: Map<string, Timed>;
}

const timedOf = (fields: Fields<{ x?: number; y?: number }>, log_ns: bigint): Timed | undefined => {
  const place = pointOf(fields);
  return place && { ...place, log_ns };
};

const worldOf = (fields: Fields<GroundTruth>, log_ns: bigint): World => ({
  ball: timedOf(fieldsOf(fields, "ball"), log_ns),
  robots: new Map(
    listOf(fields, "robots").flatMap((robot) => {
      const place = timedOf(robot, log_ns);
      return place ? [[`${numberOf(robot, "team")}/${numberOf(robot, "player")}`, place] as const] : [];
    }),
  ),
});

/** [m/s] and [m]: more than `speed` times the time, and `slack` for noise, is no way but a leap. */
const kFastest = {
  ball: { speed: 8, slack: 0.3 }, // hard kicks of the Nao stay below
  robot: { speed: 1, slack: 0.2 }, // the Nao walks below 0.5 m/s; a fall adds its length
};

/** Marks the points that no way leads to: somebody placed the thing there, or a robot corrected its belief. */
export function withLeaps(points: Timed[], kind: keyof typeof kFastest): TrailPoint[] {
  const { speed, slack } = kFastest[kind];
  return points.map(({ x, y, log_ns }, i) => {
    const before = points[i - 1];
    const passed = before ? Number(log_ns - before.log_ns) / 1e9 : 0;
    const leaps = before && (passed < 0 || Math.hypot(x - before.x, y - before.y) > slack + speed * passed);
    return leaps ? { x, y, leaps } : { x, y };
  });
}

export class Trails {
  #worlds = new Map<MemoryObject<GroundTruth>, Trail<World, GroundTruth>>();
  #poses = new Map<MemoryObject<Pose>, Trail<Timed, Pose>>();

  /** Returns the trails of the ball, of the chosen robot, and with `everyone` of all others. */
  of(told: Told[], chosen: string, everyone: boolean): Drawing["trails"] {
    const trails: Drawing["trails"] = [];
    for (const { memory, robots, keyOf } of told) {
      const truth = memory.world(kTruth);
      const worlds = truth ? trailOf(this.#worlds, truth, worldOf).points(kSeconds) : [];
      if (worlds.length > 0)
        trails.push({
          key: "",
          kind: "ball",
          points: withLeaps(
            worlds.flatMap(({ ball }) => ball ?? []),
            "ball",
          ),
        });
      for (const robot of robots.filter((robot) => everyone || keyOf(robot) === chosen)) {
        const key = keyOf(robot);
        const places = worlds.flatMap(({ robots }) => robots.get(robot) ?? []);
        trails.push({ key, kind: "truth", points: withLeaps(places, "robot") });
        const pose = memory.of(robot, "pose");
        const sign = isTurned(valueOf(memory.of(robot, "game"))) ? -1 : 1;
        const points = pose ? trailOf(this.#poses, pose, timedOf).points(kSeconds) : [];
        const turned = points.map(({ x, y, log_ns }) => ({ x: sign * x, y: sign * y, log_ns }));
        trails.push({ key, kind: "belief", points: withLeaps(turned, "robot") });
      }
    }
    return trails;
  }
}

const kMost = 64; // [objects] with a kept trail; beyond it all are dropped

function trailOf<T, M>(
  trails: Map<MemoryObject<M>, Trail<T, M>>,
  object: MemoryObject<M>,
  read: (fields: Fields<M>, log_ns: bigint) => T | undefined,
): Trail<T, M> {
  if (!trails.has(object)) {
    if (trails.size >= kMost) trails.clear();
    trails.set(object, new Trail(object, read));
  }
  return trails.get(object)!;
}
