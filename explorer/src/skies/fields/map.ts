/** Clouds as a map of the dome: what they leave of the clear sky's light toward every direction, and what they add. */

import { azimuth, elevation, limited, wrapped, type Vec3 } from "../../core/vector";

/** Rows from the horizon up: elevations are finest there. */
export const CROWDED = 1.5;

export interface CloudMap {
  width: number;
  height: number;
  /** Share left of X, Y and Z of the clear sky, and XYZ added, cd m-2; rows from the horizon up, columns from north eastward. */
  left: Float32Array;
  added: Float32Array;
  /** Light that the clouds add on the horizontal, XYZ, lx. */
  level: Vec3;
  /** Share of the sun's light that comes straight through. */
  sun: number;
}

/** Elevation, radians, of a place along the rows, 0..1. */
export const heightAt = (v: number): number => (Math.PI / 2) * v ** CROWDED;

/** The sky's light with the clouds before it. */
export function behind({ width, height, left, added }: CloudMap, light: Vec3, toward: Vec3): Vec3 {
  const x = wrapped((azimuth(toward) / (2 * Math.PI)) * width - 0.5, width);
  const y = limited((Math.max(elevation(toward), 0) / (Math.PI / 2)) ** (1 / CROWDED) * height - 0.5, 0, height - 1);
  const [i, j] = [Math.floor(x) % width, Math.min(Math.floor(y), height - 2)];
  const [u, v, i1] = [x - Math.floor(x), y - j, (i + 1) % width];
  const mixed = (numbers: Float32Array, c: number): number => {
    const at = (row: number, column: number): number => numbers[3 * (row * width + column) + c];
    return (at(j, i) * (1 - u) + at(j, i1) * u) * (1 - v) + (at(j + 1, i) * (1 - u) + at(j + 1, i1) * u) * v;
  };
  const of = (c: 0 | 1 | 2): number => Math.max(light[c] * mixed(left, c) + mixed(added, c), 0);
  return [of(0), of(1), of(2)];
}
