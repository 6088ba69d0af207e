/** Skies of shapes that the nine numbers cannot tell: sums of four kinds of terms, whose numbers a model gives. */

import type { Shaped } from "./sky";

/** Where a shape's numbers stand: linear, two coronas, the CIE's intermediate sky, Pokrowski's; 20 in all. */
export const SHAPE_NUMBERS = 20;

/** a0 + a1 cos t + a2 exp(-a3 g). */
export type Linear = [number, number, number, number];
/** (constant + corona exp(-decay g) + square cos^2 g) (1 - exp(-depth / cos t)). */
export type Corona = [constant: number, corona: number, decay: number, square: number, depth: number];

export interface Terms {
  linear?: Linear;
  coronas?: [Corona] | [Corona, Corona];
  /** Weight of the CIE's intermediate sky under the sun of a zenith angle. */
  intermediate?: [weight: number, sunZenith: number];
  /** (constant + (1 + cos^2 g) / (1 - cos g)) (1 - exp(-depth / cos t)); nearer to the sun than `nearest`, 1 - cos, as there. */
  pokrowski?: [constant: number, depth: number, nearest: number];
}

const NONE: Corona = [0, 0, 0, 0, 1];

/** The terms as twenty numbers. */
export function shapeOf({ linear = [0, 0, 0, 0], coronas = [NONE], intermediate = [0, 0], pokrowski }: Terms): number[] {
  const [weight, sunZenith] = intermediate;
  const sun = [weight, Math.sin(4.396 - 2.6 * sunZenith), 1.562 - sunZenith];
  return [...linear, ...coronas[0], ...(coronas[1] ?? NONE), ...sun, ...(pokrowski ?? [-1, 1, 1])];
}

/** The same, so many times as bright. */
export function brighter(terms: Terms, by: number): Terms {
  const { linear, coronas, intermediate } = terms;
  const [a0, a1, a2, a3] = linear ?? [0, 0, 0, 0];
  const corona = ([k, c, decay, s, depth]: Corona): Corona => [k * by, c * by, decay, s * by, depth];
  return {
    linear: [a0 * by, a1 * by, a2 * by, a3],
    coronas: (coronas ?? [NONE]).map(corona) as [Corona],
    intermediate: [(intermediate?.[0] ?? 0) * by, intermediate?.[1] ?? 0],
  };
}

/** GLSL of a shape from the view's height and the angle to the sun; the same as `shapeAt`. */
export const SHAPE_TEXT = `
float corona(float constant, float strength, float decay, float square, float depth, float up, float g, float c2) {
    return (constant + strength * exp(-decay * g) + square * c2) * (1.0 - exp(-depth / max(up, 1.0e-6)));
}
float shape_at(float up, float half_square, float g) {
    float c = 1.0 - 2.0 * half_square, c2 = c * c;
    float light = max(0.0, n[0] + n[1] * up + n[2] * exp(-n[3] * g));
    light += corona(n[4], n[5], n[6], n[7], n[8], up, g, c2) + corona(n[9], n[10], n[11], n[12], n[13], up, g, c2);
    if (n[14] > 0.0) {
        float t = skydome_angle(0.5 * (1.0 - up));
        float first = (1.35 * sin(5.631 - 3.59 * t) + 3.12) * n[15];
        light += n[14] * (first + 6.37 - t) / 2.326 * exp(-0.563 * g * ((2.629 - t) * n[16] + 0.812));
    }
    if (n[17] >= 0.0) light += (n[17] + (1.0 + c2) / max(2.0 * half_square, n[19])) * (1.0 - exp(-n[18] / max(up, 1.0e-6)));
    return light;
}
`;

function corona(n: number[], k: number, up: number, g: number, c2: number): number {
  return (n[k] + n[k + 1] * Math.exp(-n[k + 2] * g) + n[k + 3] * c2) * (1 - Math.exp(-n[k + 4] / Math.max(up, 1e-6)));
}

/** A shape's relative luminance from the view's height, sin^2 of half the angle to the sun, and that angle. */
export function shapeAt(n: number[], up: number, half: number, g: number): number {
  const c2 = (1 - 2 * half) ** 2;
  let light = Math.max(0, n[0] + n[1] * up + n[2] * Math.exp(-n[3] * g));
  light += corona(n, 4, up, g, c2) + corona(n, 9, up, g, c2);
  if (n[14] > 0) {
    const t = Math.acos(up);
    const first = (1.35 * Math.sin(5.631 - 3.59 * t) + 3.12) * n[15];
    light += ((n[14] * (first + 6.37 - t)) / 2.326) * Math.exp(-0.563 * g * ((2.629 - t) * n[16] + 0.812));
  }
  if (n[17] >= 0) light += (n[17] + (1 + c2) / Math.max(2 * half, n[19])) * (1 - Math.exp(-n[18] / Math.max(up, 1e-6)));
  return light;
}

/** A recipe of a shape brought to a level, cd m-2 a unit of it. */
export function shaped(numbers: number[], level: number, white: number[]): Shaped {
  return { kind: "shaped", numbers, level, white };
}
