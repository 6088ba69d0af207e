/** Points of light on the texels of a map, energy and place kept, as `skydome.dome.small_lights.points_on_map` does it. */

import { azimuth, wrapped, type Vec3 } from "../core/vector";
import type { Points } from "../skies/sky";
import { solidAngle, type Layout } from "./sunmap";

/** Call with each texel's number and the XYZ, cd m-2, that a point adds to it: the four around it, none below the horizon. */
export function pointsOnMap({ toward, light }: Points, layout: Layout, add: (texel: number, xyz: Vec3) => void): void {
  const { height, left } = layout;
  for (let k = 0; k < toward.length; k += 3) {
    const at: Vec3 = [toward[k], toward[k + 1], toward[k + 2]];
    const row = (Math.atan2(Math.hypot(at[0], at[1]), at[2]) / Math.PI) * height;
    const column = (wrapped(azimuth(at) - left, 2 * Math.PI) / (2 * Math.PI)) * 2 * height;
    const [y, x] = [Math.floor(row - 0.5), Math.floor(column - 0.5)];
    const [down, right] = [row - 0.5 - y, column - 0.5 - x];
    for (const [i, j] of [[0, 0], [0, 1], [1, 0], [1, 1]]) {
      const share = (i ? down : 1 - down) * (j ? right : 1 - right);
      const over = y + i < 0;
      const inside = y + i < height / 2;
      const there = over ? 0 : inside ? y + i : Math.min(Math.floor(row), height - 1);
      const turn = wrapped(inside ? x + j + (over ? height : 0) : Math.min(Math.floor(column), 2 * height - 1), 2 * height);
      const scale = share / solidAngle(layout, there);
      add(there * 2 * height + turn, [light[k] * scale, light[k + 1] * scale, light[k + 2] * scale]);
    }
  }
}
