// YUYV drawn by the graphics card. A texel holds a pair of pixels as (Y0, U, Y1, V); the fragment picks its half.

import { programOf } from "./gl_program";
import { kBlueFromU, kGreenFromU, kGreenFromV, kRedFromV } from "./yuyv";

const kVertex = `#version 300 es
void main() {
  // one triangle that covers the canvas: (-1,-1) (3,-1) (-1,3)
  gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1);
}`;

const kFragment = `#version 300 es
precision highp float;
uniform highp sampler2D pairs;
uniform int height;
out vec4 colour;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y)); // images start at the top, WebGL at the bottom
  vec4 pair = texelFetch(pairs, ivec2(pixel.x >> 1, pixel.y), 0);
  float y = (pixel.x & 1) == 0 ? pair.r : pair.b;
  float u = pair.g - 128.0 / 255.0;
  float v = pair.a - 128.0 / 255.0;
  colour = vec4(y + ${kRedFromV} * v, y + ${kGreenFromU} * u + ${kGreenFromV} * v, y + ${kBlueFromU} * u, 1);
}`;

export interface YuyvPainter {
  paint(yuyv: Uint8Array, width: number, height: number): void;
  /** Gives the context back: a page may have 16, and canvases long gone count until they are collected. */
  dispose(): void;
}

/** A painter for `canvas`, which it resizes to the image; undefined where WebGL 2 is missing. */
export function yuyvPainter(canvas: HTMLCanvasElement): YuyvPainter | undefined {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false });
  const program = gl && programOf(gl, kVertex, kFragment);
  if (!program) return undefined;

  gl.useProgram(program);
  const height_uniform = gl.getUniformLocation(program, "height");
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST); // the default would want mipmaps

  return {
    paint(yuyv, width, height) {
      if (gl.isContextLost()) return;
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      gl.viewport(0, 0, width, height);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width / 2, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, yuyv);
      gl.uniform1i(height_uniform, height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    },
    dispose() {
      gl.getExtension("WEBGL_lose_context")?.loseContext();
    },
  };
}
