/** The shaders: a sky's XYZ toward every pixel, and the picture made of one or two of them. */

import { FORMULA, INPUTS } from "../data/shaders";
import { SHAPE_NUMBERS, SHAPE_TEXT } from "../skies/shaped";
import type { Network, Recipe } from "../skies/sky";
import { fieldsSky } from "./fieldshader";
import { DOME_SIZE } from "./view";

export const VERTEX = `#version 300 es
in vec2 corner;
out vec2 uv;
void main() { uv = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y); gl_Position = vec4(corner, 0.0, 1.0); }
`;

export const HEAD = `#version 300 es
precision highp float;
precision highp sampler2D;
in vec2 uv;
uniform bool dome;
uniform vec4 span;
uniform float aspect;
uniform vec3 sun;
const float PI = 3.14159265358979;
vec2 dome_plane() {
    vec2 p = vec2(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y) / ${DOME_SIZE.toFixed(4)};
    return aspect > 1.0 ? vec2(p.x * aspect, p.y) : vec2(p.x, p.y / aspect);
}
/* Sine and cosine to single precision: graphics drivers promise theirs to 5e-4 only. */
vec2 sine_cosine(float x) {
    float quarter = floor(x * (2.0 / PI) + 0.5);
    float r = x - quarter * 1.5703125 - quarter * 4.83826794896619e-4;
    float q = r * r;
    float s = r * (1.0 + q * (-1.66666667e-1 + q * (8.33333333e-3 + q * (-1.98412698e-4 + q * 2.75573e-6))));
    float c = 1.0 + q * (-0.5 + q * (4.16666667e-2 + q * (-1.38888889e-3 + q * 2.48015873e-5)));
    float turn = mod(quarter, 4.0);
    return turn < 0.5 ? vec2(s, c) : turn < 1.5 ? vec2(c, -s) : turn < 2.5 ? vec2(-s, -c) : vec2(-c, s);
}
vec3 toward() {
    if (dome) {
        vec2 p = dome_plane();
        float r = length(p);
        vec2 high = sine_cosine(0.5 * PI * r);
        return r > 0.0 ? vec3(-p.x / r * high.x, p.y / r * high.x, high.y) : vec3(0.0, 0.0, 1.0);
    }
    vec2 turn = sine_cosine(span.x + uv.x * span.y);
    vec2 high = sine_cosine(span.z - uv.y * span.w);
    return vec3(turn * high.y, high.x);
}
`;

const SKY_MAIN = `
uniform bool masked;
out vec4 light;
void main() {
    vec3 d = toward();
    bool outside = dome && length(dome_plane()) > 1.0;
    if (masked && (outside || d.z < 0.0)) { light = vec4(0.0, 0.0, 0.0, outside ? -1.0 : 0.0); return; }
    if (dome && length(dome_plane()) > 1.05) { light = vec4(0.0); return; }
    light = vec4(sky_xyz(d), 1.0);
}
`;

const FORMULA_SKY = `
uniform float letters[30];
uniform int channels;
uniform bool chromatic;
uniform mat3 to_xyz;
float channel(int k, float up, float half_square, float angle) {
    int n = 10 * k;
    return CHANNEL(up, half_square, angle, letters[n], letters[n + 1], letters[n + 2], letters[n + 3], letters[n + 4],
        letters[n + 5], letters[n + 6], letters[n + 7], letters[n + 8], letters[n + 9]);
}
vec3 sky_xyz(vec3 d) {
    float up = max(d.z, 0.0);
    vec3 apart = d - sun;
    float half_square = min(0.25 * dot(apart, apart), 1.0);
    float angle = skydome_angle(half_square);
    vec3 c = vec3(channel(0, up, half_square, angle), 0.0, 0.0);
    if (channels > 1) c.yz = vec2(channel(1, up, half_square, angle), channel(2, up, half_square, angle));
    if (chromatic) { float s = c.z / max(c.y, 1.0e-6); c = vec3(c.x * s, c.z, (1.0 - c.x - c.y) * s); }
    return to_xyz * c;
}
`;

/** Vectors of four that hold so many numbers. */
export const quads = (count: number): number => Math.ceil(count / 4);

/** Numbers of a network as its uniform block has them: rows padded to vectors of four, then the biases. */
export function networkBlock(network: Network): Float32Array {
  const numbers: number[] = [];
  const pad = (): void => {
    while (numbers.length % 4) numbers.push(0);
  };
  for (const rows of network.layers) {
    for (const row of rows) {
      numbers.push(...row.slice(0, -1));
      pad();
    }
    numbers.push(...rows.map((row) => row[row.length - 1]));
    pad();
  }
  numbers.push(...network.toXYZ.flatMap((row) => [...row, ...new Array<number>(4 * quads(row.length) - row.length).fill(0)]));
  return new Float32Array(numbers);
}

/** Four names or zeros as a vector. */
function vectors(names: string[]): string[] {
  const padded = [...names, ...new Array<string>(4 * quads(names.length) - names.length).fill("0.0")];
  return Array.from({ length: padded.length / 4 }, (_, k) => `vec4(${padded.slice(4 * k, 4 * k + 4).join(", ")})`);
}

/** GLSL of a network's light, its numbers in `W`, which `declared` declares. */
export function networkText(network: Network, spelled: Record<string, string>, declared: string): string {
  const lines: string[] = [];
  let at = 0;
  let names = network.inputs.map((_, k) => `i${k}`);
  const declare = (prefix: string): string[] =>
    vectors(names).map((text, k) => (lines.push(`vec4 ${prefix}${k} = ${text};`), `${prefix}${k}`));
  network.layers.forEach((rows, depth) => {
    const from = declare(`s${depth}_`);
    const biases = at + rows.length * from.length;
    const next = rows.map((_, r) => {
      const terms = from.map((name, k) => `dot(W[${at + r * from.length + k}], ${name})`);
      const total = [`W[${biases + (r >> 2)}].${"xyzw"[r % 4]}`, ...terms].join(" + ");
      lines.push(`float z${depth}_${r} = ${total};`);
      const last = depth === network.layers.length - 1;
      const light = network.exponential ? "exp(clamp(Z, -30.0, 30.0))" : "0.5 * Z * Z";
      lines.push(`float n${depth}_${r} = ${(last ? light : "1.0 / (1.0 + Z * Z)").replaceAll("Z", `z${depth}_${r}`)};`);
      return `n${depth}_${r}`;
    });
    at = biases + quads(rows.length);
    names = next;
  });
  const lights = declare("l");
  const xyz = [0, 1, 2].map((r) => lights.map((name, k) => `dot(W[${at + r * lights.length + k}], ${name})`).join(" + "));
  const inputs = network.inputs.map((name, k) => `float i${k} = ${spelled[name]};`);
  return `
${declared}
vec3 sky_xyz(vec3 d) {
    float east = d.x, north = d.y, up = max(d.z, 0.0);
    vec3 apart = d - sun;
    float distance_to_sun = sqrt(dot(apart, apart));
    ${[...inputs, ...lines].join("\n    ")}
    return vec3(${xyz.join(", ")});
}
`;
}

const SHAPED_SKY = `
uniform float n[${SHAPE_NUMBERS}];
uniform vec3 white;
${SHAPE_TEXT}
vec3 sky_xyz(vec3 d) {
    vec3 apart = d - sun;
    float half_square = min(0.25 * dot(apart, apart), 1.0);
    return white * shape_at(max(d.z, 0.0), half_square, skydome_angle(half_square));
}
`;

const block = (network: Network): string =>
  `layout(std140) uniform Weights { vec4 W[${networkBlock(network).length / 4}]; };`;

/** Name of the program that a recipe needs: recipes of one name differ by uniforms alone. */
export function programKey(recipe: Recipe): string {
  if (recipe.kind === "formula") return recipe.hosek ? "hosek" : "formula";
  if (recipe.kind === "fields" || recipe.kind === "shaped") return recipe.kind;
  return `network ${recipe.inputs.join()} ${recipe.layers.map((rows) => rows.length).join()} ${recipe.exponential}`;
}

/** The fragment shader of a recipe's sky. */
export function skyShader(recipe: Recipe): string {
  if (recipe.kind === "network") return HEAD + networkText(recipe, INPUTS, block(recipe)) + SKY_MAIN;
  if (recipe.kind === "fields") return HEAD + FORMULA + fieldsSky(recipe) + SKY_MAIN;
  if (recipe.kind === "shaped") return HEAD + FORMULA + SHAPED_SKY + SKY_MAIN;
  const name = recipe.hosek ? "hosek_channel" : "skydome_channel";
  return HEAD + FORMULA + FORMULA_SKY.replace("CHANNEL", name) + SKY_MAIN;
}
