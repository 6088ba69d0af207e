/** The moon over a place: where it stands, how much of it is lit, and its light over the sun's. */

import table from "../data/moon.json";
import { DEG, polynomial, scaled, sum, unit, dot, type Vec3 } from "../core/vector";
import { centuries, eclipticSun, fromPlace, sunOver, type Place } from "./position";

export interface Moon {
  toward: Vec3;
  /** Angular radius, radians. */
  radius: number;
  /** Share of the disc that is lit. */
  lit: number;
  waxing: boolean;
  /** Its light above the air over that of a sun 1 AU away, in X, Y and Z. */
  light: Vec3;
}

interface Series {
  powers: number[];
  terms: number[][];
}

function series({ powers, terms }: Series, phases: number[], t: number, wave: (x: number) => number): number {
  return terms.reduce(
    (total, [d, m, moon, f, amplitude]) => total + amplitude * wave(d * phases[0] + m * phases[1] + moon * phases[2] + f * phases[3]),
    polynomial(powers, t));
}

/** Longitude and latitude in the mean ecliptic of date, radians, and distance from the earth's centre, AU. */
function eclipticMoon(utc: number): [number, number, number] {
  const t = centuries(utc);
  const [mean, ...phases] = table.arguments.map((row) => polynomial(row, t) * DEG);
  const { sin, cos } = Math;
  return [mean + series(table.longitude, phases, t, sin), series(table.latitude, phases, t, sin), series(table.distance, phases, t, cos)];
}

/** log10 of the light over the sun's at a phase angle in degrees. */
function brightness(degrees: number, waxing: boolean): number[] {
  const { phases } = table;
  const k = Math.min(Math.max(phases.findIndex((phase) => phase >= degrees), 1), phases.length - 1);
  const share = (degrees - phases[k - 1]) / (phases[k] - phases[k - 1]);
  const rows = waxing ? table.waxing : table.waning;
  return rows[k].map((value, c) => rows[k - 1][c] * (1 - share) + value * share);
}

/** The moon over a place at milliseconds since 1970. */
export function moonOver(place: Place, utc: number): Moon {
  const [along, high, far] = eclipticMoon(utc);
  const seen = fromPlace(place, utc, along, high, far);
  const distance = Math.hypot(...seen);
  const sun = sunOver(place, utc);
  const back = sum(scaled(sun.toward, sun.distance), scaled(seen, -1));
  const cosine = -dot(unit(back), unit(seen));
  const waxing = Math.sin(along - eclipticSun(utc)[0]) > 0;
  const nearness = (table.meanDistance / distance) ** 2 / dot(back, back);
  const log = brightness(Math.acos(Math.min(1, Math.max(-1, cosine))) / DEG, waxing);
  return {
    toward: unit(seen), radius: Math.asin(table.radius / distance), lit: (1 + cosine) / 2, waxing,
    light: log.map((value) => 10 ** value * nearness) as unknown as Vec3,
  };
}
