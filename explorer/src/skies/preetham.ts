/** Preetham, Shirley and Smits 1999: coefficients of the channels x, y, Y (A.2). */

import { TABLES } from "../core/tables";
import { elevation, type Vec3 } from "../core/vector";
import { fromPerez, inZenith } from "./level";
import type { Letters } from "./sky";

const N = TABLES.preetham;

/** A cubic in the sun's zenith angle, quadratic in turbidity. */
function zenithChromaticity(turbidity: number, zenith: number, rows: number[][]): number {
  const cubics = rows.map(([a, b, c, d]) => ((a * zenith + b) * zenith + c) * zenith + d);
  return (cubics[0] * turbidity + cubics[1]) * turbidity + cubics[2];
}

/** Luminance in the zenith, cd m-2. */
function zenithLuminance(turbidity: number, zenith: number): number {
  const [a, b, c, d] = N.zenith_Y;
  const chi = (N.chi[0] * turbidity + N.chi[1]) * (Math.PI - 2 * zenith);
  return 1000 * ((a * turbidity + b) * Math.tan(chi) + c * turbidity + d);
}

/** R A ... I of x, y, Y. */
export function preethamLetters(sun: Vec3, turbidity: number): Letters[] {
  const zenith = Math.min(Math.PI / 2 - elevation(sun), Math.PI / 2);
  const parts: [number[][], number][] = [
    [N.letters_x, zenithChromaticity(turbidity, zenith, N.zenith_x)],
    [N.letters_y, zenithChromaticity(turbidity, zenith, N.zenith_y)],
    [N.letters_Y, zenithLuminance(turbidity, zenith)],
  ];
  return parts.map(([rows, value]) => {
    const five = rows.map(([slope, constant]) => slope * turbidity + constant);
    const relative = fromPerez(1, five);
    return [value / inZenith(relative, zenith), ...relative.slice(1)];
  });
}
