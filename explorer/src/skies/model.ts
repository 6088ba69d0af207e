/** What a sky model takes, and what the page says of it. */

import type { Vec3 } from "../core/vector";
import type { Moon } from "../sun/moon";
import type { Kind } from "./clouds/optics";
import type { Hour } from "./night/night";
import type { Air } from "./physical/airs";
import type { Sky } from "./sky";

/** The numbers that models take, as the controls and the address have them. */
export interface Numbers {
  turbidity: number;
  albedo: number;
  dni: number;
  dhi: number;
  dew: number;
  /** Perez's five, and the diffuse horizontal illuminance of a sky of such letters, lx. */
  letters: number[];
  lux: number;
  /** Diffuse share of global irradiance and clearness index of Brunger and Hooper; opaque cloud of Harrison and Coombes. */
  share: number;
  clearness: number;
  cloud: number;
  /** Optical depth at 550 nm of an even layer of cloud, and the share of such a sky beside a clear one. */
  depth: number;
  cover: number;
}

/** What a sky is made of, in the package's units; angles in radians. */
export interface Conditions extends Numbers {
  sun: Vec3;
  /** Angular radius of the sun, rad, and its distance, AU. */
  radius: number;
  distance: number;
  air: Air;
  /** Of what a layer of cloud is. */
  particles: Kind;
  /** The moon of that hour; null where it is left out, or the sun is set by hand. */
  moon: Moon | null;
  /** Where and when, for stars and the glow of the night; null where they are left out. */
  night: Hour | null;
}

/** Parameters that few models have. */
export type Own = "letters" | "lux" | "share" | "clearness" | "cloud" | "air" | "cover" | "depth" | "particles";

export interface Model {
  name: string;
  label: string;
  group: string;
  source: string;
  /** Turbidity's range; null where the model takes none. */
  turbidity: [number, number] | null;
  albedo: boolean;
  irradiance: boolean;
  own?: Own[];
  /** Least elevation of the sun, degrees, that it has light for. */
  lowest: number;
  make(c: Conditions): Sky;
}
