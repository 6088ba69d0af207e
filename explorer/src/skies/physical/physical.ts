/** The physical sky from its table: fields of light scattered once and of the rest, for any sun, haze and ground. */

import table from "../../data/physical.json";
import { crossed, cubicRows, straightRows, type Mixed } from "../../core/cubic";
import { numbersOf, type Digits } from "../../core/digits";
import { azimuth, DEG, direction, elevation, limited, type Vec3 } from "../../core/vector";
import { inAir, lawOf, type Air } from "./airs";
import { ROWS, TURNS } from "./grid";
import { Refiner } from "./refine";
import type { Fields } from "../sky";

interface Compressed {
  size: Digits;
  coefficients: Digits;
  basis: Digits;
}

const { turbidities, leastHaze } = table;
/** Logarithms of the turbidities of air with haze near the ground. */
const LOGS = turbidities.slice(1).map(Math.log);
const REFINER = new Refiner(table.nodes, table.turns);
/** Of molecules, haze near the ground and haze of the stratosphere. */
export const LAWS = table.laws;
export const LEAST_COSINE = table.leastCosine;
/** End of astronomical twilight, degrees. */
export const LOWEST = -18;

export interface Physical {
  fields: Fields;
  /** Illuminance of the sun facing it, lx. */
  lux: number;
}

/** No light. */
export const DARK: Physical = {
  fields: {
    kind: "fields", clear: false, grid: new Float32Array(ROWS * TURNS * 12), seen: [0, 1, 0], leastCosine: LEAST_COSINE, laws: LAWS,
    moonlit: null, layer: null, clouds: null, glow: null,
  },
  lux: 0,
};

/** Fields (fields, shape) of a condition from a compressed table whose rows hold so many fields. */
function unpackedFields(held: Compressed, rows: Mixed, fields: number): Float32Array {
  const [size, coefficients, basis] = [numbersOf(held.size), numbersOf(held.coefficients), numbersOf(held.basis)];
  const [count, length] = [held.basis.shape[0], basis.length / held.basis.shape[0]];
  const found = new Float32Array(fields * length);
  for (let f = 0; f < fields; f++) {
    const scale = Math.exp(rows.reduce((total, [row, weight]) => total + weight * size[row * fields + f], 0));
    for (let k = 0; k < count; k++) {
      let amount = 0;
      for (const [row, weight] of rows) amount += weight * coefficients[k * size.length + row * fields + f];
      amount *= scale;
      for (let n = 0; n < length; n++) found[f * length + n] += amount * basis[k * length + n];
    }
  }
  return found;
}

/** Rows of a turbidity: straight lines where all haze is the stratosphere's. */
function hazeRows(turbidity: number): Mixed {
  return turbidity < leastHaze ? straightRows(turbidities, turbidity) : cubicRows(LOGS, Math.log(turbidity), 1);
}

/** What the fields of light scattered once stand for: molecules, haze near the ground, haze of the stratosphere. */
function amounts(turbidity: number): number[] {
  return [1, Math.max(0, turbidity - leastHaze), Math.min(1, (turbidity - 1) / (leastHaze - 1))];
}

/** The sky under a lamp, a sun 1 AU away whose X, Y and Z are taken times `strength`. */
export function physicalLight(sun: Vec3, turbidity: number, albedo: number, air: Air, strength: Vec3): Physical {
  const degrees = elevation(sun) / DEG;
  const which = degrees < -5.75 ? 0 : degrees < 4 ? 1 : 2;
  const span = table.spans[which];
  const height = limited(degrees, span.elevations[0], span.elevations[span.elevations.length - 1]);
  const heights = cubicRows(span.elevations, height);
  const airs = crossed(heights, hazeRows(turbidity), turbidities.length);
  const once = unpackedFields(span.once, airs, 9);
  const rest = unpackedFields(span.rest, crossed(airs, cubicRows(table.albedos, albedo), table.albedos.length), 3);
  const dimmed = inAir(air, which, heights, height, turbidity, albedo, once, rest);
  const length = table.nodes * table.turns;
  const grid = new Float32Array(ROWS * TURNS * 12);
  const amount = amounts(turbidity);
  for (let f = 0; f < 9; f++) REFINER.refine(once, f * length, grid, f, strength[f % 3] * amount[Math.floor(f / 3)]);
  for (let c = 0; c < 3; c++) REFINER.refine(rest, c * length, grid, 9 + c, strength[c]);
  const seen = heights.reduce((total, [row, weight]) => total + weight * span.seen[row], 0) + degrees - height;
  const laws = table.laws.map((law, k) => (k === 1 ? lawOf(air, law) : law));
  const lux = dimmed * Math.exp(airs.reduce((total, [row, weight]) => total + weight * span.lux.flat()[row], 0));
  const fields: Fields = { kind: "fields", clear: true, grid, seen: direction(azimuth(sun), seen * DEG), leastCosine: table.leastCosine, laws, moonlit: null, layer: null, clouds: null, glow: null };
  return { fields, lux: lux < 1e-3 ? 0 : lux * strength[1] };
}
