/** Diffusion of light through a coarse grid of cloud, on grids from coarse to fine: what hastens discrete ordinates.
 *
 * Grids are (up, north, east). What passes between cells is worked out once, and each column's equations are freed of the
 * cell below once. A second form of the package's `Diffusion`, of cloud that absorbs nothing.
 */

import table from "../../../data/clouds.json";

const { sweeps: SWEEPS, nothing: NOTHING, smeared: SMEARED } = table.diffusion;

/** A grid of `side` x `side` columns. */
export interface Grid {
  side: number;
  levels: number;
  /** Width and height of its cells, m. */
  dx: number;
  dz: number;
}

/** Means of two by two cells to north and east. */
export function paired(cells: Float32Array, side: number, levels: number): Float32Array {
  const half = side / 2, found = new Float32Array(half * half * levels);
  for (let k = 0, at = 0; k < levels; k++) {
    for (let j = 0; j < half; j++) {
      const low = (k * side + 2 * j) * side, high = low + side;
      for (let i = 0; i < half; i++, at++) found[at] = 0.25 * (cells[low + 2 * i] + cells[low + 2 * i + 1] + cells[high + 2 * i] + cells[high + 2 * i + 1]);
    }
  }
  return found;
}

/** Each cell of a grid of `half` x `half` columns four times. */
export function doubled(cells: Float32Array, half: number, levels: number): Float32Array {
  const side = 2 * half, found = new Float32Array(side * side * levels);
  for (let k = 0, at = 0; k < levels; k++) {
    for (let j = 0; j < side; j++) {
      const row = (k * half + (j >> 1)) * half;
      for (let i = 0; i < side; i++, at++) found[at] = cells[row + (i >> 1)];
    }
  }
  return found;
}

/** What passes between two cells for a difference of 1: their diffusivities in a row. */
const joined = (d: number, other: number, weight: number): number => (weight * 2 * d * other) / (d + other);

export class Diffusion {
  private readonly coarser: Diffusion | null;
  /** What passes to the next cell in the east and in the north, ... */
  private readonly east: Float32Array;
  private readonly north: Float32Array;
  /** ... and of each cell freed of the one below: what passes from above over what is lost, one over that, and what passes from below. */
  private readonly above: Float32Array;
  private readonly overLost: Float32Array;
  private readonly below: Float32Array;
  private readonly column: Float32Array;

  /** Diffusivity, m, from level to level and on one. */
  constructor(private readonly grid: Grid, upward: Float32Array, level: Float32Array) {
    const { side, levels, dx } = grid, count = upward.length;
    this.coarser = null; // one column, from which nothing goes to its sides, has none
    if (side > 1) {
      const wide = paired(level, side, levels), lost = side > 2 ? 1 : NOTHING;
      this.coarser = new Diffusion({ ...grid, side: side / 2, dx: 2 * dx }, paired(upward, side, levels), wide.map((value) => value * lost));
    }
    [this.east, this.north, this.above, this.overLost, this.below] = [0, 1, 2, 3, 4].map(() => new Float32Array(count)) as unknown as Float32Array[];
    this.column = new Float32Array(side * levels);
    this.join(level, 1 / (dx * dx));
    this.free(upward);
  }

  /** By transport extinction above 0, m-1. */
  static of(grid: Grid, extinction: Float32Array): Diffusion {
    const along = (step: number): Float32Array => extinction.map((value) => Math.hypot(1 / (3 * value), SMEARED * step));
    return new Diffusion(grid, along(grid.dz), along(grid.dx));
  }

  private join(level: Float32Array, across: number): void {
    const { side, levels } = this.grid, last = side - 1;
    for (let k = 0, at = 0; k < levels; k++) {
      for (let j = 0; j < side; j++) {
        const row = (k * side + j) * side, next = (k * side + ((j + 1) & last)) * side;
        for (let i = 0; i < side; i++, at++) {
          this.east[at] = joined(level[at], level[row + ((i + 1) & last)], across);
          this.north[at] = joined(level[at], level[next + i], across);
        }
      }
    }
  }

  private free(upward: Float32Array): void {
    const { side, levels, dz } = this.grid, { east, north, above, overLost } = this, plane = side * side, last = side - 1;
    const atEdge = (d: number): number => 0.5 / (dz * (1 + dz / (4 * d))); // Marshak's boundary
    for (let j = 0; j < side; j++) {
      for (let i = 0; i < side; i++) {
        const west = j * side + ((i - 1) & last), south = ((j - 1) & last) * side + i;
        let below = 0, before = 0;
        for (let k = 0, at = j * side + i; k < levels; k++, at += plane) {
          const d = upward[at], up = k < levels - 1 ? joined(d, upward[at + plane], 1 / (dz * dz)) : 0;
          let lost = east[at] + east[k * plane + west] + north[at] + north[k * plane + south] + below + up - below * below * before;
          if (k === 0 || k === levels - 1) lost += atEdge(d) * (levels === 1 ? 2 : 1);
          this.below[at] = below;
          before = 1 / lost;
          above[at] = up * before;
          overLost[at] = before;
          below = up;
        }
      }
    }
  }

  /** Fluence of a source, m-1, by -div(D grad fluence) = source; nothing comes in from outside. */
  fluence(source: Float32Array): Float32Array {
    const { side, levels } = this.grid;
    const found = this.coarser ? doubled(this.coarser.fluence(paired(source, side, levels)), side / 2, levels) : new Float32Array(source.length);
    for (let sweep = 0; sweep < 2 * SWEEPS; sweep++) for (let j = 0; j < side; j++) this.relax(source, found, j, (j + sweep) % 2);
    return found;
  }

  /** Solve every other column of a row whole. */
  private relax(source: Float32Array, fluence: Float32Array, j: number, from: number): void {
    const { side, levels } = this.grid, { east, north, above, overLost, below, column } = this, plane = side * side, last = side - 1;
    const south = ((j - 1) & last) * side, own = j * side, next = ((j + 1) & last) * side;
    for (let k = 0; k < levels; k++) {
      const level = k * plane, here = level + own, s = level + south, n = level + next, held = k * side;
      for (let i = from; i < side; i += 2) {
        const at = here + i, w = here + ((i - 1) & last), e = here + ((i + 1) & last);
        let won = source[at] + east[at] * fluence[e] + east[w] * fluence[w] + north[at] * fluence[n + i] + north[s + i] * fluence[s + i];
        if (k > 0) won += below[at] * column[held - side + i];
        column[held + i] = won * overLost[at];
      }
    }
    for (let k = levels - 1; k >= 0; k--) {
      const here = k * plane + own, held = k * side;
      for (let i = from; i < side; i += 2) fluence[here + i] = column[held + i] + (k < levels - 1 ? above[here + i] * fluence[here + i + plane] : 0);
    }
  }
}
