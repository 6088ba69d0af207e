/** Colour temperature: the black body nearest in CIE 1960 u, v (CIE 15; Robertson 1968 with isotherms at 1 mired). */

import { TABLES, unpacked } from "../core/tables";
import type { Vec3 } from "../core/vector";

const LOCUS = TABLES.colour.locus;

/** Correlated colour temperature, K; Infinity for colours bluer than any black body, NaN for black. */
export function colourTemperature([x, y, z]: Vec3): number {
  const total = x + 15 * y + 3 * z;
  if (!(total > 0)) return NaN;
  const [u, v] = [(4 * x) / total, (6 * y) / total];
  const points = unpacked(LOCUS);
  const along = (k: number): number =>
    (u - points[4 * k]) * points[4 * k + 2] + (v - points[4 * k + 1]) * points[4 * k + 3];
  if (along(0) < 0) return Infinity;
  let [low, high] = [0, LOCUS.shape[0] - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (along(middle) >= 0) low = middle;
    else high = middle;
  }
  const [before, after] = [along(low), along(low + 1)];
  if (after > 0) return NaN;
  const mired = low + Math.min(1, Math.max(0, before / (before - after)));
  return mired > 0 ? 1e6 / mired : Infinity;
}

/** CIE x, y of XYZ; NaN for black. */
export function chromaticity([x, y, z]: Vec3): [number, number] {
  const total = x + y + z;
  return total > 0 ? [x / total, y / total] : [NaN, NaN];
}
