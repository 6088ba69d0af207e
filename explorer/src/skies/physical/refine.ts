/** From values at few heights and azimuths of half a sky to the fine grid that the shader reads. */

import { cubicAt } from "../../core/cubic";
import { limited } from "../../core/vector";
import { ROWS, TURNS } from "./grid";

/** The first of four neighbours, and their weights, for each of `count` even places among so many nodes. */
function even(count: number, nodes: number, inside: boolean): [number, number[]][] {
  return Array.from({ length: count }, (_, k) => {
    const place = (k / (count - 1)) * (nodes - 1);
    const first = inside ? limited(Math.floor(place) - 1, 0, nodes - 4) : Math.min(Math.floor(place), nodes - 2) - 1;
    return [first, cubicAt([0, 1, 2, 3], place - first)[1]];
  });
}

/** A turn beyond 0 or 180 degrees is its mirror image. */
function mirrored(turn: number, last: number): number {
  return turn < 0 ? -turn : turn > last ? 2 * last - turn : turn;
}

/** Puts values (nodes, turns) into cells of 4 x 3 of a fine grid. */
export class Refiner {
  private rows: [number, number[]][];
  private turns: [number, number[]][];

  constructor(nodes: number, private coarse: number) {
    this.rows = even(ROWS, nodes, true);
    this.turns = even(TURNS, coarse, false).map(([first, weights]) => [first, weights]);
  }

  /** Values from `from` on, times `scale`, at least 0, as channel `at` of the cells. */
  refine(values: Float32Array, from: number, grid: Float32Array, at: number, scale: number): void {
    const { coarse } = this;
    const across = new Float32Array(coarse);
    for (let row = 0; row < ROWS; row++) {
      const [first, weights] = this.rows[row];
      for (let turn = 0; turn < coarse; turn++) {
        let total = 0;
        for (let k = 0; k < 4; k++) total += weights[k] * values[from + (first + k) * coarse + turn];
        across[turn] = total;
      }
      for (let turn = 0; turn < TURNS; turn++) {
        const [near, shares] = this.turns[turn];
        let total = 0;
        for (let k = 0; k < 4; k++) total += shares[k] * across[mirrored(near + k, coarse - 1)];
        grid[(row * TURNS + turn) * 12 + at] = Math.max(0, total * scale);
      }
    }
  }
}
