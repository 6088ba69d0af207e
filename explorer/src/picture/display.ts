/** The shader that develops a picture: exposure and film curve, false colour, or the difference of two skies. */

import { HEAD } from "./shaders";

/** Nine colours of viridis (CC0), evenly spaced. */
export const VIRIDIS = [
  [0.267, 0.005, 0.329], [0.279, 0.175, 0.483], [0.23, 0.322, 0.546], [0.173, 0.449, 0.558], [0.128, 0.567, 0.551],
  [0.158, 0.684, 0.502], [0.369, 0.789, 0.383], [0.678, 0.864, 0.19], [0.993, 0.906, 0.144],
];

/** From darker by blue to brighter by red, through near white. */
export const DIVERGING = [
  [0.085, 0.212, 0.425], [0.196, 0.443, 0.682], [0.5, 0.72, 0.855], [0.82, 0.9, 0.945], [0.962, 0.958, 0.953],
  [0.985, 0.84, 0.76], [0.945, 0.6, 0.48], [0.79, 0.29, 0.27], [0.45, 0.06, 0.14],
];

const array = (colours: number[][]): string =>
  `vec3[9](${colours.map((c) => `vec3(${c.map((v) => v.toFixed(4)).join(", ")})`).join(", ")})`;

/** The shader of a mode (0 photograph, 1 false colour, 2 difference): each has a program that does nothing else. */
export const display = (mode: number): string => `${HEAD}
const int mode = ${mode};
uniform sampler2D first;
uniform sampler2D second;
uniform bool two;
uniform float wipe;
uniform float exposure;
uniform vec2 bar;
uniform float stops;
uniform mat3 from_xyz;
uniform vec3 grounds[2];
uniform vec3 suns[2];
uniform float radius;
uniform float pixel;
uniform vec3 paper;
out vec4 colour;

const vec3 VIRIDIS[9] = ${array(VIRIDIS)};
const vec3 DIVERGING[9] = ${array(DIVERGING)};

vec3 viridis(float x) {
    float place = clamp(x, 0.0, 1.0) * 8.0;
    int k = int(min(floor(place), 7.0));
    return mix(VIRIDIS[k], VIRIDIS[k + 1], place - float(k));
}
vec3 diverging(float x) {
    float place = clamp(x, 0.0, 1.0) * 8.0;
    int k = int(min(floor(place), 7.0));
    return mix(DIVERGING[k], DIVERGING[k + 1], place - float(k));
}
float film(float x) {
    x = min(x, 1.0e6);
    return min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
}
vec3 encoded(vec3 x) {
    return mix(12.92 * x, 1.055 * pow(max(x, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}
vec3 developed(vec3 rgb) {
    rgb = max(rgb, 0.0);
    float peak = max(max(rgb.r, rgb.g), rgb.b);
    float mapped = film(peak);
    vec3 coloured = peak > 0.0 ? rgb * (mapped / peak) : rgb;
    float fade = peak / (peak + 4.0);
    return coloured + fade * fade * (mapped - coloured);
}
vec3 within(vec3 rgb, float white) {
    float least = min(min(rgb.r, rgb.g), rgb.b);
    return least < 0.0 ? max(white, 0.0) * (rgb - least) / max(white - least, 1.0e-9) : rgb;
}
vec3 photograph(vec3 xyz) {
    return encoded(developed(exposure * within(from_xyz * xyz, xyz.y)));
}
/* Sunlight spread in the lens: a halo that a photograph of the sun has, and the disc, at least a pixel wide. */
vec3 sunlight(vec3 d, vec3 normal) {
    if (normal.y <= 0.0) return vec3(0.0);
    vec3 apart = d - sun;
    float angle = 2.0 * asin(min(0.5 * length(apart), 1.0));
    float wide = max(radius, 1.5 * pixel);
    float disc = d.z < 0.0 ? 0.0 : 1.0 - smoothstep(wide - pixel, wide + pixel, angle);
    float degrees = angle * 180.0 / PI;
    float halo = 0.7 / (degrees * degrees + 0.12) + 0.004 * exp(-degrees / 9.0);
    return normal * (disc / (PI * wide * wide) + halo);
}
float log10(float x) { return log(max(x, 1.0e-6)) / log(10.0); }
vec3 false_colour(vec3 xyz) {
    float x = (log10(xyz.y) - bar.x) / (bar.y - bar.x);
    vec3 c = viridis(x);
    float level = log10(xyz.y) * 4.0;
    float line = abs(fract(level - 0.5) - 0.5) / max(fwidth(level), 1.0e-4);
    return mix(mix(c, vec3(1.0), 0.35), c, smoothstep(0.4, 1.2, line));
}
vec3 difference(vec3 a, vec3 b) {
    float ratio = log2(max(b.y, 1.0e-6) / max(a.y, 1.0e-6));
    return diverging(0.5 + 0.5 * ratio / stops);
}
void main() {
    vec3 d = toward();
    vec2 place = vec2(uv.x, 1.0 - uv.y);
    vec3 a = texture(first, place).xyz;
    vec3 b = two ? texture(second, place).xyz : a;
    bool right = two && uv.x > wipe;
    bool outside = dome && length(dome_plane()) > 1.0;
    bool sky = d.z >= 0.0 && !outside;
    float edge = dome ? 1.0 - smoothstep(1.0 - pixel / 1.57, 1.0, length(dome_plane())) : 1.0;
    vec3 ground = grounds[right ? 1 : 0];
    vec3 xyz = sky ? (right ? b : a) : ground;
    vec3 shown;
    if (mode == 0) shown = photograph(xyz + sunlight(d, suns[right ? 1 : 0]));
    else if (!sky) shown = vec3(0.16);
    else if (mode == 1) shown = false_colour(xyz);
    else shown = difference(a, b);
    if (outside) shown = paper;
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(mix(paper, shown + (mode == 0 ? grain / 255.0 : 0.0), edge), 1.0);
}
`;
