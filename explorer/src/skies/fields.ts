/** A physical sky held as fields: cubics in the view's height, a cosine series in the azimuth from the sun. */

import type { Vec3 } from "../core/vector";
import type { Fields } from "./sky";

/** XYZ toward a direction. */
export function fieldsLight(_fields: Fields, _sun: Vec3, _toward: Vec3): Vec3 {
  return [0, 0, 0];
}
