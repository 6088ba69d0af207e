/** A field of cloud: extinction at every place over the ground, repeating. A second form of `sd.CloudField`. */

import table from "../../data/clouds.json";
import { shapeOf, type FieldKind, type KindNumbers } from "./kinds";
import { cells, Lattice } from "./noise";

/** Places along each side of the block of fine detail, which repeats. */
const DETAIL = 64;
const EACH = [[0.5, 4], [0.3, 9], [0.2, 19]];

/** Fine detail: distances to points strewn at three scales. */
function detailOf(seed: number): Float32Array {
  const found = new Float64Array(DETAIL ** 3);
  for (const [weight, n] of EACH) {
    const lattice = new Lattice(n, n, 0, n, seed + 101 + n, n);
    for (let j = 0, at = 0; j < DETAIL; j++)
      for (let i = 0; i < DETAIL; i++)
        for (let k = 0; k < DETAIL; k++, at++) found[at] += weight * cells(lattice, (i * n) / DETAIL, (j * n) / DETAIL, (k * n) / DETAIL);
  }
  return Float32Array.from(found);
}

/** A kind and a seed: its shape and detail as tables, and how high its columns come. */
export class Texture {
  readonly numbers: KindNumbers;
  /** (count, count, levels): north, east, up. */
  readonly shape: Float32Array;
  readonly detail: Float32Array;
  /** The greatest of shape less erosion in each column where there can be cloud, in order of size. */
  private readonly tops: Float32Array;

  constructor(readonly kind: FieldKind, readonly seed: number) {
    this.numbers = table.kinds[kind];
    const { count, levels, period, thickness } = this.numbers;
    this.shape = new Float32Array(count * count * levels);
    this.detail = detailOf(seed);
    const shape = shapeOf(kind, seed);
    for (let j = 0, at = 0; j < count; j++) {
      for (let i = 0; i < count; i++) {
        shape.column((i * period) / count, (j * period) / count);
        for (let k = 0; k < levels; k++, at++) this.shape[at] = shape.at(((k + 0.5) / levels) * thickness, (k + 0.5) / levels);
      }
    }
    this.tops = this.columnTops();
  }

  private columnTops(): Float32Array {
    const { count, levels, period, thickness, erosion, detail, profile } = this.numbers;
    const found = new Float32Array(count * count);
    for (let j = 0, at = 0; j < count; j++) {
      for (let i = 0; i < count; i++, at++) {
        let top = -Infinity;
        for (let k = 0; k < levels; k++) {
          if (profile[k] <= 0.05) continue;
          const eaten = erosion * wrapped(this.detail, (i * period) / count / detail, (j * period) / count / detail, (((k + 0.5) / levels) * thickness) / detail);
          top = Math.max(top, this.shape[at * levels + k] - eaten);
        }
        found[at] = top;
      }
    }
    return found.sort();
  }

  /** The shape from which on there is cloud, so that a cover is met. */
  threshold(cover: number): number {
    const { edge } = this.numbers;
    const last = this.tops.length - 1;
    if (cover <= 0) return this.tops[last] + 1;
    const place = (1 - cover) * last;
    const low = Math.min(Math.floor(place), last - 1);
    const found = this.tops[low] + (this.tops[low + 1] - this.tops[low]) * (place - low);
    return found - (cover < 1 ? edge * table.met : Math.max(edge, table.closed));
  }
}

/** The detail, linear at a place, that repeats in all. */
function wrapped(block: Float32Array, x: number, y: number, z: number): number {
  const fx = Math.floor(x), fy = Math.floor(y), fz = Math.floor(z), last = DETAIL - 1;
  const u = x - fx, v = y - fy, w = z - fz;
  const i = fx & last, i1 = (fx + 1) & last, k = fz & last, k1 = (fz + 1) & last;
  const j = (fy & last) * DETAIL, j1 = ((fy + 1) & last) * DETAIL;
  const a = (j + i) * DETAIL, b = (j + i1) * DETAIL, c = (j1 + i) * DETAIL, d = (j1 + i1) * DETAIL;
  const low = (block[a + k] * (1 - u) + block[b + k] * u) * (1 - v) + (block[c + k] * (1 - u) + block[d + k] * u) * v;
  const high = (block[a + k1] * (1 - u) + block[b + k1] * u) * (1 - v) + (block[c + k1] * (1 - u) + block[d + k1] * u) * v;
  return low + (high - low) * w;
}

/** A table (north, east, up), linear at a place in cells, that repeats to east and north and is held upward. */
export function between(held: Float32Array, side: number, levels: number, x: number, y: number, z: number): number {
  z = Math.min(Math.max(z, 0), levels - 1.000001);
  const fx = Math.floor(x), fy = Math.floor(y), k = Math.floor(z), last = side - 1;
  const u = x - fx, v = y - fy, w = z - k;
  const i = fx & last, i1 = (fx + 1) & last, j = (fy & last) * side, j1 = ((fy + 1) & last) * side;
  const a = (j + i) * levels + k, b = (j + i1) * levels + k, c = (j1 + i) * levels + k, d = (j1 + i1) * levels + k;
  const low = (held[a] * (1 - u) + held[b] * u) * (1 - v) + (held[c] * (1 - u) + held[d] * u) * v;
  const high = (held[a + 1] * (1 - u) + held[b + 1] * u) * (1 - v) + (held[c + 1] * (1 - u) + held[d + 1] * u) * v;
  return low + (high - low) * w;
}

/** A texture with a cover: what extinction is computed from. */
export class Field {
  readonly numbers: KindNumbers;
  private readonly threshold: number;

  constructor(readonly texture: Texture, readonly cover: number) {
    this.numbers = texture.numbers;
    this.threshold = texture.threshold(cover);
  }

  /** Extinction, m-1, at places in m, z above the base. */
  extinction(x: number, y: number, z: number): number {
    const { thickness, levels, count, period, erosion, detail, edge, profile, extinction } = this.numbers;
    if (z < 0 || z > thickness) return 0;
    const place = (z / thickness) * levels - 0.5;
    let over = between(this.texture.shape, count, levels, (x * count) / period, (y * count) / period, place) - this.threshold;
    if (over <= 0) return 0;
    if (erosion > 0) {
      over -= erosion * wrapped(this.texture.detail, x / detail, y / detail, z / detail);
      if (over <= 0) return 0;
    }
    const share = Math.min(over / edge, 1);
    const held = Math.min(Math.max(place, 0), levels - 1);
    const k = Math.min(Math.floor(held), levels - 2);
    return share * share * (3 - 2 * share) * (profile[k] + (profile[k + 1] - profile[k]) * (held - k)) * extinction;
  }

  /** Mean extinction of cells of a coarse grid, `side` along the period, of four places in each. */
  means(side: number): Float32Array {
    const { levels, period, thickness } = this.numbers;
    const found = new Float32Array(side * side * levels);
    const [step, high] = [period / side, thickness / levels];
    for (let j = 0, at = 0; j < side; j++) {
      for (let i = 0; i < side; i++) {
        for (let k = 0; k < levels; k++, at++) {
          let total = 0;
          for (let s = 0; s < 4; s++) {
            const a = 0.25 + 0.5 * (s & 1), b = 0.25 + 0.5 * (s >> 1), c = 0.25 + 0.5 * ((s & 1) ^ (s >> 1));
            total += this.extinction((i + a) * step, (j + b) * step, (k + c) * high);
          }
          found[at] = 0.25 * total;
        }
      }
    }
    return found;
  }
}
