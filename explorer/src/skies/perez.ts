/** Perez's all-weather sky (Perez, Seals and Michalsky 1993) and its efficacies (Perez et al. 1990). */

import { TABLES } from "../core/tables";
import { elevation, limited, type Vec3 } from "../core/vector";
import { fromPerez, withIlluminance } from "./level";
import type { Letters } from "./sky";

type Columns = Record<string, number[]>;
const LETTERS: Columns = TABLES.perez.letters;
const EFFICACY: Columns = TABLES.perez.efficacy;

/** Relative optical mass (Kasten 1966). */
function opticalMass(zenith: number): number {
  const z = Math.min(zenith, Math.PI / 2);
  return 1 / (Math.max(Math.cos(z), 0) + 0.15 * (93.885 - (z * 180) / Math.PI) ** -1.253);
}

function clearness(direct: number, diffuse: number, zenith: number): number {
  const cube = 1.041 * zenith ** 3;
  return (1 + direct / Math.max(diffuse, 1e-9) + cube) / (1 + cube);
}

function bin(epsilon: number): number {
  return LETTERS.epsilon.slice(1).filter((bound) => epsilon >= bound).length;
}

/** The letters a to e of a bin (eq. 6-8, Table 1). */
function letters(index: number, delta: number, zenith: number): number[] {
  const x = (letter: string, k: number): number => LETTERS[letter + k][index];
  const usual = [..."abcde"].map((l) => x(l, 1) + x(l, 2) * zenith + delta * (x(l, 3) + x(l, 4) * zenith));
  if (index > 0) return usual;
  const inner = (l: string): number => delta * (x(l, 1) + x(l, 2) * zenith);
  usual[2] = Math.exp(limited(Math.max(inner("c"), 1e-12) ** x("c", 3), 0, 50)) - x("c", 4);
  usual[3] = -Math.exp(limited(inner("d"), -50, 50)) + x("d", 3) + delta * x("d", 4);
  return usual;
}

/** Whether the gradation is negative on so much of the dome. */
function isDark(a: number, b: number): boolean {
  return a < -1 && -b <= (1 - TABLES.perez.mostBlack) * Math.log(-a);
}

/** The same, such that the sky has light. */
function guarded(index: number, delta: number, zenith: number): number[] {
  const first = letters(index, delta, zenith);
  const dark = isDark(first[0], first[1]);
  const found = dark ? letters(index, Math.max(delta, TABLES.perez.leastBrightness), zenith) : first;
  const b = Math.min(found[1], 0);
  return [found[0], isDark(found[0], b) ? 0 : b, ...found.slice(2)];
}

export interface AllWeather {
  letters: Letters;
  /** Luminous efficacy of the direct irradiance, lm W-1, times it: lx facing the sun. */
  directNormal: number;
}

/** What is measured of a sky: irradiances, W m-2, dew point, degrees C; and the sun's distance, AU. */
export interface Irradiances {
  dni: number;
  dhi: number;
  dew: number;
  distance: number;
}

export interface Weather {
  epsilon: number;
  delta: number;
  index: number;
  zenith: number;
  /** Diffuse horizontal illuminance, and the direct one facing the sun, lx. */
  diffuse: number;
  direct: number;
}

/** Clearness, brightness and illuminances by the efficacies of 1990. */
export function byWeather(sun: Vec3, { dni: direct, dhi: diffuse, dew: dewPoint, distance }: Irradiances): Weather {
  const zenith = Math.PI / 2 - elevation(sun);
  const epsilon = clearness(direct, diffuse, zenith);
  const delta = (opticalMass(zenith) * diffuse) / (TABLES.perez.solarConstant / distance ** 2);
  const index = bin(epsilon);
  const water = Math.exp(0.07 * dewPoint - 0.075);
  const k = (kind: string, letter: string): number => EFFICACY[`${kind}_${letter}`][index];
  const rest = [Math.cos(zenith), Math.log(Math.max(delta, 1e-12))];
  const ofDiffuse =
    k("diffuse", "a") + k("diffuse", "b") * water + k("diffuse", "c") * rest[0] + k("diffuse", "d") * rest[1];
  const ofDirect =
    k("direct", "a") + k("direct", "b") * water + k("direct", "c") * Math.exp(5.73 * zenith - 5) + k("direct", "d") * delta;
  return { epsilon, delta, index, zenith, diffuse: diffuse * ofDiffuse, direct: direct * Math.max(ofDirect, 0) };
}

/** Letters and direct illuminance of Perez's sky. */
export function allWeather(sun: Vec3, given: Irradiances): AllWeather {
  const { index, delta, zenith, diffuse, direct } = byWeather(sun, given);
  return { letters: withIlluminance(fromPerez(1, guarded(index, delta, zenith)), zenith, diffuse), directNormal: direct };
}

/** Perez's sky of five letters, of a diffuse illuminance. */
export function byLetters(sun: Vec3, five: number[], lux: number): Letters {
  return withIlluminance(fromPerez(1, five), Math.PI / 2 - elevation(sun), lux);
}

/** Igawa's sky (2014): letters from the clear-sky and the cloudless index. */
export function igawa(sun: Vec3, given: Irradiances): AllWeather {
  const { zenith, diffuse, direct } = byWeather(sun, given);
  const [kc, cle] = igawaIndices(zenith, given);
  const table: Columns = TABLES.igawa;
  const bell = (x: number, at: number, wide: number): number => Math.exp(-(((x - at) / wide) ** 2) / 2);
  const five = [0, 1, 2, 3, 4].map((row) => {
    const [base, ofLight, atLight, wide, ofClear, atClear, broad, ofBoth] = [..."ABCDEFGH"].map((name) => table[name][row]);
    const [light, clear] = [bell(kc, atLight, wide), bell(cle, atClear, broad)];
    return base + ofLight * light + ofClear * clear + ofBoth * light * clear;
  });
  const [a, b, c, d, e] = [five[0], Math.min(five[1], 0), Math.max(five[2], 0), five[3], Math.max(five[4], 0)];
  const relative = fromPerez(1, [a, b, c, d, e], 1 - c * Math.exp((d * Math.PI) / 2));
  return { letters: withIlluminance(relative, zenith, diffuse), directNormal: direct };
}

function igawaIndices(zenith: number, { dni, dhi, distance }: Irradiances): [number, number] {
  const z = Math.min(zenith, Math.PI / 2);
  const mass = 1 / (Math.max(Math.cos(z), 0) + 0.50572 * (96.07995 - (z * 180) / Math.PI) ** -1.6364);
  const height = Math.max(Math.PI / 2 - zenith, 0);
  const whole = dhi + dni * Math.sin(height);
  const standard = ((0.84 * TABLES.perez.solarConstant) / distance ** 2 / mass) * Math.exp(-0.054 * mass);
  const clouds = 0.08302 + 0.5358 * Math.exp(-17.3 * height) + 0.3818 * Math.exp(-3.2899 * height);
  const clear = (1 - dhi / Math.max(whole, 1e-9)) / Math.max(1 - clouds, 1e-3);
  return [limited(whole / standard, 0, TABLES.igawaMost), limited(clear, 0, TABLES.igawaMost)];
}
