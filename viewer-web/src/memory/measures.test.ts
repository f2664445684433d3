import { expect, test } from "vitest";
import { measureOf, measuresOf, topicsOfMeasure } from "./measures";
import { Memory } from "./memory";
import { kPerceptChannel, percept } from "./test_schema";

function memory() {
  const memory = new Memory();
  memory.offer(kPerceptChannel);
  memory.offer({ ...kPerceptChannel, topic: "/truth/world" });
  for (let i = 0; i < 10; ++i)
    memory.arrived("/14/2/percept", BigInt(i) * 100_000_000n, percept({ x: i, weights: [i, 2 * i] }), i / 10);
  return memory;
}

test("a path becomes a series that knows its message and field", () => {
  const measure = measureOf(memory(), "/14/2/percept.x");
  if ("why" in measure) throw new Error(measure.why);
  measure.series.update(100);
  expect([...measure.series.values.subarray(0, measure.series.length)]).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
  expect(measure.field).toEqual({ message: "htwk.Percept", name: "x" });
});

test("a path that cannot be plotted gives a sentence", () => {
  for (const text of ["", "/14/2/nothing.x", "/14/2/percept", "/14/2/percept~truth", "~truth"])
    expect(measureOf(memory(), text), text).toEqual({ why: expect.any(String) });
});

test("everything that can be plotted is offered, and the topics it needs are listed", () => {
  expect(measuresOf(memory(), "14/2")).toEqual(expect.arrayContaining(["/14/2/percept.x", "/14/2/percept.weights[1]"]));
  expect(topicsOfMeasure(memory(), "/14/2/percept.weights[1]")).toEqual(["/14/2/percept"]);
  expect(topicsOfMeasure(memory(), "nonsense")).toEqual([]);
});
