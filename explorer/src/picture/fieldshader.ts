/** The shader of skies of fields: physical ones, under cloud, and at night. */

import { CROWDED } from "../skies/fields/map";
import { COLUMNS, RINGS } from "../skies/night/glow";
import { ROWS, TURNS } from "../skies/physical/grid";
import type { Fields, Law } from "../skies/sky";

/** GLSL of a phase function of `away`, 1 - cosine. */
function phaseText(law: Law): string {
  const n = (value: number): string => `float(${value.toPrecision(9)})`;
  const lobes = law.lobes.map(([a, b, g]) => `lobe(${n(a)}, ${n(b)}, ${n(g)}, away, squared)`);
  return [`${n(law.constant)} + ${n(law.square)} * squared`, ...lobes].join(" + ");
}

/** Which of the laws is the aerosol's, which changes with its kind. */
const AEROSOL = 1;

/** GLSL of a physical sky: four taps in a table of fields, for each of sun, moon and cloud that is there, and the night's glow. */
export function fieldsSky(fields: Fields): string {
  return `
uniform sampler2D grid;
uniform sampler2D moon_grid;
uniform sampler2D layer_grid;
uniform sampler2D layer_phases;
uniform vec3 seen;
uniform vec3 moon_seen;
uniform float lit;
uniform bool clear;
uniform bool moonlit;
uniform bool layered;
uniform sampler2D glow_grid;
uniform bool glowing;
uniform sampler2D clouds_left;
uniform sampler2D clouds_added;
uniform bool clouded;
uniform vec3 haze;
float lobe(float a, float b, float g, float away, float squared) {
    float gap = (1.0 - g) * (1.0 - g) + 2.0 * g * away;
    return (a + b * squared) / (gap * sqrt(gap));
}
/* The angle whose tangent is across / along: some drivers have another where nothing is across. */
float bearing(float across, float along) {
    return atan(abs(across) < 1.0e-6 ? 1.0e-6 : across, along);
}
vec3 cell(sampler2D grid, int row, int turn, vec4 shapes) {
    vec3 light = vec3(0.0);
    for (int k = 0; k < 4; k++) light += shapes[k] * texelFetch(grid, ivec2(4 * turn + k, row), 0).rgb;
    return light;
}
vec3 taps(sampler2D grid, vec3 seen, vec3 d, vec4 shapes) {
    float up = clamp(d.z, ${fields.leastCosine.toFixed(6)}, 1.0);
    float row = sqrt(max(0.0, 1.0 - skydome_angle(0.5 * (1.0 - up)) / ${Math.acos(fields.leastCosine).toFixed(9)})) * ${(ROWS - 1).toFixed(1)};
    float level = d.x * seen.x + d.y * seen.y;
    float turn = bearing(abs(d.x * seen.y - d.y * seen.x), level) / PI * ${(TURNS - 1).toFixed(1)};
    int i = int(min(floor(row), ${(ROWS - 2).toFixed(1)})), j = int(min(floor(turn), ${(TURNS - 2).toFixed(1)}));
    float a = row - float(i), b = turn - float(j);
    return mix(mix(cell(grid, i, j, shapes), cell(grid, i, j + 1, shapes), b), mix(cell(grid, i + 1, j, shapes), cell(grid, i + 1, j + 1, shapes), b), a);
}
vec3 of_lamp(sampler2D grid, vec3 seen, vec3 d) {
    vec3 apart = d - seen;
    float away = 0.5 * dot(apart, apart), squared = (1.0 - away) * (1.0 - away);
    vec4 shapes = vec4(${fields.laws.map((law, k) => (k === AEROSOL ? "lobe(haze.x, haze.y, haze.z, away, squared)" : phaseText(law))).join(", ")}, 1.0);
    return taps(grid, seen, d, shapes);
}
vec3 of_layer(vec3 d) {
    vec3 apart = d - sun;
    float last = float(textureSize(layer_phases, 0).x - 1);
    float place = sqrt(skydome_angle(min(1.0, 0.25 * dot(apart, apart))) / PI) * last;
    float first = min(floor(place), last - 1.0);
    ivec2 at = ivec2(int(first), 0);
    vec3 shapes = mix(texelFetch(layer_phases, at, 0).rgb, texelFetch(layer_phases, at + ivec2(1, 0), 0).rgb, place - first);
    return max(taps(layer_grid, sun, d, vec4(shapes, 1.0)), 0.0);
}
vec3 of_glow(vec3 d) {
    float high = 0.5 * PI - skydome_angle(0.5 * (1.0 - clamp(d.z, 0.0, 1.0)));
    float row = pow(max(high, 0.0) / (0.5 * PI), 1.0 / 3.0) * ${(RINGS - 1).toFixed(1)};
    float column = mod(bearing(d.x, d.y), 2.0 * PI) / (2.0 * PI) * ${(COLUMNS - 1).toFixed(1)};
    int i = int(min(floor(row), ${(RINGS - 2).toFixed(1)})), j = int(min(floor(column), ${(COLUMNS - 2).toFixed(1)}));
    float a = row - float(i), b = column - float(j);
    vec3 upper = mix(texelFetch(glow_grid, ivec2(j, i), 0).rgb, texelFetch(glow_grid, ivec2(j + 1, i), 0).rgb, b);
    return mix(upper, mix(texelFetch(glow_grid, ivec2(j, i + 1), 0).rgb, texelFetch(glow_grid, ivec2(j + 1, i + 1), 0).rgb, b), a);
}
vec3 behind_clouds(vec3 light, vec3 d) {
    float high = 0.5 * PI - skydome_angle(0.5 * (1.0 - clamp(d.z, 0.0, 1.0)));
    vec2 place = vec2(bearing(d.x, d.y) / (2.0 * PI), pow(max(high, 0.0) / (0.5 * PI), ${(1 / CROWDED).toFixed(9)}));
    return max(light * texture(clouds_left, place).rgb + texture(clouds_added, place).rgb, 0.0);
}
vec3 sky_xyz(vec3 d) {
    vec3 light = clear ? of_lamp(grid, seen, d) : vec3(0.0);
    if (moonlit) light += of_lamp(moon_grid, moon_seen, d);
    if (glowing) light += of_glow(d);
    if (clouded) light = behind_clouds(light, d);
    if (layered) light += of_layer(d);
    return lit * light;
}
`;
}
