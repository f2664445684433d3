// Sentences about ground truth: sensors, errors, and the quality of a calibration.

import type { Calibrated } from "../memory/calibration";
import { kTagRefusals, type Sensor } from "../memory/truth";
import type { MeanErrors } from "../memory/truth_errors";

/** "1.9 cm", or "–" for a number that is not known. */
export const centimetres = (metres: number): string =>
  Number.isFinite(metres) ? `${(100 * metres).toFixed(1)} cm` : "–";

const kStates: Record<Sensor["state"], string> = {
  watching: "watching",
  waiting: "waiting for images",
  ended: "the recording is over",
  "": "state not reported",
};

/** Such as "watching, 30.0 images a second, detection takes 0.8 ms". */
export function sensorWords(sensor: Sensor): string {
  const { state, rate, detection_ms, place, errorMean, background } = sensor;
  const words = [kStates[state]];
  if (state === "watching" && Number.isFinite(rate)) words.push(`${rate.toFixed(1)} images a second`);
  if (state === "watching" && detection_ms > 0) words.push(`detection takes ${detection_ms.toFixed(1)} ms`);
  if (!place) words.push("not calibrated, so nothing is detected");
  else if (Number.isFinite(errorMean) && errorMean > 0) words.push(`expected error ${centimetres(errorMean)}`);
  if (background.images + background.awaited > 0) words.push(`empty field ${backgroundWords(sensor)}`);
  return words.join(", ");
}

/** Such as "learned from 15 images". */
export function backgroundWords({ background: { images, awaited } }: Sensor): string {
  if (awaited > 0) return `learning, ${awaited} ${awaited === 1 ? "image" : "images"} to come`;
  return images > 0 ? `learned from ${images} images` : "not learned: depths are compared with a flat carpet";
}

/** Such as "tags refused: 3 unknown, 1 implausible", or "" if no tag was refused. */
export function refusedTagsWords({ refusedTags }: Sensor): string {
  const counts = kTagRefusals
    .map((reason) => ({ reason, count: refusedTags?.[reason] ?? 0 }))
    .filter(({ count }) => count > 0)
    .map(({ reason, count }) => `${count} ${reason}`);
  return counts.length > 0 ? `tags refused: ${counts.join(", ")}` : "";
}

/** The error of the fused truth against true positions, or "" without any. */
export function errorWords({ robots, ball }: MeanErrors): string {
  const parts = [
    ...(Number.isFinite(robots) ? [`robots ${centimetres(robots)}`] : []),
    ...(Number.isFinite(ball) ? [`ball ${centimetres(ball)}`] : []),
  ];
  return parts.length > 0 ? `Mean error over 3 s: ${parts.join(", ")}` : "";
}

/** The expected error of a calibration, and its independent check. */
export function calibrationWords({ mean, p95, leftOut, depthScale, depthScaleDeviation }: Calibrated): string[] {
  const sentences = [`Expected error on the field: mean ${centimetres(mean)}, 95 % below ${centimetres(p95)}.`];
  if (Number.isFinite(leftOut.mean)) {
    const worst = leftOut.landmark ? `, worst ${centimetres(leftOut.worst)} at ${leftOut.landmark}` : "";
    sentences.push(`Landmarks left out of the fit: mean ${centimetres(leftOut.mean)}${worst}.`);
  }
  if (Number.isFinite(depthScale)) {
    const deviation = Number.isFinite(depthScaleDeviation) ? ` ± ${depthScaleDeviation.toFixed(4)}` : "";
    sentences.push(`True depth / measured depth: ${depthScale.toFixed(4)}${deviation}.`);
  }
  return sentences;
}
