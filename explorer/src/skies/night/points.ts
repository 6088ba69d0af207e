/** Stars and planets as points of light through the air. */

import table from "../../data/night.json";
import { numbersOf } from "../../core/digits";
import { DEG, type Vec3 } from "../../core/vector";
import type { Heavens } from "../../sun/heavens";
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

/** Steps of elevation in a degree at which lift and loss are looked up. */
const FINE = 10;
const LEAST = -10;

/** Where what stands at elevations every tenth of a degree from -1 is seen, radians, and what stays of its X, Y and Z. */
function throughAir(turbidity: number): { seen: Float64Array; stays: Float64Array } {
  const left = atTurbidity(table.left, turbidity);
  const count = 91 * FINE + 2;
  const [seen, stays] = [new Float64Array(count), new Float64Array(3 * count)];
  for (let k = 0; k < count; k++) {
    seen[k] = lifted((k + LEAST) / FINE) * DEG;
    const ring = Math.min(ringOf(seen[k]), RINGS - 1.000001);
    const [first, share] = [Math.floor(ring), ring % 1];
    for (let c = 0; c < 3; c++) stays[3 * k + c] = Math.exp(left[c * RINGS + first] * (1 - share) + left[c * RINGS + first + 1] * share);
  }
  return { seen, stays };
}

/** Those above the horizon, lifted and dimmed by the usual air of a turbidity. */
export function pointsOver(heavens: Heavens, utc: number, turbidity: number): Points {
  const { seen, stays } = throughAir(turbidity);
  const known = stars();
  const planets = planetsOver(heavens, utc);
  const most = known.toward.length + 3 * planets.length;
  const [toward, light] = [new Float32Array(most), new Float32Array(most)];
  let count = 0;
  const add = (x: number, y: number, z: number, lights: ArrayLike<number>, at: number): void => {
    const place = Math.max(0, (Math.asin(z) / DEG) * FINE - LEAST);
    const [k, share] = [Math.floor(place), place % 1];
    const high = seen[k] + (seen[k + 1] - seen[k]) * share;
    if (high < 0) return;
    const flat = Math.cos(high) / Math.hypot(x, y);
    toward[count] = x * flat;
    toward[count + 1] = y * flat;
    toward[count + 2] = Math.sin(high);
    for (let c = 0; c < 3; c++) light[count + c] = lights[at + c] * (stays[3 * k + c] + (stays[3 * k + 3 + c] - stays[3 * k + c]) * share);
    count += 3;
  };
  const [a, b, c] = heavens.stars;
  for (let k = 0; k < known.toward.length; k += 3) {
    const [x, y, z] = [known.toward[k], known.toward[k + 1], known.toward[k + 2]];
    const up = c[0] * x + c[1] * y + c[2] * z;
    if (up > -0.015) add(a[0] * x + a[1] * y + a[2] * z, b[0] * x + b[1] * y + b[2] * z, up, known.light, k);
  }
  for (const { toward: at, magnitude, hue } of planets) if (at[2] > -0.015) add(...at, lightOf(magnitude, hue), 0);
  return { toward: toward.slice(0, count), light: light.slice(0, count) };
}
