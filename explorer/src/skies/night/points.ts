/** Stars and planets as points of light through the air. */

import table from "../../data/night.json";
import { numbersOf } from "../../core/digits";
import { DEG, elevation, type Vec3 } from "../../core/vector";
import { turned, type Heavens } from "../../sun/heavens";
import { planetsOver } from "../../sun/planets";
import type { Points } from "../sky";
import { atTurbidity, between, lifted, RINGS, ringOf } from "./air";

/** Stars in the axes of J2000, three numbers each, and X, Y and Z outside the air, lx. */
let catalogue: Points | null = null;

function stars(): Points {
  if (catalogue) return catalogue;
  const [along, north, magnitude, hue] = [table.stars.along, table.stars.north, table.stars.magnitude, table.stars.hue].map(numbersOf);
  const made: Points = { toward: new Float32Array(3 * along.length), light: new Float32Array(3 * along.length) };
  along.forEach((a, k) => {
    const level = Math.cos(north[k]);
    made.toward.set([level * Math.cos(a), level * Math.sin(a), Math.sin(north[k])], 3 * k);
    made.light.set(lightOf(magnitude[k], hue[k]), 3 * k);
  });
  return (catalogue = made);
}

/** XYZ outside the air, lx, of a magnitude in V and a colour B - V. */
function lightOf(magnitude: number, hue: number): Vec3 {
  const level = table.zero * 10 ** (-0.4 * magnitude);
  const [first, share] = between(table.hues, hue);
  return table.xyz[first].map((value, c) => level * (value * (1 - share) + table.xyz[first + 1][c] * share)) as unknown as Vec3;
}

/** Those above the horizon, lifted and dimmed by the usual air of a turbidity. */
export function pointsOver(heavens: Heavens, utc: number, turbidity: number): Points {
  const left = atTurbidity(table.left, turbidity);
  const [toward, light]: [number[], number[]] = [[], []];
  const add = (at: Vec3, x: number, y: number, z: number): void => {
    if (at[2] < -0.01) return;
    const seen = lifted(elevation(at) / DEG) * DEG;
    if (seen < 0) return;
    const ring = Math.min(ringOf(seen), RINGS - 1.000001);
    const [first, share] = [Math.floor(ring), ring % 1];
    const stays = [0, 1, 2].map((c) => Math.exp(left[c * RINGS + first] * (1 - share) + left[c * RINGS + first + 1] * share));
    const flat = Math.cos(seen) / Math.hypot(at[0], at[1]);
    toward.push(at[0] * flat, at[1] * flat, Math.sin(seen));
    light.push(x * stays[0], y * stays[1], z * stays[2]);
  };
  const known = stars();
  for (let k = 0; k < known.toward.length; k += 3) {
    const at = turned(heavens.stars, [known.toward[k], known.toward[k + 1], known.toward[k + 2]]);
    add(at, known.light[k], known.light[k + 1], known.light[k + 2]);
  }
  for (const { toward: at, magnitude, hue } of planetsOver(heavens, utc)) add(at, ...lightOf(magnitude, hue));
  return { toward: Float32Array.from(toward), light: Float32Array.from(light) };
}
