/** What glows all over the night: stars too faint to be points, dust about the sun, the upper air; a grid of the dome. */

import table from "../../data/night.json";
import { numbersOf, type Digits } from "../../core/digits";
import { azimuth, DEG, direction, elevation, limited, wrapped, type Matrix3, type Vec3 } from "../../core/vector";
import { product, transposed, turned, type Heavens } from "../../sun/heavens";
import { atTurbidity, between, RINGS, ringOf } from "./air";

/** Azimuths of the grid, the first again at the end. */
export const COLUMNS = 97;
export { RINGS };

const LOGS = table.levels.map(Math.log);
const count = table.levels.length;

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

/** Add what a brightness is seen as at a ring: logarithms (3, levels, rings) between whose levels are straight lines. */
function add(grid: Float32Array, at: number, air: Float32Array, ring: number, brightness: number): void {
  const level = Math.log(Math.max(brightness, table.levels[0]));
  const above = LOGS.findIndex((log) => log > level);
  const first = limited((above < 0 ? count : above) - 1, 0, count - 2);
  const share = (level - LOGS[first]) / (LOGS[first + 1] - LOGS[first]);
  for (let c = 0; c < 3; c++) {
    const low = (c * count + first) * RINGS + ring;
    grid[at + c] += brightness * Math.exp(air[low] * (1 - share) + air[low + RINGS] * share);
  }
}

/** XYZ, cd m-2, over the dome, (rings, columns, 3), in the usual air of a turbidity. */
export function glowOver(heavens: Heavens, turbidity: number): Float32Array {
  const grid = new Float32Array(RINGS * COLUMNS * 3);
  const back = transposed(heavens.stars);
  const toGalaxy = product(table.milkyWay.axes as unknown as Matrix3, back);
  const fromSun = product([[Math.cos(heavens.sun[0]), Math.sin(heavens.sun[0]), 0], [-Math.sin(heavens.sun[0]), Math.cos(heavens.sun[0]), 0], [0, 0, 1]], transposed(heavens.ofDate));
  const own = atTurbidity(table.airglow, turbidity);
  const [stars, dusty] = [atTurbidity(table.milkyWay.air, turbidity), atTurbidity(table.dust.air, turbidity)];
  for (let ring = 0; ring < RINGS; ring++) {
    const height = (ring / (RINGS - 1)) ** 3 * (Math.PI / 2);
    for (let column = 0; column < COLUMNS; column++) {
      const toward = direction((column / (COLUMNS - 1)) * 2 * Math.PI, height);
      const at = (ring * COLUMNS + column) * 3;
      for (let c = 0; c < 3; c++) grid[at + c] = Math.exp(own[c * RINGS + ring]);
      add(grid, at, stars, ring, milkyWay(turned(toGalaxy, toward)));
      add(grid, at, dusty, ring, dust(turned(fromSun, toward)));
    }
  }
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
