/** A field under its lights: depths toward the sun, scattered light of sun, sky and ground. A second form of the package's `LitField`. */

import table from "../../data/clouds.json";
import type { Vec3 } from "../../core/vector";
import { openShare, type Shares } from "./air/exchange";
import { Beams } from "./beams";
import type { Field } from "./field";
import type { Grid } from "./transport/diffusion";
import { Ordinates, type Light } from "./transport/ordinates";

const { lowest: LOWEST, widths: WIDTHS } = table;
/** Numbers of each cell that rays of the eye read. */
export const READ = 8;

/** A sun no lower than the lowest whose shadows are let down. */
export function heldUp(sun: Vec3): Vec3 {
  const high = Math.max(sun[2], LOWEST);
  const flat = Math.sqrt(1 - high * high) / Math.max(Math.hypot(sun[0], sun[1]), 1e-12);
  return [sun[0] * flat, sun[1] * flat, high];
}

/** A field on a coarse grid, with what does not depend on the sun. */
export class Cells {
  readonly grid: Grid;
  /** Metres around each cell that are free of cloud, (north, east, up). */
  readonly gaps: Float32Array;
  readonly asymmetry: number;
  /** Share of the extinction that stays when the forward peak g^2 is taken out. */
  readonly kept: number;
  readonly open: number;
  private readonly ordinates: Ordinates;
  /** Scaled extinction, m-1, (up, north, east). */
  private readonly sigma: Float32Array;
  private ofSky: Light | null = null;

  constructor(readonly field: Field, side: number) {
    const { period, thickness, levels, asymmetry } = field.numbers, plane = side * side;
    this.grid = { side, levels, dx: period / side, dz: thickness / levels };
    [this.asymmetry, this.kept] = [asymmetry, 1 - asymmetry ** 2];
    const coarse = field.means(side), columns = new Float32Array(plane), seen = new Uint8Array(coarse.length);
    this.gaps = gapsOf(coarse, this.grid);
    this.sigma = new Float32Array(coarse.length);
    const near = widened(Uint8Array.from(coarse, (value) => Number(value > 0)), this.grid, 1, 1);
    for (let column = 0, n = 0; column < plane; column++) {
      for (let k = 0; k < levels; k++, n++) {
        const scaled = coarse[n] * this.kept;
        this.sigma[k * plane + column] = scaled;
        seen[k * plane + column] = near[n];
        columns[column] += scaled * this.grid.dz;
      }
    }
    this.open = openShare(columns);
    this.ordinates = new Ordinates(this.grid, this.sigma, asymmetry / (1 + asymmetry), seen);
  }

  /** The same under a sun, with pauses. */
  *under(sun: Vec3): Generator<void, Lit> {
    this.ofSky ??= yield* this.ordinates.found(null, 1);
    const beams = new Beams(this.field, sun, this.kept, this.gaps, this.grid), { met } = beams;
    yield;
    let meets = 0;
    for (let n = 0; n < met.length; n++) meets += (met[n] * this.sigma[n]) / met.length;
    const scale = (sun[2] * (1 - beams.straight(sun[2]))) / Math.max(meets * this.field.numbers.thickness, 1e-30); // what is lost is scattered
    const first = this.ordinates.beam(met.map((value) => value * scale), sun);
    return new Lit(this, sun, beams, yield* this.ordinates.found(first, 0), this.ofSky);
  }
}

/** Cells under a sun, ready for rays. */
export class Lit {
  /** What of sunlight of irradiance 1 on a plane that faces it is scattered down, on the horizontal. */
  readonly ofSun: number;
  readonly shares: Shares;
  /** Fluence and flux to east, north and up of the sun's light, and of the sky's, (north, east, up, READ). */
  readonly light: Float32Array;

  constructor(readonly cells: Cells, readonly sun: Vec3, readonly beams: Beams, ofSun: Light, ofSky: Light) {
    this.ofSun = ofSun.down;
    this.shares = { open: cells.open, through: ofSky.down, back: 1 - ofSky.down };
    const { side, levels } = cells.grid, plane = side * side, parts = [...ofSun.parts, ...ofSky.parts];
    this.light = new Float32Array(READ * plane * levels);
    parts.forEach((part, p) => {
      for (let k = 0, at = 0; k < levels; k++) for (let column = 0; column < plane; column++, at++) this.light[READ * (column * levels + k) + p] = part[at];
    });
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
