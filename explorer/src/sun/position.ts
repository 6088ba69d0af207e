/** Where the sun stands over a place: the steps of NREL's Solar Position Algorithm (Reda and Andreas 2004). */

import { TABLES } from "../core/tables";
import { DEG, polynomial, unit, type Vec3 } from "../core/vector";

export interface Place {
  latitude: number;
  longitude: number;
}

const J2000 = Date.UTC(2000, 0, 1, 12);
const ABERRATION = (20.4898 / 3600) * DEG;
const AU = 149597870700;
const EARTH = { radius: 6378137, flattening: 1 / 298.257223563 };

/** Terrestrial minus universal time, s, in a decimal year (Espenak and Meeus 2006). */
function deltaT(year: number): number {
  let seconds = -20 + 32 * ((year - 1820) / 100) ** 2;
  for (const [first, origin, unitYears, coefficients] of TABLES.sun.deltaT as [number, number, number, number[]][]) {
    if (year >= first) seconds = polynomial(coefficients, (year - origin) / unitYears);
  }
  return seconds;
}

/** Longitude (0), latitude (1), radians, or distance (2), AU, of the earth from the sun (VSOP87D). */
function heliocentric(quantity: number, t: number): number {
  let total = 0;
  for (const [which, power, amplitude, phase, rate] of TABLES.sun.vsop87) {
    if (which === quantity) total += t ** power * amplitude * Math.cos(phase + rate * t);
  }
  return total * 1e-8;
}

/** Nutation in longitude and obliquity, radians: the four largest terms (Meeus 1998, chapter 22). */
function nutation(centuries: number): [number, number] {
  const node = (125.04452 - 1934.136261 * centuries) * DEG;
  const sun = 2 * (280.4665 + 36000.7698 * centuries) * DEG;
  const moon = 2 * (218.3165 + 481267.8813 * centuries) * DEG;
  const { sin, cos } = Math;
  const longitude = -17.2 * sin(node) - 1.32 * sin(sun) - 0.23 * sin(moon) + 0.21 * sin(2 * node);
  const obliquity = 9.2 * cos(node) + 0.57 * cos(sun) + 0.1 * cos(moon) - 0.09 * cos(2 * node);
  return [(longitude / 3600) * DEG, (obliquity / 3600) * DEG];
}

/** Greenwich mean sidereal time, radians (Meeus 1998, eq. 12.4). */
function siderealTime(days: number): number {
  const t = days / 36525;
  return (280.46061837 + 360.98564736629 * days + 0.000387933 * t * t - (t * t * t) / 38710000) * DEG;
}

/** Days since J2000, of clocks, and thousands of years of even time. */
function elapsed(utc: number): [number, number] {
  const days = (utc - J2000) / 86400e3;
  return [days, (days + deltaT(2000 + days / 365.2425) / 86400) / 365250];
}

/** Centuries of terrestrial time since J2000. */
export const centuries = (utc: number): number => 10 * elapsed(utc)[1];

/** The sun's longitude and latitude in the mean ecliptic of date, radians, and its distance, AU. */
export function eclipticSun(utc: number): [number, number, number] {
  const [, t] = elapsed(utc);
  const distance = heliocentric(2, t);
  return [heliocentric(0, t) + Math.PI - ABERRATION / distance, -heliocentric(1, t), distance];
}

/** What stands at a longitude and latitude of the mean ecliptic of date, radians, so far from the earth's centre, AU. */
function apparent(utc: number, longitude: number, high: number, distance: number): Vec3 {
  const [days, t] = elapsed(utc);
  const [inLongitude, inObliquity] = nutation(10 * t);
  const along = longitude + inLongitude;
  const oblique = (polynomial(TABLES.sun.obliquity, t / 10) / 3600) * DEG + inObliquity;
  const [x, y, z] = [Math.cos(along) * Math.cos(high), Math.sin(along) * Math.cos(high), Math.sin(high)];
  const [c, s] = [Math.cos(oblique), Math.sin(oblique)];
  const equatorial = [x, c * y - s * z, s * y + c * z];
  const turn = siderealTime(days) + inLongitude * c;
  const [ct, st] = [Math.cos(turn), Math.sin(turn)];
  return [
    distance * (ct * equatorial[0] + st * equatorial[1]),
    distance * (ct * equatorial[1] - st * equatorial[0]),
    distance * equatorial[2],
  ];
}

/** Unit vector toward the true sun over a place, and its distance from the earth, AU. */
export function sunOver(place: Place, utc: number): { toward: Vec3; distance: number } {
  const [along, high, distance] = eclipticSun(utc);
  return { toward: unit(fromPlace(place, utc, along, high, distance)), distance };
}

/** What stands at a place of the ecliptic as seen from a place on the earth, AU east, north and up. */
export function fromPlace(place: Place, utc: number, along: number, high: number, distance: number): Vec3 {
  const vector = apparent(utc, along, high, distance);
  const [b, l] = [place.latitude * DEG, place.longitude * DEG];
  const e2 = EARTH.flattening * (2 - EARTH.flattening);
  const n = EARTH.radius / Math.sqrt(1 - e2 * Math.sin(b) ** 2) / AU;
  const rest: Vec3 = [
    vector[0] - n * Math.cos(b) * Math.cos(l),
    vector[1] - n * Math.cos(b) * Math.sin(l),
    vector[2] - n * (1 - e2) * Math.sin(b),
  ];
  const east = -Math.sin(l) * rest[0] + Math.cos(l) * rest[1];
  const outward = Math.cos(l) * rest[0] + Math.sin(l) * rest[1];
  const north = -Math.sin(b) * outward + Math.cos(b) * rest[2];
  const up = Math.cos(b) * outward + Math.sin(b) * rest[2];
  return [east, north, up];
}

/** Angular radius of the disc from a distance in AU, radians. */
export function radiusAt(distance: number): number {
  return Math.asin(Math.sin(TABLES.disc.radius) / distance);
}
