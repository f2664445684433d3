import { expect, test } from "vitest";
import { changes, sized } from "./canvas";

test("a canvas has the wanted pixels for its place on the page, and is set only when they change", () => {
  let count = 0;
  const canvas = { clientWidth: 301, clientHeight: 200, width: 300, height: 150 };
  const counted = new Proxy(canvas, { set: (on, name, value) => (++count, Reflect.set(on, name, value)) });
  const size = () => sized(counted as HTMLCanvasElement, 1.5);
  expect(size()).toEqual({ width: 301, height: 200 });
  expect([canvas.width, canvas.height, count]).toEqual([452, 300, 2]);
  size();
  expect(count).toBe(2);
});

test("changes are reported once, by identity", () => {
  const isNew = changes();
  const both = {};
  expect([isNew(both, 1), isNew(both, 1), isNew({}, 1), isNew({})]).toEqual([true, false, true, true]);
  expect([isNew(NaN), isNew(NaN)]).toEqual([true, false]);
});
