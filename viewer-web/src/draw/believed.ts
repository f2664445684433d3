// The robot's beliefs at the shown moment. An edit starts from them before foresight has answered.

import type { Body, Place, Situation } from "../memory/forecast";
import type { Memory } from "../memory/memory";
import { valueOf, type RobotName } from "../memory/memory_object";
import { isTurned } from "../memory/places";
import { fieldsOf } from "../memory/value";
import { beliefsOf, pointOf } from "./beliefs";

/**
 * Returns the situation in team_field. Opponents that are not distinguished are left out, because nobody could name
 * the moved one.
 */
export function believedBy(memory: Memory, robot: RobotName, now: number): Situation {
  const { pose, ball, teammates, opponents } = beliefsOf(memory, robot, now);
  // the beliefs are in `field`; the half turn is its own inverse
  const turned = isTurned(valueOf(memory.of(robot, "game")));
  const back = ({ x, y }: Place): Place => (turned ? { x: -x, y: -y } : { x, y });
  const body = (side: Body["side"], player: number, at: Place & { heading: number }, deviation: number): Body => ({
    side,
    player,
    ...back(at),
    heading: at.heading - (turned ? Math.PI : 0),
    deviation,
  });
  const shared = pointOf(fieldsOf(valueOf(memory.of(robot, "team")), "shared_ball"));
  return {
    ball: ball ? { ...back(ball), deviation: ball.deviation || 0 } : shared && { ...shared, deviation: 0 },
    bodies: [
      ...(pose ? [body("own", Number(robot.split("/")[1]), pose, pose.deviation)] : []),
      ...teammates.map((mate) => body("own", mate.player, mate, 0)),
      ...opponents.flatMap(({ player, deviation, ...at }) =>
        player ? [body("opponent", player, { ...at, heading: turned ? 0 : Math.PI }, deviation)] : [],
      ),
    ],
  };
}
