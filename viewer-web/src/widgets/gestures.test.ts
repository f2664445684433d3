import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { gestures, type Gestures } from "./gestures";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Returns a function that sends a pointer's event to a canvas with these gestures. */
function canvasWith(act: Partial<Gestures>) {
  const listeners = new Map<string, (event: unknown) => void>();
  const canvas = {
    addEventListener: (name: string, listener: (event: unknown) => void) => listeners.set(name, listener),
    setPointerCapture: () => {},
    getBoundingClientRect: () => ({ left: 10, top: 20 }),
  };
  const end = gestures({ dragged: () => {}, zoomed: () => {}, ...act })(canvas as unknown as HTMLCanvasElement);
  const send = (type: string, pointerId = 1, [x, y] = [50, 50], more: object = {}) =>
    listeners.get(type)!({
      type,
      pointerId,
      pointerType: "touch",
      clientX: x,
      clientY: y,
      buttons: 1,
      shiftKey: false,
      ...more,
    });
  return { send, end };
}

test("a press without a way is a tap, and one with a way drags", () => {
  const [tapped, dragged] = [vi.fn(), vi.fn()];
  const { send } = canvasWith({ tapped, dragged });
  send("pointerdown");
  send("pointerup");
  expect(tapped).toHaveBeenCalledExactlyOnceWith({ x: 40, y: 30 });
  send("pointerdown");
  send("pointermove", 1, [60, 50]);
  send("pointerup", 1, [60, 50]);
  expect(tapped).toHaveBeenCalledTimes(1);
  expect(dragged).toHaveBeenCalledExactlyOnceWith({ x: 10, y: 0 }, { x: 50, y: 30 }, false);
});

test("a release says whether the browser took a pointer of the press", () => {
  const [tapped, released] = [vi.fn(), vi.fn()];
  const { send } = canvasWith({ tapped, released });
  send("pointerdown");
  send("pointercancel");
  expect(released).toHaveBeenLastCalledWith(true);
  expect(tapped).not.toHaveBeenCalled();
  send("pointerdown", 1);
  send("pointerdown", 2);
  send("pointercancel", 1);
  send("pointerup", 2);
  expect(released).toHaveBeenLastCalledWith(true);
  send("pointerdown");
  send("pointerup");
  expect(released).toHaveBeenLastCalledWith(false);
  expect(released).toHaveBeenCalledTimes(3);
});

test("a finger that has left points there for a while, also after two fingers were lifted", () => {
  const hovered = vi.fn();
  const { send } = canvasWith({ hovered });
  send("pointerdown", 1);
  send("pointerdown", 2);
  send("pointerup", 1);
  send("pointerup", 2);
  send("pointerdown", 1);
  vi.advanceTimersByTime(60_000);
  expect(hovered).not.toHaveBeenCalledWith(undefined);
  send("pointerup", 1);
  vi.advanceTimersByTime(60_000);
  expect(hovered).toHaveBeenLastCalledWith(undefined);
});

test("nothing is called after the canvas has left the page", () => {
  const hovered = vi.fn();
  const { send, end } = canvasWith({ hovered });
  send("pointerdown");
  send("pointerup");
  end();
  vi.advanceTimersByTime(60_000);
  expect(hovered).not.toHaveBeenCalledWith(undefined);
});
