import { expect, test } from "vitest";
import { Memory } from "./memory";
import { objectOf, robotOf } from "./memory_object";
import { Played } from "./played";
import { kPerceptChannel, percept } from "./test_schema";

const channel = (topic: string, metadata: Record<string, string> = {}) => ({ ...kPerceptChannel, topic, metadata });
const kTopic = kPerceptChannel.topic;

test("the robot is in the metadata, else in the first two parts of the topic", () => {
  const cases: [string, Record<string, string>, string, string][] = [
    ["/14/2/ball", {}, "14/2", "ball"],
    ["/14/2/camera_top/jpeg", { robot: "14/2", object: "camera_top" }, "14/2", "camera_top/jpeg"],
    ["/odd", { robot: "14/2" }, "14/2", "odd"],
    ["/truth/world", {}, "", "truth/world"],
    ["/truth/world", { robot: "truth" }, "", "truth/world"],
    ["/lab/1/runtime", { object: "lab/1/runtime" }, "", "lab/1/runtime"],
    ["plain", {}, "", "plain"],
  ];
  for (const [topic, metadata, robot, object] of cases) {
    expect(robotOf({ topic, metadata }), topic).toBe(robot);
    expect(objectOf({ topic, metadata }), topic).toBe(object);
  }
});

test("robots are sorted by team and player, and share the objects without a robot", () => {
  const memory = new Memory();
  for (const topic of ["/14/10/ball", "/truth/world", "/lab/1/log", "/14/2/pose", "/14/2/ball", "/3/1/ball"])
    memory.offer(channel(topic));
  expect(memory.robots()).toEqual(["3/1", "14/2", "14/10"]);
  expect(memory.robots("14/10")).toEqual(["14/2", "14/10", "3/1"]);
  expect(memory.objectsOf("14/2").map(({ name }) => name)).toEqual(["ball", "pose", "lab/1/log", "truth/world"]);
});

test("sentences of a robot and of its server are listed together, without those of other robots", () => {
  const memory = new Memory();
  for (const topic of ["/14/2/log", "/lab/1/log", "/14/3/log", "/14/2/log/foxglove"]) {
    memory.offer(channel(topic, topic.endsWith("foxglove") ? { derived: "true" } : {}));
    memory.arrived(topic, 1n, percept(), 0);
  }
  expect(memory.log.entries("14/2", "debug")).toHaveLength(2);
});

test("the newest message counts and is decoded on demand, and a bad one gives a sentence until a good one arrives", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  const object = memory.get(kTopic)!;
  expect(object.decoded()).toBeUndefined();
  memory.arrived(kTopic, 1n, percept({ x: 1 }), 0);
  memory.arrived(kTopic, 2n, percept({ x: 2 }), 0.1);
  expect(object.decoded()!.fields!.get("x")).toBe(2);
  memory.arrived(kTopic, 3n, Uint8Array.of(0xff), 0.2);
  expect(object.decoded()!.error).toMatch("does not fit");
  memory.arrived(kTopic, 4n, percept({ x: 4 }), 0.3);
  expect(object.decoded()!.fields!.get("x")).toBe(4);
  expect(object.received).toBe(4);
});

test("an object that is offered again keeps value and count, but not with another schema or after a reset", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  memory.arrived(kTopic, 1n, percept({ x: 1 }), 0);
  memory.offer({ ...kPerceptChannel, id: 77 });
  expect(memory.get(kTopic)!.received).toBe(1);
  memory.offer({ ...kPerceptChannel, schemaName: "htwk.Point" });
  expect(memory.get(kTopic)!.received).toBe(0);
  memory.reset();
  expect(memory.get(kTopic)).toBeUndefined();
});

test("an object that came evenly and stopped is overdue, unlike events and unsubscribed objects", () => {
  const overdue = (metadata: Record<string, string>, subscribed: boolean) => {
    const memory = new Memory();
    memory.offer(channel(kTopic, metadata));
    memory.subscribed(kTopic, true);
    for (let i = 0; i <= 10; ++i) memory.arrived(kTopic, 0n, percept(), i);
    if (!subscribed) memory.subscribed(kTopic, false);
    return [14, 16].map((now) => memory.get(kTopic)!.overdue(now));
  };
  expect(overdue({ delivery: "latest" }, true)).toEqual([undefined, 6]);
  expect(overdue({ delivery: "reliable" }, true)).toEqual([undefined, undefined]);
  expect(overdue({}, false)).toEqual([undefined, undefined]);
});

test("all objects show the same past moment, while new messages arrive and are kept", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  const object = memory.get(kTopic)!;
  const second = (count: number) => BigInt(count) * 1_000_000_000n;
  for (let i = 1; i <= 5; ++i) memory.arrived(kTopic, second(i), percept({ x: i }), i);
  const shown = () => object.decoded()?.fields!.get("x");
  memory.show(second(3) + 5n);
  expect(shown()).toBe(3);
  expect(memory.age(object, 99)).toBeCloseTo(5e-9);
  memory.arrived(kTopic, second(6), percept({ x: 6 }), 6);
  expect(shown()).toBe(3);
  memory.show(second(0));
  expect([shown(), object.shown]).toEqual([undefined, undefined]);
  memory.show(undefined);
  expect(shown()).toBe(6);
  expect(memory.range()).toEqual({ first_ns: second(1), last_ns: second(6) });
});

test("a retained value does not stretch the time of a live server, and is shown with its age", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  const game = "/14/2/game";
  memory.offer({ ...kPerceptChannel, id: 77, topic: game });
  const start_ns = 1_700_000_000_000_000_000n;
  const second = (count: number) => start_ns + BigInt(count) * 1_000_000_000n;
  memory.arrived(game, second(-123), percept({ x: 1 }), 50);
  for (let i = 0; i <= 4; ++i) memory.arrived(kTopic, second(i), percept({ x: i }), 50 + i);
  expect(memory.range()).toEqual({ first_ns: second(0), last_ns: second(4) });
  memory.arrived(game, second(5), percept({ x: 2 }), 55);
  expect(memory.range()).toEqual({ first_ns: second(0), last_ns: second(5) });
  memory.show(second(0));
  expect(memory.get(game)!.decoded()!.fields!.get("x")).toBe(1);
  expect(memory.age(memory.get(game)!, 99)).toBe(123);
});

test("a recording that restarts does not remove the past that is being looked at", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  const object = memory.get(kTopic)!;
  const play = () =>
    [10, 11, 12].forEach((second) =>
      memory.arrived(kTopic, BigInt(second) * 1_000_000_000n, percept({ x: second }), second),
    );
  play();
  memory.show(11_000_000_000n);
  memory.restart();
  memory.arrived(kTopic, 10_000_000_000n, percept({ x: 10 }), 13);
  expect(object.decoded()!.fields!.get("x")).toBe(11);
  memory.show(undefined);
  expect(object.decoded()!.fields!.get("x")).toBe(10);
  expect(object.history.end - object.history.begin).toBe(0);
});

test("the part of a recording that was seen without a gap is known, and kept after a seek into it", () => {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  const object = memory.get(kTopic)!;
  const played = (memory.played = new Played(0n, 1000n));
  const go = (at_ns: bigint) => {
    played.told({ status: "paused", time_ns: at_ns, speed: 1 }, 0);
    memory.reached(0);
  };
  expect(memory.range()).toEqual({ first_ns: 0n, last_ns: 1000n });
  go(100n);
  memory.subscribed(kTopic, true, 0);
  memory.sought(100n);
  for (const [log_ns, x] of [
    [95n, 1],
    [120n, 2],
    [140n, 3],
  ] as const)
    memory.arrived(kTopic, log_ns, percept({ x }), 0);
  go(150n);
  expect(memory.seen()).toEqual({ from_ns: 100n, to_ns: 150n });
  expect([99n, 100n, 150n, 151n].map((at_ns) => memory.holds(at_ns))).toEqual([false, true, true, false]);

  // inside: the seen part stays, and repeated messages are not stored twice
  memory.sought(125n);
  go(125n);
  memory.arrived(kTopic, 120n, percept({ x: 2 }), 0);
  expect(object.decoded()!.fields!.get("x")).toBe(2);
  expect([object.history.end - object.history.begin, memory.holds(150n)]).toEqual([3, true]);
  // outside: another part begins
  memory.sought(500n);
  go(500n);
  expect(memory.seen()).toEqual({ from_ns: 500n, to_ns: 500n });
});

test("after a seek, objects without a value at that time are cleared, and the others replaced", () => {
  const memory = new Memory();
  for (const topic of ["/14/2/a", "/14/2/b"]) {
    memory.offer(channel(topic));
    memory.arrived(topic, 50n, percept({ x: 5 }), 0);
  }
  memory.played = new Played(0n, 100n);
  memory.sought(20n);
  expect(memory.get("/14/2/a")!.decoded()).toBeDefined();
  memory.arrived("/14/2/a", 10n, percept({ x: 1 }), 0);
  memory.dropOutdated();
  expect(memory.get("/14/2/a")!.decoded()!.fields!.get("x")).toBe(1);
  expect(memory.get("/14/2/b")!.decoded()).toBeUndefined();

  // a slow server: the value comes late
  memory.arrived("/14/2/b", 15n, percept({ x: 7 }), 1);
  expect(memory.get("/14/2/b")!.decoded()!.fields!.get("x")).toBe(7);
});

test("an object without a value at the time of a seek keeps its history of the part that the page has seen", () => {
  const memory = new Memory();
  memory.offer(channel(kTopic));
  const played = (memory.played = new Played(0n, 1000n));
  memory.sought(100n);
  memory.subscribed(kTopic, true, 0);
  memory.arrived(kTopic, 120n, percept({ x: 2 }), 0);
  played.told({ status: "paused", time_ns: 150n, speed: 1 }, 0);
  memory.reached(0);
  memory.sought(110n);
  memory.dropOutdated();
  expect(memory.get(kTopic)!.decoded()).toBeUndefined();
  memory.show(130n);
  expect(memory.get(kTopic)!.decoded()!.fields!.get("x")).toBe(2);
});

test("what a server remembers comes before what the page has, in the range, the log and the age", () => {
  const memory = new Memory();
  memory.offer(channel("/14/2/ball"));
  memory.offer(channel("/14/2/log"));
  const second = (at: number) => BigInt(at) * 1_000_000_000n;
  for (const topic of ["/14/2/ball", "/14/2/log"])
    for (let at = 400; at < 410; ++at) memory.arrived(topic, second(at), percept(), at + 7);
  for (const topic of ["/14/2/ball", "/14/2/log", "/unknown"])
    memory.recall(
      topic,
      Array.from({ length: 304 }, (_, i) => ({ log_ns: second(100 + i), data: percept() })),
      500,
    );
  expect(memory.range()).toEqual({ first_ns: second(100), last_ns: second(409) });
  const { history, newest } = memory.get("/14/2/ball")!;
  expect(history.end - history.begin).toBe(310);
  expect(newest!.log_ns).toBe(second(409));
  expect(history.at(second(150))!.arrived).toBe(157);
  expect(memory.log.all("debug")).toHaveLength(310);
  memory.show(second(200));
  expect(memory.get("/14/2/ball")!.shown!.log_ns).toBe(second(200));
});

test("a moment that is shown is found among recalled messages too", () => {
  const memory = new Memory();
  memory.offer(channel(kTopic));
  memory.arrived(kTopic, 400n, percept(), 1);
  memory.show(300n);
  expect(memory.get(kTopic)!.shown).toBeUndefined();
  memory.recall(kTopic, [{ log_ns: 250n, data: percept() }], 2);
  expect(memory.get(kTopic)!.shown!.log_ns).toBe(250n);
});
