import { expect, test } from "vitest";
import { MemoryObject } from "./memory_object";
import { Series } from "./series";
import { kPerceptChannel, percept } from "./test_schema";
import { numberOf } from "./value";

function filled(count: number) {
  const object = new MemoryObject(kPerceptChannel);
  const add = (i: number) =>
    object.history.add({
      log_ns: 10n ** 18n + (BigInt(i) * 10n ** 9n) / 30n,
      data: percept({ x: i }),
      arrived: i / 30,
    });
  for (let i = 0; i < count; ++i) add(i);
  return { object, add, series: new Series(object, (fields) => numberOf(fields, "x")) };
}

test("a series has the number of every message at its capture time, however often reading is interrupted", () => {
  const { series, object, add } = filled(500);
  let time = 0;
  let steps = 1;
  while (!series.update(1, () => (time += 0.4))) ++steps;
  expect(steps).toBeGreaterThan(5);
  expect(series.length).toBe(500);
  add(500);
  expect(series.update(100)).toBe(true);
  for (const i of [0, 1, 250, 500]) expect([series.times[i], series.values[i]]).toEqual([expect.closeTo(i / 30, 6), i]);
  expect([series.indexAt(-1), series.indexAt(0), series.indexAt(1.0001), series.indexAt(1e9)]).toEqual([
    -1, 0, 30, 500,
  ]);
  object.history.clear();
  series.update(100);
  expect(series.length).toBe(0);
});

test("points that the history has dropped are dropped here too, in the end", () => {
  const { series, object } = filled(4000);
  series.update(1e9);
  while (object.history.begin < 3000) object.history.dropOldest();
  series.update(1e9);
  expect(series.length).toBe(4000 - object.history.begin);
  expect(series.values[0]).toBe(object.history.begin);
});
