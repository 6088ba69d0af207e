/** The lights of the night over a place at an hour that are neither sun nor moon. */

import table from "../../data/night.json";
import { DEG } from "../../core/vector";
import { heavensOver } from "../../sun/heavens";
import type { Place } from "../../sun/position";
import type { Points } from "../sky";
import { glowOver } from "./glow";
import { pointsOver } from "./points";

/** Sines of the sun's elevations below which points and glows are more than a thousandth of the sky. */
export const [POINTS_SEEN, GLOWS_SEEN] = [Math.sin(table.seen.points * DEG), Math.sin(table.seen.glows * DEG)];

/** A place and milliseconds since 1970. */
export interface Hour {
  place: Place;
  utc: number;
}

export interface Night {
  points: Points;
  /** Null while twilight is much brighter. */
  glow: Float32Array | null;
}

let last: { key: string; night: Night } | null = null;

/** The lights of an hour in the usual air of a turbidity over a ground, the sun's elevation by its sine; those asked last are kept. */
export function nightOf({ place, utc }: Hour, turbidity: number, albedo: number, sine: number): Night {
  const dark = sine < GLOWS_SEEN;
  const key = [place.latitude, place.longitude, utc, turbidity, albedo, dark].join();
  if (last?.key === key) return last.night;
  const heavens = heavensOver(place, utc, table.obliquity);
  const night = { points: pointsOver(heavens, utc, turbidity), glow: dark ? glowOver(heavens, turbidity, albedo) : null };
  last = { key, night };
  return night;
}
