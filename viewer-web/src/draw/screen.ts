// Shows images on two stacked canvases, one of them visible: WebGL for YUYV, 2D for JPEG.

import type { Picture } from "./picture";
import { rgbaFromYuyv } from "./yuyv";
import { yuyvPainter, type YuyvPainter } from "./yuyv_gl";

export interface Shown {
  width: number;
  height: number;
}

export class Screen {
  #painter: YuyvPainter | undefined;

  constructor(
    readonly shaded: HTMLCanvasElement,
    readonly flat: HTMLCanvasElement,
  ) {
    this.#painter = yuyvPainter(shaded);
    // a restored context is empty: everything is created again
    shaded.addEventListener("webglcontextlost", (event) => event.preventDefault());
    shaded.addEventListener("webglcontextrestored", () => (this.#painter = yuyvPainter(shaded)));
  }

  /** Rejects with the browser's message if it cannot decode a JPEG. */
  async show(picture: Picture): Promise<Shown> {
    if (picture.kind === "jpeg") return this.#showJpeg(picture.data);
    const { data, width, height } = picture;
    if (this.#painter) {
      this.#reveal(this.shaded); // first: a drawing of WebGL on a hidden canvas may be lost
      this.#painter.paint(data, width, height);
    } else {
      this.#showFlat(width, height, (ctx) =>
        ctx.putImageData(new ImageData(rgbaFromYuyv(data, width, height), width, height), 0, 0),
      );
    }
    return { width, height };
  }

  /** Frees the canvases; they cannot be used again. */
  dispose(): void {
    this.#painter?.dispose();
  }

  async #showJpeg(data: Uint8Array): Promise<Shown> {
    const bitmap = await createImageBitmap(new Blob([data as Uint8Array<ArrayBuffer>], { type: "image/jpeg" }));
    const { width, height } = bitmap;
    this.#showFlat(width, height, (ctx) => ctx.drawImage(bitmap, 0, 0));
    bitmap.close();
    return { width, height };
  }

  #showFlat(width: number, height: number, draw: (ctx: CanvasRenderingContext2D) => void): void {
    if (this.flat.width !== width || this.flat.height !== height) [this.flat.width, this.flat.height] = [width, height];
    draw(this.flat.getContext("2d", { alpha: false })!);
    this.#reveal(this.flat);
  }

  #reveal(canvas: HTMLCanvasElement): void {
    this.shaded.hidden = canvas !== this.shaded;
    this.flat.hidden = canvas !== this.flat;
  }
}
