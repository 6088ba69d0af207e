/** An even layer of cloud at the network's wavelengths: its optical numbers, and what it scatters once. */

import table from "../../data/overcast.json";

/** Number of wavelengths. */
export const WAVES = table.above.length;
export const KINDS = table.kinds;
export type Kind = keyof typeof KINDS;

export interface Optics {
  /** Optical depths of molecules above and below the cloud's middle, of ozone and of the cloud. */
  above: number[];
  below: number[];
  ozone: number[];
  cloud: number[];
  /** The cloud's single scattering albedo, asymmetry and forward peak. */
  albedo: number[];
  asymmetry: number[];
  peak: number[];
  /** The ground's. */
  ground: number;
}

/** The numbers of a layer of an optical depth at 550 nm. */
export function opticsOf(kind: Kind, depth: number, ground: number): Optics {
  const { cloud, albedo, asymmetry, peak } = KINDS[kind];
  const { above, below, ozone } = table;
  return { above, below, ozone, cloud: cloud.map((each) => each * depth), albedo, asymmetry, peak, ground };
}

/** Optical mass by Kasten and Young 1989, eq. 3, from the sine of the elevation. */
export function mass(sine: number): number {
  const zenith = Math.acos(Math.min(1, Math.max(0, sine)));
  return 1 / (Math.cos(zenith) + 0.50572 * (96.07995 - (zenith * 180) / Math.PI) ** -1.6364);
}

/** Cosine to the vertical, at a height, of a view that leaves the ground with `cosine`. */
function upThere(cosine: number, height: number): number {
  const ratio = (table.earth / (table.earth + height)) ** 2;
  return Math.max(table.least, Math.sqrt(1 - ratio * (1 - cosine * cosine)));
}

const shareLeft = (x: number): number => (x < 1e-4 ? 1 - x / 2 : -Math.expm1(-x) / x);

/** What air and cloud leave of the sun's beam on the ground. */
export function beamOnGround({ above, below, ozone, cloud }: Optics, sun: number): number[] {
  const path = mass(sun);
  return cloud.map((depth, w) => Math.exp(-path * (above[w] + below[w] + ozone[w]) - depth / Math.max(sun, table.least)));
}

/** Light scattered once by the cloud for a sun of irradiance 1, over its phase function, toward a view. */
export function once({ above, below, ozone, cloud, albedo, peak }: Optics, view: number, sun: number): number[] {
  const [path, middle, half] = [mass(sun), upThere(view, table.height), upThere(view, table.height / 2)];
  return cloud.map((depth, w) => {
    const straight = 1 - albedo[w] * peak[w];
    const [along, through] = [(depth * straight) / middle, (depth * straight) / Math.max(sun, table.least)];
    const lit = along * Math.exp(-Math.min(along, through)) * shareLeft(Math.abs(along - through));
    return (lit * Math.exp(-below[w] / half - path * (above[w] + ozone[w])) * albedo[w]) / straight;
  });
}
