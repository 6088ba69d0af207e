/** The fifteen skies of CIE S 011 and the older clear sky. */

import { TABLES } from "../core/tables";
import type { Vec3 } from "../core/vector";
import { elevation } from "../core/vector";
import { fromPerez, overcast, withClearLevel, withZenith } from "./level";
import type { Letters } from "./sky";

const TABLE: Record<string, number[]> = TABLES.cie;

/** Relative letters of a type, 1 to 15; C = 1 - c exp(d pi / 2). */
export function cieLetters(type: number): Letters {
  const five = [..."abcde"].map((letter) => TABLE[letter][type - 1]);
  return fromPerez(1, five, 1 - five[2] * Math.exp((five[3] * Math.PI) / 2));
}

/** The letters with the usual level: an overcast sky's up to type 6, a clear one's above. */
export function levelledCie(type: number, sun: Vec3, turbidity: number): Letters {
  const relative = cieLetters(type);
  if (type > 6) return withClearLevel(relative, sun, turbidity);
  return withZenith(relative, Math.PI / 2 - elevation(sun), overcast(sun, turbidity));
}

/** Kittler's clear sky with the usual level. */
export function levelledClear(sun: Vec3, turbidity: number): Letters {
  return withClearLevel(TABLES.clearShape, sun, turbidity);
}
