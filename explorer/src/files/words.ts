/** The sky that is shown in the words of others: Python, the command line, a shader. */

import { FORMULA, INPUTS } from "../data/shaders";
import { TABLES } from "../core/tables";
import { networkBlock, networkText } from "../picture/shaders";
import { zenithXYZ } from "../skies/light";
import type { Sky } from "../skies/sky";
import { isoText } from "../sun/clock";
import { sunAngles, type Scene } from "../page/scene";

const short = (value: number, digits = 4): string => String(Number(value.toFixed(digits)));

/** The parameters of the first model, by their names in Python. */
function parameters({ state, model, skies, distance }: Scene): Record<string, string> {
  const told: Record<string, string> = {};
  if (model.turbidity && !model.name.startsWith("cie")) told.turbidity = short(limit(state.turbidity, model.turbidity), 2);
  if (model.albedo) told.albedo = short(state.albedo, 3);
  if (model.irradiance) {
    told.direct_normal_irradiance = short(state.dni, 1);
    told.diffuse_horizontal_irradiance = short(state.dhi, 1);
    told.dew_point = short(state.dew, 1);
    if (!state.sun) told.extraterrestrial_irradiance = short(TABLES.perez.solarConstant / distance ** 2, 3);
  }
  if (model.name.startsWith("cie")) told.zenith_luminance = short(zenithXYZ(skies[0])[1], 2);
  if (/^cie-\d/.test(model.name)) told.type = model.name.slice(4);
  return told;
}

const limit = (value: number, [low, high]: [number, number]): number => Math.min(high, Math.max(low, value));

const CLASSES: Record<string, string> = {
  "hosek-wilkie": "HosekWilkie", "hosek-wilkie-rgb": "HosekWilkieRGB", preetham: "Preetham", "cie-clear": "CIEClear",
  "perez-all-weather": "PerezAllWeather", physical: "PhysicalSky",
};

/** Python that makes the sky's map. */
export function asPython(scene: Scene): string {
  const { state, model } = scene;
  const time = isoText(state.date, state.minutes, state.zone);
  const [turn, height] = sunAngles(scene.sun);
  const sun = state.sun ? `sd.direction(azimuth=${short(turn)} * sd.deg, elevation=${short(height)} * sd.deg)`
    : `sd.sun_direction(sd.Place(${short(state.latitude)}, ${short(state.longitude)}), "${time}")`;
  const told = Object.entries(parameters(scene)).map(([name, value]) => `${name}=${value}`).join(", ");
  const neural = model.name.startsWith("neural-") ? model.name.slice(7) : "";
  const kind = neural ? `${neural.endsWith("spectral") ? "NeuralSpectralSky" : "NeuralSky"}.load("${neural}", sun, ` : `${CLASSES[model.name] ?? "CIE"}(sun, `;
  let sky = `sd.${kind}${told})`;
  if (model.name === "physical") sky = `sd.PhysicalSky(sun, ${physicalAir(scene)})`;
  if (scene.skies[0].notes.length) sky = `sd.Daylight(${sky})`;
  const when = state.sun ? "" : `, time="${time}"`;
  const turbidity = model.name.startsWith("cie") ? `, turbidity=${short(state.turbidity, 2)}` : "";
  const disc = scene.skies[0].disc ? ` + sd.SunDisc.of(sky${turbidity}${when})` : "";
  const albedo = model.albedo ? "" : `, ground_albedo=${short(scene.skies[0].ground, 3)}`;
  return [
    "import skydome as sd", "", `sun = ${sun}`, `sky = ${sky}`,
    `sd.render(sky${disc}, height=1024${albedo}).save("sky.exr", target="${state.target}")`, "",
  ].join("\n");
}

function physicalAir({ state }: Scene): string {
  return `sd.clear_air(${short((state.turbidity - 1) * TABLES.rayleigh, 5)}, albedo=${short(state.albedo, 3)})`;
}

const PYTHON_ONLY = ["type", "zenith_luminance", "extraterrestrial_irradiance"];
const OPTIONS: Record<string, string> = { direct_normal_irradiance: "dni", diffuse_horizontal_irradiance: "dhi", dew_point: "dew-point" };

/** The command line that makes the sky's map. */
export function asCommand(scene: Scene): string {
  const { state, model } = scene;
  const time = isoText(state.date, state.minutes, state.zone);
  const sun = state.sun ? `--sun ${sunAngles(scene.sun).map((value) => short(value)).join()}`
    : `--place ${short(state.latitude)},${short(state.longitude)} --time ${time}`;
  const told = Object.entries(parameters(scene)).filter(([name]) => !PYTHON_ONLY.includes(name))
    .map(([name, value]) => `--${OPTIONS[name] ?? name} ${value}`);
  const hazy = model.name.startsWith("cie") && model.turbidity ? [`--turbidity ${short(state.turbidity, 2)}`] : [];
  return ["skydome render", sun, `--model ${model.name}`, ...told, ...hazy, `--target ${state.target}`, "-o sky.exr"].join(" ") + "\n";
}

const literal = (value: number): string => {
  const text = String(Number(value.toPrecision(9)));
  return /[.e]/.test(text) ? text : `${text}.0`;
};

/** GLSL (WebGL 2): `vec3 skydome_rgb(vec3 direction)`, linear sRGB in which (1, 1, 1) is 1 cd m-2. */
export function asShader(sky: Sky): string {
  const head = `// skydome ${TABLES.version}, ${sky.name}: linear sRGB toward a unit vector, x east, y north, z up; 1 = 1 cd m-2.`;
  const sun = `const vec3 sun = vec3(${sky.sun.map(literal).join(", ")});`;
  const matrix = TABLES.colour.srgbFromXYZ;
  if (sky.recipe.kind === "fields") return FIELDS;
  const body = sky.recipe.kind === "formula" ? formulaText(sky) : networkWords(sky);
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

/** The page's own table is of no use outside it: how the command line writes the shader and the numbers that it reads. */
const FIELDS = `// The shader of this sky reads a table, which the command line writes beside it:
// skydome shader --lang glsl --uniforms numbers.json -o sky.glsl
// with the sun, model and air of "Copy command".
`;
