/** The planets over a place: Kepler's orbits (`scripts/fit_planets.py`), magnitudes by Mallama and Hilton 2018. */

import table from "../data/night.json";
import { DEG, dot, polynomial, scaled, sum, unit, type Vec3 } from "../core/vector";
import { transposed, turned, type Heavens } from "./heavens";
import { centuries } from "./position";

export interface Planet {
  name: string;
  toward: Vec3;
  magnitude: number;
  /** B - V. */
  hue: number;
}

/** Centuries that light takes for an astronomical unit. */
const LIGHT = 0.0057755183 / 36525;

/** From the sun, AU, in the ecliptic of J2000: the steps of `fit_planets.place`. */
function placeOf(orbit: number[], t: number): Vec3 {
  const [a, k, h, q, p, longitude] = [0, 1, 2, 3, 4, 5].map((n) => orbit[n] + orbit[n + 6] * t);
  let anomaly = longitude;
  for (let step = 0; step < 12; step++) anomaly = longitude + k * Math.sin(anomaly) - h * Math.cos(anomaly);
  const [c, s, root] = [Math.cos(anomaly), Math.sin(anomaly), 1 / (1 + Math.sqrt(1 - k * k - h * h))];
  const x = a * ((1 - h * h * root) * c + h * k * root * s - k);
  const y = a * ((1 - k * k * root) * s + h * k * root * c - h);
  const [turn, out] = [1 + Math.sqrt(Math.max(0, 1 - q * q - p * p)), p * x - q * y];
  return [x - (p * out) / turn, y + (q * out) / turn, -out];
}

/** Magnitude from the vectors sun to planet and earth to planet, AU, in the ecliptic of J2000. */
function magnitudeOf(name: string, powers: number[], there: Vec3, vector: Vec3): number {
  const [fromSun, far] = [Math.hypot(...there), Math.hypot(...vector)];
  const phase = Math.acos(Math.min(1, Math.max(-1, dot(there, vector) / (fromSun * far)))) / DEG;
  const own = name === "Venus" && phase > 163.7 ? table.farVenus : name === "Mars" && phase > 50 ? table.farMars : powers;
  const rings = name === "Saturn" ? ringsOf(there, vector, phase) : 0;
  return polynomial(own, phase) + rings + 5 * Math.log10(fromSun * far);
}

/** What Saturn's rings add: by how far earth and sun stand above their plane. */
function ringsOf(there: Vec3, vector: Vec3, phase: number): number {
  const [x, y, z] = table.pole;
  const [c, s] = [Math.cos(table.obliquity), Math.sin(table.obliquity)];
  const pole: Vec3 = [x, c * y + s * z, c * z - s * y];
  const [ofSun, ofEarth] = [there, vector].map((way) => -dot(pole, unit(way)));
  const sine = Math.sqrt(Math.max(0, ofSun * ofEarth));
  return -1.825 * sine - 0.378 * sine * Math.exp(-2.25 * phase);
}

/** Where they stand, above the horizon or not. */
export function planetsOver(heavens: Heavens, utc: number): Planet[] {
  const t = centuries(utc);
  const [along, distance] = heavens.sun;
  const earth = scaled(turned(transposed(heavens.moved), [Math.cos(along), Math.sin(along), 0]), -distance);
  return Object.entries(table.planets).map(([name, { orbit, hue, magnitude }]) => {
    let there = placeOf(orbit, t);
    for (let step = 0; step < 2; step++) there = placeOf(orbit, t - LIGHT * Math.hypot(...sum(there, scaled(earth, -1))));
    const vector = sum(there, scaled(earth, -1));
    return { name, toward: turned(heavens.ecliptic, unit(vector)), magnitude: magnitudeOf(name, magnitude, there, vector), hue };
  });
}
