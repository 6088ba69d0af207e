/** The map of a sky as `skydome render` makes it: sky above, ground below, the sun's energy on its texels. */

import { TABLES } from "../core/tables";
import { times, type Vec3 } from "../core/vector";
import type { Renderer } from "../picture/renderer";
import { mapView } from "../picture/view";
import type { Sky } from "../skies/sky";
import { pointsOnMap } from "./pointmap";
import { discOnMap } from "./sunmap";

/** Linear sRGB, (1, 1, 1) being 1 cd m-2, three numbers a texel; twice as wide as high, `left` the azimuth at the edge. */
export function mapPixels(renderer: Renderer, sky: Sky, ground: Vec3, height: number, left: number): Float32Array {
  const width = 2 * height;
  const light = renderer.read(sky, mapView(left), width, height);
  const pixels = new Float32Array(3 * width * height);
  const matrix = TABLES.colour.srgbFromXYZ;
  const below = times(matrix, ground);
  for (let k = 0; k < width * height; k++) {
    const above = k < (width * height) / 2;
    const rgb = above ? times(matrix, [light[4 * k], light[4 * k + 1], light[4 * k + 2]]) : below;
    pixels.set(rgb, 3 * k);
  }
  if (sky.disc) {
    for (const [texel, xyz] of discOnMap(sky.disc, { height, left })) {
      times(matrix, xyz).forEach((value, c) => (pixels[3 * texel + c] += value));
    }
  }
  if (sky.points) {
    pointsOnMap(sky.points, { height, left }, (texel, xyz) => times(matrix, xyz).forEach((value, c) => (pixels[3 * texel + c] += value)));
  }
  return within(pixels);
}

/** Colours outside sRGB moved toward its white, luminance kept, in place. */
function within(pixels: Float32Array): Float32Array {
  const [, luminance] = TABLES.colour.srgbToXYZ;
  for (let k = 0; k < pixels.length; k += 3) {
    const least = Math.min(pixels[k], pixels[k + 1], pixels[k + 2]);
    if (least >= 0) continue;
    const white = Math.max(0, luminance.reduce((total, weight, c) => total + weight * pixels[k + c], 0));
    for (let c = 0; c < 3; c++) pixels[k + c] = (white * (pixels[k + c] - least)) / (white - least);
  }
  return pixels;
}
