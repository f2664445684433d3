// Ball and robots that a person drags over a field, and turns by their handle or the wheel.

import { toField, type Camera, type Field, type Point } from "../draw/field";
import { gripAt, onCarpet, standingOf, type Grip } from "../draw/foreseen";
import type { Situation } from "../memory/forecast";
import type { Standing, Thing } from "../memory/question";

interface Ground {
  camera: () => Camera;
  field: () => Field;
  /** With the edit. */
  situation: () => Situation;
  canEdit: () => boolean;
  move: (thing: Thing, to: Standing) => void;
  /** Something is being dragged from now on. */
  grabbed?: () => void;
}

const placeOf = ({ offsetX, offsetY }: MouseEvent): Point => ({ x: offsetX, y: offsetY });

export class Things {
  /** The thing that is dragged or under the pointer. */
  held = $state<Thing>();
  cursor = $state("default");
  #grip: Grip | undefined;
  #away: Point = { x: 0, y: 0 }; // [m] from the pointer to the middle of what it holds

  constructor(readonly ground: Ground) {}

  #gripOf(pointer: Point): Grip | undefined {
    const { camera, situation, canEdit } = this.ground;
    return canEdit() ? gripAt(camera(), situation(), this.held, pointer) : undefined;
  }

  grab = (event: PointerEvent): void => {
    const { camera, situation, grabbed } = this.ground;
    this.#grip = this.#gripOf(placeOf(event));
    this.held = this.#grip?.thing;
    const standing = this.held && standingOf(situation(), this.held);
    if (!this.#grip || !standing) return;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    const point = toField(camera(), placeOf(event));
    this.#away = { x: standing.x - point.x, y: standing.y - point.y };
    grabbed?.();
  };

  move = (event: PointerEvent): void => {
    const { camera, field, situation, move } = this.ground;
    const pointer = placeOf(event);
    const grip = this.#grip;
    const standing = grip && standingOf(situation(), grip.thing);
    if (!grip || !standing) {
      const under = this.#gripOf(pointer);
      if (event.pointerType === "mouse" && !grip && under) this.held = under.thing;
      this.cursor = under ? "grab" : "default";
      return;
    }
    this.cursor = "grabbing";
    const point = toField(camera(), pointer);
    if (grip.turns)
      return move(grip.thing, { ...standing, heading: Math.atan2(point.y - standing.y, point.x - standing.x) });
    const to = onCarpet(field(), { x: point.x + this.#away.x, y: point.y + this.#away.y });
    move(grip.thing, { ...standing, ...to });
  };

  drop = (): void => {
    this.#grip = undefined;
  };

  /** Fingers and wheel over a thing edit it; elsewhere the page scrolls. For a canvas. */
  takeOver = (canvas: HTMLCanvasElement): (() => void) => {
    const touch = (event: TouchEvent) => {
      const box = canvas.getBoundingClientRect();
      const { clientX, clientY } = event.touches[0]!;
      if (this.#gripOf({ x: clientX - box.left, y: clientY - box.top })) event.preventDefault();
    };
    const turn = (event: WheelEvent) => {
      const under = this.#gripOf(placeOf(event))?.thing;
      const standing = under && under !== "ball" && standingOf(this.ground.situation(), under);
      if (!standing) return;
      event.preventDefault();
      this.ground.move(under, { ...standing, heading: standing.heading - event.deltaY / 400 });
    };
    canvas.addEventListener("touchstart", touch, { passive: false });
    canvas.addEventListener("wheel", turn, { passive: false });
    return () => {
      canvas.removeEventListener("touchstart", touch);
      canvas.removeEventListener("wheel", turn);
    };
  };
}

/** The situation in words, for people who cannot see it. */
export function inWords({ ball, bodies }: Situation): string {
  const metres = ({ x, y }: Point) => `${x.toFixed(1)}, ${y.toFixed(1)} m`;
  return [
    ball ? `The ball is at ${metres(ball)}` : "The place of the ball is unknown",
    ...bodies.map((body) => `${body.side} ${body.player} at ${metres(body)}`),
  ].join("; ");
}
