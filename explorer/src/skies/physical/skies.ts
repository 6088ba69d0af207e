/** Skies of fields: the physical sky by day and night, its share of cloud, and the overcast sky. */

import { DEG } from "../../core/vector";
import { overcastLight } from "../clouds/overcast";
import { discOf } from "../disc";
import { base, risen, withDisc } from "../made";
import type { Conditions } from "../model";
import { GLOWS_SEEN, nightOf, POINTS_SEEN } from "../night/night";
import type { Fields, Sky } from "../sky";
import { DARK, LAWS, LEAST_COSINE, LOWEST, physicalLight } from "./physical";

/** Sine of the elevation to which a lamp lights the air. */
const END = Math.sin(LOWEST * DEG);
const NIGHT_NOTE = "night: eclipses and the glow of towns are left out";
const NO_STARS = "night: stars, airglow and zodiacal light are left out; the command has them";

/** The physical sky: its table's fields; in twilight too, and under the moon, with the lights of the night. */
export function physical(c: Conditions): Sky {
  const near = c.distance ** -2 * (c.sun[2] > 0 ? 1 - c.cover : 1);
  const ofSun = c.sun[2] > END ? physicalLight(c.sun, c.turbidity, c.albedo, c.air, [near, near, near]) : DARK;
  const { moon } = c;
  const moonlit = moon && c.sun[2] < 0 && moon.toward[2] > END ? physicalLight(moon.toward, c.turbidity, c.albedo, c.air, moon.light) : null;
  const night = c.night && c.sun[2] < POINTS_SEEN ? nightOf(c.night, c.turbidity, c.albedo, c.sun[2]) : null;
  const fields: Fields = { ...ofSun.fields, clear: c.sun[2] > END, moonlit: moonlit?.fields ?? null, glow: night?.glow ?? null };
  const notes = c.sun[2] < GLOWS_SEEN ? [night ? NIGHT_NOTE : NO_STARS] : [];
  const sky = { ...base("physical", c, fields, c.albedo, notes), points: night?.points ?? null };
  const day = c.sun[2] > END || moonlit !== null || night !== null;
  const disc = moonlit ? discOf(moonlit.fields.seen, 3, moon!.radius, moonlit.lux) : discOf(fields.seen, 3, c.radius, ofSun.lux);
  return { ...sky, day, disc };
}

/** The physical sky by day, which holds what is left of it, with a share of an even layer of cloud. */
export function covered(c: Conditions, clear: Sky): Sky {
  if (!(c.cover > 0) || clear.recipe.kind !== "fields") return clear;
  if (c.sun[2] <= 0) return { ...clear, notes: [...clear.notes, "overcast share: by day alone"] };
  const { layer } = overcastLight(c.sun, "water", c.depth, c.albedo, c.distance ** -2, c.cover);
  return { ...clear, recipe: { ...clear.recipe, clear: c.cover < 1, layer }, disc: c.cover < 1 ? clear.disc : null };
}

/** An even layer of cloud over the whole sky. */
export function overcast(c: Conditions): Sky {
  const sun = risen(c.sun);
  const { layer, lux } = overcastLight(sun, c.particles, c.depth, c.albedo, c.distance ** -2, 1);
  const recipe: Fields = { kind: "fields", clear: false, grid: layer.grid, seen: sun, leastCosine: LEAST_COSINE, laws: LAWS, moonlit: null, layer, clouds: null, glow: null };
  return withDisc(base("overcast", c, recipe, c.albedo), c, 3, lux);
}
