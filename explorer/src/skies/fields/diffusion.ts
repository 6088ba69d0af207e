/** Diffusion of light through a coarse grid of cloud: columns solved whole, red and black in turn, from coarser grids on. */

import table from "../../data/clouds.json";

/** A grid (north, east, up) of `side` x `side` columns. */
export interface Grid {
  side: number;
  levels: number;
  /** Width and height of its cells, m. */
  dx: number;
  dz: number;
}

/** Fluence of -div(D grad fluence) = source into `fluence`, the first guess; a flux `top` falls in from above (Marshak). */
function relax({ side, levels, dx, dz }: Grid, diffusivity: Float32Array, source: Float32Array | null, top: number, sweeps: number, fluence: Float32Array): void {
  const [across, along, last, over] = [2 / (dx * dx), 2 / (dz * dz), side - 1, table.over];
  const [own, given, beyond] = [new Float64Array(levels), new Float64Array(levels), new Float64Array(levels)];
  for (let sweep = 0; sweep < 2 * sweeps; sweep++) {
    for (let j = 0; j < side; j++) {
      const j0 = ((j - 1) & last) * side, j1 = ((j + 1) & last) * side;
      for (let i = (j + sweep) % 2; i < side; i += 2) {
        const at = (j * side + i) * levels;
        const n0 = (j0 + i) * levels, n1 = (j1 + i) * levels;
        const n2 = (j * side + ((i - 1) & last)) * levels, n3 = (j * side + ((i + 1) & last)) * levels;
        let below = 0;
        for (let k = 0; k < levels; k++) {
          const d = diffusivity[at + k];
          const d0 = diffusivity[n0 + k], d1 = diffusivity[n1 + k], d2 = diffusivity[n2 + k], d3 = diffusivity[n3 + k];
          const w0 = (across * d * d0) / (d + d0), w1 = (across * d * d1) / (d + d1);
          const w2 = (across * d * d2) / (d + d2), w3 = (across * d * d3) / (d + d3);
          const next = k < levels - 1 ? diffusivity[at + k + 1] : 0;
          const above = next && (along * d * next) / (d + next);
          let here = w0 + w1 + w2 + w3 + below + above;
          let won = w0 * fluence[n0 + k] + w1 * fluence[n1 + k] + w2 * fluence[n2 + k] + w3 * fluence[n3 + k];
          if (source) won += source[at + k];
          if (k === 0 || k === levels - 1) {
            const edge = 1 / (dz * (1 + dz / (4 * d)));
            here += 0.5 * edge;
            if (k > 0) won += 2 * top * edge;
          }
          if (k > 0) {
            const share = below / own[k - 1];
            here -= share * below;
            won += share * given[k - 1];
          }
          own[k] = here;
          given[k] = won;
          beyond[k] = below = above;
        }
        let found = 0;
        for (let k = levels - 1; k >= 0; k--) {
          found = (given[k] + beyond[k] * found) / own[k];
          fluence[at + k] += over * (found - fluence[at + k]);
        }
      }
    }
  }
}

/** Means of two by two cells to north and east. */
export function paired(cells: Float32Array, side: number, levels: number): Float32Array {
  const half = side / 2;
  const found = new Float32Array(half * half * levels);
  for (let j = 0, at = 0; j < half; j++) {
    for (let i = 0; i < half; i++) {
      const a = (2 * j * side + 2 * i) * levels, b = a + side * levels;
      for (let k = 0; k < levels; k++, at++) found[at] = 0.25 * (cells[a + k] + cells[a + levels + k] + cells[b + k] + cells[b + levels + k]);
    }
  }
  return found;
}

/** Each column four times. */
function doubled(cells: Float32Array, half: number, levels: number): Float32Array {
  const side = 2 * half;
  const found = new Float32Array(side * side * levels);
  for (let j = 0, at = 0; j < side; j++) {
    for (let i = 0; i < side; i++, at += levels) {
      const from = ((j >> 1) * half + (i >> 1)) * levels;
      found.set(cells.subarray(from, from + levels), at);
    }
  }
  return found;
}

/** Sweeps that bring a fluence near to what it is under a sun not far away. */
const FEW = 4;

/** A fluence moved toward that of another source. */
export function moved(grid: Grid, diffusivity: Float32Array, source: Float32Array, fluence: Float32Array): Float32Array {
  const found = fluence.slice();
  relax(grid, diffusivity, source, 0, FEW, found);
  return found;
}

/** The fluence, whose first guess is that of a grid twice as coarse. */
export function spread(grid: Grid, diffusivity: Float32Array, source: Float32Array | null, top: number): Float32Array {
  const { side, levels, dx } = grid;
  let fluence: Float32Array;
  if (side > table.fewest) {
    const coarser = { ...grid, side: side / 2, dx: 2 * dx };
    fluence = doubled(spread(coarser, paired(diffusivity, side, levels), source && paired(source, side, levels), top), side / 2, levels);
  } else fluence = new Float32Array(side * side * levels).fill(2 * top);
  relax(grid, diffusivity, source, top, table.sweeps, fluence);
  return fluence;
}
