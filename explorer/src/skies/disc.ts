/** The sun's disc: Hosek and Wilkie's solar radiance (2013), limb darkening, exact irradiance. */

import { TABLES, unpacked } from "../core/tables";
import { elevation, limited, scaled, sum, unit, type Vec3 } from "../core/vector";
import type { Disc } from "./sky";

const D = TABLES.disc;
const BANDS = 11;
const FINE = D.xyz.shape[0];

/** Radiance at the disc's centre in the 11 bands: a cubic in elevation on each of 45 pieces, linear in turbidity. */
function solarRadiance(turbidity: number, height: number): number[] {
  const h = limited(height, 0, Math.PI / 2);
  const piece = limited(Math.floor(Math.cbrt(h / (Math.PI / 2)) * 45), 0, 44);
  const x = h - (piece / 45) ** 3 * (Math.PI / 2);
  const table = unpacked(D.radiance);
  const low = limited(Math.floor(turbidity) - 1, 0, 8);
  const share = turbidity - 1 - low;
  const cubic = (t: number, band: number): number => {
    const first = ((piece * 10 + t) * BANDS + band) * 4;
    return ((table[first + 3] * x + table[first + 2]) * x + table[first + 1]) * x + table[first];
  };
  return Array.from({ length: BANDS }, (_, b) => cubic(low, b) * (1 - share) + cubic(low + 1, b) * share);
}

/** Radiance at the centre at the 41 wavelengths of the disc, 320 to 720 nm. */
export function centreRadiance(turbidity: number, height: number): number[] {
  const bands = solarRadiance(limited(turbidity, 1, 10), height);
  const between = unpacked(D.between);
  return Array.from({ length: FINE }, (_, w) => bands.reduce((total, value, b) => total + between[w * BANDS + b] * value, 0));
}

/** XYZ of a spectrum at those wavelengths. */
export function discXYZ(spectrum: number[]): Vec3 {
  const weights = unpacked(D.xyz);
  let total: Vec3 = [0, 0, 0];
  spectrum.forEach((value, w) => {
    total = sum(total, [value * weights[3 * w], value * weights[3 * w + 1], value * weights[3 * w + 2]]);
  });
  return total;
}

/** Limb darkening at wavelength number w for the cosine mu on the sun's surface. */
export function limb(w: number, mu: number): number {
  const c = unpacked(D.limb);
  let total = 0;
  for (let k = 5; k >= 0; k--) total = total * mu + c[w * 6 + k];
  return total;
}

/** The disc through air of a turbidity; with `lux` facing the sun where that is known. */
export function discOf(sun: Vec3, turbidity: number, radius: number, lux: number | null = null): Disc | null {
  if (sun[2] <= 0) return null;
  const mean = unpacked(D.limbMean);
  const area = Math.PI * Math.sin(radius) ** 2;
  const spectrum = centreRadiance(turbidity, elevation(sun)).map((value, w) => value * mean[w] * area);
  const normal = discXYZ(spectrum);
  return { toward: sun, radius, turbidity, normal: lux === null ? normal : scaled(normal, normal[1] > 0 ? lux / normal[1] : 0) };
}

/** Directions evenly over the disc (a sunflower spiral), and the XYZ that each carries; they sum to `normal`. */
export function discPoints(disc: Disc, count: number): { directions: Vec3[]; light: Vec3[] } {
  const { toward } = disc;
  const [u, v] = tangents(toward);
  const centre = centreRadiance(disc.turbidity, elevation(toward));
  const directions: Vec3[] = [];
  const light: Vec3[] = [];
  for (let k = 0; k < count; k++) {
    const square = (k + 0.5) / count;
    const turn = k * Math.PI * (3 - Math.sqrt(5));
    const sine = Math.sqrt(square) * Math.sin(disc.radius);
    const across = sum(scaled(u, sine * Math.cos(turn)), scaled(v, sine * Math.sin(turn)));
    directions.push(sum(across, scaled(toward, Math.sqrt(1 - sine * sine))));
    const mu = Math.sqrt(1 - square);
    light.push(discXYZ(centre.map((value, w) => value * limb(w, mu))));
  }
  const total = light.reduce(sum);
  const gain = disc.normal.map((value, k) => (total[k] > 0 ? value / total[k] : 0));
  return { directions, light: light.map((l) => [l[0] * gain[0], l[1] * gain[1], l[2] * gain[2]]) };
}

/** Two unit vectors across a direction. */
function tangents(toward: Vec3): [Vec3, Vec3] {
  const pole: Vec3 = Math.abs(toward[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const u = unit(cross(pole, toward));
  return [u, cross(toward, u)];
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
