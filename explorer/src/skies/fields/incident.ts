/** The light of a clear sky on a field of cloud and the air before it, put together with what rays see. A second form of `Incident`. */

import table from "../../data/clouds.json";
import { skylight } from "./air/above";
import { exchanged, seenFromAbove, seenOf, type Exchange } from "./air/exchange";
import { EVEN, GROUND, LowerAir } from "./air/lower";
import type { FieldKind } from "./kinds";
import type { Lit } from "./lit";
import { DEPTHS, SEEN } from "./march";
import { seemingColours, type Phases } from "./scattering";
import { colourOf, depthOf, type ClearLight } from "./spectra";

const { views: VIEWS, angles: ANGLES, colours: COLOURS, earth: EARTH } = table;
/** Heights in the layer of cloud, and parts: the share of the air before it, sun, sky, ground, the sun scattered once, that air's diffuse light. */
const LEVELS = 3;
const PARTS = 6;

/** The law that light scattered once seems to follow, in the colours of the sun at the cloud. */
export function seemingLaw(kind: FieldKind, clear: ClearLight, phases: Phases): Float32Array {
  const weights = clear.sun.map((value, w) => COLOURS[w].map((colour) => colour * value));
  return seemingColours(phases, weights, table.kinds[kind].asymmetry ** 2);
}

/** Light on the field and in the air below it at one wavelength. */
class Wave {
  /** Even skylight of which the field lets as much through. */
  readonly fieldSky: number;
  readonly exchange: Exchange;
  private readonly lower: LowerAir;
  private readonly upon: number;
  private readonly ground: number;
  private readonly open: number;

  constructor(lit: Lit, kind: FieldKind, { sun, below, sky, depths, haze, upper, albedo }: ClearLight, private direct: number, w: number) {
    const { shares, ofSun } = lit, high = lit.sun[2], down = below[w] * high + sky[w];
    this.lower = new LowerAir(table.lower[kind].map((column, k) => column * depths[k][w]), haze.albedo, haze.g);
    const [upon, thick] = skylight(upper, w, sun[w] * high, seenFromAbove(shares, albedo));
    [this.upon, this.ground, this.open] = [upon, albedo * down, shares.open];
    this.fieldSky = thick + (upon - thick) * shares.open;
    const byAir = sky[w] - this.lower.down[EVEN] * upon - this.lower.down[GROUND] * this.ground;
    this.exchange = exchanged(this.lower, shares, sun[w] * ofSun + this.fieldSky * shares.through, direct * (down - sky[w]), direct * byAir, albedo);
  }

  /** What the lower air has of diffuse light, less the sun's share of what it has of it in the clear, where it lets shares `through`. */
  diffuse(sine: number, through: number[]): number[] {
    return this.lower.toward(sine, through).map((views) => {
      const clear = views[EVEN] * this.upon + views[GROUND] * this.ground;
      return seenOf(this.exchange, this.open, views) - this.direct * clear;
    });
  }
}

export class Incident {
  private readonly tables = new Float64Array(VIEWS * LEVELS * PARTS * 3);
  /** Share of the sun's light that comes straight to the air below. */
  private readonly direct: number;
  private readonly low: number;
  private readonly high: number;

  /** `seeming`: of `seemingLaw`. */
  constructor(readonly lit: Lit, kind: FieldKind, clear: ClearLight, private readonly seeming: Float32Array) {
    const { base, thickness } = table.kinds[kind];
    [this.low, this.high] = [base, base + thickness];
    this.direct = lit.beams.straight(Math.sqrt(1 - (1 - lit.sun[2] ** 2) * (EARTH / (EARTH + base)) ** 2));
    const waves = clear.sun.map((_, w) => new Wave(lit, kind, clear, this.direct, w));
    const lights = [clear.sun, waves.map((wave) => wave.fieldSky), waves.map((wave) => wave.exchange.below), clear.sun];
    for (let j = 0, at = 0; j < VIEWS; j++) {
      const mean = colourOf((w) => clear.mean[j][w]);
      const through = clear.sun.map((_, w) => table.between[kind][j].map((columns) => Math.exp(-Math.max(depthOf(columns, clear.depths, w), 0))));
      const diffuse = waves.map((wave, w) => wave.diffuse((j / (VIEWS - 1)) ** 2, through[w]));
      for (let level = 0; level < LEVELS; level++) {
        const before = colourOf((w) => {
          const all = -Math.expm1(-depthOf(table.ground[j], clear.depths, w));
          return clear.mean[j][w] * Math.min((1 - through[w][level]) / Math.max(all, 1e-30), 1);
        });
        const share = before.map((value, c) => value / (Math.abs(mean[c]) > 1e-30 ? mean[c] : 1));
        const parts = [share, ...lights.map((light) => colourOf((w) => through[w][level] * light[w])), colourOf((w) => diffuse[w][level])];
        for (const part of parts) for (let c = 0; c < 3; c++) this.tables[at++] = part[c];
      }
    }
  }

  /** What is left of the clear sky's light toward a direction, and what is added to it, XYZ; six numbers into `out`. */
  put(seen: Float64Array, a: number, b: number, upward: number, out: Float32Array, at: number): void {
    const { tables, seeming, lit } = this;
    const up = Math.min(Math.max(upward, 0), 1), far = seen[SEEN.far], through = seen[SEEN.through];
    const height = far * up + (far * far * (1 - up * up)) / (2 * EARTH);
    const row = Math.sqrt(up) * (VIEWS - 1), level = Math.min(Math.max((height - this.low) / (this.high - this.low), 0), 1) * (LEVELS - 1);
    const j = Math.min(Math.floor(row), VIEWS - 2), k = Math.min(Math.floor(level), LEVELS - 2), v = row - j, u = level - k;
    const cosine = a * lit.sun[0] + b * lit.sun[1] + upward * lit.sun[2];
    const place = Math.sqrt(Math.acos(Math.min(Math.max(cosine, -1), 1)) / Math.PI) * (ANGLES - 1);
    const n = Math.min(Math.floor(place), ANGLES - 2), t = place - n;
    for (let c = 0; c < 3; c++) {
      let once = 0;
      for (let depth = 0; depth < DEPTHS; depth++) {
        const part = seen[SEEN.once + depth];
        if (part > 0) once += part * (seeming[3 * (depth * ANGLES + n) + c] * (1 - t) + seeming[3 * (depth * ANGLES + n + 1) + c] * t);
      }
      let added = 0;
      for (let part = 0; part < PARTS; part++) {
        const first = (j * LEVELS + k) * PARTS * 3 + 3 * part + c, next = first + PARTS * 3, above = first + LEVELS * PARTS * 3;
        const lower = tables[first] * (1 - u) + tables[next] * u, upper = tables[above] * (1 - u) + tables[above + PARTS * 3] * u;
        const there = lower * (1 - v) + upper * v;
        if (part > 0 && part < PARTS - 1) {
          added += (part === PARTS - 2 ? once : seen[part]) * there;
          continue;
        }
        const top = first + (LEVELS - 1 - k) * PARTS * 3; // air before what passes goes up to there
        const whole = tables[top] * (1 - v) + tables[top + LEVELS * PARTS * 3] * v, air = there + (whole - there) * through;
        if (part === 0) out[at + c] = through * (1 - whole) + air * this.direct;
        else added += air;
      }
      out[at + 3 + c] = added;
    }
  }
}
