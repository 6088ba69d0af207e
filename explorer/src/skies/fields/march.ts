/** Rays through a lit field: what is seen through it, and what it sends of sun, sky and ground. A second form of `march_kernel`. */

import table from "../../data/clouds.json";
import type { Vec3 } from "../../core/vector";
import { between } from "./field";
import { heldUp, type Lit } from "./lit";

const { earth: EARTH, gone: GONE, dense: DENSE, farthest: FARTHEST, first: FIRST, step: STEP } = table;
/** Scaled depths by which light scattered once is told apart. */
export const DEPTHS = table.depths;
/** Where the parts of what is seen lie: transmittance, sun, sky, ground, distance, and light scattered once by depth. */
export const SEEN = { through: 0, sun: 1, sky: 2, ground: 3, far: 4, once: 5 } as const;

/** Diffuse light scattered toward the eye, by the fluence somewhat before and behind. */
function onward(low: number, high: number, way: number, ahead: number): number {
  const fluence = 0.5 * (low + high);
  return (fluence + Math.min(Math.max(way * (high - low) + ahead, -fluence), fluence)) / (4 * Math.PI);
}

/** Distance at which a ray comes to a height over the round ground, m. */
function distanceTo(height: number, up: number): number {
  const curve = (1 - up * up) / (2 * EARTH);
  return (2 * height) / (up + Math.sqrt(up * up + 4 * curve * height));
}

export class Rays {
  readonly seen = new Float64Array(5 + DEPTHS);
  private readonly depth: Float32Array;
  private ofSun = 0;
  private ofSky = 0;

  constructor(private readonly lit: Lit) {
    this.depth = lit.light.filter((_, n) => n % 3 === 0);
  }

  /** Fluences of sun and sky at a place in cells, down to the base, into `ofSun` and `ofSky`. */
  private fluences(x: number, y: number, z: number, lowest: number): void {
    const { side, levels } = this.lit.cells.grid, { light } = this.lit;
    const left = 1 - (2 * Math.min(Math.max(-z, 0), 0.5) * 1.5 * lowest) / (1 + 1.5 * lowest);
    z = Math.min(Math.max(z, 0), levels - 1.000001);
    const fx = Math.floor(x), fy = Math.floor(y), k = Math.floor(z), last = side - 1;
    const u = x - fx, v = y - fy, w = z - k;
    const i = fx & last, i1 = (fx + 1) & last, j = (fy & last) * side, j1 = ((fy + 1) & last) * side;
    let sun = 0, sky = 0;
    for (let n = 0; n < 4; n++) {
      const at = 3 * (((n & 2 ? j1 : j) + (n & 1 ? i1 : i)) * levels + k);
      const weight = (n & 1 ? u : 1 - u) * (n & 2 ? v : 1 - v);
      sun += weight * (light[at + 1] * (1 - w) + light[at + 4] * w);
      sky += weight * (light[at + 2] * (1 - w) + light[at + 5] * w);
    }
    this.ofSun = sun * left;
    this.ofSky = sky * left;
  }

  /** Scaled optical depth from a place to the sun: a few steps through the field itself, and that of the cells beyond. */
  private depthToSun(x: number, y: number, z: number, near: number): number {
    const { cells, sun } = this.lit, { side, levels, dx, dz } = cells.grid;
    let total = 0, t = 0;
    for (let n = 0; n < 3; n++) {
      const ds = near * (0.5 + n), s = t + 0.5 * ds;
      total += cells.field.extinction(x + s * sun[0], y + s * sun[1], z + s * sun[2]) * ds;
      t += ds;
    }
    z += t * sun[2];
    if (z > cells.field.numbers.thickness) return total * cells.kept;
    return total * cells.kept + between(this.depth, side, levels, (x + t * sun[0]) / dx - 0.5, (y + t * sun[1]) / dx - 0.5, z / dz - 0.5);
  }

  /** March toward a direction and fill `seen`, for irradiances of 1. */
  march(a: number, b: number, upward: number): Float64Array {
    const { seen, lit } = this, { cells, sun } = lit, { field, gaps, kept, asymmetry, openToSun } = cells;
    const { side, levels, dx, dz } = cells.grid, { base, thickness, detail } = field.numbers;
    const up = Math.max(upward, 1e-4), curve = (1 - up * up) / (2 * EARTH), fine = 2 * detail, last = side - 1;
    const cosine = a * sun[0] + b * sun[1] + up * sun[2], left = asymmetry / (1 + asymmetry);
    seen.fill(0);
    let s = distanceTo(base, up), through = 1, weight = 0, far = 0, wasCloud = false;
    const end = Math.min(distanceTo(base + thickness, up), FARTHEST);
    while (s < end && through > 0) {
      const level = Math.min(Math.max(Math.floor((s * up + s * s * curve - base) / dz), 0), levels - 1);
      const gap = gaps[((Math.floor((s * b) / dx) & last) * side + (Math.floor((s * a) / dx) & last)) * levels + level];
      if (gap > 0) {
        s += gap;
        wasCloud = false;
        continue;
      }
      let step = Math.max(fine * (1 + 1.5 * (1 - through)), 0.002 * s), middle = s + 0.5 * step;
      let x = middle * a, y = middle * b, z = middle * up + middle * middle * curve - base;
      const sigma = field.extinction(x, y, z);
      if (sigma <= 0) {
        s += wasCloud ? step : 1.5 * step;
        wasCloud = false;
        continue;
      }
      if (!wasCloud) step = Math.max(0.5 * step, fine);
      if (sigma * kept * step > DENSE) {
        step = DENSE / (sigma * kept);
        middle = s + 0.5 * step;
        x = middle * a;
        y = middle * b;
        z = middle * up + middle * middle * curve - base;
      }
      const depth = this.depthToSun(x, y, z, 2 * fine);
      const turned = sigma * (1 - asymmetry), off = Math.min(0.5 * dx, 0.5 / turned), lowest = 0.5 * turned * dz;
      const cx = x / dx - 0.5, cy = y / dx - 0.5, cz = z / dz - 0.5;
      this.fluences(cx + (a * off) / dx, cy + (b * off) / dx, cz + (up * off) / dz, lowest);
      const sun1 = this.ofSun, sky1 = this.ofSky;
      this.fluences(cx - (a * off) / dx, cy - (b * off) / dx, cz - (up * off) / dz, lowest);
      const sun0 = this.ofSun, sky0 = this.ofSky;
      const way = left / (Math.max(turned, openToSun) * 2 * off);
      const ahead = ((3 * left * left) / (1 - left)) * Math.min(turned / openToSun, 1) * Math.exp(-depth) * cosine;
      let share = through * (1 - Math.exp(-sigma * kept * step));
      if (through - share < GONE) share = through;
      const place = Math.min(Math.log1p((depth - Math.log(through)) / FIRST) / STEP, DEPTHS - 1.000001), k = Math.floor(place);
      const once = share * Math.exp(-depth);
      seen[SEEN.once + k] += once * (1 - place + k);
      seen[SEEN.once + k + 1] += once * (place - k);
      seen[SEEN.sun] += share * onward(sun0, sun1, way, ahead);
      seen[SEEN.sky] += share * onward(sky0, sky1, way, 0);
      seen[SEEN.ground] += share * onward(4 - sky0, 4 - sky1, way, 0);
      far += share * middle;
      weight += share;
      through -= share;
      s += step;
      wasCloud = true;
    }
    seen[SEEN.through] = through;
    seen[SEEN.far] = weight > 0 ? far / weight : s;
    return seen;
  }
}

/** Share of the sun's light that a field lets straight through to the eye, over points of its disc. */
export function sunShare(lit: Lit, seen: Vec3): number {
  const { field } = lit.cells, { base, thickness, detail } = field.numbers;
  if (seen[2] <= 0 || field.cover <= 0) return Number(seen[2] > 0);
  const sun = heldUp(seen);
  const flat = Math.max(Math.hypot(sun[0], sun[1]), 1e-12);
  const across = [sun[1] / flat, -sun[0] / flat, 0];
  const upward = [(-sun[0] * sun[2]) / flat, (-sun[1] * sun[2]) / flat, flat];
  let total = 0;
  for (let point = 0; point < table.points; point++) {
    const wide = Math.sqrt((point + 0.5) / table.points) * Math.tan(table.discRadius), turn = point * Math.PI * (3 - Math.sqrt(5));
    const ray = sun.map((value, n) => value + wide * (Math.cos(turn) * across[n] + Math.sin(turn) * upward[n]));
    const long = Math.hypot(...ray);
    const [a, b, up] = ray.map((value) => value / long);
    const [start, end] = [base / up, (base + thickness) / up];
    const count = Math.max(1, Math.floor((end - start) / (1.5 * detail))), ds = (end - start) / count;
    let depth = 0;
    for (let k = 0; k < count; k++) {
      const s = start + (k + 0.5) * ds;
      depth += field.extinction(s * a, s * b, s * up - base);
    }
    total += Math.exp(-depth * ds);
  }
  return total / table.points;
}
