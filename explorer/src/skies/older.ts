/** The older skies and those of the weather whose shapes are sums of terms: their numbers, and their level. */

import { TABLES } from "../core/tables";
import { elevation, type Vec3 } from "../core/vector";
import { skydome_angle } from "../data/formula";
import { integralOf } from "./integral";
import { overcast, usualLevel, type Usual } from "./level";
import { byWeather, type Irradiances } from "./perez";
import { brighter, shapeAt, shapeOf, type Corona, type Linear, type Terms } from "./shaped";

/** A shape's numbers and its level, cd m-2 a unit. */
export type Levelled = [number[], number];

const OLDER = TABLES.older;
const OVERCAST: Linear = [1 / 3, 2 / 3, 0, 0];

function inZenith(numbers: number[], sunZenith: number): number {
  const half = Math.sin(sunZenith / 2) ** 2;
  return shapeAt(numbers, 1, half, skydome_angle(half));
}

const onGround = (numbers: number[], sunZenith: number): number => integralOf((up, half, angle) => shapeAt(numbers, up, half, angle), sunZenith);

/** A shape, by the sun's zenith angle, with a usual level: above `highest` by the illuminance that it has there. */
function usually(terms: (sunZenith: number) => Terms, level: Usual, sun: Vec3, turbidity: number): Levelled {
  const zenith = Math.PI / 2 - elevation(sun);
  const limit = Math.PI / 2 - TABLES.highest;
  const numbers = shapeOf(terms(zenith));
  if (zenith >= limit || level === overcast) return [numbers, level(sun, turbidity) / inZenith(numbers, zenith)];
  const there = shapeOf(terms(limit));
  const lux = (level(sun, turbidity) / inZenith(there, limit)) * onGround(there, limit);
  return [numbers, lux / onGround(numbers, zenith)];
}

export const uniform = (sun: Vec3): Levelled => [shapeOf({ linear: [1, 0, 0, 0] }), overcast(sun, 0)];

export const moonSpencer = (sun: Vec3): Levelled => [shapeOf({ linear: OVERCAST }), overcast(sun, 0)];

export const intermediate = (sun: Vec3, turbidity: number): Levelled =>
  usually((zenith) => ({ intermediate: [1, zenith] }), usualLevel.middle, sun, turbidity);

export const pokrowski = (sun: Vec3, turbidity: number): Levelled =>
  usually(() => ({ pokrowski: OLDER.pokrowski as [number, number, number] }), usualLevel.clear, sun, turbidity);

/** Brunger and Hooper's of the nearest kind of weather in their table. */
export function brungerHooper(sun: Vec3, turbidity: number, share: number, clearness: number): Levelled {
  const table = OLDER.brungerHooper;
  const off = table.diffuse_share.map((value, k) => (value - share) ** 2 + (table.clearness[k] - clearness) ** 2);
  const nearest = off.indexOf(Math.min(...off));
  const linear: Linear = [table.a0[nearest], table.a1[nearest], table.a2[nearest], table.a3[nearest]];
  return usually(() => ({ linear }), usualLevel.middle, sun, turbidity);
}

/** Harrison and Coombes' under a share of opaque cloud. */
export function harrisonCoombes(sun: Vec3, turbidity: number, cloud: number): Levelled {
  const terms = (zenith: number): Terms => {
    const up = Math.max(Math.cos(zenith), 1e-6);
    const clear = (1 - cloud) * (1 - Math.exp(-0.53 / up));
    return {
      linear: [cloud * (0.45 + 0.12 * zenith), cloud * 0.43, cloud * 0.72, 1.88],
      coronas: [[clear * 1.63, clear * 53.7, 5.49, clear * 2.04 * up, 0.19]],
    };
  };
  return usually(terms, usualLevel.middle, sun, turbidity);
}

/** The two of four standard skies that the weather lies between, as bright as the diffuse irradiance. */
export function asrc(sun: Vec3, given: Irradiances): Levelled {
  const { epsilon, delta, diffuse, zenith } = byWeather(sun, given);
  const part = (value: number): number => Math.min(1, Math.max(0, value));
  const [low, high] = [epsilon <= 1.2, epsilon > 3];
  const clear = high ? part((epsilon - 3) / 3) : 0;
  const middle = part((epsilon - 1.2) / 1.8);
  const cover = part(Math.max((epsilon - 1) / 0.2, (delta - 0.05) / 0.4));
  const turbid = high ? 1 - clear : low ? 0 : middle;
  const between = high ? 0 : low ? cover : 1 - middle;
  const over = low ? 1 - cover : 0;
  const corona = ([constant, strength, square]: number[]): Terms => ({ coronas: [[constant, strength, 3, square, 0.32]] });
  const unit = (terms: Terms, share: number): Terms => brighter(terms, share / inZenith(shapeOf(terms), zenith));
  const [first, second] = [unit(corona(OLDER.asrc.clear), clear), unit(corona(OLDER.asrc.turbid), turbid)];
  const numbers = shapeOf({
    linear: OVERCAST.map((value) => value * over) as Linear,
    coronas: [first.coronas![0], second.coronas![0]] as [Corona, Corona],
    intermediate: unit({ intermediate: [1, zenith] }, between).intermediate!,
  });
  return [numbers, diffuse / onGround(numbers, zenith)];
}
