// The look at an image: zoom and place, for clicks to a fraction of a pixel.

import type { Point } from "./field";
import { fitOf, toImage, type Fit } from "./overlay";

export interface ImageLook {
  /** 1: the whole image fits. */
  zoom: number;
  /** [0..1] Place in the middle of the canvas, as a share of the image's size. */
  x: number;
  y: number;
}

export const kWholeImage: ImageLook = { zoom: 1, x: 0.5, y: 0.5 };
const kMostZoom = 40;

interface Size {
  width: number;
  height: number;
}

/** Returns how the image lies on a canvas of `width` x `height` [px]. */
export function fitBy(look: ImageLook, image: Size, width: number, height: number): Fit {
  const scale = fitOf(image, width, height).scale * look.zoom;
  return {
    ...image,
    scale,
    left: width / 2 - scale * look.x * image.width,
    top: height / 2 - scale * look.y * image.height,
  };
}

/** Zooms by `factor`. The pixel under `pointer` stays there. */
export function imageZoomed(look: ImageLook, fit: Fit, pointer: Point, factor: number): ImageLook {
  const zoom = Math.min(kMostZoom, Math.max(1, look.zoom * factor));
  if (zoom === 1) return kWholeImage;
  const pixel = toImage(fit, pointer);
  const share = look.zoom / zoom;
  const [x, y] = [pixel.x / fit.width, pixel.y / fit.height];
  return kept({ zoom, x: x + share * (look.x - x), y: y + share * (look.y - y) });
}

/** Moves the image by these pixels of the canvas. */
export function imageDragged(look: ImageLook, fit: Fit, by: Point): ImageLook {
  if (look.zoom === 1) return look;
  return kept({
    zoom: look.zoom,
    x: look.x - by.x / (fit.scale * fit.width),
    y: look.y - by.y / (fit.scale * fit.height),
  });
}

/** Keeps a part of the image in the middle. */
const kept = ({ zoom, x, y }: ImageLook): ImageLook => ({
  zoom,
  x: Math.min(1, Math.max(0, x)),
  y: Math.min(1, Math.max(0, y)),
});
