import { expect, test } from "vitest";
import { calibratedOf } from "../memory/calibration";
import { sensorOf } from "../memory/truth";
import { backgroundWords, calibrationWords, errorWords, refusedTagsWords, sensorWords } from "./truth";

test("a sensor is described by its state, rate and calibration", () => {
  const none = sensorOf(new Map());
  const place = { rotation: [], at: { x: 0, y: 0, z: 0 }, depthScale: 1 };
  const watching = { ...none, state: "watching" as const, rate: 29.97, detection_ms: 0.81 };
  expect(sensorWords(watching)).toBe(
    "watching, 30.0 images a second, detection takes 0.8 ms, not calibrated, so nothing is detected",
  );
  expect(sensorWords({ ...watching, state: "waiting", place, errorMean: 0.012 })).toBe(
    "waiting for images, expected error 1.2 cm",
  );
});

test("the empty field is described while it is learned and after it", () => {
  const none = sensorOf(new Map());
  expect(backgroundWords(none)).toBe("not learned: depths are compared with a flat carpet");
  const learning = { ...none, background: { images: 7, awaited: 8 } };
  expect(backgroundWords(learning)).toBe("learning, 8 images to come");
  const place = { rotation: [], at: { x: 0, y: 0, z: 0 }, depthScale: 1 };
  const learned = { ...none, state: "watching" as const, place, background: { images: 15, awaited: 0 } };
  expect(sensorWords(learned)).toBe("watching, empty field learned from 15 images");
});

test("refused tags are told with their reasons, and nothing is told without any", () => {
  const none = sensorOf(new Map());
  expect(refusedTagsWords(none)).toBe("");
  const counts = { unknown: 3, repeated: 0, implausible: 1, contradictory: 0 };
  expect(refusedTagsWords({ ...none, refusedTags: counts })).toBe("tags refused: 3 unknown, 1 implausible");
  expect(refusedTagsWords({ ...none, refusedTags: { ...counts, unknown: 0, implausible: 0 } })).toBe("");
});

test("errors that are not known are not told", () => {
  expect(errorWords({ robots: NaN, ball: NaN })).toBe("");
  expect(errorWords({ robots: 0.019, ball: NaN })).toBe("Mean error over 3 s: robots 1.9 cm");
});

test("a calibration is described with its independent check, where there is one", () => {
  const answer = calibratedOf({
    error: { mean: 0.005, p95: 0.0112 },
    left_out: { mean: 0.01, worst: 0.02, landmark: "corner" },
  });
  expect(calibrationWords(answer)).toEqual([
    "Expected error on the field: mean 0.5 cm, 95 % below 1.1 cm.",
    "Landmarks left out of the fit: mean 1.0 cm, worst 2.0 cm at corner.",
  ]);
  expect(calibrationWords(calibratedOf({ depth_scale: 1.01, depth_scale_deviation: 0.002 })).at(-1)).toBe(
    "True depth / measured depth: 1.0100 ± 0.0020.",
  );
});
