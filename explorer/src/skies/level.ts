/** The level of skies that are known up to a factor: by zenith luminance or illuminance, or the usual one. */

import { TABLES } from "../core/tables";
import { elevation, type Vec3 } from "../core/vector";
import { skydome_angle } from "../data/formula";
import { channelIntegral } from "./integral";
import { channel } from "./light";
import type { Letters } from "./sky";

/** R A ... I of Perez's form: (1 + a exp(b / cos t)) (constant + c exp(d g) + e cos^2 g). */
export function fromPerez(level: number, [a, b, c, d, e]: number[], constant = 1): Letters {
  return [level, a, b, constant, c, d, e, 0, 0, 0];
}

/** The formula in the zenith. */
export function inZenith(letters: Letters, sunZenith: number): number {
  const half = Math.sin(Math.max(sunZenith, 0) / 2) ** 2;
  return channel(letters, false, 1, half, skydome_angle(half));
}

export function withZenith(letters: Letters, sunZenith: number, luminance: number): Letters {
  return withFactor(letters, luminance / inZenith(letters, sunZenith));
}

export function withIlluminance(letters: Letters, sunZenith: number, lux: number): Letters {
  return withFactor(letters, lux / channelIntegral(letters, sunZenith));
}

function withFactor(letters: Letters, factor: number): Letters {
  return [Number.isFinite(factor) ? letters[0] * factor : 0, ...letters.slice(1)];
}

export type Usual = (sun: Vec3, turbidity: number) => number;

/** Zenith luminance of a clear sky, cd m-2 (Karayel et al. 1984), for suns up to `highest`. */
function clearZenith(height: number, turbidity: number): number {
  return 1000 * ((1.376 * turbidity - 1.81) * Math.tan(Math.max(height, 0)) + 0.38);
}

/** Zenith luminance of an overcast sky, cd m-2. */
export const overcast: Usual = (sun) => 1000 * (8.6 * Math.sin(Math.max(elevation(sun), 0)) + 0.123);

/** Zenith luminances, cd m-2, of usual skies under suns up to `highest`, at which those above are held. */
export const usualLevel: Record<"clear" | "middle", Usual> = {
  clear: (sun, turbidity) => clearZenith(Math.min(elevation(sun), TABLES.highest), turbidity),
  middle: (sun, turbidity) => {
    const height = Math.min(elevation(sun), TABLES.highest);
    return (clearZenith(height, turbidity) + overcast([0, Math.cos(height), Math.sin(height)], turbidity)) / 2;
  },
};

/** Letters with the level of a usual clear sky: by zenith luminance, of higher suns by the illuminance at the limit. */
export function withClearLevel(letters: Letters, sun: Vec3, turbidity: number): Letters {
  const height = elevation(sun);
  const luminance = clearZenith(Math.min(height, TABLES.highest), turbidity);
  if (height <= TABLES.highest) return withZenith(letters, Math.PI / 2 - height, luminance);
  const limit = Math.PI / 2 - TABLES.highest;
  const lux = channelIntegral(withZenith(letters, limit, luminance), limit);
  return withIlluminance(letters, Math.PI / 2 - height, lux);
}
