/** Hosek and Wilkie 2012: quintic Bezier curves of the sun's height, linear in turbidity and albedo. */

import { TABLES, unpacked, type Packed } from "../core/tables";
import { elevation, limited, type Vec3 } from "../core/vector";
import type { Letters } from "./sky";

const BINOMIAL = [1, 5, 10, 10, 5, 1];

/** Bernstein polynomials in (elevation / 90 deg)^(1/3). */
function controlWeights(height: number): number[] {
  const s = Math.cbrt(limited(height, 1e-12, Math.PI / 2) / (Math.PI / 2));
  return BINOMIAL.map((count, k) => count * s ** k * (1 - s) ** (5 - k));
}

/** R A ... I of every channel of a form. */
export function hosekLetters(form: "xyz" | "rgb" | "spectral", sun: Vec3, turbidity: number, albedo: number): Letters[] {
  const table: Packed = TABLES.hosekWilkie[form];
  const [nodes, grounds, points, channels, count] = table.shape;
  const numbers = unpacked(table);
  const control = controlWeights(elevation(sun));
  const low = limited(Math.floor(turbidity) - 1, 0, nodes - 2);
  const share = turbidity - 1 - low;
  const letters: Letters[] = Array.from({ length: channels }, () => new Array<number>(count).fill(0));
  for (const [t, byHaze] of [[low, 1 - share], [low + 1, share]]) {
    for (const [g, byGround] of [[0, 1 - albedo], [1, albedo]]) {
      control.forEach((weight, p) => {
        const first = ((t * grounds + g) * points + p) * channels * count;
        const factor = byHaze * byGround * weight;
        letters.forEach((row, c) => row.forEach((_, k) => (row[k] += factor * numbers[first + c * count + k])));
      });
    }
  }
  return letters;
}
