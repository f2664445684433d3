// Canvases that fit their place on the page and use its colours.

import type { Colours } from "../draw/timeline";

/** To people who cannot see it, a canvas is a picture. Spread, because Svelte wrongly takes canvases for controls. */
export const kPicture = { role: "img" } as const;

interface Size {
  width: number;
  height: number;
}

/** Gives the canvas `ratio` of its own pixels for each of the page. Returns its size on the page. */
export function sized(canvas: HTMLCanvasElement, ratio: number): Size {
  const { clientWidth: width, clientHeight: height } = canvas;
  const [fineWidth, fineHeight] = [Math.round(ratio * width), Math.round(ratio * height)];
  // setting a size clears the canvas
  if (canvas.width !== fineWidth) canvas.width = fineWidth;
  if (canvas.height !== fineHeight) canvas.height = fineHeight;
  return { width, height };
}

/** Sets the canvas to the screen's resolution, clears it, and uses the page's pixels as its unit. */
export function fitted(canvas: HTMLCanvasElement, pen: CanvasRenderingContext2D): Size {
  const ratio = window.devicePixelRatio;
  const { width, height } = sized(canvas, ratio);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return { width, height };
}

/** Returns a function that reports whether one of its arguments differs from the last call, so that drawings can be saved. */
export function changes(): (...values: unknown[]) => boolean {
  let before: unknown[] = [];
  return (...values) => {
    const differs = values.length !== before.length || values.some((value, i) => !Object.is(value, before[i]));
    before = values;
    return differs;
  };
}

let known: { key: string; colours: Colours } | undefined;

/** The page's colours in its current theme. */
export function coloursOf(element: Element): Colours {
  const style = getComputedStyle(element);
  const key = style.color;
  if (known?.key !== key) {
    const probe = document.createElement("span");
    document.body.append(probe);
    const colour = (name: string) => {
      probe.style.color = `var(${name})`;
      return getComputedStyle(probe).color;
    };
    known = {
      key,
      colours: {
        ink: colour("--ink"),
        soft: colour("--soft"),
        line: colour("--line"),
        fill: colour("--fill"),
        accent: colour("--accent"),
        warn: colour("--warn"),
      },
    };
    probe.remove();
  }
  return known.colours;
}
