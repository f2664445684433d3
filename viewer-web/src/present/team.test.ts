import { expect, test } from "vitest";
import type { Memory } from "../memory/memory";
import { memoryWith } from "../memory/test_memory";
import { EnumValue, type Fields, type Value } from "../memory/value";
import { lossOf, tileOf } from "./team";

const fields = (entries: Record<string, Value>): Fields => new Map(Object.entries(entries));
const kNow_ns = 100_000_000_000n;
const before = (seconds: number) => kNow_ns - BigInt(Math.round(seconds * 1e9));

/** A memory of robot 14/2 with these values, each `age` [s] old. */
function memoryOf(values: Record<string, Record<string, Value>>, age = 0): Memory {
  const get = (topic: string) => {
    const value = values[topic.replace("/14/2/", "")];
    return value && { shown: { log_ns: before(age) }, decoded: () => ({ fields: fields(value) }) };
  };
  const ageOf = (at_ns: bigint) => Number(kNow_ns - at_ns) / 1e9;
  return memoryWith({ get, ageOf, age: ({ shown }: { shown: { log_ns: bigint } }) => ageOf(shown.log_ns) });
}
const game = (player: Record<string, Value> = {}) => ({
  state: new EnumValue(5, "STATE_PLAYING"),
  own_player: 2,
  own: fields({ players: [fields({ penalised: true }), fields(player)] }),
});
const fall = (name: string) => ({ fall: new EnumValue(1, `FALL_${name}`) });
const stateOf = (memory: Memory, still = false) => tileOf(memory, "14/2", 0, still).state;

test("a tile says whether the robot plays, is penalised, has fallen or is gone: the worst first", () => {
  expect(stateOf(memoryOf({}))).toBe("no data");
  expect(stateOf(memoryOf({ game: game() }))).toBe("playing");
  expect(stateOf(memoryOf({ game: game({ penalised: true, seconds_till_unpenalised: 29.2 }) }))).toBe("penalised 30 s");
  const down = { game: game({ penalised: true }), motion_status: fall("FALLEN") };
  expect(tileOf(memoryOf(down), "14/2", 0, false)).toMatchObject({ state: "fallen", mood: "wrong" });
  expect(stateOf(memoryOf({ ...down, motion_status: fall("GETTING_UP") }))).toBe("getting up");
  expect(stateOf(memoryOf(down, 12.7))).toBe("gone 12 s");
  expect(stateOf(memoryOf(down, 300))).toBe("gone 5 min");
  expect(stateOf(memoryOf(down, 12.7), true)).toBe("fallen"); // a pause is no silence
  expect(stateOf(memoryOf({ game: game(), motion_status: fall("UPRIGHT") }, 2.9))).toBe("playing");
});

test("a robot that lies in the truth has fallen, whatever it believes", () => {
  const world = (robots: Fields[]) => memoryOf({ game: game(), "/truth/world": { robots } });
  expect(stateOf(world([fields({ team: 14, player: 2, fallen: true })]))).toBe("fallen");
  expect(stateOf(world([fields({ team: 14, player: 3, fallen: true })]))).toBe("playing");
});

test("skill, ball, battery and the hottest joint are told if they are known", () => {
  const tile = tileOf(
    memoryOf({
      game: game(),
      decision: { skill: "walk_to_ball", role: "chaser" },
      ball: { seen_ns: before(0.42) },
      battery: { charge: 0.19 },
      joints: { temperature: [38, 71.4, NaN] },
    }),
    "14/2",
    0,
    false,
  );
  expect(tile).toMatchObject({ skill: "walk to ball", role: "chaser", ball: "ball 0.4 s", battery: "19 %" });
  expect(tile).toMatchObject({ isEmpty: true, heat: "71 °C", isHot: true });
  expect(tileOf(memoryOf({ ball: { seen_ns: before(42.5) } }), "14/2", 0, false).ball).toBe("ball 42 s");
  const bare = tileOf(memoryOf({ game: game(), ball: { seen_ns: 0n }, joints: { temperature: [] } }), "14/2", 0, false);
  expect(bare).toMatchObject({ skill: "", ball: "", battery: "", heat: "", isHot: false, isEmpty: false });
});

test("a loss counts the robot's own streams and its link; what viewers passed over is none", () => {
  const stream = (inside: number, recording: number, viewers: number) => ({
    rate_hz: 1,
    sequence: 1,
    dropped: { inside, recording, viewers },
  });
  const link = {
    name: "",
    robot: "14/2",
    state: "",
    received: 0,
    lost: 5,
    connections: 1,
    clock_offset: 0,
    shift: 0,
    message: "",
  };
  const streams = new Map([
    ["/14/2/ball", stream(1, 2, 99)],
    ["/14/20/ball", stream(50, 0, 0)],
  ]);
  expect(lossOf("14/2", streams, [])).toBe("lost 3");
  expect(lossOf("14/2", streams, [link])).toBe("lost 8");
  expect(lossOf("14/3", streams, [link])).toBe("");
});
