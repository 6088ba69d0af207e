/** What a field of cloud must know of the clear sky about it, and the sky with the field in it. */

import { DEG, direction, elevation, scaled, sum, type Vec3 } from "../../core/vector";
import { diffuseXYZ } from "../integral";
import { xyzToward } from "../light";
import type { Conditions } from "../model";
import type { Sky } from "../sky";
import type { CloudMap } from "./map";
import type { ClearColours } from "./spectra";

/** Least elevation of the sun, degrees, under which fields are drawn. */
export const LOWEST_SUN = -6;
/** Illuminance, lx, of a sun that is not seen. */
const FAINT = 1e-3;
/** Elevations, even in the root of the sine, and azimuths of a mean sky. */
const [ROWS, AROUND] = [13, 12];

/** Whether a sky is a clear one that clouds can stand in. */
export const isOpen = (sky: Sky): boolean =>
  sky.name === "physical" && sky.recipe.kind === "fields" && sky.recipe.clear && sky.sun[2] > Math.sin(LOWEST_SUN * DEG);

/** The colours of a clear sky that the clouds are lit by, without moon and stars. */
export function clearColours(sky: Sky, c: Pick<Conditions, "turbidity" | "albedo" | "air" | "distance" | "cover">): ClearColours {
  if (sky.recipe.kind !== "fields") throw new Error(`clouds stand in the physical sky, got ${sky.name}`);
  const alone: Sky = { ...sky, points: null, recipe: { ...sky.recipe, moonlit: null, layer: null, glow: null } };
  const mean = Array.from({ length: ROWS }, (_, j) => {
    const height = Math.asin((j / (ROWS - 1)) ** 2);
    let total: Vec3 = [0, 0, 0];
    for (let k = 0; k < AROUND; k++) total = sum(total, scaled(xyzToward(alone, direction((2 * Math.PI * k) / AROUND, height)), 1 / AROUND));
    return total;
  });
  const sun = sky.recipe.seen;
  const lux = sun[2] > 0 && !sky.recipe.moonlit ? (sky.disc?.normal[1] ?? 0) : 0;
  const strength = c.distance ** -2 * (1 - c.cover);
  return { sky: diffuseXYZ(alone), mean, sun, elevation: elevation(sky.sun) / DEG, lux, strength, turbidity: c.turbidity, aerosol: c.air.aerosol, ozone: c.air.ozone, albedo: c.albedo };
}

/** A clear sky with clouds before it. */
export function withClouds(sky: Sky, clouds: CloudMap): Sky {
  if (sky.recipe.kind !== "fields") return sky;
  const normal = sky.disc && scaled(sky.disc.normal, clouds.sun);
  const disc = sky.disc && normal && normal[1] > FAINT ? { ...sky.disc, normal } : null;
  return { ...sky, recipe: { ...sky.recipe, clouds }, points: null, disc };
}
