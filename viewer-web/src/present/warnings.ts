// Sentences about problems in the data flow.

import { duration, hertz } from "./format";
import type { Memory } from "../memory/memory";
import { valueOf, type MemoryObject } from "../memory/memory_object";
import { fieldsOf, listOf, numberOf } from "../memory/value";
import type { StreamStatistics } from "../memory/statistics";

const kLate = 1; // [s] an older image is misleading

/** Returns the sentence about this object's problem, or undefined. */
export function warningOf(
  object: MemoryObject,
  statistics: StreamStatistics | undefined,
  memory: Memory,
  now: number,
): string | undefined {
  const overdue = object.overdue(now);
  if (overdue !== undefined && !isPenalised(object, memory))
    return `${object.name} has been silent for ${duration(overdue)}; before, it came at ${hertz(1 / object.rate.interval()!)} Hz.`;

  const lost = statistics?.dropped;
  if (lost && lost.recording > 0)
    return `The recording lost ${messages(lost.recording)} of ${object.name}: the disk is too slow or full.`;
  if (lost && lost.inside > 0) return `The robot's own consumers missed ${messages(lost.inside)} of ${object.name}.`;

  // a single old value is simply the newest; a stream of old values is a slow network
  const age = memory.age(object, now);
  const late = age !== undefined && object.newest ? age - (now - object.newest.arrived) : 0;
  if (late > kLate && object.rate.hz(now) > 1)
    return `${object.name} arrives ${duration(late)} late: the network or this computer is too slow.`;
  return undefined;
}

/** A penalised robot stands aside: its objects may pause. */
function isPenalised({ robot }: MemoryObject, memory: Memory): boolean {
  const game = valueOf(memory.of(robot, "game"));
  const [player] = listOf(fieldsOf(game, "own"), "players").slice(numberOf(game, "own_player") - 1);
  return player?.get("penalised") === true;
}

const messages = (count: number): string => (count === 1 ? "1 message" : `${count} messages`);
