// The clicks of a calibration: each joins a pixel and a landmark, in either order.

import type { Click } from "../memory/calibration";

interface Point {
  x: number;
  y: number;
}

export interface Clicking {
  clicks: readonly Click[];
  /** The landmark that keys and the next click are for, or "". */
  chosen: string;
  /** A pixel that has no landmark yet. */
  pending: Point | undefined;
}

export const kNoClicks: Clicking = { clicks: [], chosen: "", pending: undefined };

export const hasClick = ({ clicks }: Clicking, landmark: string): boolean =>
  clicks.some((click) => click.landmark === landmark);

function joined(now: Clicking, landmark: string, { x, y }: Point): Clicking {
  const others = now.clicks.filter((click) => click.landmark !== landmark);
  return { clicks: [...others, { landmark, x, y }], chosen: landmark, pending: undefined };
}

/** Handles a click in the image: it belongs to the chosen landmark if that has none yet, else it waits for one. */
export const clickedPixel = (now: Clicking, pixel: Point): Clicking =>
  now.chosen && !hasClick(now, now.chosen)
    ? joined(now, now.chosen, pixel)
    : { ...now, chosen: "", pending: { x: pixel.x, y: pixel.y } };

/** Handles a click on a landmark: the waiting pixel is its pixel, else the landmark waits for one. */
export const clickedLandmark = (now: Clicking, landmark: string): Clicking =>
  now.pending ? joined(now, landmark, now.pending) : { ...now, chosen: landmark };

/** Chooses a landmark to correct its click; "" chooses none. */
export const chose = (now: Clicking, landmark: string): Clicking => ({ ...now, chosen: landmark, pending: undefined });

/** Returns the pixel that can be moved: the waiting one, else the chosen landmark's. */
export const movable = ({ clicks, chosen, pending }: Clicking): Point | undefined =>
  pending ?? clicks.find(({ landmark }) => landmark === chosen);

/** Moves that pixel. */
export function movedTo(now: Clicking, { x, y }: Point): Clicking {
  if (now.pending) return { ...now, pending: { x, y } };
  return {
    ...now,
    clicks: now.clicks.map((click) => (click.landmark === now.chosen ? { ...click, x, y } : click)),
  };
}

/** Moves it by a part of a pixel. */
function nudged(now: Clicking, by: Point): Clicking {
  const at = movable(now);
  return at ? movedTo(now, { x: at.x + by.x, y: at.y + by.y }) : now;
}

/** Removes the waiting pixel, else the click of the chosen landmark, or of another one. */
export function removed(now: Clicking, landmark = now.chosen): Clicking {
  if (now.pending && landmark === now.chosen) return { ...now, pending: undefined };
  return { clicks: now.clicks.filter((click) => click.landmark !== landmark), chosen: "", pending: undefined };
}

const kWays: Record<string, Point> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};
const kStep = 0.25; // [px] of an arrow key
const kLongStep = 2; // [px] with Shift

/** Handles a key. Undefined if the key has no meaning now. */
export function pressed(
  now: Clicking,
  { key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
): Clicking | undefined {
  if (!movable(now)) return key === "Escape" && now.chosen ? chose(now, "") : undefined;
  const [way, step] = [kWays[key], shiftKey ? kLongStep : kStep];
  if (way) return nudged(now, { x: step * way.x, y: step * way.y });
  if (key === "Delete" || key === "Backspace") return removed(now);
  return key === "Escape" ? chose(now, "") : undefined;
}

/** The next step in words. */
export function nextStep(now: Clicking): string {
  if (now.pending) return "Now click its place on the field, or its name in the list.";
  if (now.chosen && !hasClick(now, now.chosen)) return `Now click ${now.chosen} in the image.`;
  if (now.chosen) return "Drag the mark or press the arrow keys to correct it, Delete to remove it.";
  return "Click a landmark in the image and its place on the field, in either order.";
}
