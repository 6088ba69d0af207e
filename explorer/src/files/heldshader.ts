/** The physical sky's code for other programs, which reads its numbers, and those numbers: its table in linear sRGB. */

import { TABLES } from "../core/tables";
import { times, type Vec3 } from "../core/vector";
import { HELD } from "../data/shaders";
import { fieldsAt } from "../skies/physical/fields";
import type { Fields } from "../skies/sky";

export type ShaderLanguage = keyof typeof HELD.texts;
export const LANGUAGES = Object.keys(HELD.texts) as ShaderLanguage[];

/** The code in a language; the same for every sun, air and ground. */
export const heldText = (language: ShaderLanguage): string => HELD.texts[language];

/** The numbers in the order in which the code reads them: the sun, the phase functions, the table. */
export function heldNumbers(fields: Fields): number[] {
  const [x, y, z] = fields.seen;
  const level = Math.max(Math.hypot(x, y), 1e-9);
  const numbers = [x, y, z, x / level, y / level];
  for (const { constant, square, lobes } of fields.laws) {
    numbers.push(constant, square);
    for (const [a, b, g] of lobes) numbers.push((1 - g) ** 2, 4 * g, a, b);
  }
  for (let row = 0; row < HELD.heights; row++) {
    const q = row / (HELD.heights - 1);
    for (let turn = 0; turn < HELD.azimuths; turn++) {
      const cell = fieldsAt(fields.grid, fields.leastCosine, 1 - (1 - q * q) ** 2, turn / (HELD.azimuths - 1));
      for (let k = 0; k < 4; k++) {
        const xyz = cell.slice(3 * k, 3 * k + 3) as unknown as Vec3;
        numbers.push(...times(TABLES.colour.srgbFromXYZ, xyz));
      }
    }
  }
  return numbers;
}
