import { expect, test } from "vitest";
import {
  chose,
  clickedLandmark,
  clickedPixel,
  kNoClicks,
  movable,
  movedTo,
  nextStep,
  pressed,
  removed,
} from "./clicks";

const kPixel = { x: 10.5, y: 20.25 };
const kOne = clickedPixel(clickedLandmark(kNoClicks, "corner"), kPixel);
const key = (name: string, shiftKey = false) => ({ key: name, shiftKey });

test("a pixel and a landmark belong together in either order", () => {
  expect(clickedLandmark(clickedPixel(kNoClicks, kPixel), "corner")).toEqual(kOne);
  expect(kOne).toEqual({ clicks: [{ landmark: "corner", ...kPixel }], chosen: "corner", pending: undefined });
});

test("after a whole click the next pixel is a new one", () => {
  const next = clickedPixel(kOne, { x: 1, y: 2 });
  expect(next).toMatchObject({ chosen: "", pending: { x: 1, y: 2 }, clicks: kOne.clicks });
  expect(clickedLandmark(next, "mark").clicks).toHaveLength(2);
});

test("a landmark that is clicked again gets the new pixel", () => {
  expect(clickedLandmark(clickedPixel(kOne, { x: 1, y: 2 }), "corner").clicks).toEqual([
    { landmark: "corner", x: 1, y: 2 },
  ]);
});

test("arrow keys move the chosen click by a quarter of a pixel, by two with Shift", () => {
  expect(movable(pressed(kOne, key("ArrowLeft"))!)).toMatchObject({ x: 10.25, y: 20.25 });
  expect(movable(pressed(kOne, key("ArrowDown", true))!)).toMatchObject({ x: 10.5, y: 22.25 });
  const back = pressed(pressed(kOne, key("ArrowUp"))!, key("ArrowDown"))!;
  expect(back.clicks).toEqual(kOne.clicks);
  expect(pressed(kOne, key("x"))).toBeUndefined();
});

test("a waiting pixel is moved and removed before any click", () => {
  const waiting = clickedPixel(kOne, { x: 1, y: 2 });
  expect(movedTo(waiting, { x: 3, y: 4 })).toMatchObject({ pending: { x: 3, y: 4 }, clicks: kOne.clicks });
  expect(pressed(waiting, key("Delete"))).toMatchObject({ pending: undefined, clicks: kOne.clicks });
});

test("a click is removed by the key or from the list, and Escape chooses none", () => {
  expect(pressed(kOne, key("Delete"))).toEqual(kNoClicks);
  expect(removed(clickedLandmark(kOne, "mark"), "corner").clicks).toEqual([]);
  expect(pressed(kOne, key("Escape"))).toEqual({ ...kNoClicks, clicks: kOne.clicks });
});

test("keys without anything to move stay the page's", () => {
  for (const name of ["ArrowLeft", "Delete", "Backspace", "Escape"])
    expect(pressed(kNoClicks, key(name))).toBeUndefined();
  const waiting = clickedLandmark(kNoClicks, "corner");
  expect(pressed(waiting, key("ArrowLeft"))).toBeUndefined();
  expect(pressed(waiting, key("Escape"))).toEqual(kNoClicks);
});

test("what did not change stays the same object, so that no fit is asked for", () => {
  expect(chose(kOne, "corner").clicks).toBe(kOne.clicks);
  expect(clickedPixel(kOne, kPixel).clicks).toBe(kOne.clicks);
});

test("the next step is told at each point", () => {
  const steps = [kNoClicks, clickedLandmark(kNoClicks, "corner"), clickedPixel(kNoClicks, kPixel), kOne].map(nextStep);
  expect(new Set(steps).size).toBe(4);
  expect(steps[1]).toMatch(/corner in the image/);
});
