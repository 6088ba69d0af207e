/** The physical sky from its table: fields of light scattered once and of the rest, for any sun, haze and ground. */

import table from "../../data/physical.json";
import { cubicAt, halves, type Half } from "../../core/half";
import { azimuth, DEG, direction, elevation, limited, type Vec3 } from "../../core/vector";
import { inAir, lawOf, type Air } from "./airs";
import { ROWS, TURNS } from "./grid";
import type { Fields } from "../sky";

interface Compressed {
  size: Half;
  coefficients: Half;
  basis: Half;
}

const LOGS = table.turbidities.map(Math.log);
/** End of astronomical twilight, degrees. */
export const LOWEST = -18;

export interface Physical {
  fields: Fields;
  /** Illuminance of the sun facing it, lx. */
  lux: number;
}

/** A weight for each of some rows of a table. */
type Mixed = [number, number][];

function crossed(first: Mixed, second: Mixed, count: number): Mixed {
  return first.flatMap(([a, v]) => second.map(([b, w]): [number, number] => [a * count + b, v * w]));
}

function mixedAt(nodes: number[], x: number): Mixed {
  const [first, weights] = cubicAt(nodes, x);
  return weights.map((weight, k) => [first + k, weight]);
}

/** Fields (fields, shape) of a condition from a compressed table whose rows hold so many fields. */
function unpackedFields(held: Compressed, rows: Mixed, fields: number): Float32Array {
  const [size, coefficients, basis] = [halves(held.size), halves(held.coefficients), halves(held.basis)];
  const [count, length] = held.basis.shape;
  const found = new Float32Array(fields * length);
  for (let f = 0; f < fields; f++) {
    let log = 0;
    const amounts = new Float32Array(count);
    for (const [row, weight] of rows) {
      log += weight * size[row * fields + f];
      const at = (row * fields + f) * count;
      for (let k = 0; k < count; k++) amounts[k] += weight * coefficients[at + k];
    }
    const scale = Math.exp(log);
    for (let k = 0; k < count; k++) {
      const amount = scale * amounts[k];
      for (let n = 0; n < length; n++) found[f * length + n] += amount * basis[k * length + n];
    }
  }
  return found;
}

/** Values (nodes, turns) of a field on the fine grid, as channel `at` of cells of 4 x 3. */
function refine(coarse: Float32Array, from: number, grid: Float32Array, at: number, scale: number): void {
  const across = new Float32Array(ROWS * table.turns);
  for (let row = 0; row < ROWS; row++) {
    const [first, weights] = EVEN_ROWS[row];
    for (let turn = 0; turn < table.turns; turn++) {
      let total = 0;
      for (let k = 0; k < 4; k++) total += weights[k] * coarse[from + (first + k) * table.turns + turn];
      across[row * table.turns + turn] = total;
    }
  }
  for (let row = 0; row < ROWS; row++) {
    for (let turn = 0; turn < TURNS; turn++) {
      const [first, weights] = EVEN_TURNS[turn];
      let total = 0;
      for (let k = 0; k < 4; k++) total += weights[k] * across[row * table.turns + mirrored(first + k)];
      grid[(row * TURNS + turn) * 12 + at] = Math.max(0, total * scale);
    }
  }
}

/** A turn beyond 0 or 180 degrees is its mirror image. */
function mirrored(turn: number): number {
  const last = table.turns - 1;
  return turn < 0 ? -turn : turn > last ? 2 * last - turn : turn;
}

function even(count: number, nodes: number, inside: boolean): [number, number[]][] {
  return Array.from({ length: count }, (_, k) => {
    const place = (k / (count - 1)) * (nodes - 1);
    const first = inside ? limited(Math.floor(place) - 1, 0, nodes - 4) : Math.min(Math.floor(place), nodes - 2) - 1;
    return [first, cubicAt([0, 1, 2, 3], place - first)[1]];
  });
}

const EVEN_ROWS = even(ROWS, table.nodes, true);
const EVEN_TURNS = even(TURNS, table.turns, false);

/** The aerosol's three channels stand for each turbidity above that of the stratosphere's alone. */
const isAerosol = (field: number): boolean => field >= 3 && field < 6;

/** The sky under a lamp, a sun 1 AU away whose X, Y and Z are taken times `strength`. */
export function physicalLight(sun: Vec3, turbidity: number, albedo: number, air: Air, strength: Vec3): Physical {
  const degrees = elevation(sun) / DEG;
  const which = degrees < -5.75 ? 0 : degrees < 4 ? 1 : 2;
  const span = table.spans[which];
  const height = limited(degrees, span.elevations[0], span.elevations[span.elevations.length - 1]);
  const heights = mixedAt(span.elevations, height);
  const haze = Math.max(Math.log(turbidity), LOGS[0]);
  const airs = crossed(heights, mixedAt(LOGS, haze), LOGS.length);
  const once = unpackedFields(span.once, airs, 9);
  const rest = unpackedFields(span.rest, crossed(airs, mixedAt(table.albedos, albedo), table.albedos.length), 3);
  const dimmed = inAir(air, which, heights, height, haze, albedo, once, rest);
  const length = table.nodes * table.turns;
  const grid = new Float32Array(ROWS * TURNS * 12);
  for (let f = 0; f < 9; f++) refine(once, f * length, grid, f, strength[f % 3] * (isAerosol(f) ? Math.max(0, turbidity - table.leastHaze) : 1));
  for (let c = 0; c < 3; c++) refine(rest, c * length, grid, 9 + c, strength[c]);
  const seen = heights.reduce((total, [row, weight]) => total + weight * span.seen[row], 0) + degrees - height;
  const laws = table.laws.map((law, k) => (k === 1 ? lawOf(air, law) : law));
  const lux = dimmed * Math.exp(airs.reduce((total, [row, weight]) => total + weight * span.lux.flat()[row], 0));
  const fields: Fields = { kind: "fields", grid, seen: direction(azimuth(sun), seen * DEG), leastCosine: table.leastCosine, laws, moonlit: null };
  return { fields, lux: lux < 1e-3 ? 0 : lux * strength[1] };
}
