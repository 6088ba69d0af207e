/** Discrete ordinates through a coarse grid of cloud: fluence and flux of all light scattered; gaps are as they are.
 *
 * A second form of the package's `Ordinates` and its kernel, of cloud that absorbs nothing: rays go from cell to cell, straight up or
 * down a cell over as long a way as their slant has, then over to the nearest cell of where they come out. Directions come in fours.
 * Steps begin with what cells twice as wide have.
 */

import table from "../../../data/clouds.json";
import type { Vec3 } from "../../../core/vector";
import { Diffusion, doubled, paired, type Grid } from "./diffusion";

const { change: CHANGE, wideChange: WIDE_CHANGE, most: MOST, narrowest: NARROWEST, thin: THIN, least: LEAST } = table.ordinates;
const [SINES, SHARES] = table.ordinates.slants;
const SLANTS = SINES.length, FOUR_PI = 4 * Math.PI;

/** Fluence and flux to east, north and up, each (up, north, east), and the flux that goes out of the bottom. */
export interface Light {
  parts: Float32Array[];
  down: number;
}

/** Rays of a slant: steps through a level, their length, m, and what cells make of light along one. */
interface Slant {
  count: number;
  long: number;
  /** (1 - exp(-t)) / t of their optical depths t, and what a source that grows by 1 along a step sends ahead over what an even one does. */
  met: Float32Array;
  bent: Float32Array;
}

/** A direction that stands for four, a quarter turn apart: to east, north and up, what it counts at a step, sr, and the cells gone at each step. */
interface Way {
  a: number;
  b: number;
  c: number;
  weight: number;
  slant: Slant;
  /** (steps, quarters, 2): to east and north. */
  hops: Int32Array;
}

function slantOf(sine: number, { side, levels, dx, dz }: Grid, sigma: Float32Array): Slant {
  const count = Math.max(Math.ceil(((Math.sqrt(1 - sine * sine) / sine) * dz) / dx), 1), long = dz / sine / count;
  const met = new Float32Array(side * side * levels), bent = new Float32Array(met.length);
  for (let n = 0; n < met.length; n++) {
    const t = long * sigma[n], gone = -Math.expm1(-t);
    met[n] = t > THIN ? gone / t : 1 - t / 2 + (t * t) / 6;
    bent[n] = t > THIN ? (1 - gone / 2 - gone / t) / t : t / 12;
  }
  return { count, long, met, bent };
}

function wayOf(n: number, slant: Slant, { side, levels, dx, dz }: Grid): Way {
  const up = n >= SLANTS ? 1 : -1, sine = SINES[n % SLANTS], flat = Math.sqrt(1 - sine * sine);
  const azimuth = (Math.PI / 4) * (0.5 + ((n + Math.floor(n / SLANTS)) % 2));
  const a = flat * Math.sin(azimuth), b = flat * Math.cos(azimuth), { count } = slant;
  const each = dz / dx / sine / count, turns = [a, b, -b, a, -a, -b, b, -a];
  const hops = Int32Array.from({ length: 8 * count * levels }, (_, k) => Math.floor(turns[k % 8] * each * (Math.floor(k / 8) + 0.5) + 0.5) & (side - 1));
  return { a, b, c: up * sine, weight: ((Math.PI / 2) * SHARES[n % SLANTS]) / count, slant, hops };
}

export class Ordinates {
  private readonly ways: Way[];
  private readonly diffusion: Diffusion;
  /** Light on the rays of a direction, four planes. */
  private readonly rays: Float32Array[];
  /** Columns of the cells that are looked at, row by row, and where each row of each level begins among them. */
  private readonly columns: Int16Array;
  private readonly begins: Int32Array;
  /** By cells twice as wide; null where these are the widest. */
  private readonly wider: Ordinates | null;

  /** Through cells of scaled extinction, m-1, (up, north, east), that scatter with a mean cosine of `asymmetry`; light is wanted
   *  in those `seen` alone, all that hold cloud and those beside: through others rays go as they are. */
  constructor(readonly grid: Grid, private readonly sigma: Float32Array, private readonly asymmetry: number, private readonly seen: Uint8Array) {
    const { side, levels, dz } = grid, openAir = 1 / (dz * levels);
    const slants = SINES.map((sine) => slantOf(sine, grid, sigma));
    this.ways = Array.from({ length: 2 * SLANTS }, (_, n) => wayOf(n, slants[n % SLANTS], grid));
    this.rays = [0, 1, 2, 3].map(() => new Float32Array(side * side));
    this.begins = new Int32Array(side * levels + 1);
    this.columns = new Int16Array(seen.reduce((total, each) => total + each, 0));
    for (let row = 0, n = 0; row < side * levels; row++) {
      for (let i = 0; i < side; i++) if (seen[row * side + i]) this.columns[n++] = i;
      this.begins[row + 1] = n;
    }
    const wide = { ...grid, side: side / 2, dx: 2 * grid.dx };
    const beside = side > NARROWEST ? Uint8Array.from(paired(Float32Array.from(seen), side, levels), (value) => Number(value > 0)) : null;
    this.wider = beside && new Ordinates(wide, paired(sigma, side, levels), asymmetry, beside);
    this.diffusion = Diffusion.of(grid, sigma.map((value) => Math.max((1 - asymmetry) * value, openAir)));
  }

  /** What a beam of so much light in each cell, from the sun, makes them send. */
  beam(light: Float32Array, sun: Vec3): Float32Array[] {
    return [1, ...sun.map((part) => -3 * this.asymmetry * part)].map((share) => light.map((value) => (share * value) / FOUR_PI));
  }

  /** Light where cells send `first` besides what they scatter, and a flux comes in from above; with a pause after each step. */
  *found(first: Float32Array[] | null, above: number): Generator<void, Light> {
    let light = yield* this.begun(first, above), down = 0;
    const enough = this.wider ? CHANGE : WIDE_CHANGE, count = this.sigma.length;
    for (let step = 0; step < MOST; step++) {
      const next = this.swept(light, first, above / Math.PI), [fluence] = next.parts, [before] = light;
      const changed = new Float32Array(count);
      for (let n = 0; n < count; n++) changed[n] = (fluence[n] - before[n]) * this.sigma[n];
      const more = this.diffusion.fluence(changed);
      let change = 0, whole = 0;
      for (let n = 0; n < count; n++) {
        if (!this.seen[n]) continue;
        fluence[n] += more[n];
        change += Math.abs(fluence[n] - before[n]);
        whole += fluence[n];
      }
      [light, down] = [next.parts, next.down];
      if (change < enough * whole) break;
      yield;
    }
    for (let n = 0; n < count; n++) light[0][n] = Math.max(light[0][n], 0);
    return { parts: light, down };
  }

  /** What cells twice as wide have, nothing where these are the widest. */
  private *begun(first: Float32Array[] | null, above: number): Generator<void, Float32Array[]> {
    const { wider, grid: { side, levels } } = this;
    if (!wider) return [0, 1, 2, 3].map(() => new Float32Array(this.sigma.length));
    const { parts } = yield* wider.found(first && this.ofWider(wider, first), above);
    return parts.map((part) => doubled(part, side / 2, levels));
  }

  /** What cells twice as wide send where these send `first`. */
  private ofWider(wider: Ordinates, first: Float32Array[]): Float32Array[] {
    const { side, levels } = this.grid;
    return first.map((part) => {
      const met = new Float32Array(part.length);
      for (let n = 0; n < met.length; n++) met[n] = this.sigma[n] * part[n];
      return paired(met, side, levels).map((value, n) => value / Math.max(wider.sigma[n], LEAST));
    });
  }

  /** Fluence and flux by one sweep along all directions. */
  private swept(light: Float32Array[], first: Float32Array[] | null, entering: number): Light {
    const { levels } = this.grid;
    const sent = light.map((part, p) => {
      const share = (p > 0 ? 3 * this.asymmetry : 1) / FOUR_PI, more = first?.[p], found = new Float32Array(part.length);
      for (let n = 0; n < found.length; n++) found[n] = more ? share * part[n] + more[n] : share * part[n];
      return found;
    });
    const parts = light.map((part) => new Float32Array(part.length));
    let down = 0;
    for (const way of this.ways) {
      for (const ray of this.rays) ray.fill(way.c < 0 ? entering : 0);
      for (let place = 0; place < levels * way.slant.count; place++) {
        const level = Math.floor(place / way.slant.count);
        this.cross(way, way.c < 0 ? levels - 1 - level : level, place, sent, parts);
      }
      if (way.c < 0) down += this.leaving(way);
    }
    return { parts, down };
  }

  /** Flux that the rays of a direction carry out. */
  private leaving({ weight, c, slant }: Way): number {
    const total = this.rays.reduce((sum, ray) => ray.reduce((a, b) => a + b, sum), 0);
    return (weight * Math.abs(c) * slant.count * total) / this.rays[0].length;
  }

  /** Carry the rays of a direction through a level, and add the cells' light to `out`. */
  private cross({ a, b, c, weight, slant, hops }: Way, k: number, place: number, sent: Float32Array[], out: Float32Array[]): void {
    const { side, levels } = this.grid, { sigma, columns, begins } = this, { met, bent, long, count } = slant, last = side - 1, plane = side * side;
    const [s0, s1, s2, s3] = sent, [o0, o1, o2, o3] = out, [r0, r1, r2, r3] = this.rays, h = 8 * place;
    const [x0, y0, x1, y1, x2, y2, x3, y3] = hops.subarray(h, h + 8);
    const below = k > 0 ? -plane : 0, over = k < levels - 1 ? plane : 0;
    const grown = ((c > 0 ? 1 : -1) * (below && over ? 0.5 : 1)) / count, tall = weight * c, wa = weight * a, wb = weight * b;
    for (let j = 0; j < side; j++) {
      const row = k * plane + j * side, from = begins[k * side + j], to = begins[k * side + j + 1];
      const j0 = ((j - y0) & last) * side, j1 = ((j - y1) & last) * side, j2 = ((j - y2) & last) * side, j3 = ((j - y3) & last) * side;
      for (let n = from; n < to; n++) {
        const i = columns[n], at = row + i, up = s3[at], x = s1[at], y = s2[at];
        const base = s0[at] + c * up, across = a * x + b * y, along = a * y - b * x;
        const m = met[at], lost = long * sigma[at], rising = grown * bent[at] * (s0[at + over] - s0[at + below]);
        const n0 = j0 + ((i - x0) & last), n1 = j1 + ((i - x1) & last), n2 = j2 + ((i - x2) & last), n3 = j3 + ((i - x3) & last);
        const v0 = r0[n0], v1 = r1[n1], v2 = r2[n2], v3 = r3[n3];
        const e0 = m * (v0 - base - across) - rising, e1 = m * (v1 - base - along) - rising;
        const e2 = m * (v2 - base + across) - rising, e3 = m * (v3 - base + along) - rising;
        r0[n0] = v0 - lost * e0;
        r1[n1] = v1 - lost * e1;
        r2[n2] = v2 - lost * e2;
        r3[n3] = v3 - lost * e3;
        const total = 4 * base + e0 + e1 + e2 + e3, way = 2 * across + e0 - e2, side2 = 2 * along + e1 - e3;
        o0[at] += weight * total;
        o3[at] += tall * total;
        o1[at] += wa * way - wb * side2;
        o2[at] += wb * way + wa * side2;
      }
    }
  }
}
