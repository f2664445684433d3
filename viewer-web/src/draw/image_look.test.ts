import { expect, test } from "vitest";
import { fitBy, imageDragged, imageZoomed, kWholeImage } from "./image_look";
import { toImage } from "./overlay";

const kImage = { width: 640, height: 480 };

test("the whole image is in the middle", () => {
  const fit = fitBy(kWholeImage, kImage, 1280, 1000);
  expect([fit.scale, fit.left, fit.top]).toEqual([2, 0, 20]);
});

test("the pixel under the pointer stays there while zooming, and back again", () => {
  const pointer = { x: 333, y: 222 };
  const fit = fitBy(kWholeImage, kImage, 800, 600);
  const look = imageZoomed(kWholeImage, fit, pointer, 7);
  const near = fitBy(look, kImage, 800, 600);
  expect(near.scale).toBeCloseTo(7 * fit.scale);
  expect(toImage(near, pointer).x).toBeCloseTo(toImage(fit, pointer).x);
  expect(toImage(near, pointer).y).toBeCloseTo(toImage(fit, pointer).y);
  expect(imageZoomed(look, near, pointer, 1 / 7)).toEqual(kWholeImage);
});

test("a dragged pixel follows the pointer, and the whole image stays", () => {
  const look = { zoom: 4, x: 0.5, y: 0.5 };
  const fit = fitBy(look, kImage, 800, 600);
  const moved = fitBy(imageDragged(look, fit, { x: 30, y: -20 }), kImage, 800, 600);
  expect(moved.left - fit.left).toBeCloseTo(30);
  expect(moved.top - fit.top).toBeCloseTo(-20);
  expect(imageDragged(kWholeImage, fit, { x: 30, y: 0 })).toBe(kWholeImage);
});
