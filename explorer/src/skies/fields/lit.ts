/** A field under its lights: depths toward the sun, diffused light of sun, sky and ground. A second form of the package's `LitField`. */

import table from "../../data/clouds.json";
import type { Vec3 } from "../../core/vector";
import { openShare, type Shares } from "./air/exchange";
import { moved, spread, type Grid } from "./diffusion";
import { between, type Field } from "./field";

const { lowest: LOWEST, widths: WIDTHS, open: OPEN } = table;
const LEAST = 1e-9;

/** A sun no lower than the lowest whose shadows are let down. */
export function heldUp(sun: Vec3): Vec3 {
  const high = Math.max(sun[2], LOWEST);
  const flat = Math.sqrt(1 - high * high) / Math.max(Math.hypot(sun[0], sun[1]), 1e-12);
  return [sun[0] * flat, sun[1] * flat, high];
}

/** A field on a coarse grid, with what does not depend on the sun. */
export class Cells {
  readonly grid: Grid;
  readonly coarse: Float32Array;
  /** Metres around each cell that are free of cloud. */
  readonly gaps: Float32Array;
  /** Fluence for a skylight of irradiance 1 from above. */
  readonly ofSky: Float32Array;
  readonly asymmetry: number;
  readonly kept: number;
  /** Transport extinction that stands for empty air, m-1, in the diffusion of sunlight; and of sky and ground. */
  readonly openToSun: number;
  private readonly openToSky: number;

  constructor(readonly field: Field, side: number) {
    const { period, thickness, levels, asymmetry } = field.numbers;
    this.grid = { side, levels, dx: period / side, dz: thickness / levels };
    this.asymmetry = asymmetry;
    this.kept = 1 - asymmetry ** 2;
    this.openToSun = 1 / Math.sqrt(Math.max(field.cover, LEAST) * thickness * OPEN[0]);
    this.openToSky = 1 / (OPEN[1] * thickness);
    this.coarse = field.means(side);
    this.gaps = gapsOf(this.coarse, this.grid);
    this.ofSky = this.held(spread(this.grid, this.diffusivity(this.openToSky), null, 1));
  }

  private held(fluence: Float32Array): Float32Array {
    return fluence.map((value) => Math.max(value, 0));
  }

  /** 1 / (3 transport extinction), m, that of empty air in the gaps. */
  private diffusivity(open: number): Float32Array {
    return this.coarse.map((value) => 1 / (3 * Math.max((1 - this.asymmetry) * value, open)));
  }

  /** The same under a sun; `moving`: that stands near to the one before, by few sweeps. */
  under(sun: Vec3, moving = false): Lit {
    const depths = this.depths(sun), diffusivity = this.diffusivity(this.openToSun), source = this.source(sun, depths);
    const { last, grid } = this;
    const ofSun = this.held(moving && last ? moved(grid, diffusivity, source, last) : spread(grid, diffusivity, source, 0));
    this.last = ofSun;
    return new Lit(this, sun, depths, ofSun);
  }

  /** Fluence of the sun before. */
  private last: Float32Array | null = null;

  /** Optical depth, less the forward peak, from each cell's middle toward the sun, by slices from the top down. */
  private depths(sun: Vec3): Float32Array {
    const { side, levels, dx, dz } = this.grid;
    const sigma = this.coarse.map((value) => value * this.kept);
    const found = new Float32Array(sigma.length);
    const [shiftX, shiftY, long] = [((dz * sun[0]) / sun[2]) / dx, ((dz * sun[1]) / sun[2]) / dx, dz / sun[2]];
    const count = Math.floor(Math.hypot(shiftX, shiftY)) + 1;
    for (let k = levels - 1; k >= 0; k--) {
      for (let j = 0; j < side; j++) {
        for (let i = 0; i < side; i++) {
          const at = (j * side + i) * levels + k;
          if (k === levels - 1) {
            found[at] = 0.5 * long * sigma[at];
            continue;
          }
          let total = 0;
          for (let n = 0; n < count; n++) {
            const s = (n + 0.5) / count;
            total += between(sigma, side, levels, i + s * shiftX, j + s * shiftY, k + s);
          }
          found[at] = between(found, side, levels, i + shiftX, j + shiftY, k + 1) + (total * long) / count;
        }
      }
    }
    return found;
  }

  /** Share of the sun's light that comes straight through, on a way through the field at a sine. */
  straight(sun: Vec3, depths: Float32Array, sine = sun[2]): number {
    const { side, levels, dz } = this.grid;
    let total = 0;
    for (let at = 0; at < depths.length; at += levels) total += Math.exp(-(depths[at] + ((0.5 * dz) / sun[2]) * this.kept * this.coarse[at]) * (sun[2] / sine));
    return total / (side * side);
  }

  /** What the beam gives to the diffusion of sunlight, m-1. */
  private source(sun: Vec3, depths: Float32Array): Float32Array {
    const { side, levels, dx, dz } = this.grid;
    const beam = this.coarse.map((value, n) => value * this.kept * Math.exp(-depths[n]));
    const mean = beam.reduce((a, b) => a + b, 0) / beam.length;
    const scale = (sun[2] * (1 - this.straight(sun, depths))) / Math.max(mean * this.field.numbers.thickness, 1e-30);
    const forward = this.diffusivity(this.openToSun);
    for (let n = 0; n < beam.length; n++) {
      beam[n] *= scale; // what is lost is scattered
      forward[n] *= 3 * beam[n] * (this.asymmetry / (1 + this.asymmetry));
    }
    const found = new Float32Array(beam.length);
    const last = side - 1;
    for (let j = 0, at = 0; j < side; j++) {
      const j0 = ((j - 1) & last) * side, j1 = ((j + 1) & last) * side;
      for (let i = 0; i < side; i++) {
        const n0 = (j0 + i) * levels, n1 = (j1 + i) * levels;
        const n2 = (j * side + ((i - 1) & last)) * levels, n3 = (j * side + ((i + 1) & last)) * levels;
        for (let k = 0; k < levels; k++, at++) {
          const below = k > 0 ? forward[at - 1] : -forward[at], above = k < levels - 1 ? forward[at + 1] : -forward[at];
          found[at] = beam[at] + (sun[1] * (forward[n1 + k] - forward[n0 + k]) + sun[0] * (forward[n3 + k] - forward[n2 + k])) / (2 * dx)
            + (sun[2] * (above - below)) / (2 * dz);
        }
      }
    }
    return found;
  }

  /** What a field makes of sunlight of irradiance 1, on the horizontal below it, and of diffuse light. */
  budget(ofSun: Float32Array): [number, Shares] {
    const { side, levels, dz } = this.grid, ofGround = this.ofSky.map((value) => 4 - value);
    const columns = new Float32Array(side * side);
    this.coarse.forEach((value, n) => (columns[Math.floor(n / levels)] += value * dz * this.kept));
    const shares = { open: openShare(columns), through: this.leaving(this.ofSky, this.openToSky, 0), back: 1 + this.leaving(ofGround, this.openToSky, 1) };
    return [this.leaving(ofSun, this.openToSun, 0), shares];
  }

  /** Mean net flux out of the field's bottom, where a flux comes in. */
  private leaving(fluence: Float32Array, open: number, entering: number): number {
    const { side, levels, dz } = this.grid;
    let total = 0;
    for (let at = 0; at < fluence.length; at += levels) {
      const transport = Math.max((1 - this.asymmetry) * this.coarse[at], open);
      total += (fluence[at] / 2 - 2 * entering) / (1 + 0.75 * dz * transport);
    }
    return total / (side * side);
  }
}

/** Cells under a sun, ready for rays. */
export class Lit {
  /** What of sunlight of irradiance 1 is scattered down, on the horizontal. */
  readonly ofSun: number;
  readonly shares: Shares;
  /** For each cell the scaled depth toward the sun, and the fluences of sun and sky; the ground's is 4 less the sky's. */
  readonly light: Float32Array;

  constructor(readonly cells: Cells, readonly sun: Vec3, private readonly depths: Float32Array, ofSun: Float32Array) {
    [this.ofSun, this.shares] = cells.budget(ofSun);
    this.light = new Float32Array(3 * depths.length);
    for (let n = 0; n < depths.length; n++) {
      this.light[3 * n] = depths[n];
      this.light[3 * n + 1] = ofSun[n];
      this.light[3 * n + 2] = cells.ofSky[n];
    }
  }

  /** Share of the sun's light that comes straight through, on a way through the field at a sine. */
  straight(sine: number): number {
    return this.cells.straight(this.sun, this.depths, sine);
  }
}

/** Metres around each cell that are free of cloud, 0 within it and beside it. */
function gapsOf(coarse: Float32Array, grid: Grid): Float32Array {
  const found = new Float32Array(coarse.length);
  let taken = Uint8Array.from(coarse, (value) => Number(value > 0));
  taken = widened(taken, grid, 1, 1);
  let [level, upward] = [0, 0];
  for (const width of WIDTHS) {
    const free = grid.dz * width;
    const [wide, high] = [Math.ceil(free / grid.dx), Math.round(free / grid.dz)];
    taken = widened(taken, grid, wide - level, high - upward);
    for (let n = 0; n < found.length; n++) if (!taken[n]) found[n] = free;
    [level, upward] = [wide, high];
  }
  return found;
}

/** Cells within so many cells of those taken; around to north and east. */
function widened(taken: Uint8Array<ArrayBuffer>, { side, levels }: Grid, level: number, upward: number): Uint8Array<ArrayBuffer> {
  const last = side - 1;
  for (const north of [true, false]) {
    for (let time = 0; time < level; time++) {
      const wider = taken.slice();
      for (let j = 0; j < side; j++) {
        for (let i = 0; i < side; i++) {
          const at = (j * side + i) * levels;
          const before = (north ? ((j - 1) & last) * side + i : j * side + ((i - 1) & last)) * levels;
          const after = (north ? ((j + 1) & last) * side + i : j * side + ((i + 1) & last)) * levels;
          for (let k = 0; k < levels; k++) wider[at + k] |= taken[before + k] | taken[after + k];
        }
      }
      taken = wider;
    }
  }
  for (let time = 0; time < upward; time++) {
    const wider = taken.slice();
    for (let at = 0; at < taken.length; at += levels) {
      for (let k = 0; k < levels; k++) {
        if (k > 0) wider[at + k] |= taken[at + k - 1];
        if (k < levels - 1) wider[at + k] |= taken[at + k + 1];
      }
    }
    taken = wider;
  }
  return taken;
}
