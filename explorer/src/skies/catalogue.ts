/** The sky models of the page by the package's names: what each takes, and how its sky is made. */

import { TABLES } from "../core/tables";
import { halfSquare, limited, times, type Vec3 } from "../core/vector";
import { levelledCie, levelledClear } from "./cie";
import { hosekLetters } from "./hosek";
import { channel } from "./light";
import { skydome_angle } from "../data/formula";
import { base, risen, withDisc } from "./made";
import { foldedNetwork, NETWORKS, networkOutputs } from "./network";
import type { Conditions, Model } from "./model";
import { asrc, brungerHooper, harrisonCoombes, intermediate, moonSpencer, pokrowski, uniform, type Levelled } from "./older";
import { allWeather, byLetters, byWeather, igawa } from "./perez";
import { covered, overcast, physical } from "./physical/skies";
import { LOWEST } from "./physical/physical";
import { preethamLetters } from "./preetham";
import { shaped } from "./shaped";
import type { Formula, Letters, Network, Recipe, Sky, Spectrum } from "./sky";

const EYE = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const NORMAL = EYE.map((row) => row.map((value) => value * TABLES.efficacy));
const RGB = TABLES.colour.srgbToXYZ.map((row) => row.map((value) => value * TABLES.efficacy));
const GREY = TABLES.colour.d65.map((value) => [value]);
const GREY_NOTE = "colour: the model knows luminance only; daylight of D65 is given to it";

function formula(channels: Letters[], toXYZ: number[][], hosek = false, chromatic = false): Formula {
  return { kind: "formula", channels, hosek, chromatic, toXYZ };
}

function preetham(c: Conditions): Sky {
  const channels = preethamLetters(risen(c.sun), c.turbidity);
  const sky = withDisc(base("preetham", c, formula(channels, EYE, false, true), TABLES.albedo.ground), c, c.turbidity);
  return { ...sky, spectrum: (toward) => daylight(recipeXYZ(sky, toward)) };
}

function recipeXYZ(sky: Sky, toward: Vec3): number[] {
  const half = halfSquare(toward, sky.sun);
  const { channels } = sky.recipe as Formula;
  const [x, y, luminance] = channels.map((row) => channel(row, false, Math.max(toward[2], 0), half, skydome_angle(half)));
  return [(x / y) * luminance, luminance, ((1 - x - y) / y) * luminance];
}

/** The CIE daylight series at a colour (Preetham 1999, A.5). */
function daylight(xyz: number[]): Spectrum {
  const { matrix, balance, wavelengths } = TABLES.colour.daylight;
  const level = xyz[1] / times([balance], xyz)[0];
  return { wavelengths, radiance: times(matrix, xyz).map((value) => value * level) };
}

function hosek(c: Conditions): Sky {
  const sun = risen(c.sun);
  const channels = hosekLetters("xyz", sun, c.turbidity, c.albedo);
  const bands = hosekLetters("spectral", sun, c.turbidity, c.albedo);
  const sky = withDisc(base("hosek-wilkie", c, formula(channels, NORMAL, true), c.albedo), c, c.turbidity);
  const spectrum = (toward: Vec3): Spectrum => {
    const half = halfSquare(toward, c.sun);
    const up = Math.max(toward[2], 0);
    const radiance = bands.map((row) => channel(row, true, up, half, skydome_angle(half)));
    return { wavelengths: TABLES.hosekWilkie.bands, radiance };
  };
  return { ...sky, spectrum };
}

function hosekRGB(c: Conditions): Sky {
  const channels = hosekLetters("rgb", risen(c.sun), c.turbidity, c.albedo);
  return withDisc(base("hosek-wilkie-rgb", c, formula(channels, RGB, true), c.albedo), c, c.turbidity);
}

function neural(name: string, c: Conditions): Sky {
  const network: Network = foldedNetwork(name, risen(c.sun), c.turbidity, c.albedo);
  const sky = withDisc(base(name, c, network, c.albedo), c, c.turbidity);
  const { bands, scale } = NETWORKS[name];
  if (!bands.length) return sky;
  const radiance = (toward: Vec3): number[] => networkOutputs(network, c.sun, toward).map((value) => value * scale);
  return { ...sky, spectrum: (toward) => ({ wavelengths: bands, radiance: radiance(toward) }) };
}

/** A sky of luminance alone. */
function grey(name: string, c: Conditions, recipe: Recipe): Sky {
  return base(name, c, recipe, TABLES.albedo.ground, [GREY_NOTE]);
}

/** Of irradiances, with the sun that they tell. */
function ofWeather(sky: Sky, c: Conditions, lux: number): Sky {
  return withDisc({ ...sky, day: sky.day && c.dni + c.dhi > 0 }, c, 3, lux);
}

function perez(c: Conditions): Sky {
  const found = allWeather(risen(c.sun), c);
  return ofWeather(grey("perez-all-weather", c, formula([found.letters], GREY)), c, found.directNormal);
}

function igawaSky(c: Conditions): Sky {
  const found = igawa(risen(c.sun), c);
  return ofWeather(grey("igawa", c, formula([found.letters], GREY)), c, found.directNormal);
}

function asrcSky(c: Conditions): Sky {
  const sky = grey("asrc-cie", c, ofShape(asrc(risen(c.sun), c)));
  return ofWeather(sky, c, byWeather(risen(c.sun), c).direct);
}

function perezLetters(c: Conditions): Sky {
  const letters = byLetters(risen(c.sun), c.letters, c.lux);
  return withDisc(grey("perez", c, formula([letters], GREY)), c, c.turbidity);
}

const ofShape = ([numbers, level]: Levelled): Recipe => shaped(numbers, level, TABLES.colour.d65);

/** An older sky of the usual level. */
function older(name: string, levelled: (sun: Vec3, c: Conditions) => Levelled, shines = true): (c: Conditions) => Sky {
  return (c) => {
    const sky = grey(name, c, ofShape(levelled(risen(c.sun), c)));
    return shines ? withDisc(sky, c, c.turbidity) : sky;
  };
}

function cie(type: number, c: Conditions): Sky {
  const name = `cie-${type}`;
  const sky = base(name, c, formula([levelledCie(type, risen(c.sun), c.turbidity)], GREY), TABLES.albedo.ground, [GREY_NOTE]);
  return (TABLES.shines as Record<string, boolean>)[name] ? withDisc(sky, c, c.turbidity) : sky;
}

function cieClear(c: Conditions): Sky {
  const letters = levelledClear(risen(c.sun), c.turbidity);
  return withDisc(base("cie-clear", c, formula([letters], GREY), TABLES.albedo.ground, [GREY_NOTE]), c, c.turbidity);
}

const CIE_NAMES = [
  "overcast, steep gradation", "overcast, brightening sunward", "overcast, gradual", "overcast, gradual, sunward",
  "uniform", "partly cloudy, slight sunward", "partly cloudy, brighter sunward", "partly cloudy, distinct corona",
  "partly cloudy, sun hidden", "partly cloudy, bright circumsolar", "white-blue, distinct corona", "clear, low turbidity",
  "clear, polluted", "cloudless turbid, broad corona", "white-blue turbid, broad corona",
];

const HAZE: [number, number] = [1, 10];
const clear = { group: "Clear skies", turbidity: HAZE, albedo: true, irradiance: false, lowest: 0.1 };
const measured = { albedo: false, irradiance: false, lowest: 0.1 };
const weather = { ...measured, group: "Measured and standard", turbidity: null, irradiance: true };
const old = { ...measured, group: "Older skies", turbidity: HAZE };

export const MODELS: Model[] = [
  { ...clear, group: "Physical", name: "physical", label: "Physical, with twilight", lowest: LOWEST, own: ["air", "cover", "depth"], source:
    "Single scattering in round shells, networks for the rest", make: (c) => covered(c, physical(c)) },
  { ...measured, group: "Physical", name: "overcast", label: "Overcast, a layer of cloud", albedo: true, turbidity: null,
    own: ["depth", "particles"], source: "A network taught by discrete ordinates", make: overcast },
  { ...clear, name: "hosek-wilkie", label: "Hosek-Wilkie", source: "Hosek and Wilkie 2012", make: hosek },
  { ...clear, name: "hosek-wilkie-rgb", label: "Hosek-Wilkie RGB", source: "Hosek and Wilkie 2012", make: hosekRGB },
  { ...clear, name: "preetham", label: "Preetham", source: "Preetham, Shirley and Smits 1999", turbidity: [2, 6],
    albedo: false, make: preetham },
  ...Object.keys(NETWORKS).map((name): Model => ({
    ...clear, group: "Neural skies", name, label: name.replace("neural-", "").replaceAll("-", " "),
    source: "Satilmis et al. 2017", albedo: NETWORKS[name].features.includes("albedo"), make: (c) => neural(name, c),
  })),
  { ...weather, name: "perez-all-weather", label: "Perez all-weather", source: "Perez, Seals and Michalsky 1993", make: perez },
  { ...weather, name: "igawa", label: "Igawa", source: "Igawa 2014", make: igawaSky },
  { ...weather, name: "asrc-cie", label: "ASRC-CIE", source: "Perez et al. 1990, Matsuura 1987", make: asrcSky },
  { ...old, group: "Measured and standard", name: "perez", label: "Perez by letters", own: ["letters", "lux"],
    source: "Perez, Seals and Michalsky 1993", make: perezLetters },
  { ...old, group: "Measured and standard", name: "cie-clear", label: "CIE clear (Kittler)",
    source: "Kittler 1967, CIE 110-1994", make: cieClear },
  { ...old, name: "cie-intermediate", label: "CIE intermediate", source: "Nakamura, Oki and Hayashi 1985",
    make: older("cie-intermediate", (sun, c) => intermediate(sun, c.turbidity)) },
  { ...old, name: "matsuura-iwata", label: "Matsuura-Iwata", source: "Matsuura and Iwata 1990",
    make: older("matsuura-iwata", (sun, c) => intermediate(sun, c.turbidity)) },
  { ...old, name: "brunger-hooper", label: "Brunger-Hooper", source: "Brunger and Hooper 1993", own: ["share", "clearness"],
    make: older("brunger-hooper", (sun, c) => brungerHooper(sun, c.turbidity, c.share, c.clearness)) },
  { ...old, name: "harrison-coombes", label: "Harrison-Coombes", source: "Harrison and Coombes 1988", own: ["cloud"],
    make: older("harrison-coombes", (sun, c) => harrisonCoombes(sun, c.turbidity, c.cloud)) },
  { ...old, name: "pokrowski", label: "Pokrowski", source: "Pokrowski 1929; Grant, Heisler and Gao 1996",
    make: older("pokrowski", (sun, c) => pokrowski(sun, c.turbidity)) },
  { ...old, name: "moon-spencer", label: "Moon-Spencer overcast", turbidity: null, source: "Moon and Spencer 1942",
    make: older("moon-spencer", moonSpencer, false) },
  { ...old, name: "uniform", label: "Uniform", turbidity: null, source: "definition", make: older("uniform", uniform, false) },
  ...CIE_NAMES.map((text, k): Model => ({
    ...measured, group: "CIE standard general skies", name: `cie-${k + 1}`, label: `CIE ${k + 1}: ${text}`,
    turbidity: k >= 5 ? HAZE : null, source: "CIE S 011, ISO 15469", make: (c) => cie(k + 1, c),
  })),
];

/** The model by name; undefined for a name that is none. */
export function modelNamed(name: string): Model | undefined {
  return MODELS.find((model) => model.name === name);
}

/** The sky of a model, its turbidity held in the model's range. */
export function skyOf(model: Model, given: Conditions): Sky {
  const turbidity = model.turbidity ? limited(given.turbidity, ...model.turbidity) : given.turbidity;
  const albedo = limited(given.albedo, 0, 1);
  return model.make({ ...given, turbidity, albedo });
}

