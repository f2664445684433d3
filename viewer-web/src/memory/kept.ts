// Whether a moment has data, and the nearest one that has.

import type { Memory } from "./memory";
import { topicOfRobot, type RobotName } from "./memory_object";
import { kTruth } from "./vocabulary";

const kGap_ns = 2_000_000_000n; // places come at least ten times a second; older ones are not of this moment

/** Returns the offered topics with the places of robots and ball, without which a field is empty. */
export function placesOf(memory: Memory, robots: RobotName[]): string[] {
  const topics = [
    kTruth,
    ...robots.flatMap((robot) => (["pose", "ball", "vision"] as const).map((object) => topicOfRobot(robot, object))),
  ];
  return topics.filter((topic) => memory.get(topic));
}

/** Whether one of `topics` shows a value that was captured at most two seconds before `at_ns`. */
export const isKept = (memory: Memory, topics: string[], at_ns: bigint): boolean =>
  topics.some((topic) => {
    const shown = memory.get(topic)?.shown;
    return shown !== undefined && at_ns - shown.log_ns <= kGap_ns;
  });

/** Returns the capture time nearest to `at_ns` of the messages of `topics` that the page holds, or undefined if it holds none. */
export function nearestKept(memory: Memory, topics: string[], at_ns: bigint): bigint | undefined {
  const times = topics.flatMap((topic) => {
    const history = memory.get(topic)?.history;
    const index = history?.indexAt(at_ns) ?? 0;
    return [history?.timeOf(index), history?.timeOf(index + 1)];
  });
  return nearestOf(times, at_ns);
}

/** Returns the time nearest to `at_ns`, or undefined without one. The earlier one if two are equally near. */
export function nearestOf(times: (bigint | undefined)[], at_ns: bigint): bigint | undefined {
  const known = times.filter((time) => time !== undefined);
  return known.sort((a, b) => Number(apart(a, at_ns) - apart(b, at_ns)) || Number(a - b))[0];
}

/** Returns the time between two moments [ns]. */
export const apart = (a: bigint, b: bigint): bigint => (a > b ? a - b : b - a);
