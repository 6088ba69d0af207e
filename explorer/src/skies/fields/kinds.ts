/** The shapes of the kinds of cloud as noise, a second form of `sd.Cumulus` and its like; their numbers are the package's. */

import table from "../../data/clouds.json";
import { billows, cells, gradient, Octaves } from "./noise";

export type FieldKind = keyof typeof table.kinds;
export type KindNumbers = (typeof table.kinds)[FieldKind];

/** A shape by columns: what a column is made from, and the shape at a height, m, that is a share of the thickness. */
export interface Shape {
  column(x: number, y: number): void;
  at(z: number, height: number): number;
}

/** From 0 at 0 to 1 at 1, smooth. */
export function ramp(x: number): number {
  const held = Math.min(1, Math.max(0, x));
  return held * held * (3 - 2 * held);
}

/** Columns moved sideways by two octaves of noise. */
class Drift {
  private readonly east: Octaves;
  private readonly north: Octaves;
  x = 0;
  y = 0;

  constructor(period: number, wavelength: number, private readonly most: number, seed: number) {
    this.east = new Octaves(gradient, period, wavelength, 2, seed);
    this.north = new Octaves(gradient, period, wavelength, 2, seed + 1);
  }

  move(x: number, y: number): void {
    this.x = x + this.most * this.east.at(x, y, 0);
    this.y = y + this.most * this.north.at(x, y, 0);
  }
}

function cumulus({ period, thickness }: KindNumbers, seed: number): Shape {
  const drift = new Drift(period, 1500, 700, seed + 7);
  const [domes, plans] = [new Octaves(cells, period, 2300, 2, seed), new Octaves(gradient, period, 5000, 2, seed + 1)];
  const bumps = new Octaves(gradient, period, 800, 3, seed + 2, thickness, [1, 1, 1], billows);
  let plan = 0, east = 0, north = 0;
  return {
    column(x, y) {
      [east, north] = [x, y];
      drift.move(x, y);
      plan = 0.9 - domes.at(drift.x, drift.y, 0) + 0.5 * plans.at(drift.x, drift.y, 0);
    },
    at: (z, height) =>
      plan - 0.45 * height ** 2 + (0.25 + 0.35 * Math.min(2 * height, 1)) * (bumps.at(east, north, z) - 0.4),
  };
}

function stratocumulus({ period, thickness }: KindNumbers, seed: number): Shape {
  const [sheet, plans] = [new Octaves(cells, period, 1500, 2, seed), new Octaves(gradient, period, 4000, 2, seed + 1)];
  const bumps = new Octaves(gradient, period, 400, 3, seed + 2, thickness, [1, 1, 1], billows);
  let plan = 0, east = 0, north = 0;
  return {
    column(x, y) {
      [east, north] = [x, y];
      plan = 1 - sheet.at(x, y, 0) + 0.5 * plans.at(x, y, 0);
    },
    at: (z, height) =>
      plan - 1.6 * Math.max(height - 0.3, 0) ** 2 - 2 * Math.max(0.3 - height, 0) ** 2 + 0.3 * (bumps.at(east, north, z) - 0.4),
  };
}

function altocumulus({ period }: KindNumbers, seed: number): Shape {
  const drift = new Drift(period, 2500, 500, seed + 7);
  const rolls = new Octaves(cells, period, 500, 2, seed, 0, [1, 1.8, 1]);
  const patches = new Octaves(gradient, period, 7000, 3, seed + 1);
  let plan = 0;
  return {
    column(x, y) {
      drift.move(x, y);
      plan = 0.8 * (1 - rolls.at(drift.x, drift.y, 0)) + 0.9 * patches.at(drift.x, drift.y, 0);
    },
    at: (_, height) => plan - 1.2 * (height - 0.4) ** 2,
  };
}

function cirrus({ period }: KindNumbers, seed: number): Shape {
  const drift = new Octaves(gradient, period, 12_000, 2, seed + 7);
  const fibres = new Octaves(gradient, period, 1100, 4, seed, 0, [8, 1, 1], billows);
  const patches = new Octaves(gradient, period, 16_000, 3, seed + 1, 0, [1.5, 1, 1]);
  let plan = 0, east = 0, north = 0;
  return {
    column(x, y) {
      [east, north] = [x, y + 3500 * drift.at(x, y, 0)];
      plan = patches.at(x, y, 0);
    },
    at: (_, height) =>
      0.9 * (0.8 - fibres.at(east + 2500 * (height - 0.5), north, 0)) + plan - 0.8 * (height - 0.5) ** 2,
  };
}

const SHAPES: Record<FieldKind, (kind: KindNumbers, seed: number) => Shape> = { cumulus, stratocumulus, altocumulus, cirrus };

/** The shape of a kind and a seed. */
export function shapeOf(kind: FieldKind, seed: number): Shape {
  return SHAPES[kind](table.kinds[kind], seed);
}
