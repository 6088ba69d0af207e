/** The light of a clear sky at a field of cloud by wavelength, from its colours and its air. */

import table from "../../data/clouds.json";
import { heldRows } from "../../core/cubic";
import { limited, type Vec3 } from "../../core/vector";
import { upperSky, type UpperSky } from "./air/above";
import type { FieldKind } from "./kinds";

const { colours: COLOURS, wavelengths: WAVELENGTHS, views: VIEWS } = table;

/** What the page knows of a clear sky: XYZ, and its air. */
export interface ClearColours {
  /** On the horizontal, lx; and around elevations from the horizon to the zenith, even in the root of the sine, cd m-2. */
  sky: Vec3;
  mean: Vec3[];
  /** Where the sun is seen and how high it stands, degrees, its illuminance facing it at the ground, lx, and its strength over that 1 AU away. */
  sun: Vec3;
  elevation: number;
  lux: number;
  strength: number;
  turbidity: number;
  aerosol: string;
  /** Dobson units. */
  ozone: number;
  albedo: number;
}

/** What a clear sky sends, by wavelength, over the sun's irradiance above the air 1 AU away. */
export interface ClearLight {
  /** Of the sun on a plane that faces it, at the field and at the ground. */
  sun: number[];
  below: number[];
  /** Of the sky on the horizontal, and its radiance around each of `views` elevations. */
  sky: number[];
  mean: number[][];
  /** Vertical optical depths of molecules, haze near the ground, ozone and haze of the stratosphere. */
  depths: number[][];
  haze: HazeLaw;
  /** The sky above the field. */
  upper: UpperSky;
  albedo: number;
}

/** XYZ of light by wavelength. */
export function colourOf(light: (w: number) => number): Vec3 {
  const total: [number, number, number] = [0, 0, 0];
  for (let w = 0; w < COLOURS.length; w++) {
    const value = light(w);
    for (let c = 0; c < 3; c++) total[c] += value * COLOURS[w][c];
  }
  return total;
}

/** Optical depth of columns of the air's constituents. */
export const depthOf = (columns: readonly number[], depths: number[][], w: number): number =>
  columns.reduce((total, column, k) => total + column * depths[k][w], 0);

/** Three spectra of scattered light, and how much of each a colour has: (3, 3), columns X, Y, Z. */
const BASIS = [0, 1, 2].map((n) => WAVELENGTHS.map((length) => (length / 550) ** (-2 * n)));
const FROM_XYZ = inverse(BASIS.map((light) => [...colourOf((w) => light[w])]));

function inverse([[a, b, c], [d, e, f], [g, h, i]]: number[][]): number[][] {
  const whole = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return [[e * i - f * h, c * h - b * i, b * f - c * e], [f * g - d * i, a * i - c * g, c * d - a * f], [d * h - e * g, b * g - a * h, a * e - b * d]]
    .map((row) => row.map((value) => value / whole));
}

/** A smooth spectrum of a colour. */
function spectrumOf(xyz: Vec3): number[] {
  const amounts = [0, 1, 2].map((n) => xyz.reduce((total, value, c) => total + value * FROM_XYZ[c][n], 0));
  return WAVELENGTHS.map((_, w) => Math.max(0, amounts.reduce((total, amount, n) => total + amount * BASIS[n][w], 0)));
}

/** Rows (even in the root of the sine) at a place among them, 0..1, by straight lines. */
function rowAt(rows: readonly (readonly number[])[], place: number): number[] {
  const at = place * (rows.length - 1), k = Math.min(Math.floor(at), rows.length - 2);
  return rows[k].map((value, n) => value + (rows[k + 1][n] - value) * (at - k));
}

/** The same by cubics, for columns that are steep where the sun is low. */
function curvedRowAt(rows: readonly (readonly number[])[], place: number): number[] {
  const near = heldRows(rows.map((_, k) => k), place * (rows.length - 1));
  return rows[0].map((_, n) => Math.max(0, near.reduce((total, [row, weight]) => total + weight * rows[row][n], 0)));
}

/** Haze near the ground: the share that it scatters, its lobe's g, and its exponent. */
interface HazeLaw {
  albedo: number;
  g: number;
  angstrom: number;
}

/** An aerosol's. */
function hazeOf(aerosol: string): HazeLaw {
  const [albedo, g] = (table.haze as Record<string, number[]>)[aerosol] ?? table.haze.usual;
  return { albedo, g, angstrom: (table.angstrom as Record<string, number>)[aerosol] ?? table.angstrom.usual };
}

const USUAL = hazeOf("usual");

/** Optical depths of the air's constituents. */
function depthsOf({ turbidity, aerosol, ozone }: ClearColours): number[][] {
  const whole = (turbidity - 1) * table.rayleigh;
  const high = Math.min(whole, table.background[0]);
  const along = (depth: number, exponent: number): number[] => WAVELENGTHS.map((length) => depth * (length / 550) ** -exponent);
  return [table.molecules, along(whole - high, hazeOf(aerosol).angstrom), table.ozone.map((each) => each * ozone), along(high, table.background[1])];
}

/** The light of a clear sky at a kind's field. */
export function clearLight(clear: ClearColours, kind: FieldKind): ClearLight {
  const { sun, lux, strength, ozone, turbidity, elevation } = clear, depths = depthsOf(clear), haze = hazeOf(clear.aerosol);
  const beam = ([share, ...along]: number[]): number[] => WAVELENGTHS.map((_, w) => strength * share * Math.exp(-depthOf(along, depths, w)));
  const [least, most] = table.standing;
  const sunward = curvedRowAt(table.sunward[kind], Math.sqrt(limited((elevation - least) / (most - least), 0, 1)));
  const below = beam([Number(lux > 0), ...curvedRowAt(table.ground, Math.sqrt(Math.max(0, sun[2])))]);
  const gases = lux > 0 ? lux / colourOf((w) => below[w])[1] : 1;
  const turbidities = WAVELENGTHS.map((length) => 1 + ((turbidity - 1) * (length / 550) ** (USUAL.angstrom - haze.angstrom) * haze.albedo) / USUAL.albedo);
  const left = table.ozone.map((each) => Math.exp(-each * (ozone - table.usualOzone) * sunward[3]));
  const upper = upperSky(kind, elevation, turbidities, left, strength);
  const mean = Array.from({ length: VIEWS }, (_, j) => spectrumOf(rowAt(clear.mean, j / (VIEWS - 1)) as unknown as Vec3));
  return { sun: beam(sunward), below: below.map((value) => value * gases), sky: spectrumOf(clear.sky), mean, depths, haze, upper, albedo: clear.albedo };
}
