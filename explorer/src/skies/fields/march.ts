/** Rays through a lit field: what is seen through it, and what it sends of sun, sky and ground. A second form of `march_kernel`. */

import table from "../../data/clouds.json";
import type { Vec3 } from "../../core/vector";
import { heldUp, READ, type Lit } from "./lit";

const { earth: EARTH, gone: GONE, dense: DENSE, farthest: FARTHEST, first: FIRST, step: STEP } = table;
const FOUR_PI = 4 * Math.PI;
/** Scaled depths by which light scattered once is told apart. */
export const DEPTHS = table.depths;
/** Where the parts of what is seen lie: transmittance, sun, sky, ground, distance, and light scattered once by depth. */
export const SEEN = { through: 0, sun: 1, sky: 2, ground: 3, far: 4, once: 5 } as const;

/** Distance at which a ray comes to a height over the round ground, m. */
function distanceTo(height: number, up: number): number {
  const curve = (1 - up * up) / (2 * EARTH);
  return (2 * height) / (up + Math.sqrt(up * up + 4 * curve * height));
}

export class Rays {
  readonly seen = new Float64Array(5 + DEPTHS);
  private ofSun = 0;
  private ofSky = 0;
  private ofGround = 0;

  constructor(private readonly lit: Lit) {}

  /** Diffuse light of sun, sky and ground that is scattered toward the eye at a place in cells, into `ofSun` and so on: fluence and
   *  flux linear between the middles of cells, and down to the base (Marshak's boundary), half a cell that is `lowest` transport free paths thick. */
  private radiances(x: number, y: number, z: number, a: number, b: number, up: number, lowest: number): void {
    const { grid, asymmetry } = this.lit.cells, { side, levels } = grid, { light } = this.lit, last = side - 1;
    const left = 1 - (2 * Math.min(Math.max(-z, 0), 0.5) * 1.5 * lowest) / (1 + 1.5 * lowest);
    z = Math.min(Math.max(z, 0), levels - 1.000001);
    const fx = Math.floor(x), fy = Math.floor(y), k = Math.floor(z), u = x - fx, v = y - fy, w = z - k;
    const i = fx & last, i1 = (fx + 1) & last, j = (fy & last) * side, j1 = ((fy + 1) & last) * side;
    let sun = 0, alongSun = 0, sky = 0, alongSky = 0;
    for (let n = 0; n < 8; n++) {
      const at = READ * (((n & 2 ? j1 : j) + (n & 1 ? i1 : i)) * levels + k + (n >> 2));
      const weight = (n & 1 ? u : 1 - u) * (n & 2 ? v : 1 - v) * (n & 4 ? w : 1 - w);
      sun += weight * light[at];
      alongSun += weight * (a * light[at + 1] + b * light[at + 2] + up * light[at + 3]);
      sky += weight * light[at + 4];
      alongSky += weight * (a * light[at + 5] + b * light[at + 6] + up * light[at + 7]);
    }
    const forward = (3 * asymmetry) / (1 + asymmetry), ground = 4 - sky * left; // under both lights it is even
    this.ofSun = Math.max(sun * left - forward * alongSun, 0) / FOUR_PI;
    this.ofSky = Math.max(sky * left - forward * alongSky, 0) / FOUR_PI;
    this.ofGround = Math.max(ground + forward * alongSky, 0) / FOUR_PI;
  }

  /** Scaled optical depth from a place to the sun: a few steps through the field itself, and along the sun's rays beyond them. */
  private depthToSun(x: number, y: number, z: number, near: number): number {
    const { cells, sun, beams } = this.lit;
    let total = 0, t = 0;
    for (let n = 0; n < 3; n++) {
      const ds = near * (0.5 + n), s = t + 0.5 * ds;
      total += cells.field.extinction(x + s * sun[0], y + s * sun[1], z + s * sun[2]) * ds;
      t += ds;
    }
    const high = z + t * sun[2];
    return total * cells.kept + (high > cells.field.numbers.thickness ? 0 : beams.depth(x + t * sun[0], y + t * sun[1], high));
  }

  /** March toward a direction and fill `seen`, for irradiances of 1. */
  march(a: number, b: number, upward: number): Float64Array {
    const { seen, lit } = this, { cells } = lit, { field, gaps, kept, asymmetry } = cells;
    const { side, levels, dx, dz } = cells.grid, { base, thickness, detail } = field.numbers;
    const up = Math.max(upward, 1e-4), curve = (1 - up * up) / (2 * EARTH), fine = 2 * detail, last = side - 1;
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
      this.radiances(x / dx - 0.5, y / dx - 0.5, z / dz - 0.5, a, b, up, 0.5 * sigma * (1 - asymmetry) * dz);
      let share = through * (1 - Math.exp(-sigma * kept * step));
      if (through - share < GONE) share = through;
      const place = Math.min(Math.log1p((depth - Math.log(through)) / FIRST) / STEP, DEPTHS - 1.000001), k = Math.floor(place);
      const once = share * Math.exp(-depth);
      seen[SEEN.once + k] += once * (1 - place + k);
      seen[SEEN.once + k + 1] += once * (place - k);
      seen[SEEN.sun] += share * this.ofSun;
      seen[SEEN.sky] += share * this.ofSky;
      seen[SEEN.ground] += share * this.ofGround;
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

/** Two unit vectors that make a right-handed frame with an axis, the package's. */
function frame([x, y, z]: Vec3): [Vec3, Vec3] {
  const u: Vec3 = z < 0.9 ? [-y, x, 0] : [0, -z, y], long = Math.hypot(...u);
  const [a, b, c] = u.map((part) => part / long);
  return [[a, b, c], [y * c - z * b, z * a - x * c, x * b - y * a]];
}

/** Share of the sun's light that a field lets straight through to the eye, over points of its disc. */
export function sunShare(lit: Lit, seen: Vec3): number {
  const { field } = lit.cells, { base, thickness, detail } = field.numbers;
  if (seen[2] <= 0 || field.cover <= 0) return Number(seen[2] > 0);
  const sun = heldUp(seen);
  const [across, upward] = frame(sun);
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
