import { expect, test } from "vitest";
import { kFields, toField, toScreen } from "./field";
import { cameraOf, dragged, kWhole, lookOfText, textOfLook, zoomed, type Look } from "./look";

const kField = kFields["spl2012"]!;
const sizes = [
  [900, 600],
  [390, 700],
] as const;
const looks: Look[] = [
  kWhole,
  { zoom: 2.5, x: 1, y: -0.5, mirrored: false },
  { zoom: 1, x: 0.25, y: 0, mirrored: true },
];
const near = (a: { x: number; y: number }, b: { x: number; y: number }) => Math.hypot(a.x - b.x, a.y - b.y) < 1e-9;

test("the conversions between screen and field are inverse to each other for every look", () => {
  for (const [width, height] of sizes)
    for (const look of looks) {
      const camera = cameraOf(kField, look, width, height);
      for (const point of [
        { x: 0, y: 0 },
        { x: 3, y: -2 },
        { x: -1.5, y: 0.7 },
      ])
        expect(near(toField(camera, toScreen(camera, point)), point)).toBe(true);
      expect(near(toField(camera, { x: width / 2, y: height / 2 }), look)).toBe(true);
    }
});

test("an upright canvas shows the field upright, and the mirrored look is the other side's view", () => {
  const up = toScreen(cameraOf(kField, kWhole, 390, 700), { x: 3, y: 0 });
  expect([Math.round(up.x), up.y < 350]).toEqual([195, true]);
  const right = toScreen(cameraOf(kField, kWhole, 900, 600), { x: 3, y: 1 });
  const mirrored = toScreen(cameraOf(kField, { ...kWhole, mirrored: true }, 900, 600), { x: -3, y: -1 });
  expect(near(right, mirrored)).toBe(true);
});

test("the place under the pointer stays there while zooming, and follows while dragging", () => {
  for (const [width, height] of sizes)
    for (const look of looks) {
      const camera = cameraOf(kField, look, width, height);
      const [pointer, moved] = [
        { x: 100, y: 140 },
        { x: 130, y: 90 },
      ];
      const place = toField(camera, pointer);
      expect(near(toField(cameraOf(kField, zoomed(look, camera, pointer, 1.7), width, height), pointer), place)).toBe(
        true,
      );
      const after = cameraOf(kField, dragged(look, camera, { x: 30, y: -50 }), width, height);
      expect(near(toField(after, moved), place)).toBe(true);
    }
});

test("a look survives the address, and an invalid one is the whole field", () => {
  for (const look of looks) expect(lookOfText(textOfLook(look))).toEqual(look);
  expect(textOfLook(kWhole)).toBe("");
  for (const text of ["", "x,y", "NaN,1e9,,", "1e99"]) expect(lookOfText(text)).toEqual(kWhole);
});
