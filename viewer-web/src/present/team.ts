// One robot's state at a glance, for the bar of all robots.

import type { Memory } from "../memory/memory";
import { valueOf, type RobotName } from "../memory/memory_object";
import type { Ball, GameState, RobotObject } from "../memory/schema";
import type { LinkStatistics, StreamStatistics } from "../memory/statistics";
import { fieldsOf, listOf, numberOf, textOf, wordOf, type Fields } from "../memory/value";
import { kTruth } from "../memory/vocabulary";
import { count, duration, words } from "./format";

/** `wrong`: a person should look; `aside`: it does not play, and that is right. */
export type Mood = "well" | "aside" | "wrong";

export interface Tile {
  /** Such as "playing", "fallen", "penalised", "gone 12 s". */
  state: string;
  mood: Mood;
  /** The skill of its decision, or ""; with the role if it says one. */
  skill: string;
  role: string;
  /** Such as "ball 0.4 s"; "" if it never reported one. */
  ball: string;
  /** Such as "83 %", and whether that is little. */
  battery: string;
  isEmpty: boolean;
  /** The hottest joint, such as "61 °C", and whether that is much. */
  heat: string;
  isHot: boolean;
  /** Such as "lost 12"; "" without a loss. Messages that a newer one replaced for a viewer are no loss. */
  loss: string;
}

export const kTileObjects: readonly RobotObject[] = ["game", "motion_status", "decision", "ball", "battery"];

const kAlsoOften: readonly RobotObject[] = ["pose", "joints", "clock"];
const kGone = 3; // [s] the slowest objects of a playing robot come twice a second
const kLittle = 0.2; // of the charge
const kHot = 70; // [°C] the Nao's firmware reduces a motor's torque a little above (Aldebaran's documentation)

/** `still`: nothing is due, because the game or the recording is paused. */
export function tileOf(memory: Memory, robot: RobotName, now: number, still: boolean): Tile {
  const read = <Name extends RobotObject>(name: Name) => valueOf(memory.of(robot, name));
  const game = read("game");
  const decision = read("decision");
  const charge = numberOf(read("battery"), "charge");
  const temperatures = (read("joints").get("temperature") as number[] | undefined) ?? [];
  const hottest = Math.max(...temperatures.filter((value) => Number.isFinite(value)), -Infinity);
  return {
    ...stateOf(memory, robot, now, still, game, wordOf(read("motion_status"), "fall")),
    skill: words(textOf(decision, "skill")),
    role: textOf(decision, "role"),
    ball: ballWords(memory, read("ball"), now),
    battery: Number.isFinite(charge) ? `${Math.round(100 * charge)} %` : "",
    isEmpty: charge < kLittle,
    heat: hottest > 0 ? `${Math.round(hottest)} °C` : "",
    isHot: hottest >= kHot,
    loss: "",
  };
}

function stateOf(
  memory: Memory,
  robot: RobotName,
  now: number,
  still: boolean,
  game: Fields<GameState>,
  fall: string,
): Pick<Tile, "state" | "mood"> {
  const silence = silenceOf(memory, robot, now);
  if (silence === undefined) return { state: "no data", mood: "aside" };
  if (silence > kGone && !still)
    return {
      state: `gone ${silence < 120 ? `${Math.floor(silence)} s` : `${Math.floor(silence / 60)} min`}`,
      mood: "wrong",
    };
  if (fall === "fallen" || fall === "falling" || liesInTruth(memory, robot)) return { state: "fallen", mood: "wrong" };
  if (fall === "getting_up") return { state: "getting up", mood: "wrong" };
  const [player] = listOf(fieldsOf(game, "own"), "players").slice(Math.max(0, numberOf(game, "own_player") - 1));
  if (player?.get("penalised") === true) {
    const left = Math.ceil(numberOf(player, "seconds_till_unpenalised"));
    return { state: left > 0 ? `penalised ${left} s` : "penalised", mood: "aside" };
  }
  return { state: words(wordOf(game, "state")) || "here", mood: "well" };
}

/** [s] since the newest shown value of the robot. Undefined without any. */
function silenceOf(memory: Memory, robot: RobotName, now: number): number | undefined {
  const ages = [...kTileObjects, ...kAlsoOften].flatMap((name) => {
    const object = memory.of(robot, name);
    return object ? (memory.age(object, now) ?? []) : [];
  });
  return ages.length > 0 ? Math.min(...ages) : undefined;
}

function liesInTruth(memory: Memory, robot: RobotName): boolean {
  return listOf(valueOf(memory.world(kTruth)), "robots").some(
    (one) => `${numberOf(one, "team")}/${numberOf(one, "player")}` === robot && one.get("fallen") === true,
  );
}

function ballWords(memory: Memory, ball: Fields<Ball>, now: number): string {
  const seen = ball.get("seen_ns");
  const age = typeof seen === "bigint" && seen > 0n ? memory.ageOf(seen, now) : undefined;
  if (age === undefined) return "";
  return `ball ${age < 10 ? `${age.toFixed(1)} s` : duration(Math.floor(age)).replace(".0", "")}`;
}

/** The messages of a robot that were lost within it, in its recording, or on the way to a relay. */
export function lossOf(robot: RobotName, streams: Map<string, StreamStatistics>, links: LinkStatistics[]): string {
  const inside = [...streams]
    .filter(([topic]) => topic.startsWith(`/${robot}/`))
    .reduce((sum, [, { dropped }]) => sum + dropped.inside + dropped.recording, 0);
  const lost = inside + (links.find((link) => link.robot === robot)?.lost || 0);
  return lost > 0 ? `lost ${count(lost)}` : "";
}
