import { expect, test } from "vitest";
import { calibratedOf, landmarksOf } from "./calibration";

const kAnswer = {
  fitted: true,
  refused: "",
  residuals: [{ landmark: "corner", pixels: 0.7, outlier: false }],
  depth_scale: 1.01,
  depth_scale_deviation: 0.002,
  error: { mean: 0.005, p95: 0.01, grid: [{ x: 0, y: 1, metres: 0.004 }] },
  left_out: { mean: 0.01, worst: 0.02, landmark: "corner" },
  place: { rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], x: 1, y: 2, z: 3 },
  saved: "lab.json",
};

test("landmarks and saved clicks are read, and clicks of unknown landmarks are dropped", () => {
  const landmarks = [{ name: "corner", x: 4.5, y: 3, z: 0 }, { name: "nowhere", x: "far" }, 7];
  const clicks = [
    { landmark: "corner", x: 1.5, y: 2 },
    { landmark: "nowhere", x: 1, y: 2 },
  ];
  expect(landmarksOf({ landmarks, clicks, file: "lab.json" })).toEqual({
    landmarks: [{ name: "corner", x: 4.5, y: 3, z: 0 }],
    clicks: [{ landmark: "corner", x: 1.5, y: 2 }],
    file: "lab.json",
  });
});

test("a whole answer is read", () => {
  expect(calibratedOf(kAnswer)).toMatchObject({
    fitted: true,
    mean: 0.005,
    grid: [{ x: 0, y: 1, metres: 0.004 }],
    leftOut: { worst: 0.02 },
    place: { at: { x: 1, y: 2, z: 3 }, depthScale: 1.01 },
    saved: "lab.json",
  });
});

test("an answer without parts, or with parts of other types, has none of them and harms nobody", () => {
  for (const name of Object.keys(kAnswer))
    for (const wrong of [undefined, null, 7, "seven", [7], { seven: 7 }]) {
      const read = calibratedOf({ ...kAnswer, [name]: wrong });
      expect(read.grid.every(({ metres }) => Number.isFinite(metres))).toBe(true);
      expect(read.place === undefined || read.place.rotation.length === 9).toBe(true);
    }
  expect(calibratedOf({})).toMatchObject({ fitted: false, refused: "", residuals: [], place: undefined, mean: NaN });
});
