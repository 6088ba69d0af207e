/** The sun's own rays through a field: optical depths toward it, and how much of it meets the cloud of coarse cells. */

import table from "../../data/clouds.json";
import type { Vec3 } from "../../core/vector";
import { between, type Field } from "./field";
import type { Grid } from "./transport/diffusion";

const { fine: FINE, most: MOST, least: LEAST } = table.beams;
/** Rays along the period: a place of most kinds' shapes each. */
const RAYS = 256;

/** A second form of the package's `medium_kernel.beams`. */
export class Beams {
  /** Scaled depths (north, east, up) from places that lie along the rays: a level z above the base has them shifted by z toward the sun. */
  private readonly depths: Float32Array;
  private readonly count: number;
  private readonly side: number;
  /** Sunlight in each coarse cell (up, north, east) of what meets its cloud, for an irradiance of 1 on a plane that faces the sun. */
  readonly met: Float32Array;

  /** `gaps` (north, east, up) of the coarse grid; fewer rays and steps where that is coarser than the package's. */
  constructor(private readonly field: Field, private readonly sun: Vec3, kept: number, gaps: Float32Array, grid: Grid) {
    const { thickness, detail, levels, count } = field.numbers, share = (2 * grid.side) / count;
    this.side = RAYS * share;
    this.count = Math.max(Math.ceil(Math.min(thickness / sun[2] / (FINE * detail), MOST) * share), levels) + 1;
    this.depths = new Float32Array(this.side * this.side * this.count);
    const depth = new Float32Array(gaps.length), lost = new Float32Array(gaps.length);
    this.follow(kept, gaps, grid, depth, lost);
    this.met = lost.map((value, n) => value / Math.max(depth[n], LEAST));
  }

  /** Follow each ray from the top down; sums of the depths that they meet in the coarse cells, and of the light that they lose there. */
  private follow(kept: number, gaps: Float32Array, { side: cells, levels, dx, dz }: Grid, met: Float32Array, lost: Float32Array): void {
    const { field, sun, side, count, depths } = this, { thickness, period } = field.numbers;
    const step = period / side, high = thickness / (count - 1), long = (high / sun[2]) * kept, wrap = cells - 1;
    for (let j = 0, at = 0; j < side; j++) {
      for (let i = 0; i < side; i++, at += count) {
        let total = 0;
        for (let k = count - 2; k >= 0; k--) {
          const z = (k + 0.5) * high, x = i * step + (z * sun[0]) / sun[2], y = j * step + (z * sun[1]) / sun[2];
          const c = Math.min(Math.floor(z / dz), levels - 1), a = Math.floor(x / dx) & wrap, b = Math.floor(y / dx) & wrap;
          if (gaps[(b * cells + a) * levels + c] === 0) {
            const depth = field.extinction(x, y, z) * long, cell = (c * cells + b) * cells + a;
            if (depth > 0) {
              met[cell] += depth;
              lost[cell] += Math.exp(-total) * -Math.expm1(-depth);
              total += depth;
            }
          }
          depths[at + k] = total;
        }
      }
    }
  }

  /** Scaled depth from a place in m, z above the base, toward the sun. */
  depth(x: number, y: number, z: number): number {
    const { sun, side, count } = this, { period, thickness } = this.field.numbers, step = period / side, lean = z / sun[2];
    return between(this.depths, side, count, (x - lean * sun[0]) / step, (y - lean * sun[1]) / step, (z / thickness) * (count - 1));
  }

  /** Share of the sun's light that comes straight through the field, on a way through it at a sine. */
  straight(sine: number): number {
    let total = 0;
    for (let at = 0; at < this.depths.length; at += this.count) total += Math.exp(-this.depths[at] * (this.sun[2] / sine));
    return total / this.side ** 2;
  }
}
