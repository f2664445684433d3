// Mouse, wheel and fingers on a canvas: one pointer drags, two zoom, a press without a way is a tap.

import type { Point } from "../draw/field";

const kStill = 4; // [px] of a hand that does not drag
const kLinger_ms = 2500; // a finger that has left still points there
const kPerWheel = 400; // [px of the wheel] for a factor of e

/** Places are in the page's pixels, from the canvas's corner. */
export interface Gestures {
  pressed?(at: Point): void;
  /** `other`: another button than the first, or a pressed key Shift. */
  dragged(by: Point, at: Point, other: boolean): void;
  /** Two fingers move: `by` of their middle. */
  shifted?(by: Point): void;
  zoomed(at: Point, factor: number): void;
  tapped?(at: Point): void;
  /** The last pointer of a press was lifted, or the browser took one of them: `cancelled`. */
  released?(cancelled: boolean): void;
  hovered?(at: Point | undefined): void;
}

/** An attachment of a canvas. */
export const gestures = (act: Gestures) => (canvas: HTMLCanvasElement) => {
  const down = new Map<number, Point>();
  let way = 0; // [px] since the press
  let cancelled = false; // since the press
  let linger: ReturnType<typeof setTimeout>;
  const placeOf = ({ clientX, clientY }: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return { x: clientX - box.left, y: clientY - box.top };
  };
  const hover = (at: Point | undefined) => {
    clearTimeout(linger);
    act.hovered?.(at);
  };

  function press(event: PointerEvent) {
    canvas.setPointerCapture(event.pointerId);
    const at = placeOf(event);
    if (down.size === 0) cancelled = false;
    down.set(event.pointerId, at);
    way = down.size > 1 ? kStill : 0;
    hover(at);
    if (down.size === 1) act.pressed?.(at);
  }
  function move(event: PointerEvent) {
    const at = placeOf(event);
    hover(at);
    const before = down.get(event.pointerId);
    if (!before) return;
    const by = { x: at.x - before.x, y: at.y - before.y };
    way += Math.hypot(by.x, by.y);
    down.set(event.pointerId, at);
    if (way < kStill) return;
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) return act.dragged(by, at, event.buttons > 1 || event.shiftKey);
    const apart = (point: Point) => Math.hypot(point.x - other.x, point.y - other.y);
    act.zoomed({ x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 }, apart(at) / Math.max(1, apart(before)));
    act.shifted?.({ x: by.x / 2, y: by.y / 2 });
  }
  function release(event: PointerEvent) {
    if (!down.delete(event.pointerId)) return;
    cancelled ||= event.type === "pointercancel";
    clearTimeout(linger);
    if (event.pointerType !== "mouse") linger = setTimeout(() => act.hovered?.(undefined), kLinger_ms);
    if (way < kStill && event.type === "pointerup") act.tapped?.(placeOf(event));
    if (down.size === 0) act.released?.(cancelled);
  }
  function leave(event: PointerEvent) {
    if (event.pointerType === "mouse" && down.size === 0) hover(undefined);
  }
  function turn(event: WheelEvent) {
    event.preventDefault();
    act.zoomed(placeOf(event), Math.exp(-event.deltaY / kPerWheel));
  }
  const noMenu = (event: Event) => event.preventDefault(); // the other button drags

  canvas.addEventListener("pointerdown", press);
  canvas.addEventListener("pointermove", move);
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("wheel", turn, { passive: false });
  canvas.addEventListener("contextmenu", noMenu);
  // a canvas's listeners end with it
  return () => clearTimeout(linger);
};
