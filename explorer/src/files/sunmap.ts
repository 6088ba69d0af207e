/** The sun's disc on the texels of a map: its energy and its place are kept, as `skydome.dome.sun_on_map` does it. */

import { azimuth, dot, wrapped, type Vec3 } from "../core/vector";
import { discPoints } from "../skies/disc";
import type { Disc } from "../skies/sky";

const [PER_TEXEL, LEAST, MOST] = [4096, 4096, 1 << 18];

/** A map of the whole sphere, twice as wide as high, with an azimuth at its left edge. */
export interface Layout {
  height: number;
  left: number;
}

/** Flux by texel (row x width + column), XYZ. */
type Spot = Map<number, Vec3>;
type Step = [number, number];

const SINGLE: Step[] = [[-1, 0], [1, 0], [0, -1], [0, 1]];
const PAIRS: Step[][] = [...[0, 1].flatMap((a) => [2, 3].map((b) => [SINGLE[a], SINGLE[b]])), ...SINGLE.map((s) => [s])];

/** Solid angle of a row's texels, sr. */
export function solidAngle({ height }: Layout, row: number): number {
  const step = Math.PI / height;
  return step * 2 * Math.sin(step / 2) * Math.sin((row + 0.5) * step);
}

/** Integral of the direction over a texel, its height only above the horizon. */
function vectorOf({ height, left }: Layout, texel: number): Vec3 {
  const [row, column] = [Math.floor(texel / (2 * height)), texel % (2 * height)];
  const step = Math.PI / height;
  const high = (row + 0.5) * step;
  const level = step / 2 - (Math.sin(step) * Math.cos(2 * high)) / 2;
  const turn = left + (column + 0.5) * step;
  const across = 2 * Math.sin(step / 2);
  const up = ((Math.sin(step) * Math.sin(2 * high)) / 2) * step;
  return [level * across * Math.sin(turn), level * across * Math.cos(turn), Math.max(up, 0)];
}

function meanDirection(spot: Spot, layout: Layout): Vec3 {
  const total = [0, 0, 0];
  let flux = 0;
  for (const [texel, light] of spot) {
    const share = light[1] / solidAngle(layout, Math.floor(texel / (2 * layout.height)));
    vectorOf(layout, texel).forEach((part, k) => (total[k] += share * part));
    flux += light[1];
  }
  return total.map((value) => value / flux) as unknown as Vec3;
}

function shifted(spot: Spot, [down, on]: Step, { height }: Layout): Spot {
  const moved: Spot = new Map();
  for (const [texel, light] of spot) {
    const row = Math.floor(texel / (2 * height)) + down;
    const over = row < 0 || row >= height;
    const inside = row < 0 ? -1 - row : row >= height ? 2 * height - 1 - row : row;
    const column = wrapped((texel % (2 * height)) + on + (over ? height : 0), 2 * height);
    moved.set(inside * 2 * height + column, light);
  }
  return moved;
}

/** What share of the light takes each way to move the mean by `wanted`, and the error left. */
function shares(ways: Vec3[], wanted: Vec3, weights: Vec3): [number[], number] {
  const scaledBy = (v: Vec3): Vec3 => [v[0] * weights[0], v[1] * weights[1], v[2] * weights[2]];
  const [columns, goal] = [ways.map(scaledBy), scaledBy(wanted)];
  let found: number[];
  if (columns.length === 1) found = [dot(columns[0], goal) / dot(columns[0], columns[0])];
  else {
    const [a, b, c] = [dot(columns[0], columns[0]), dot(columns[0], columns[1]), dot(columns[1], columns[1])];
    const [p, q] = [dot(columns[0], goal), dot(columns[1], goal)];
    const determinant = a * c - b * b;
    found = [(p * c - q * b) / determinant, (a * q - b * p) / determinant];
  }
  found = found.map((value) => Math.min(1, Math.max(0, value)));
  const whole = Math.max(1, found.reduce((x, y) => x + y));
  found = found.map((value) => value / whole);
  const left = goal.map((value, k) => columns.reduce((total, column, n) => total + column[k] * found[n], 0) - value);
  return [found, Math.hypot(...left)];
}

/** XYZ in cd m-2 that the disc adds, by texel. */
export function discOnMap(disc: Disc, layout: Layout): Map<number, Vec3> {
  const { height, left } = layout;
  const texels = 2 * height * height;
  const count = Math.min(MOST, Math.max(LEAST, (PER_TEXEL * Math.PI * disc.radius ** 2) / ((4 * Math.PI) / texels)));
  const { directions, light } = discPoints(disc, Math.floor(count));
  const spot: Spot = new Map();
  const [wanted, total] = [[0, 0, 0], { flux: 0 }];
  directions.forEach((toward, k) => {
    const flux = light[k];
    if (toward[2] < 0 || flux[1] <= 0) return;
    const row = Math.min(height - 1, Math.floor((Math.atan2(Math.hypot(toward[0], toward[1]), toward[2]) / Math.PI) * height));
    const u = wrapped((azimuth(toward) - left) / (2 * Math.PI), 1);
    const texel = row * 2 * height + Math.min(2 * height - 1, Math.floor(u * 2 * height));
    const held = spot.get(texel) ?? [0, 0, 0];
    spot.set(texel, [held[0] + flux[0], held[1] + flux[1], held[2] + flux[2]]);
    toward.forEach((part, c) => (wanted[c] += part * flux[1]));
    total.flux += flux[1];
  });
  if (!spot.size) return new Map();
  return asLight(centred(spot, wanted.map((value) => value / total.flux) as unknown as Vec3, layout), layout);
}

/** The spot and moved parts of it, so that its mean direction is `wanted`. */
function centred(spot: Spot, wanted: Vec3, layout: Layout): [Spot, number][] {
  const start = meanDirection(spot, layout);
  const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const moved = new Map(SINGLE.map((step) => [step, shifted(spot, step, layout)]));
  const ways = new Map(SINGLE.map((step) => [step, minus(meanDirection(moved.get(step)!, layout), start)]));
  const weights: Vec3 = [1, 1, 1 / wanted[2]];
  let best: { steps: Step[]; part: number[]; error: number } | null = null;
  for (const steps of PAIRS) {
    const [part, error] = shares(steps.map((step) => ways.get(step)!), minus(wanted, start), weights);
    if (!best || error < best.error) best = { steps, part, error };
  }
  const rest = 1 - best!.part.reduce((a, b) => a + b);
  return [[spot, rest], ...best!.steps.map((step, k): [Spot, number] => [moved.get(step)!, best!.part[k]])];
}

function asLight(parts: [Spot, number][], layout: Layout): Map<number, Vec3> {
  const found = new Map<number, Vec3>();
  for (const [spot, share] of parts) {
    for (const [texel, flux] of spot) {
      const factor = share / solidAngle(layout, Math.floor(texel / (2 * layout.height)));
      const held = found.get(texel) ?? [0, 0, 0];
      found.set(texel, [held[0] + factor * flux[0], held[1] + factor * flux[1], held[2] + factor * flux[2]]);
    }
  }
  return found;
}
