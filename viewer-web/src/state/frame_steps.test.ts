import { beforeEach, expect, test } from "vitest";
import { Memory } from "../memory/memory";
import type { MemoryObject } from "../memory/memory_object";
import { kPerceptChannel, percept } from "../memory/test_schema";
import { beatOf, FrameSteps } from "./frame_steps";

const kFrames = [10n, 20n, 30n, 40n, 50n];

let memory: Memory;
let object: MemoryObject;
let at_ns: bigint;
let finds: boolean;
let waits: boolean;
let sentences: string[];
let searches: { from_ns: bigint; by: number; resolve(at_ns: bigint): void; reject(error: Error): void }[];
let steps: FrameSteps;

const offered = (topic: string, times: bigint[]): MemoryObject => {
  memory.offer({ ...kPerceptChannel, topic, metadata: {} });
  for (const time of times) memory.arrived(topic, time, percept(), 0);
  return memory.get(topic)!;
};
const settled = () => new Promise((resolve) => setTimeout(resolve));

beforeEach(() => {
  memory = new Memory();
  object = offered("/14/2/pose", kFrames);
  [at_ns, finds, waits, sentences, searches] = [30n, false, false, [], []];
  steps = new FrameSteps({
    get waits() {
      return waits;
    },
    get finds() {
      return finds;
    },
    beat: () => object,
    find: (_, from_ns, by) => new Promise((resolve, reject) => searches.push({ from_ns, by, resolve, reject })),
    holds: (moment) => moment < 50n,
    at_ns: () => at_ns,
    go: (moment) => (at_ns = moment),
    warn: (sentence) => sentences.push(sentence),
  });
});

test("a step goes to the next or previous message that the page holds", () => {
  steps.add(1);
  expect(at_ns).toBe(40n);
  steps.add(-1);
  expect(at_ns).toBe(30n);
  at_ns = 35n;
  steps.add(-1);
  expect(at_ns).toBe(30n);
  at_ns = 35n;
  steps.add(1);
  expect([at_ns, steps.underWay]).toEqual([40n, false]);
});

test("a step to a message that the page does not hold is not made", () => {
  at_ns = 40n;
  steps.add(1);
  expect([at_ns, steps.underWay]).toEqual([40n, false]);
});

test("steps wait until the place is known, and are made together", () => {
  waits = true;
  steps.add(-1);
  steps.add(-1);
  expect([at_ns, steps.underWay]).toEqual([30n, true]);
  waits = false;
  steps.make();
  expect(at_ns).toBe(10n);
});

test("a server is asked for the frame; steps that are added meanwhile come next", async () => {
  finds = true;
  steps.add(1);
  steps.add(1);
  steps.add(1);
  expect(searches).toMatchObject([{ from_ns: 30n, by: 1 }]);
  searches[0]!.resolve(31n);
  await settled();
  expect([at_ns, steps.underWay]).toEqual([31n, true]);
  steps.make();
  expect(searches[1]).toMatchObject({ from_ns: 31n, by: 2 });
  searches[1]!.resolve(33n);
  await settled();
  expect([at_ns, steps.underWay]).toEqual([33n, false]);
});

test("the answer of a search that has ended is ignored", async () => {
  finds = true;
  steps.add(1);
  steps.end();
  searches[0]!.resolve(31n);
  await settled();
  expect(at_ns).toBe(30n);
});

test("a refused search steps among the messages of the page, or says why it cannot", async () => {
  finds = true;
  steps.add(1);
  searches[0]!.reject(new Error("needs the token"));
  await settled();
  expect([at_ns, sentences]).toEqual([40n, []]);
  steps.add(1);
  searches[1]!.reject(new Error("needs the token"));
  await settled();
  expect([at_ns, sentences]).toEqual([40n, ["needs the token"]]);
});

test("many steps are asked for a hundred at a time", () => {
  finds = waits = true;
  for (let i = 0; i < 150; ++i) steps.add(-1);
  waits = false;
  steps.make();
  expect(searches[0]!.by).toBe(-100);
});

test("frames are those of the picture, else of the world, the decision or a belief, else of the fullest object", () => {
  const names = (): string | undefined => beatOf([...memory.objects()])?.name;
  memory = new Memory();
  expect(names()).toBeUndefined();
  offered("/14/2/rare", [1n]);
  offered("/14/2/often", [1n, 2n, 3n]);
  offered("/14/2/silent", []);
  expect(names()).toBe("often");
  offered("/14/2/joints", [1n]);
  expect(names()).toBe("joints");
  offered("/14/2/decision", [1n]);
  expect(names()).toBe("decision");
  offered("/truth/world", [1n]);
  expect(names()).toBe("truth/world");
  memory.offer({ ...kPerceptChannel, topic: "/14/2/camera_top", schemaName: "foresight.Image", metadata: {} });
  expect(names()).toBe("truth/world"); // no picture has arrived
  memory.arrived("/14/2/camera_top", 1n, percept(), 0);
  expect(names()).toBe("camera_top");
});
