/** From the page's state to its skies: the sun's place, the models' light, exposure and numbers. */

import { azimuth, DEG, direction, elevation, scaled, sum, type Vec3 } from "../core/vector";
import { modelNamed, MODELS, skyOf } from "../skies/catalogue";
import type { Conditions, Model } from "../skies/model";
import { isOpen, LOWEST_SUN, withClouds } from "../skies/fields/clear";
import type { CloudMaker } from "../skies/fields/maker";
import { diffuseXYZ, directXYZ } from "../skies/integral";
import { xyzToward, zenithXYZ } from "../skies/light";
import type { Hour } from "../skies/night/night";
import type { Sky } from "../skies/sky";
import { instant } from "../sun/clock";
import { moonOver, type Moon } from "../sun/moon";
import { radiusAt, sunOver } from "../sun/position";
import type { State } from "./state";

export interface Scene {
  state: State;
  /** Milliseconds since 1970; of the chosen date and hour, a sun set by hand or not. */
  utc: number;
  sun: Vec3;
  /** Distance of the sun, AU; 1 where it is set by hand. */
  distance: number;
  /** The moon of that hour; null under a sun set by hand. */
  moon: Moon | null;
  model: Model;
  /** One sky, or two side by side. */
  skies: Sky[];
  /** What is not drawn yet, or not here, a line each. */
  wanting: string[];
}

export interface Numbers {
  zenith: Vec3;
  diffuse: Vec3;
  direct: Vec3;
  global: Vec3;
}

/** Middle grey, to which a picture's usual luminance is brought. */
export const GREY = 0.18;
/** Exposure value at ISO 100 of a luminance: log2(L 100 / 12.5). */
export const EV_PER_LUMINANCE = 8;

/** What the state's skies are made of under a sun. */
export function conditionsOf(state: State, sun: Vec3, distance: number, given: Moon | null = null, hour: Hour | null = null): Conditions {
  const { turbidity, albedo, dni, dhi, dew, letters, lux, share, clearness, cloud, depth, cover, particles, aerosol, ozone } = state;
  const moon = state.sun || !state.moon ? null : given;
  const numbers = { turbidity, albedo, dni, dhi, dew, letters, lux, share, clearness, cloud, depth, cover };
  const night = state.sun || !state.stars ? null : hour;
  return { ...numbers, night, sun, distance, radius: radiusAt(distance), moon, particles, air: { aerosol, ozone } };
}

/** The scene of a state. */
export function sceneOf(state: State): Scene {
  const utc = instant(state.date, state.minutes, state.zone);
  const found = sunOver(state, utc);
  const sun = state.sun ? direction(state.sun[0] * DEG, state.sun[1] * DEG) : found.toward;
  const distance = state.sun ? 1 : found.distance;
  const moon = moonOver(state, utc);
  const conditions = conditionsOf(state, sun, distance, moon, { place: state, utc });
  const model = modelNamed(state.model) ?? MODELS[0];
  const beside = state.beside ? modelNamed(state.beside) : undefined;
  const skies = [model, ...(beside ? [beside] : [])].map((each) => skyOf(each, conditions));
  return { state, utc, sun, distance, moon: state.sun ? null : moon, model, skies, wanting: [] };
}

const COMING = "clouds: finer ones are being made";
const FAR = `clouds: drawn while the sun is above ${LOWEST_SUN} degrees; the command has them at every hour`;

/** The scene with its clouds, as far as they are made; has others made where they must change. */
export function cloudedScene(scene: Scene, maker: CloudMaker, moving: boolean): Scene {
  const { state, sun, distance } = scene;
  if (!state.clouds) maker.forget();
  const open = state.clouds ? scene.skies.find(isOpen) : undefined;
  if (!open || !state.clouds) return state.clouds && scene.model.name === "physical" ? { ...scene, wanting: [FAR] } : scene;
  maker.ask({ kind: state.clouds, cover: state.clouded, seed: state.seed }, open, conditionsOf(state, sun, distance), moving);
  const { map } = maker;
  const skies = map ? scene.skies.map((sky) => (isOpen(sky) ? withClouds(sky, map) : sky)) : scene.skies;
  return { ...scene, skies, wanting: maker.settled ? [] : [COMING] };
}

/** The numbers of a sky: Y in cd m-2 in the zenith, else lx on the horizontal. */
export function numbersOf(sky: Sky): Numbers {
  const [diffuse, direct] = [diffuseXYZ(sky), directXYZ(sky)];
  return { zenith: zenithXYZ(sky), diffuse, direct, global: sum(diffuse, direct) };
}

/** XYZ of the Lambertian ground under a sky. */
export function groundXYZ(sky: Sky, numbers: Numbers): Vec3 {
  return scaled(numbers.global, sky.ground / Math.PI);
}

/** Luminances over the dome, evenly by solid angle, for exposure and bars. */
function luminances(sky: Sky): number[] {
  const found: number[] = [];
  const lamp = azimuth(sky.disc?.toward ?? sky.sun);
  for (let ring = 0; ring < 6; ring++) {
    for (let turn = 0; turn < 12; turn++) {
      const toward = direction(lamp + (turn + 0.5) * 30 * DEG, Math.asin((ring + 0.5) / 6));
      found.push(xyzToward(sky, toward)[1]);
    }
  }
  return found.filter((value) => value > 0);
}

/** The luminance, cd m-2, that a photographer would expose for: the sky's logarithmic mean. */
export function middleLuminance(sky: Sky): number {
  const known = middles.get(sky);
  if (known !== undefined) return known;
  const found = luminances(sky);
  const middle = found.length ? Math.exp(found.reduce((total, value) => total + Math.log(value), 0) / found.length) : 1000;
  middles.set(sky, middle);
  return middle;
}

const middles = new WeakMap<Sky, number>();

/** Luminance, cd m-2, below which a picture may look darker: dusk should not look like day. */
const DUSK = 400;

/** The exposure value that suits a sky: a little brighter than middle grey by day, darker at dusk. */
export function usualEV(sky: Sky): number {
  const middle = middleLuminance(sky);
  const dusk = 0.2 * Math.max(0, Math.log2(DUSK / middle));
  return Math.log2(middle * EV_PER_LUMINANCE) - 0.75 + dusk;
}

/** What luminance is multiplied by at an exposure value. */
export function exposureOf(ev: number): number {
  return (GREY * EV_PER_LUMINANCE) / 2 ** ev;
}

/** log10 of the luminances at the ends of a bar that suits the skies. */
export function usualBar(skies: Sky[]): [number, number] {
  const found = skies.flatMap(luminances).map(Math.log10).sort((a, b) => a - b);
  if (!found.length) return [2, 5];
  const low = Math.floor(found[0] * 5) / 5;
  return [low, Math.max(low + 0.6, Math.ceil((found[found.length - 1] + 0.15) * 5) / 5)];
}

/** The sun's azimuth and elevation, degrees. */
export function sunAngles(sun: Vec3): [number, number] {
  return [azimuth(sun) / DEG, elevation(sun) / DEG];
}
