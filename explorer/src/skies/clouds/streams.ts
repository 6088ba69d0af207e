/** What two streams of light make of a layer of cloud at one wavelength: what the network reads, and its unit of light. */

import table from "../../data/overcast.json";
import { mass, type Optics } from "./optics";

const { streams, dark, earth } = table;

export interface Streams {
  /** Depth of the cloud by similarity, how fast light dies in it, and what it mirrors of light from below. */
  turned: number;
  dying: number;
  mirror: number;
  /** Optical masses of air and ozone. */
  mass: number;
  high: number;
  /** Light on the level cloud for a sun of irradiance 1, and the share of upright light that comes through. */
  coming: number;
  through: number;
  /** Radiance under the cloud, the same everywhere, sr-1. */
  typical: number;
}

/** Optical mass of ozone, which lies high: a straight way through a thin shell. */
function highMass(sine: number): number {
  const ratio = (earth / (earth + streams.ozoneHeight)) ** 2;
  return 1 / Math.sqrt(1 - ratio * (1 - sine * sine));
}

/** At wavelength number w, the sun's elevation by its sine. */
export function streamsOf(air: Optics, sine: number, w: number): Streams {
  const [depth, albedo, path, high] = [air.cloud[w], air.albedo[w], mass(sine), highMass(sine)];
  const turned = depth * (1 - albedo * air.asymmetry[w]);
  const dying = Math.sqrt(Math.max(0, 3 * depth * (1 - albedo) * turned));
  const mirror = (0.75 * turned) / (1 + 0.75 * turned);
  const [left, scattered] = [Math.exp(-high * air.ozone[w]), -Math.expm1(-path * air.above[w])];
  const [beam, sky] = [left * sine * (1 - scattered), (left * streams.toTheCloud * scattered) / path];
  const safe = Math.max(dying, 1e-3);
  const passed = (cosine: number) =>
    ((((2 + 3 * cosine) / (4 + 3 * turned)) * safe) / Math.sinh(safe)) * -Math.expm1(-depth);
  const cosine = (beam * sine + sky * streams.diffuse) / Math.max(beam + sky, 1e-30);
  const back = (air.ground * mirror) / (1 + dying);
  const typical = ((beam + sky) * passed(cosine)) / (Math.PI * (1 - back)) + dark;
  return { turned, dying, mirror, mass: path, high, coming: beam + sky, through: passed(1), typical };
}
