// For tests: a memory whose objects are plain values.

import type { Memory } from "./memory";
import { topicOfRobot } from "./memory_object";
import type { RobotObject } from "./schema";

/** Returns a memory with these parts; `get` finds its objects by topic. */
export const memoryWith = (parts: { get: (topic: string) => unknown; age?: unknown; ageOf?: unknown }): Memory =>
  ({
    of: (robot: string, name: RobotObject) => parts.get(topicOfRobot(robot, name)),
    world: parts.get,
    ...parts,
  }) as unknown as Memory;
