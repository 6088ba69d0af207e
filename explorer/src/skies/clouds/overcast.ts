/** The overcast sky: an even layer of cloud over the whole sky, as fields on the same grid as the physical sky's. */

import table from "../../data/overcast.json";
import { azimuth, direction, elevation, type Vec3 } from "../../core/vector";
import { ROWS, TURNS } from "../physical/grid";
import { Refiner } from "../physical/refine";
import type { Layer } from "../sky";
import { NODES, restOf } from "./network";
import { beamOnGround, KINDS, once, opticsOf, type Kind } from "./optics";

/** Azimuths, of half a sky, at which the network is asked. */
const COARSE = 33;
const REFINER = new Refiner(NODES, COARSE);

/** Turns of the fine grid from one at which the light scattered once is asked to the next. */
const STRIDE = 9;

/** Illuminance, lx, below which no sun is seen. */
const LEAST = 1e-3;

export interface Overcast {
  layer: Layer;
  /** Illuminance of the sun through the cloud on a plane that faces it, lx. */
  lux: number;
}

/** Shapes of a kind's phase functions, three numbers for each angle. */
const tables: Record<Kind, Float32Array> = { water: phases("water"), ice: phases("ice") };

function phases(kind: Kind): Float32Array {
  return Float32Array.from(KINDS[kind].shapes.flat());
}

/** Cosine to the vertical of a fine grid's row. */
function heightOf(row: number): number {
  return Math.cos(Math.acos(table.leastCosine) * (1 - (row / (ROWS - 1)) ** 2));
}

/** Cosine of the angle between the sun and a place of the fine grid. */
function angleAt(row: number, turn: number, sine: number): number {
  const view = heightOf(row);
  const level = Math.sqrt((1 - view * view) * Math.max(0, 1 - sine * sine));
  return view * sine + level * Math.cos((Math.PI * turn) / (TURNS - 1));
}

/** The sky under a layer of an optical depth, its light times `share`; the sun's strength over that 1 AU away. */
export function overcastLight(sun: Vec3, kind: Kind, depth: number, albedo: number, strength: number, share: number): Overcast {
  const sine = Math.max(table.leastCosine, sun[2]);
  const air = opticsOf(kind, depth, albedo);
  const grid = new Float32Array(ROWS * TURNS * 12);
  const rest = restOf(air, sine, COARSE);
  for (let c = 0; c < 3; c++) REFINER.refine(rest, c * NODES * COARSE, grid, 9 + c, strength * share);
  const { mixture } = KINDS[kind];
  const amounts = mixture.flatMap((part) => [0, 1, 2].map((c) => part.map((value, w) => value * table.colours[w][c] * strength * share)));
  for (let row = 0; row < ROWS; row++) {
    let before: number[] = [];
    for (let turn = 0; turn < TURNS; turn += STRIDE) {
      const single = once(air, heightOf(row), sine, angleAt(row, turn, sine));
      const light = amounts.map((each) => each.reduce((total, value, w) => total + value * single[w], 0));
      for (let back = turn ? STRIDE - 1 : 0; back >= 0; back--) {
        const at = (row * TURNS + turn - back) * 12;
        for (let k = 0; k < 9; k++) grid[at + k] = back ? light[k] + ((before[k] - light[k]) * back) / STRIDE : light[k];
      }
      before = light;
    }
  }
  const beam = beamOnGround(air, sun[2]).reduce((total, value, w) => total + value * table.colours[w][1], 0);
  return { layer: { grid, seen: direction(azimuth(sun), elevation(sun)), phases: tables[kind] }, lux: beam < LEAST ? 0 : strength * beam };
}
