/** What all skies are made with. */

import { azimuth, direction, type Vec3 } from "../core/vector";
import { discOf } from "./disc";
import type { Conditions } from "./model";
import type { Recipe, Sky } from "./sky";

/** Overcast up to the horizon: no sky before sunrise but the physical one. */
export function base(name: string, c: Conditions, recipe: Recipe, ground: number, notes: string[] = []): Sky {
  return { name, sun: c.sun, recipe, day: c.sun[2] > 0, ground, disc: null, spectrum: null, points: null, notes };
}

/** Models need a sun above the horizon for their numbers; below it their light is 0 anyhow. */
export function risen(sun: Vec3): Vec3 {
  return sun[2] > 0 ? sun : direction(azimuth(sun), 1e-6);
}

export function withDisc(sky: Sky, c: Conditions, turbidity: number, lux: number | null = null): Sky {
  return { ...sky, disc: discOf(c.sun, turbidity, c.radius, lux) };
}
