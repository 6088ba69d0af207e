/** Other air than the usual: by how much the fields of the physical sky's table change with the aerosol's kind and ozone. */

import table from "../../data/airs.json";
import { crossed, heldRows, type Mixed } from "../../core/cubic";
import type { Law } from "../sky";

export interface Air {
  /** The kind of aerosol, "usual" or one of `AEROSOLS`. */
  aerosol: string;
  /** Dobson units. */
  ozone: number;
}

export const AEROSOLS = ["usual", ...table.kinds];
/** Dobson units of the usual air. */
const USUAL_OZONE = 330;

interface Bytes {
  shape: number[];
  scale: number[];
  i1: string;
}

const held = new Map<string, Float32Array>();

/** Rows of numbers; decoded once. */
function numbers({ i1, scale }: Bytes): Float32Array {
  const found = held.get(i1);
  if (found) return found;
  const bytes = Uint8Array.from(atob(i1), (letter) => letter.charCodeAt(0));
  const whole = Float32Array.from(new Int8Array(bytes.buffer), (value, k) => (value / 127) * scale[k % scale.length]);
  held.set(i1, whole);
  return whole;
}

/** Multiply fields (fields, shape) by the exponential of an air's factor times `amount`; `parts` of its rows make each field. */
function multiply(fields: Float32Array, stored: { shapes: Bytes; airs: Bytes[] }, air: number, rows: Mixed, parts: Mixed[], amount: number): void {
  const [shapes, coefficients] = [numbers(stored.shapes), numbers(stored.airs[air])];
  const [length, count] = stored.shapes.shape;
  const stride = stored.airs[air].shape[2];
  parts.forEach((of, field) => {
    const amounts = new Float32Array(count);
    for (const [row, weight] of rows) {
      for (const [part, share] of of) {
        const at = (row * stride + part) * count;
        for (let k = 0; k < count; k++) amounts[k] += amount * weight * share * coefficients[at + k];
      }
    }
    for (let n = 0; n < length; n++) {
      let log = 0;
      for (let k = 0; k < count; k++) log += amounts[k] * shapes[n * count + k];
      fields[field * length + n] *= Math.exp(log);
    }
  });
}

/** Change the fields of a span, once (9, shape) and rest (3, shape), to another air; how many times the sun's light is that.
 *  `fine`: rows of the whole table's heights. */
export function inAir(
  { aerosol, ozone }: Air, span: number, fine: Mixed, height: number, turbidity: number, albedo: number, once: Float32Array, rest: Float32Array,
): number {
  const stored = table.spans[span];
  const heights = heldRows(stored.elevations, height);
  const hazes = table.turbidities;
  const rows = crossed(heights, heldRows(hazes.map(Math.log), Math.log(turbidity)), hazes.length);
  const fineRows = crossed(fine, heldRows(hazes, turbidity), hazes.length);
  const [alone, grounds] = [
    Array.from({ length: 9 }, (_, f): Mixed => [[f, 1]]),
    [0, 1, 2].map((c): Mixed => [[c, 1 - albedo], [3 + c, albedo]]),
  ];
  let log = 0;
  const changed = (air: number, amount: number): void => {
    multiply(once, stored.once, air, rows, alone, amount);
    multiply(rest, stored.rest, air, rows, grounds, amount);
    for (const [row, weight] of fineRows) log += amount * weight * stored.lux[air].flat()[row];
  };
  const kind = table.kinds.indexOf(aerosol);
  if (kind >= 0) changed(kind, 1);
  if (ozone !== USUAL_OZONE) {
    const x = (2 * (ozone - USUAL_OZONE)) / (table.ozone[1] - table.ozone[0]);
    changed(table.kinds.length, (x * x - x) / 2);
    changed(table.kinds.length + 1, (x * x + x) / 2);
  }
  return Math.exp(log);
}

/** The aerosol's phase function: one lobe of Henyey and Greenstein. */
export function lawOf({ aerosol }: Air, usual: Law): Law {
  const kind = table.kinds.indexOf(aerosol);
  if (kind < 0) return usual;
  const g = table.lobes[kind];
  return { constant: 0, square: 0, lobes: [[(1 - g * g) / (4 * Math.PI), 0, g]] };
}
