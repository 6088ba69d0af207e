/** What glows all over the night: stars too faint to be points, dust about the sun, the upper air; a grid of the dome. */

import table from "../../data/night.json";
import { numbersOf, type Digits } from "../../core/digits";
import { cubicAt } from "../../core/cubic";
import { azimuth, DEG, elevation, limited, type Matrix3, type Vec3 } from "../../core/vector";
import { aboutPole, product, transposed, type Heavens } from "../../sun/heavens";
import { atTurbidity, overGround, RINGS, ringOf } from "./air";

/** Azimuths of the grid, the first again at the end. */
export const COLUMNS = 97;
export { RINGS };

/** Brightness toward a vector in axes of its own. */
type Brightness = (x: number, y: number, z: number) => number;

/** A map's value at a latitude and a longitude, degrees from its first row and column, straight lines between. */
function valueAt(values: Digits, row: number, column: number): number {
  const numbers = numbersOf(values);
  const [rows, columns] = values.shape;
  const [y, x] = [row / table.even, column / table.even];
  const [i, j] = [Math.min(Math.floor(y), rows - 2), Math.min(Math.floor(x), columns - 2)];
  const at = i * columns + j;
  const upper = numbers[at] + (numbers[at + 1] - numbers[at]) * (x - j);
  const lower = numbers[at + columns] + (numbers[at + columns + 1] - numbers[at + columns]) * (x - j);
  return upper + (lower - upper) * (y - i);
}

/** Of the Milky Way in the galaxy's axes, of the zodiacal light in the ecliptic's from the sun. */
const milkyWay: Brightness = (x, y, z) => {
  const longitude = Math.atan2(y, x) / DEG;
  return valueAt(table.milkyWay.values, 90 + Math.asin(limited(z, -1, 1)) / DEG, longitude < 0 ? longitude + 360 : longitude);
};
const dust: Brightness = (x, y, z) =>
  Math.exp(valueAt(table.dust.values, Math.abs(Math.asin(limited(z, -1, 1))) / DEG, Math.abs(Math.atan2(y, x)) / DEG));

/** The same toward vectors in other axes. */
function inAxes(brightness: Brightness, [a, b, c]: Matrix3): Brightness {
  return (x, y, z) => brightness(a[0] * x + a[1] * y + a[2] * z, b[0] * x + b[1] * y + b[2] * z, c[0] * x + c[1] * y + c[2] * z);
}

interface Air {
  /** Logarithms of what stays of a unit, (3, turbidities, rings). */
  left: Digits;
  /** Harmonics of what comes from beside, (3, turbidities, grounds, views, sources, modes). */
  beside: Digits;
}

/** Sines and cosines of the columns' azimuths, times 0, 1, 2, ... */
const COSINE = (column: number, m: number): number => Math.cos((m * column * 2 * Math.PI) / (COLUMNS - 1));
const SINE = (column: number, m: number): number => Math.sin((m * column * 2 * Math.PI) / (COLUMNS - 1));
const MODES = table.dust.air.beside.shape[5];
const WAVES = Float64Array.from({ length: COLUMNS * MODES * 2 }, (_, k) =>
  (k % 2 ? SINE : COSINE)(Math.floor(k / 2 / MODES), Math.floor(k / 2) % MODES));

/** Add a glow of some brightness by direction to the dome: what stays of it, and what the air scatters. */
function add(grid: Float32Array, { left, beside }: Air, turbidity: number, albedo: number, brightness: Brightness): void {
  const stays = atTurbidity(left, turbidity).map(Math.exp);
  const spread = scattered(overGround(atTurbidity(beside, turbidity), 3, albedo), brightness);
  for (let ring = 0; ring < RINGS; ring++) {
    const height = (ring / (RINGS - 1)) ** 3 * (Math.PI / 2);
    const [z, level] = [Math.sin(height), Math.cos(height)];
    const [first, weights] = cubicAt(PLACES, Math.sqrt(z));
    for (let column = 0; column < COLUMNS; column++) {
      const at = (ring * COLUMNS + column) * 3;
      const bright = brightness(level * WAVES[2 * (column * MODES + 1) + 1], level * WAVES[2 * (column * MODES + 1)], z);
      for (let c = 0; c < 3; c++) {
        let light = bright * stays[c * RINGS + ring];
        for (let k = 0; k < 4; k++) light += weights[k] * spread[((first + k) * COLUMNS + column) * 3 + c];
        grid[at + c] += light;
      }
    }
  }
}

/** Root of the sine of the views' elevations. */
const PLACES = table.views.map(Math.sqrt);

/** What the air scatters toward the views (views, columns, 3), of harmonics (3, views, sources, modes). */
function scattered(harmonics: Float32Array, brightness: Brightness): Float32Array {
  const { sources, views } = table;
  const waves = sources.map((sine) => wavesOf(sine, brightness));
  const found = new Float32Array(views.length * COLUMNS * 3);
  const sums = new Float64Array(2 * MODES);
  for (let row = 0; row < 3 * views.length; row++) {
    sums.fill(0);
    waves.forEach((wave, s) => {
      for (let k = 0; k < 2 * MODES; k++) sums[k] += harmonics[(row * sources.length + s) * MODES + (k >> 1)] * wave[k];
    });
    const [c, view] = [Math.floor(row / views.length), row % views.length];
    for (let column = 0; column < COLUMNS; column++) {
      let total = 0;
      for (let k = 0; k < 2 * MODES; k++) total += (k < 2 ? 1 : 2) * sums[k] * WAVES[2 * MODES * column + k];
      found[(view * COLUMNS + column) * 3 + c] = total / table.turns;
    }
  }
  return found;
}

/** Sums of the brightness at a sine of the elevation and even turns, times cosines and sines of these. */
function wavesOf(sine: number, brightness: Brightness): Float64Array {
  const found = new Float64Array(2 * MODES);
  const level = Math.sqrt(1 - sine * sine);
  for (let a = 0; a < table.turns; a++) {
    const turn = (2 * Math.PI * a) / table.turns;
    const bright = brightness(level * Math.sin(turn), level * Math.cos(turn), sine);
    for (let m = 0; m < MODES; m++) {
      found[2 * m] += bright * Math.cos(m * turn);
      found[2 * m + 1] += bright * Math.sin(m * turn);
    }
  }
  return found;
}

/** XYZ, cd m-2, over the dome, (rings, columns, 3), in the usual air of a turbidity over a ground. */
export function glowOver(heavens: Heavens, turbidity: number, albedo: number): Float32Array {
  const grid = new Float32Array(RINGS * COLUMNS * 3);
  const own = overGround(atTurbidity(table.airglow, turbidity).map(Math.exp), 3, albedo);
  own.forEach((light, k) => {
    const [c, ring] = [Math.floor(k / RINGS), k % RINGS];
    for (let column = 0; column < COLUMNS; column++) grid[(ring * COLUMNS + column) * 3 + c] = light;
  });
  const toGalaxy = product(table.milkyWay.axes as unknown as Matrix3, transposed(heavens.stars));
  const fromSun = product(aboutPole(heavens.sun[0]), transposed(heavens.ofDate));
  add(grid, table.milkyWay.air, turbidity, albedo, inAxes(milkyWay, toGalaxy));
  add(grid, table.dust.air, turbidity, albedo, inAxes(dust, fromSun));
  return grid;
}

/** Between the nodes of such a grid. */
export function glowAt(grid: Float32Array, toward: Vec3): Vec3 {
  const row = Math.min(ringOf(Math.max(0, elevation(toward))), RINGS - 1.000001);
  const column = Math.min((azimuth(toward) / (2 * Math.PI)) * (COLUMNS - 1), COLUMNS - 1.000001);
  const [i, j, a, b] = [Math.floor(row), Math.floor(column), row % 1, column % 1];
  const at = (i * COLUMNS + j) * 3;
  return [0, 1, 2].map((c) => {
    const [upper, lower] = [at + c, at + COLUMNS * 3 + c].map((k) => grid[k] * (1 - b) + grid[k + 3] * b);
    return upper * (1 - a) + lower * a;
  }) as unknown as Vec3;
}
