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

/** The same, such that the sky has light. */
function guarded(index: number, delta: number, zenith: number): number[] {
  const first = letters(index, delta, zenith);
  const dark = first[1] >= 0 && first[0] < -1;
  const found = dark ? letters(index, Math.max(delta, TABLES.perez.leastBrightness), zenith) : first;
  return [found[0], Math.min(found[1], 0), ...found.slice(2)];
}

export interface AllWeather {
  letters: Letters;
  /** Luminous efficacy of the direct irradiance, lm W-1, times it: lx facing the sun. */
  directNormal: number;
}

/** Letters and direct illuminance from direct normal and diffuse horizontal irradiance, W m-2. */
export function allWeather(sun: Vec3, direct: number, diffuse: number, dewPoint: number, distance = 1): AllWeather {
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
  const relative = fromPerez(1, guarded(index, delta, zenith));
  return {
    letters: withIlluminance(relative, zenith, diffuse * ofDiffuse),
    directNormal: direct * Math.max(ofDirect, 0),
  };
}
