/** The light of the sky above a field on it, by wavelength, from the package's tables. A second form of `skylight`. */

import table from "../../../data/clouds.json";
import { crossed, heldRows } from "../../../core/cubic";
import { numbersOf } from "../../../core/digits";
import type { FieldKind } from "../kinds";

const { suns: SUNS, turbidities: TURBIDITIES, wavelengths: WAVELENGTHS } = table;
const LOGS = TURBIDITIES.map(Math.log);

/** Over a field that sends nothing back, over the sun's irradiance above the air 1 AU away, by wavelength. */
export interface UpperSky {
  light: number[];
  /** Share of it that thick cloud has of even light, and the share that the air sends back of light from below. */
  thick: number[];
  back: number[];
}

/** The sky above a kind's field under a sun at a true elevation, degrees, and of a strength, where haze scatters by wavelength as much
 *  as the usual haze of these turbidities, and shares `left` pass what there is of ozone more than usual. */
export function upperSky(kind: FieldKind, elevation: number, turbidities: number[], left: number[], strength: number): UpperSky {
  const { light, back } = table.above[kind];
  const numbers = numbersOf(light), count = WAVELENGTHS.length, half = numbers.length / 2, suns = heldRows(SUNS, elevation);
  const hazes = turbidities.map((each) => heldRows(LOGS, Math.log(each))), rows = hazes.map((each) => crossed(each, suns, SUNS.length));
  const of = (from: number): number[] => rows.map((each, w) => each.reduce((total, [row, weight]) => total + weight * numbers[from + row * count + w], 0));
  return {
    light: of(0).map((log, w) => strength * left[w] * Math.exp(log)), thick: of(half),
    back: hazes.map((each, w) => each.reduce((total, [row, weight]) => total + weight * back[row][w], 0)),
  };
}

/** At wavelength number w, irradiance of that sky over what sends a share `mirrored` of it and of the sun's `beam` back:
 *  all, and the even light of which thick cloud would let as much through. */
export function skylight(upper: UpperSky, w: number, beam: number, mirrored: number): [number, number] {
  const whole = (upper.light[w] + beam) / (1 - upper.back[w] * mirrored) - beam;
  return [whole, whole * upper.thick[w]];
}
