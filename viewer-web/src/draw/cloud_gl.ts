// A point cloud drawn by WebGL. The depth image is a texture, and the vertex shader makes a point of each pixel, so that
// the page's own code touches no point.

import { linesOf } from "./overlay";
import type { Field } from "./field";
import { programOf } from "./gl_program";
import type { ColourPicture, DepthPicture } from "./depth_picture";
import { kSteps, orderedTable } from "./ordered_colours";
import type { Optics } from "./optics";

/** [m] Heights of the first and the last colour. Lower points are ground. */
export const kLowest = 0.08;
export const kHighest = 0.7;
const kGround = "vec3(0.21, 0.31, 0.27)";
const kAboveCarpet = 0.015; // [m] of lines, which the noise of the ground would hide

const kPointVertex = `#version 300 es
precision highp float;
precision highp int;
uniform highp usampler2D depth;
uniform sampler2D colours;
uniform sampler2D heights;
uniform mat4 clip_from_field;
uniform mat3 field_from_sensor;
uniform vec3 sensor;
uniform vec2 focal, centre;
uniform float metres, pixels_per_metre;
uniform int across, stride;
uniform bool coloured;
flat out vec3 shade;
void main() {
  ivec2 pixel = stride * ivec2(gl_VertexID % across, gl_VertexID / across) + stride / 2;
  float z = metres * float(texelFetch(depth, pixel, 0).r);
  vec3 point = sensor + field_from_sensor * (z * vec3((vec2(pixel) + 0.5 - centre) / focal, 1));
  // a pixel without a depth is outside of the picture
  gl_Position = z > 0.0 ? clip_from_field * vec4(point, 1) : vec4(2, 2, 2, 1);
  gl_PointSize = clamp(1.2 * float(stride) * z / focal.x * pixels_per_metre / gl_Position.w, 1.0, 16.0);
  float share = clamp((point.z - ${kLowest}) / ${kHighest - kLowest}, 0.0, 1.0);
  shade = coloured ? texelFetch(colours, pixel, 0).rgb
        : share > 0.0 ? texelFetch(heights, ivec2(int((0.25 + 0.75 * share) * ${kSteps - 1}.0), 0), 0).rgb
        : ${kGround};
}`;

const kPointFragment = `#version 300 es
precision mediump float;
flat in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1); }`;

const kLineVertex = `#version 300 es
uniform mat4 clip_from_field;
in vec2 place;
void main() { gl_Position = clip_from_field * vec4(place, ${kAboveCarpet}, 1); }`;

const kLineFragment = `#version 300 es
precision mediump float;
uniform vec4 ink;
out vec4 colour;
void main() { colour = ink; }`;

export interface CloudScene {
  /** clip_from_field, column by column. */
  clip: Float32Array;
  /** [px] of 1 m at a distance of 1 m. */
  pixelsPerMetre: number;
  /** The projection of the depth image, and its place. */
  optics: Optics;
  depthScale: number;
  /** Every n-th column and row is drawn. */
  stride: number;
  coloured: boolean;
  /** Undefined: no lines. */
  field: Field | undefined;
}

/** A painter of point clouds on one canvas. */
export interface CloudPainter {
  /** Takes over images. A colour image of another size than the depths is not used. */
  load(depth: DepthPicture, colour: ColourPicture | undefined): void;
  /** Whether the last drawing is not finished. */
  readonly busy: boolean;
  /** Draws the loaded images. */
  paint(scene: CloudScene): void;
  /** [s] The duration of the last drawing, once after its end. */
  finished(now: number): number | undefined;
  dispose(): void;
}

/** Returns undefined where WebGL 2 is missing. */
export function cloudPainter(canvas: HTMLCanvasElement): CloudPainter | undefined {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, powerPreference: "low-power" });
  if (!gl) return undefined;
  const points = programOf(gl, kPointVertex, kPointFragment);
  const lines = programOf(gl, kLineVertex, kLineFragment);
  if (!points || !lines) return undefined;
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.enable(gl.DEPTH_TEST);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.clearColor(0.043, 0.055, 0.067, 1);

  const [depths, colours, heights] = [0, 1, 2].map((unit) => textureOf(gl, unit));
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D, colours!);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // until there is one
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D, heights!);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, kSteps, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, orderedTable());
  const ground = groundOf(gl, lines);
  const uniform = uniformsOf(gl, points);
  let size = { width: 0, height: 0 };
  let hasColours = false;
  let drawing: { fence: WebGLSync; began: number } | undefined;

  function drawPoints({ clip, pixelsPerMetre, optics, depthScale, stride, coloured }: CloudScene) {
    gl!.useProgram(points!);
    for (const [unit, name] of ["depth", "colours", "heights"].entries()) gl!.uniform1i(uniform(name), unit);
    gl!.uniformMatrix4fv(uniform("clip_from_field"), false, clip);
    gl!.uniformMatrix3fv(uniform("field_from_sensor"), true, optics.rotation);
    gl!.uniform3f(uniform("sensor"), optics.at.x, optics.at.y, optics.at.z);
    gl!.uniform2f(uniform("focal"), optics.focal.x, optics.focal.y);
    gl!.uniform2f(uniform("centre"), optics.centre.x, optics.centre.y);
    gl!.uniform1f(uniform("metres"), 0.001 * depthScale);
    gl!.uniform1f(uniform("pixels_per_metre"), pixelsPerMetre);
    const [across, down] = [Math.floor(size.width / stride), Math.floor(size.height / stride)];
    gl!.uniform1i(uniform("across"), across);
    gl!.uniform1i(uniform("stride"), stride);
    gl!.uniform1i(uniform("coloured"), Number(coloured && hasColours));
    gl!.drawArrays(gl!.POINTS, 0, across * down);
  }

  return {
    load(depth, colour) {
      if (gl.isContextLost()) return;
      size = { width: depth.width, height: depth.height };
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, depths!);
      const { width, height } = size;
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.R16UI, width, height, 0, gl.RED_INTEGER, gl.UNSIGNED_SHORT, depth.depth);
      hasColours = colour?.width === width && colour.height === height;
      if (!hasColours) return;
      gl.activeTexture(gl.TEXTURE1);
      gl.bindTexture(gl.TEXTURE_2D, colours!);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, width, height, 0, gl.RGB, gl.UNSIGNED_BYTE, colour!.rgb);
    },
    paint(scene) {
      if (gl.isContextLost() || size.width === 0) return;
      const began = performance.now() / 1000;
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      if (scene.field) ground.draw(scene.field, scene.clip, 1);
      drawPoints(scene);
      // points of the ground hide the lines here and there, and must not hide all of them
      gl.disable(gl.DEPTH_TEST);
      gl.enable(gl.BLEND);
      if (scene.field) ground.draw(scene.field, scene.clip, kThrough);
      gl.disable(gl.BLEND);
      gl.enable(gl.DEPTH_TEST);
      const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
      if (fence) drawing = { fence, began };
    },
    get busy() {
      return drawing !== undefined;
    },
    finished(now) {
      if (!drawing || gl.getSyncParameter(drawing.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return undefined;
      const { fence, began } = drawing;
      gl.deleteSync(fence);
      drawing = undefined;
      return now - began;
    },
    dispose() {
      gl.getExtension("WEBGL_lose_context")?.loseContext();
    },
  };
}

function textureOf(gl: WebGL2RenderingContext, unit: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST); // integers have no other filter
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

/** Returns the places of a program's uniforms by name, each asked for once. */
function uniformsOf(gl: WebGL2RenderingContext, program: WebGLProgram): (name: string) => WebGLUniformLocation | null {
  const known = new Map<string, WebGLUniformLocation | null>();
  return (name) => {
    if (!known.has(name)) known.set(name, gl.getUniformLocation(program, name));
    return known.get(name)!;
  };
}

const kGrid = [0.23, 0.28, 0.3] as const;
const kLines = [0.95, 1, 0.97] as const;
const kThrough = 0.3; // opacity of lines in front of everything

/** A painter of the ground: a grid of one metre with the field's lines in it. */
function groundOf(gl: WebGL2RenderingContext, program: WebGLProgram) {
  const buffer = gl.createBuffer();
  const [uniform, place] = [uniformsOf(gl, program), gl.getAttribLocation(program, "place")];
  let [known, gridEnds, allEnds] = ["", 0, 0];

  function fill(field: Field) {
    const grid = gridOf(field);
    const ends = [...grid, ...linesOf(field).flat()];
    [gridEnds, allEnds] = [grid.length, ends.length];
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(ends.flatMap(({ x, y }) => [x, y])), gl.STATIC_DRAW);
  }
  return {
    draw(field: Field, clip: Float32Array, opacity: number) {
      gl.useProgram(program);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      if (known !== (known = JSON.stringify(field))) fill(field);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 2, gl.FLOAT, false, 0, 0);
      gl.uniformMatrix4fv(uniform("clip_from_field"), false, clip);
      gl.uniform4f(uniform("ink"), ...kGrid, opacity);
      gl.drawArrays(gl.LINES, 0, gridEnds);
      gl.uniform4f(uniform("ink"), ...kLines, opacity);
      gl.drawArrays(gl.LINES, gridEnds, allEnds - gridEnds);
      gl.disableVertexAttribArray(place);
    },
  };
}

/** Both ends of each line of a grid of one metre over the carpet. */
function gridOf({ length, width, border }: Field): { x: number; y: number }[] {
  const [right, top] = [Math.ceil(length / 2 + border), Math.ceil(width / 2 + border)];
  const along = Array.from({ length: 2 * right + 1 }, (_, i) => i - right);
  const across = Array.from({ length: 2 * top + 1 }, (_, i) => i - top);
  return [
    ...along.flatMap((x) => [
      { x, y: -top },
      { x, y: top },
    ]),
    ...across.flatMap((y) => [
      { x: -right, y },
      { x: right, y },
    ]),
  ];
}
