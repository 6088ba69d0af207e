/** From the fixed stars' axes to a place: precession of the ecliptic, the earth's axis and turning. */

import { DEG, type Matrix3, type Vec3 } from "../core/vector";
import { centuries, eclipticSun, fromPlace, type Place } from "./position";

/** Rows that turn by an angle about axis 0 (x) or 2 (z). */
function rotation(axis: 0 | 2, angle: number): Matrix3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return axis === 0 ? [[1, 0, 0], [0, c, s], [0, -s, c]] : [[c, s, 0], [-s, c, 0], [0, 0, 1]];
}

/** A matrix times another, rows first. */
export function product(a: Matrix3, b: Matrix3): Matrix3 {
  return a.map((row) => [0, 1, 2].map((c) => row[0] * b[0][c] + row[1] * b[1][c] + row[2] * b[2][c])) as unknown as Matrix3;
}

export function transposed(m: Matrix3): Matrix3 {
  return [0, 1, 2].map((c) => m.map((row) => row[c])) as unknown as Matrix3;
}

export function turned(m: Matrix3, v: Vec3): Vec3 {
  return m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) as unknown as Vec3;
}

/** From the ecliptic of J2000 to that of date (Meeus 1998, chapter 21). */
function precession(t: number): Matrix3 {
  const [tilt, turn] = [47.0029 * t - 0.03302 * t * t, 5029.0966 * t + 1.11113 * t * t].map((seconds) => (seconds / 3600) * DEG);
  const node = (174.876384 - (869.8089 * t) / 3600) * DEG;
  return product(rotation(2, -node - turn), product(rotation(0, tilt), rotation(2, node)));
}

/** The turn after which longitudes count from `along`. */
export const aboutPole = (along: number): Matrix3 => rotation(2, along);

export interface Heavens {
  /** Rotations to east, north and up: from the stars' axes of J2000, from the ecliptic of J2000, from that of date. */
  stars: Matrix3;
  ecliptic: Matrix3;
  ofDate: Matrix3;
  /** Longitude of the sun in the ecliptic of date, radians, and how far it is, AU. */
  sun: [number, number];
  /** Rotation from the ecliptic of J2000 to that of date. */
  moved: Matrix3;
}

/** So far away that the place on the earth does not matter, AU. */
const FAR = 1e9;

/** The heavens over a place at milliseconds since 1970; `obliquity` of J2000, radians. */
export function heavensOver(place: Place, utc: number, obliquity: number): Heavens {
  const axes = [[0, 0], [Math.PI / 2, 0], [0, Math.PI / 2]].map(([along, high]) => fromPlace(place, utc, along, high, FAR));
  const ofDate = transposed(axes.map((axis) => axis.map((part) => part / FAR)) as unknown as Matrix3);
  const moved = precession(centuries(utc));
  const ecliptic = product(ofDate, moved);
  const [along, , distance] = eclipticSun(utc);
  return { stars: product(ecliptic, rotation(0, obliquity)), ecliptic, ofDate, sun: [along, distance], moved };
}
