/** The sky that is shown in the words of others: Python, the command line, a shader. */

import { FORMULA, INPUTS } from "../data/shaders";
import { TABLES } from "../core/tables";
import { networkBlock, networkText } from "../picture/shaders";
import { zenithXYZ } from "../skies/light";
import type { Model } from "../skies/model";
import type { Sky } from "../skies/sky";
import { SHAPE_TEXT } from "../skies/shaped";
import { isoText } from "../sun/clock";
import { heldText, type ShaderLanguage } from "./heldshader";
import { sunAngles, type Scene } from "../page/scene";

const short = (value: number, digits = 4): string => String(Number(value.toFixed(digits)));

/** Models whose level is a usual one, and those whose turbidity is the sun's disc's (and that level's). */
const isUsual = (model: Model): boolean => model.group === "Older skies" || model.name.startsWith("cie");
const isOfDisc = (model: Model): boolean => isUsual(model) || model.name === "perez";

/** Names in Python of what few models have. */
const OWN = { lux: "illuminance", share: "diffuse_share", clearness: "clearness", cloud: "cloud" } as const;
type Told = keyof typeof OWN;

/** The parameters of the first model, by their names in Python. */
function parameters({ state, model, skies, distance }: Scene): Record<string, string> {
  const told: Record<string, string> = {};
  if (model.turbidity && !isOfDisc(model)) told.turbidity = short(limit(state.turbidity, model.turbidity), 2);
  if (model.albedo) told.albedo = short(state.albedo, 3);
  if (model.irradiance) {
    told.direct_normal_irradiance = short(state.dni, 1);
    told.diffuse_horizontal_irradiance = short(state.dhi, 1);
    told.dew_point = short(state.dew, 1);
    if (!state.sun) told.extraterrestrial_irradiance = short(TABLES.perez.solarConstant / distance ** 2, 3);
  }
  if (isUsual(model)) told[model.name === "uniform" ? "value" : "zenith_luminance"] = short(zenithXYZ(skies[0])[1], 2);
  for (const name of model.own ?? []) if (name in OWN) told[OWN[name as Told]] = short(state[name as Told], 3);
  if (model.name === "overcast") told.optical_depth = short(state.depth, 1);
  if (model.own?.includes("letters")) state.letters.forEach((value, k) => (told["abcde"[k]] = short(value, 3)));
  if (/^cie-\d/.test(model.name)) told.type = model.name.slice(4);
  return told;
}

const limit = (value: number, [low, high]: [number, number]): number => Math.min(high, Math.max(low, value));

const CLASSES: Record<string, string> = {
  "hosek-wilkie": "HosekWilkie", "hosek-wilkie-rgb": "HosekWilkieRGB", preetham: "Preetham", "cie-clear": "CIEClear",
  "perez-all-weather": "PerezAllWeather", physical: "PhysicalSky", igawa: "Igawa", "asrc-cie": "ASRCCIE", perez: "Perez",
  "cie-intermediate": "CIEIntermediate", "matsuura-iwata": "MatsuuraIwata", "brunger-hooper": "BrungerHooper",
  "harrison-coombes": "HarrisonCoombes", pokrowski: "Pokrowski", "moon-spencer": "MoonSpencer", uniform: "Uniform",
};

/** Whether the command shows every light of the hour: the sun has set on the physical sky of a place. */
const isNight = ({ state, model, sun }: Scene): boolean => model.name === "physical" && !state.sun && sun[2] < 0;

/** Whether clouds with a shape stand in the first sky. */
const hasClouds = ({ state, model }: Scene): boolean => state.clouds !== "" && model.name === "physical";

/** Python of those clouds. */
function fieldOf({ state }: Scene): string {
  const kind = state.clouds[0].toUpperCase() + state.clouds.slice(1);
  return `sd.CloudField(sd.${kind}(), cover=${short(state.clouded)}, seed=${state.seed})`;
}

/** Python that makes the map of every light of a night's hour. */
function nightPython(scene: Scene): string {
  const { state } = scene;
  const place = `sd.Place(${short(state.latitude)}, ${short(state.longitude)})`;
  const time = isoText(state.date, state.minutes, state.zone);
  return [
    "import skydome as sd", "", `sky = sd.sky_at(${place}, "${time}", ${physicalAir(scene)}${hasClouds(scene) ? `, clouds=${fieldOf(scene)}` : ""})`,
    `sd.render(sky, height=1024).save("sky.exr", target="${state.target}")`, "",
  ].join("\n");
}

/** Python that makes the sky's map. */
export function asPython(scene: Scene): string {
  if (isNight(scene)) return nightPython(scene);
  const { state, model } = scene;
  const time = isoText(state.date, state.minutes, state.zone);
  const [turn, height] = sunAngles(scene.sun);
  const sun = state.sun ? `sd.direction(azimuth=${short(turn)} * sd.deg, elevation=${short(height)} * sd.deg)`
    : `sd.sun_direction(sd.Place(${short(state.latitude)}, ${short(state.longitude)}), "${time}")`;
  const told = Object.entries(parameters(scene)).map(([name, value]) => `${name}=${value}`).join(", ");
  const neural = model.name.startsWith("neural-") ? model.name.slice(7) : "";
  const under = model.name === "moon-spencer" || model.name === "uniform" ? "" : "sun, ";
  const kind = neural ? `${neural.endsWith("spectral") ? "NeuralSpectralSky" : "NeuralSky"}.load("${neural}", sun, ` : `${CLASSES[model.name] ?? "CIE"}(${under}`;
  let sky = `sd.${kind}${told})`;
  if (model.name === "physical") sky = `sd.PhysicalSky(sun, ${physicalAir(scene)})`;
  if (hasClouds(scene)) sky = `sd.CloudySky(${sky}, ${fieldOf(scene)})`;
  if (model.name === "overcast") sky = layerOf(scene, state.particles === "ice" ? ", kind=sd.Ice()" : "");
  if (scene.skies[0].notes.length && model.name !== "physical") sky = `sd.Daylight(${sky})`;
  const when = state.sun ? "" : `, time="${time}"`;
  const turbidity = isOfDisc(model) ? `, turbidity=${short(state.turbidity, 2)}` : "";
  const disc = scene.skies[0].disc ? ` + sd.SunDisc.of(sky${turbidity}${when})` : "";
  const whole = isBlended(scene) ? `sd.blend(sky${disc}, ${layerOf(scene)}, ${short(state.cover, 2)})` : `sky${disc}`;
  const albedo = model.albedo ? "" : `, ground_albedo=${short(scene.skies[0].ground, 3)}`;
  return [
    "import skydome as sd", "", `sun = ${sun}`, `sky = ${sky}`,
    `sd.render(${whole}, height=1024${albedo}).save("sky.exr", target="${state.target}")`, "",
  ].join("\n");
}

/** Whether a share of an overcast sky is mixed in. */
const isBlended = ({ skies, model }: Scene): boolean => skies[0].recipe.kind === "fields" && skies[0].recipe.layer !== null && model.name !== "overcast";

/** The sky under an even layer of cloud. */
function layerOf({ state, distance }: Scene, more = ""): string {
  const scale = state.sun ? "" : `, sun_scale=${short(distance ** -2, 5)}`;
  return `sd.OvercastSky(sun, optical_depth=${short(state.depth, 1)}, albedo=${short(state.albedo, 3)}${scale}${more})`;
}

function physicalAir({ state, distance }: Scene): string {
  const kind = state.aerosol === "usual" ? "standard" : state.aerosol;
  const ozone = state.ozone === 330 ? "" : `, ozone=${short(state.ozone, 0)}`;
  const scale = state.sun ? "" : `, sun_scale=${short(distance ** -2, 5)}`;
  return `sd.Atmosphere.${kind}(${short((state.turbidity - 1) * TABLES.rayleigh, 5)}, albedo=${short(state.albedo, 3)}${ozone}${scale})`;
}

const PYTHON_ONLY = ["type", "zenith_luminance", "value", "extraterrestrial_irradiance", ..."abcde"];
const SET = ["diffuse_share", "clearness", "cloud"];
const OPTIONS: Record<string, string> = { direct_normal_irradiance: "dni", diffuse_horizontal_irradiance: "dhi", dew_point: "dew-point", optical_depth: "cloud-depth" };

/** The command line that makes the sky's map. */
export function asCommand(scene: Scene): string {
  const { state, model } = scene;
  const time = isoText(state.date, state.minutes, state.zone);
  const sun = state.sun ? `--sun ${sunAngles(scene.sun).map((value) => short(value)).join()}`
    : `--place ${short(state.latitude)},${short(state.longitude)} --time ${time}`;
  const told = Object.entries(parameters(scene)).filter(([name]) => !PYTHON_ONLY.includes(name))
    .map(([name, value]) => (SET.includes(name) ? `--set ${name}=${value}` : `--${OPTIONS[name] ?? name} ${value}`));
  if (model.own?.includes("letters")) told.push(`--letters=${state.letters.map((value) => short(value, 3)).join()}`);
  if (model.own?.includes("air")) {
    if (state.aerosol !== "usual") told.push(`--aerosol ${state.aerosol}`);
    if (state.ozone !== 330) told.push(`--ozone ${short(state.ozone, 0)}`);
  }
  if (model.own?.includes("particles") && state.particles !== "water") told.push(`--cloud-kind ${state.particles}`);
  if (hasClouds(scene)) told.push(`--clouds ${state.clouds}`, `--cover ${short(state.clouded)}`, `--seed ${state.seed}`);
  if (isBlended(scene)) told.push(`--blend-overcast ${short(state.cover, 2)}`, `--cloud-depth ${short(state.depth, 1)}`);
  const hazy = isOfDisc(model) && model.turbidity ? [`--turbidity ${short(state.turbidity, 2)}`] : [];
  return ["skydome render", sun, `--model ${model.name}`, ...told, ...hazy, `--target ${state.target}`, "-o sky.exr"].join(" ") + "\n";
}

const literal = (value: number): string => {
  const text = String(Number(value.toPrecision(9)));
  return /[.e]/.test(text) ? text : `${text}.0`;
};

/** `skydome_rgb(direction)`, linear sRGB in which (1, 1, 1) is 1 cd m-2: GLSL (WebGL 2); of the physical sky in each `language`. */
export function asShader(sky: Sky, language: ShaderLanguage = "glsl"): string {
  const head = `// skydome ${TABLES.version}, ${sky.name}: linear sRGB toward a unit vector, x east, y north, z up; 1 = 1 cd m-2.`;
  const sun = `const vec3 sun = vec3(${sky.sun.map(literal).join(", ")});`;
  const matrix = TABLES.colour.srgbFromXYZ;
  if (sky.recipe.kind === "fields" && (sky.recipe.layer || sky.recipe.clouds)) throw new Error("clouds have no shader: take their map");
  if (sky.recipe.kind === "fields") return heldText(language);
  const body = { formula: formulaText, network: networkWords, shaped: shapedText }[sky.recipe.kind](sky);
  const toRGB = `mat3(${[0, 1, 2].flatMap((c) => matrix.map((row) => literal(row[c]))).join(", ")})`;
  return [head, sun, body, `vec3 skydome_rgb(vec3 d) {\n    return d.z < 0.0 ? vec3(0.0) : ${toRGB} * sky_xyz(d);\n}`, ""].join("\n");
}

function formulaText(sky: Sky): string {
  const { recipe } = sky;
  if (recipe.kind !== "formula") return "";
  const name = recipe.hosek ? "hosek_channel" : "skydome_channel";
  const calls = recipe.channels.map((row) => `${name}(up, half_square, angle, ${row.map(literal).join(", ")})`);
  const c = recipe.channels.length > 1 ? `vec3(${calls.join(",\n        ")})` : `vec3(${calls[0]}, 0.0, 0.0)`;
  const chromatic = "    { float s = c.z / max(c.y, 1.0e-6); c = vec3(c.x * s, c.z, (1.0 - c.x - c.y) * s); }\n";
  const columns = [0, 1, 2].flatMap((k) => recipe.toXYZ.map((row) => literal((sky.day ? 1 : 0) * (row[k] ?? 0))));
  return `${FORMULA}
vec3 sky_xyz(vec3 d) {
    float up = max(d.z, 0.0);
    vec3 apart = d - sun;
    float half_square = min(0.25 * dot(apart, apart), 1.0);
    float angle = skydome_angle(half_square);
    vec3 c = ${c};
${recipe.chromatic ? chromatic : ""}    return mat3(${columns.join(", ")}) * c;
}`;
}

function networkWords(sky: Sky): string {
  const { recipe } = sky;
  if (recipe.kind !== "network") return "";
  const numbers = networkBlock(recipe);
  const rows = Array.from({ length: numbers.length / 4 }, (_, k) => `vec4(${[...numbers.slice(4 * k, 4 * k + 4)].map(literal).join(", ")})`);
  return networkText(recipe, INPUTS, `const vec4 W[${rows.length}] = vec4[${rows.length}](\n    ${rows.join(",\n    ")});`);
}

function shapedText({ recipe, day }: Sky): string {
  if (recipe.kind !== "shaped") return "";
  const white = recipe.white.map((value) => literal((day ? 1 : 0) * recipe.level * value)).join(", ");
  return `${FORMULA}
const float n[${recipe.numbers.length}] = float[${recipe.numbers.length}](${recipe.numbers.map(literal).join(", ")});
${SHAPE_TEXT}
vec3 sky_xyz(vec3 d) {
    vec3 apart = d - sun;
    float half_square = min(0.25 * dot(apart, apart), 1.0);
    return vec3(${white}) * shape_at(max(d.z, 0.0), half_square, skydome_angle(half_square));
}`;
}
