/** What glows all over the night: stars too faint to be points, dust about the sun, the upper air; a grid of the dome. */

import table from "../../data/night.json";
import { numbersOf, type Digits } from "../../core/digits";
import { cubicAt } from "../../core/cubic";
import { azimuth, DEG, direction, elevation, limited, wrapped, type Matrix3, type Vec3 } from "../../core/vector";
import { aboutPole, product, transposed, turned, type Heavens } from "../../sun/heavens";
import { atTurbidity, between, RINGS, ringOf } from "./air";

/** Azimuths of the grid, the first again at the end. */
export const COLUMNS = 97;
export { RINGS };

interface Map {
  rows: number[];
  columns: number[];
  values: Digits;
}

/** A map's value at a row and a column, straight lines between. */
function valueAt({ rows, columns, values }: Map, row: number, column: number): number {
  const numbers = numbersOf(values);
  const [[i, a], [j, b]] = [between(rows, row), between(columns, column)];
  const at = i * columns.length + j;
  const upper = numbers[at] * (1 - b) + numbers[at + 1] * b;
  return upper * (1 - a) + (numbers[at + columns.length] * (1 - b) + numbers[at + columns.length + 1] * b) * a;
}

/** Longitude and latitude of a vector, degrees. */
function angles([x, y, z]: Vec3): [number, number] {
  return [Math.atan2(y, x) / DEG, Math.asin(limited(z, -1, 1)) / DEG];
}

/** Brightness of the Milky Way and of the zodiacal light toward vectors in the galaxy's axes, and in the ecliptic's from the sun. */
function milkyWay(v: Vec3): number {
  const [longitude, latitude] = angles(v);
  return valueAt(table.milkyWay, latitude, wrapped(longitude, 360));
}

function dust(v: Vec3): number {
  const [longitude, latitude] = angles(v);
  return Math.exp(valueAt(table.dust, Math.abs(longitude), Math.abs(latitude)));
}

interface Air {
  /** Logarithms of what stays of a unit, (3, turbidities, rings). */
  left: Digits;
  /** Harmonics of what comes from beside, (3, turbidities, views, sources, modes). */
  beside: Digits;
}

/** Add a glow of some brightness by direction to the dome: what stays of it, and what the air scatters. */
function add(grid: Float32Array, { left, beside }: Air, turbidity: number, brightness: (toward: Vec3) => number): void {
  const [stays, spread] = [atTurbidity(left, turbidity), scattered(atTurbidity(beside, turbidity), beside.shape[4], brightness)];
  for (let ring = 0; ring < RINGS; ring++) {
    const height = (ring / (RINGS - 1)) ** 3 * (Math.PI / 2);
    const [first, weights] = cubicAt(PLACES, Math.sqrt(Math.sin(height)));
    for (let column = 0; column < COLUMNS; column++) {
      const at = (ring * COLUMNS + column) * 3;
      const level = brightness(direction((column / (COLUMNS - 1)) * 2 * Math.PI, height));
      for (let c = 0; c < 3; c++) {
        let near = 0;
        weights.forEach((weight, k) => (near += weight * spread[((first + k) * COLUMNS + column) * 3 + c]));
        grid[at + c] += level * Math.exp(stays[c * RINGS + ring]) + near;
      }
    }
  }
}

/** Root of the sine of the views' elevations. */
const PLACES = table.views.map(Math.sqrt);

/** What the air scatters toward the views (views, columns, 3), of harmonics (3, views, sources, modes). */
function scattered(harmonics: Float32Array, modes: number, brightness: (toward: Vec3) => number): Float32Array {
  const { sources, turns, views } = table;
  const waves = sources.map((sine) => waveOf(Array.from({ length: turns }, (_, a) => brightness(direction((a / turns) * 2 * Math.PI, Math.asin(sine)))), modes));
  const found = new Float32Array(views.length * COLUMNS * 3);
  for (let c = 0; c < 3; c++) {
    for (let view = 0; view < views.length; view++) {
      const [real, imaginary] = [new Float64Array(modes), new Float64Array(modes)];
      waves.forEach(([cosine, sine], s) => {
        const at = ((c * views.length + view) * sources.length + s) * modes;
        for (let m = 0; m < modes; m++) {
          real[m] += harmonics[at + m] * cosine[m];
          imaginary[m] += harmonics[at + m] * sine[m];
        }
      });
      for (let column = 0; column < COLUMNS; column++) {
        const turn = (column / (COLUMNS - 1)) * 2 * Math.PI;
        let total = real[0];
        for (let m = 1; m < modes; m++) total += 2 * (real[m] * Math.cos(m * turn) + imaginary[m] * Math.sin(m * turn));
        found[(view * COLUMNS + column) * 3 + c] = total / turns;
      }
    }
  }
  return found;
}

/** Sums of values at even turns times cosine and sine. */
function waveOf(values: number[], modes: number): [number[], number[]] {
  const sums = (wave: (x: number) => number): number[] =>
    Array.from({ length: modes }, (_, m) => values.reduce((total, value, a) => total + value * wave((2 * Math.PI * m * a) / values.length), 0));
  return [sums(Math.cos), sums(Math.sin)];
}

/** XYZ, cd m-2, over the dome, (rings, columns, 3), in the usual air of a turbidity. */
export function glowOver(heavens: Heavens, turbidity: number): Float32Array {
  const grid = new Float32Array(RINGS * COLUMNS * 3);
  const own = atTurbidity(table.airglow, turbidity);
  for (let at = 0; at < grid.length; at++) grid[at] = Math.exp(own[(at % 3) * RINGS + Math.floor(at / (3 * COLUMNS))]);
  const toGalaxy = product(table.milkyWay.axes as unknown as Matrix3, transposed(heavens.stars));
  const fromSun = product(aboutPole(heavens.sun[0]), transposed(heavens.ofDate));
  add(grid, table.milkyWay.air, turbidity, (toward) => milkyWay(turned(toGalaxy, toward)));
  add(grid, table.dust.air, turbidity, (toward) => dust(turned(fromSun, toward)));
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
