/** What two streams of light make of a layer of cloud at one wavelength: what the network reads, and its unit of light. */

import table from "../../data/overcast.json";
import { bend, mass, massOfOzone, scaled, type Optics } from "./optics";

const { streams, dark } = table;

/** Shares of light that a cloud makes of a beam and of even light: not scattered, gone through, sent back. */
interface Shares {
  straight: number;
  spread: number;
  through: number;
  back: number;
}

/** Sunlight of irradiance 1 on its way. */
export interface Course {
  sun: Shares;
  /** Light of the beam and of the air above on the cloud. */
  beam: number;
  sky: number;
  /** Share of the light below the cloud that comes down once more. */
  again: number;
  /** Radiance of the dome, the same everywhere, sr-1. */
  typical: number;
}

/** Eddington's two streams of delta-scaled numbers, for a beam of a cosine to the vertical. */
function sharesOf(air: Optics, w: number, cosine: number): Shares {
  const { exp, expm1, sqrt, max, min } = Math;
  const [albedo, asymmetry] = [air.albedo[w], air.asymmetry[w]];
  const peak = albedo * asymmetry ** 2;
  const [lost, depth] = [max((1 - albedo) / (1 - peak), streams.leastLost), air.cloud[w] * (1 - peak)];
  const [a, g] = [1 - lost, asymmetry / (1 + asymmetry)];
  const k = sqrt(3 * lost * (1 - a * g));
  const c = min(cosine, 0.97 / k);
  const [ahead, back, up] = [(7 - a * (4 + 3 * g)) / 4, (a * (4 - 3 * g) - 1) / 4, (2 - 3 * g * c) / 4];
  const [own, straight] = [ahead * (1 - up) + back * up, exp(-depth / c)];
  const [fallen, twice] = [exp(-k * depth), -expm1(-2 * k * depth)];
  const whole = 2 * k + (ahead - k) * twice;
  const part = 2 * k * (1 - up + own * c) * (fallen - straight) - straight * (1 - k * c) * (own - k * (1 - up)) * twice;
  const spread = (a * part) / ((1 - (k * c) ** 2) * whole);
  return { straight, spread, through: (2 * k * fallen) / whole, back: (back * twice) / whole };
}

/** Share of even light that clear air sends back. */
const airMirrors = (depth: number): number => (0.75 * depth) / (1 + 0.75 * depth);

/** At wavelength number w, the sun's elevation by its sine. */
export function courseOf(air: Optics, sine: number, w: number): Course {
  const [path, left] = [mass(sine), Math.exp(-massOfOzone(sine, 0) * air.ozone[w])];
  const [low, depth] = [sine + bend(air, w), scaled(air, w)];
  const scattered = -Math.expm1(-path * air.above[w]);
  const [beam, sky] = [left * low * (1 - scattered), (left * streams.toTheCloud * scattered) / path];
  const [sun, even] = [sharesOf(air, w, low), sharesOf(air, w, streams.diffuse)];
  const more = Math.max(sun.straight + sun.spread - Math.exp(-depth / low), 0) * -Math.expm1(-depth / low);
  const [above, below] = [airMirrors(air.above[w]), airMirrors(air.below[w])];
  const upward = beam * Math.max(sun.through + sun.back - sun.straight - sun.spread, 0) + sky * sun.back;
  const first = beam * more + sky * (even.straight + even.spread) + (upward * above * sun.through) / (1 - sun.back * above);
  const ground = (1 - below) / (1 - below * air.ground);
  const again = sun.back * (below + (1 - below) * ground * air.ground);
  const typical = ((first * ground) / (Math.PI * (1 - again))) * (streams.mean + (1 - streams.mean) * again) + dark;
  return { sun, beam, sky, again, typical };
}
