/** The light of a recipe toward a direction, on the processor: for numbers; the shader does the same for pictures. */

import { hosek_channel, skydome_angle, skydome_channel } from "../data/formula";
import { halfSquare, scaled, times, ZENITH, type Vec3 } from "../core/vector";
import { networkLight } from "./network";
import { fieldsLight } from "./physical/fields";
import { shapeAt } from "./shaped";
import type { Formula, Letters, Recipe, Shaped, Sky } from "./sky";

const BLACK: Vec3 = [0, 0, 0];

/** XYZ toward a unit vector, Y in cd m-2; 0 below the horizon and at night; without the sun's disc. */
export function xyzToward(sky: Sky, toward: Vec3): Vec3 {
  return sky.day && toward[2] >= 0 ? recipeLight(sky.recipe, sky.sun, toward) : BLACK;
}

function recipeLight(recipe: Recipe, sun: Vec3, toward: Vec3): Vec3 {
  if (recipe.kind === "network") return networkLight(recipe, sun, toward);
  if (recipe.kind === "fields") return fieldsLight(recipe, toward);
  if (recipe.kind === "shaped") return shapedLight(recipe, sun, toward);
  const half = halfSquare(toward, sun);
  return formulaLight(recipe, Math.max(toward[2], 0), half, skydome_angle(half));
}

function shapedLight({ numbers, level, white }: Shaped, sun: Vec3, toward: Vec3): Vec3 {
  const half = halfSquare(toward, sun);
  const light = level * shapeAt(numbers, Math.max(toward[2], 0), half, skydome_angle(half));
  return scaled(white as unknown as Vec3, light);
}

/** XYZ of the nine-number formula from the view's height and its angle to the sun. */
export function formulaLight(recipe: Formula, up: number, half: number, angle: number): Vec3 {
  const values = recipe.channels.map((letters) => channel(letters, recipe.hosek, up, half, angle));
  return times(recipe.toXYZ, recipe.chromatic ? fromChromaticity(values) : values) as unknown as Vec3;
}

/** X, Y, Z of x, y, Y. */
function fromChromaticity([x, y, luminance]: number[]): number[] {
  const scale = luminance / Math.max(y, 1e-6);
  return [x * scale, luminance, (1 - x - y) * scale];
}

/** One channel of the formula. */
export function channel(letters: Letters, hosek: boolean, up: number, half: number, angle: number): number {
  const [r, a, b, c, d, e, f, g, h, i] = letters;
  return (hosek ? hosek_channel : skydome_channel)(up, half, angle, r, a, b, c, d, e, f, g, h, i);
}

/** XYZ in the zenith, cd m-2. */
export function zenithXYZ(sky: Sky): Vec3 {
  return xyzToward(sky, ZENITH);
}
