/** What the usual air does to the light of the night: tables by turbidity over rings of height, and how it lifts. */

import table from "../../data/night.json";
import { numbersOf, type Digits } from "../../core/digits";
import { limited } from "../../core/vector";

export const RINGS = table.rings;

/** The first of two neighbours among rising nodes and the share of the second, held at the ends. */
export function between(nodes: number[], x: number): [number, number] {
  const above = nodes.findIndex((node) => node > x);
  const first = limited((above < 0 ? nodes.length : above) - 1, 0, nodes.length - 2);
  return [first, limited((x - nodes[first]) / (nodes[first + 1] - nodes[first]), 0, 1)];
}

/** Values (channels, rest) of a table (channels, turbidities, rest) at a turbidity. */
export function atTurbidity(packed: Digits, turbidity: number): Float32Array {
  const numbers = numbersOf(packed);
  const [channels, count] = packed.shape;
  const size = numbers.length / channels / count;
  const [first, share] = between(table.turbidities, turbidity);
  const found = new Float32Array(channels * size);
  for (let c = 0; c < channels; c++) {
    const at = (c * count + first) * size;
    for (let k = 0; k < size; k++) found[c * size + k] = numbers[at + k] * (1 - share) + numbers[at + size + k] * share;
  }
  return found;
}

/** Of light that a white ground sends up, how much the air sends back, about. */
const MIRROR = 0.15;

/** Values (channels, rest) over a ground from those (channels, black and white, rest). */
export function overGround(both: Float32Array, channels: number, albedo: number): Float32Array {
  const size = both.length / channels / 2;
  const share = (albedo * (1 - MIRROR)) / (1 - albedo * MIRROR);
  return Float32Array.from({ length: channels * size }, (_, k) => {
    const at = Math.floor(k / size) * 2 * size + (k % size);
    return both[at] + (both[at + size] - both[at]) * share;
  });
}

/** Place among the rings of an elevation, radians. */
export function ringOf(elevation: number): number {
  return Math.cbrt(limited(elevation / (Math.PI / 2), 0, 1)) * (RINGS - 1);
}

/** Where one sees what stands at an elevation, degrees. */
export function lifted(degrees: number): number {
  const [first, share] = between(table.true, degrees);
  return degrees + table.lift[first] * (1 - share) + table.lift[first + 1] * share;
}
