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

/** The same of ozone, which lies high: a straight way from a height through a thin shell. */
export function massOfOzone(sine: number, height: number): number {
  const ratio = ((table.earth + height) / (table.earth + table.streams.ozoneHeight)) ** 2;
  return 1 / Math.sqrt(1 - ratio * (1 - sine * sine));
}

/** The cloud's depth without its forward peak, at wavelength number w. */
export const scaled = ({ cloud, albedo, peak }: Optics, w: number): number => cloud[w] * (1 - albedo[w] * peak[w]);

/** What the earth's roundness adds to a low sun's sine. */
export const bend = (air: Optics, w: number): number => table.thickness / (table.earth * scaled(air, w));

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

/** Cosine of the sun to the vertical where a view meets the cloud; 0 where it is down. */
function sunThere(view: number, sun: number, angle: number): number {
  const top = table.earth + table.height;
  const away = Math.sqrt(top ** 2 - table.earth ** 2 * (1 - view * view)) - table.earth * view;
  return Math.min(1, Math.max(0, (table.earth * sun + away * angle) / top));
}

/** Light scattered once by the cloud for a sun of irradiance 1, over its phase function; cosines of view, sun and the angle between. */
export function once(air: Optics, view: number, sun: number, angle: number): number[] {
  const { above, below, ozone, cloud, albedo, peak } = air;
  const local = sunThere(view, sun, angle);
  const [path, high] = [mass(local), massOfOzone(local, table.height)];
  const [middle, half] = [upThere(view, table.height), upThere(view, table.height / 2)];
  return cloud.map((_, w) => {
    const [along, through] = [scaled(air, w) / middle, scaled(air, w) / (local + bend(air, w))];
    const lit = along * Math.exp(-Math.min(along, through)) * shareLeft(Math.abs(along - through));
    return (lit * Math.exp(-below[w] / half - path * above[w] - high * ozone[w]) * albedo[w]) / (1 - albedo[w] * peak[w]);
  });
}
