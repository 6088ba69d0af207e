/** Points of light added to the light of a sky: each a spot as wide as a lens makes it, its energy kept. */

import type { Points } from "../skies/sky";
import { DOME_SIZE, type View } from "./view";

/** Pixels across of a spot's square, and the spot's standard deviation. */
const [WIDE, BLUR] = [5, 0.7];

const VERTEX = `#version 300 es
precision highp float;
in vec3 place;
in vec3 flux;
uniform bool dome;
uniform vec4 span;
uniform vec2 size;
out vec3 light;
const float PI = 3.14159265358979;
void main() {
    float zenith = acos(clamp(place.z, -1.0, 1.0));
    float solid;
    vec2 at;
    if (dome) {
        float across = ${DOME_SIZE.toFixed(4)} * min(size.x, size.y);
        vec2 p = vec2(-place.x, place.y) / max(length(place.xy), 1.0e-9) * zenith / (0.5 * PI);
        at = p * across / size;
        float step = PI / across;
        solid = step * step * sin(zenith) / max(zenith, 1.0e-6);
    } else {
        float turn = mod(atan(place.x, place.y) - span.x, 2.0 * PI) / span.y;
        float down = (span.z - 0.5 * PI + zenith) / span.w;
        at = vec2(2.0 * turn - 1.0, 1.0 - 2.0 * down);
        solid = span.y * span.w / (size.x * size.y) * max(sin(zenith), 1.0e-3);
    }
    gl_Position = vec4(at, 0.0, 1.0);
    gl_PointSize = ${WIDE.toFixed(1)};
    light = flux / solid;
}
`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 light;
out vec4 colour;
void main() {
    vec2 apart = (gl_PointCoord - 0.5) * ${WIDE.toFixed(1)};
    colour = vec4(light * exp(-dot(apart, apart) / ${(2 * BLUR * BLUR).toFixed(6)}) / ${(2 * Math.PI * BLUR * BLUR).toFixed(6)}, 0.0);
}
`;

export const POINTS_SHADERS: [string, string] = [VERTEX, FRAGMENT];
const [PLACE, FLUX] = [1, 2];
export const POINTS_NAMES = { place: PLACE, flux: FLUX };

export class PointDrawer {
  private buffers: WebGLBuffer[];
  private shown: Points | null = null;

  constructor(private gl: WebGL2RenderingContext) {
    this.buffers = [gl.createBuffer()!, gl.createBuffer()!];
  }

  /** Draw into the float texture in use, of a size in pixels, with a program of `POINTS_SHADERS`. */
  draw(program: WebGLProgram, points: Points, view: View, width: number, height: number): void {
    const { gl } = this;
    gl.useProgram(program);
    [points.toward, points.light].forEach((numbers, k) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[k]);
      if (this.shown !== points) gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      gl.enableVertexAttribArray(k === 0 ? PLACE : FLUX);
      gl.vertexAttribPointer(k === 0 ? PLACE : FLUX, 3, gl.FLOAT, false, 0, 0);
    });
    this.shown = points;
    gl.uniform1i(gl.getUniformLocation(program, "dome"), Number(view.dome));
    gl.uniform4f(gl.getUniformLocation(program, "span"), view.left, view.across, view.top, view.down);
    gl.uniform2f(gl.getUniformLocation(program, "size"), width, height);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.POINTS, 0, points.toward.length / 3);
    gl.disable(gl.BLEND);
    for (const attribute of [PLACE, FLUX]) gl.disableVertexAttribArray(attribute);
  }
}
