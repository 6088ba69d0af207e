/** A physical sky held as fields: straight lines between the nodes of a fine grid, phase functions put in exactly. */

import { limited, sum, type Vec3 } from "../../core/vector";
import { ROWS, TURNS } from "./grid";
import type { Fields, Law } from "../sky";

/** A phase function of 1 - cosine, sr-1. */
export function phase(law: Law, away: number): number {
  const squared = (1 - away) ** 2;
  let total = law.constant + law.square * squared;
  for (const [plain, withSquare, g] of law.lobes) total += (plain + withSquare * squared) / ((1 - g) ** 2 + 2 * g * away) ** 1.5;
  return total;
}

/** A cell's twelve numbers at a view's height (its cosine from the zenith) and a turn from the sun, 0 to 1 for 180 degrees. */
export function fieldsAt({ grid, leastCosine }: Fields, up: number, turned: number): number[] {
  const angle = Math.acos(limited(up, leastCosine, 1)) / Math.acos(leastCosine);
  const row = Math.sqrt(Math.max(0, 1 - angle)) * (ROWS - 1);
  const turn = turned * (TURNS - 1);
  const [i, j] = [Math.min(Math.floor(row), ROWS - 2), Math.min(Math.floor(turn), TURNS - 2)];
  const [a, b] = [row - i, turn - j];
  const cell = new Array<number>(12).fill(0);
  for (const [di, dj, weight] of [[0, 0, (1 - a) * (1 - b)], [0, 1, (1 - a) * b], [1, 0, a * (1 - b)], [1, 1, a * b]]) {
    const at = ((i + di) * TURNS + j + dj) * 12;
    for (let k = 0; k < 12; k++) cell[k] += weight * grid[at + k];
  }
  return cell;
}

/** XYZ toward a direction above the horizon, of the sun and of the moon. */
export function fieldsLight(fields: Fields, toward: Vec3): Vec3 {
  const light = ofOneLamp(fields, toward);
  return fields.moonlit ? sum(light, ofOneLamp(fields.moonlit, toward)) : light;
}

function ofOneLamp(fields: Fields, toward: Vec3): Vec3 {
  const { seen, laws } = fields;
  const level = toward[0] * seen[0] + toward[1] * seen[1];
  const across = Math.abs(toward[0] * seen[1] - toward[1] * seen[0]);
  const cell = fieldsAt(fields, toward[2], Math.atan2(across, level) / Math.PI);
  const away = 0.5 * ((toward[0] - seen[0]) ** 2 + (toward[1] - seen[1]) ** 2 + (toward[2] - seen[2]) ** 2);
  const shapes = [...laws.map((law) => phase(law, away)), 1];
  const light = [0, 0, 0];
  shapes.forEach((shape, k) => {
    for (let c = 0; c < 3; c++) light[c] += shape * cell[3 * k + c];
  });
  return light as unknown as Vec3;
}
