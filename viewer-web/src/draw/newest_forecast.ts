// The rollouts for the Field view: those of the newest forecast of any robot, in the frame `field`.

import { chosenOf, forecastOf, type Path, type Place } from "../memory/forecast";
import { topicOfRobot, valueOf, type MemoryObject } from "../memory/memory_object";
import { isTurned } from "../memory/places";
import type { Forecast, GameState } from "../memory/schema";
import type { Foreseen } from "./draw_scene";
import { kLiveries } from "./robot_sign";
import type { Robot, Told } from "./scene";

const read = new WeakMap<Uint8Array, Path[]>(); // each message is read once

/** Returns the offered topics that are read. */
export const forecastTopicsOf = ({ memory, robots }: Pick<Told, "memory" | "robots">): string[] =>
  robots.map((robot) => topicOfRobot(robot, "forecast")).filter((topic) => memory.get(topic));

/** Returns the chosen robot's forecast if there is one, else the newest of another. `robots` have the liveries. */
export function foreseenBy(told: Told[], robots: Robot[], chosen: string): Foreseen | undefined {
  const all = told.flatMap(({ memory, robots, keyOf }) =>
    robots.flatMap((robot) => {
      const object = memory.of(robot, "forecast");
      return object?.shown
        ? [{ object, key: keyOf(robot), game: memory.of(robot, "game"), at_ns: object.shown.log_ns }]
        : [];
    }),
  );
  const newest = all.find(({ key }) => key === chosen) ?? all.sort((a, b) => Number(b.at_ns - a.at_ns))[0];
  if (!newest) return undefined;
  return {
    paths: pathsOf(newest.object, newest.game),
    colour: (robots.find(({ key }) => key === newest.key)?.livery ?? kLiveries.home).colour,
  };
}

function pathsOf(object: MemoryObject<Forecast>, game: MemoryObject<GameState> | undefined): Path[] {
  const { data, log_ns } = object.shown!;
  const known = read.get(data);
  if (known) return known;
  const fields = object.decoded()?.fields;
  const paths = (fields && chosenOf(forecastOf(fields), "")?.paths) ?? [];
  const turned = wasTurned(game, log_ns);
  const inField = (points: Place[]) => (turned ? points.map(({ x, y }) => ({ x: -x, y: -y })) : points);
  const placed = paths.map(({ spacing, ball, robots }) => ({
    spacing,
    ball: inField(ball),
    robots: robots.map(({ player, points }) => ({ player, points: inField(points) })),
  }));
  read.set(data, placed);
  return placed;
}

/** Returns the side at the start of the rollouts, so that a forecast from before half-time stays at its place. */
function wasTurned(game: MemoryObject<GameState> | undefined, at_ns: bigint): boolean {
  const then = game?.history.at(at_ns);
  return isTurned(then ? game?.decode(then.data).fields : valueOf(game));
}
