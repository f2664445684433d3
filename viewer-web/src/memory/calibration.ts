// Questions and answers of the calibration of a sensor by landmarks. Answers are untrusted JSON.

import { isObject, listOf, objectOf, textOf, type Json } from "../source/json";
import { placeFrom, type SensorPlace } from "./truth";

export const kLandmarks = "/truth/landmarks";
export const kCalibrate = "/truth/calibrate";
/** A sensor takes its next images as the empty field. */
export const kBackground = "/truth/background";

/** A point of the field that people recognise in an image: a corner, a crossing, the foot of a post. */
export interface Landmark {
  name: string;
  x: number; // [m, field]
  y: number;
  z: number;
}

/** The pixel of a landmark. The centre of the first pixel is (0.5, 0.5). */
export interface Click {
  landmark: string;
  x: number; // [px]
  y: number;
}

export interface Landmarks {
  landmarks: Landmark[];
  /** Those of the saved calibration. */
  clicks: Click[];
  /** The name of the file in which a calibration is saved. */
  file: string;
}

export interface Residual {
  landmark: string;
  /** [px] from the click to the landmark as the fit projects it. */
  pixels: number;
  /** It fits so badly that it hardly counts. */
  outlier: boolean;
}

/** The expected error of positions at places of the field [m]. */
export interface ErrorCell {
  x: number;
  y: number;
  metres: number;
}

export interface Calibrated {
  fitted: boolean;
  /** The reason why it cannot be used, or "". */
  refused: string;
  residuals: Residual[];
  depthScale: number;
  depthScaleDeviation: number;
  /** [m] NaN without a fit. */
  mean: number;
  p95: number;
  grid: ErrorCell[];
  /** [m] Errors of landmarks at a fit without them. NaN, and "" without a name, if there are too few. */
  leftOut: { mean: number; worst: number; landmark: string };
  place: SensorPlace | undefined;
  /** The name of the file if it was saved, or "". */
  saved: string;
}

const numberIn = (json: Json, name: string): number => (typeof json[name] === "number" ? json[name] : NaN);

export function landmarksOf(answer: Json): Landmarks {
  const landmarks = listOf(answer["landmarks"])
    .map(objectOf)
    .map((json) => ({
      name: textOf(json["name"]),
      x: numberIn(json, "x"),
      y: numberIn(json, "y"),
      z: numberIn(json, "z") || 0,
    }))
    .filter(({ name, x, y }) => name !== "" && Number.isFinite(x + y));
  const names = new Set(landmarks.map(({ name }) => name));
  const clicks = listOf(answer["clicks"])
    .map(objectOf)
    .map((json) => ({ landmark: textOf(json["landmark"]), x: numberIn(json, "x"), y: numberIn(json, "y") }))
    .filter(({ landmark, x, y }) => names.has(landmark) && Number.isFinite(x + y));
  return { landmarks, clicks, file: textOf(answer["file"]) };
}

export function calibratedOf(answer: Json): Calibrated {
  const [error, leftOut, place] = [answer["error"], answer["left_out"], answer["place"]].map(objectOf) as [
    Json,
    Json,
    Json,
  ];
  return {
    fitted: answer["fitted"] === true,
    refused: textOf(answer["refused"]),
    residuals: listOf(answer["residuals"])
      .filter(isObject)
      .map((json) => ({
        landmark: textOf(json["landmark"]),
        pixels: numberIn(json, "pixels"),
        outlier: json["outlier"] === true,
      })),
    depthScale: numberIn(answer, "depth_scale"),
    depthScaleDeviation: numberIn(answer, "depth_scale_deviation"),
    mean: numberIn(error, "mean"),
    p95: numberIn(error, "p95"),
    grid: listOf(error["grid"])
      .map(objectOf)
      .map((json) => ({ x: numberIn(json, "x"), y: numberIn(json, "y"), metres: numberIn(json, "metres") }))
      .filter(({ x, y, metres }) => Number.isFinite(x + y + metres)),
    leftOut: {
      mean: numberIn(leftOut, "mean"),
      worst: numberIn(leftOut, "worst"),
      landmark: textOf(leftOut["landmark"]),
    },
    place: placeFrom(
      listOf(place["rotation"]).map(Number),
      { x: numberIn(place, "x"), y: numberIn(place, "y"), z: numberIn(place, "z") },
      numberIn(answer, "depth_scale"),
    ),
    saved: textOf(answer["saved"]),
  };
}
