/** A physical sky held as fields: straight lines between the nodes of a fine grid, phase functions put in exactly. */

import { limited, sum, type Vec3 } from "../../core/vector";
import { behind } from "../fields/map";
import { glowAt } from "../night/glow";
import { ROWS, TURNS } from "./grid";
import { skydome_angle } from "../../data/formula";
import type { Fields, Law, Layer } from "../sky";

/** A phase function of 1 - cosine, sr-1. */
export function phase(law: Law, away: number): number {
  const squared = (1 - away) ** 2;
  let total = law.constant + law.square * squared;
  for (const [plain, withSquare, g] of law.lobes) total += (plain + withSquare * squared) / ((1 - g) ** 2 + 2 * g * away) ** 1.5;
  return total;
}

/** A cell's twelve numbers at a view's height (its cosine from the zenith) and a turn from the sun, 0 to 1 for 180 degrees. */
export function fieldsAt(grid: Float32Array, leastCosine: number, up: number, turned: number): number[] {
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

/** XYZ toward a direction above the horizon, of the sun, of the moon, of cloud and of what glows at night. */
export function fieldsLight(fields: Fields, toward: Vec3): Vec3 {
  const { laws, leastCosine, moonlit, layer } = fields;
  const away = (seen: Vec3): number => 0.5 * ((toward[0] - seen[0]) ** 2 + (toward[1] - seen[1]) ** 2 + (toward[2] - seen[2]) ** 2);
  let light: Vec3 = [0, 0, 0];
  if (fields.clear) light = lampLight(fields, leastCosine, toward, laws.map((law) => phase(law, away(fields.seen))));
  if (moonlit) light = sum(light, lampLight(moonlit, leastCosine, toward, moonlit.laws.map((law) => phase(law, away(moonlit.seen)))));
  if (fields.glow) light = sum(light, glowAt(fields.glow, toward));
  if (fields.clouds) light = behind(fields.clouds, light, toward);
  if (layer) light = sum(light, lampLight(layer, leastCosine, toward, phasesAt(layer, away(layer.seen))));
  return light;
}

/** Straight lines between a layer's phase functions. */
function phasesAt({ phases }: Layer, away: number): number[] {
  const last = phases.length / 3 - 1;
  const place = Math.sqrt(skydome_angle(Math.min(1, away / 2)) / Math.PI) * last;
  const first = Math.min(Math.floor(place), last - 1);
  return [0, 1, 2].map((k) => phases[3 * first + k] + (phases[3 * first + 3 + k] - phases[3 * first + k]) * (place - first));
}

function lampLight({ grid, seen }: Fields | Layer, leastCosine: number, toward: Vec3, shapes: number[]): Vec3 {
  const level = toward[0] * seen[0] + toward[1] * seen[1];
  const across = Math.abs(toward[0] * seen[1] - toward[1] * seen[0]);
  const cell = fieldsAt(grid, leastCosine, toward[2], Math.atan2(across, level) / Math.PI);
  const light = [cell[9], cell[10], cell[11]];
  shapes.forEach((shape, k) => {
    for (let c = 0; c < 3; c++) light[c] += shape * cell[3 * k + c];
  });
  return light as unknown as Vec3;
}
