/** Vectors in the frame x east, y north, z up; azimuth clockwise from north; angles in radians. */

export type Vec3 = readonly [number, number, number];
export type Matrix3 = readonly [Vec3, Vec3, Vec3];

export const DEG = Math.PI / 180;
export const ZENITH: Vec3 = [0, 0, 1];

/** Unit vector of an azimuth and an elevation. */
export function direction(azimuth: number, elevation: number): Vec3 {
  const level = Math.cos(elevation);
  return [Math.sin(azimuth) * level, Math.cos(azimuth) * level, Math.sin(elevation)];
}

/** Azimuth of a vector, [0, 2 pi). */
export function azimuth(v: Vec3): number {
  const angle = Math.atan2(v[0], v[1]);
  return angle < 0 ? angle + 2 * Math.PI : angle;
}

/** Elevation of a vector above the horizon. */
export function elevation(v: Vec3): number {
  return Math.atan2(v[2], Math.hypot(v[0], v[1]));
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function scaled(v: Vec3, factor: number): Vec3 {
  return [v[0] * factor, v[1] * factor, v[2] * factor];
}

export function sum(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function unit(v: Vec3): Vec3 {
  return scaled(v, 1 / Math.hypot(...v));
}

/** A matrix, rows first, times a column. */
export function times(matrix: readonly (readonly number[])[], v: readonly number[]): number[] {
  return matrix.map((row) => row.reduce((total, weight, k) => total + weight * v[k], 0));
}

/** sin^2 of half the angle between two unit vectors: exact for small angles. */
export function halfSquare(a: Vec3, b: Vec3): number {
  const square = (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
  return Math.min(square / 4, 1);
}

export function limited(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

/** A number brought into [0, period). */
export function wrapped(value: number, period: number): number {
  return ((value % period) + period) % period;
}

/** Coefficients in rising powers at x. */
export function polynomial(coefficients: readonly number[], x: number): number {
  return coefficients.reduceRight((total, c) => total * x + c, 0);
}
