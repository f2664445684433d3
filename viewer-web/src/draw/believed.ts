// The moment as a robot believes it to be, told by itself, to begin an edit with before foresight has answered anything.

import type { Body, Place, Situation } from "../memory/forecast";
import type { Memory } from "../memory/memory";
import type { RobotName } from "../memory/memory_object";
import { fieldsOf } from "../memory/value";
import { beliefsOf, pointOf, valueOf } from "./beliefs";

/** In team_field. Opponents that are not told apart are left out: nobody could say which of them was moved. */
export function believedBy(memory: Memory, robot: RobotName, now: number): Situation {
  const { pose, ball, teammates, opponents } = beliefsOf(memory, robot, now);
  // beliefs are told in `field`; the half turn back is the same as the one there
  const turned = valueOf(memory.get(`/${robot}/game`)).get("attacks_positive_x") === false;
  const back = ({ x, y }: Place): Place => (turned ? { x: -x, y: -y } : { x, y });
  const body = (side: Body["side"], player: number, at: Place & { heading: number }, deviation: number): Body => ({ side, player, ...back(at), heading: at.heading - (turned ? Math.PI : 0), deviation });
  const shared = pointOf(fieldsOf(valueOf(memory.get(`/${robot}/team`)), "shared_ball"));
  return {
    ball: ball ? { ...back(ball), deviation: ball.deviation || 0 } : shared && { ...shared, deviation: 0 },
    bodies: [
      ...(pose ? [body("own", Number(robot.split("/")[1]), pose, pose.deviation)] : []),
      ...teammates.map((mate) => body("own", mate.player, mate, 0)),
      ...opponents.flatMap(({ player, deviation, ...at }) => (player ? [body("opponent", player, { ...at, heading: turned ? 0 : Math.PI }, deviation)] : [])),
    ],
  };
}
