/** What one takes along: the sky as text for other programs, its map for renderers, the picture. */

import { TABLES } from "../core/tables";
import { DEG } from "../core/vector";
import { chromaticities, exrFile, floatAttribute, latlong, textAttribute, type Attribute } from "../files/exr";
import { EFFICACY, hdrFile } from "../files/hdr";
import { mapPixels } from "../files/map";
import { heldNumbers, LANGUAGES, type ShaderLanguage } from "../files/heldshader";
import { withText } from "../files/png";
import { asCommand, asPython, asShader } from "../files/words";
import { isoText, offsetMinutes } from "../sun/clock";
import type { Explorer } from "./app";
import { section } from "./controls";
import { h } from "./element";
import { figure } from "./element";
import { groundXYZ, sunAngles } from "./scene";
import { TARGETS } from "./state";

const HEIGHTS = [256, 512, 1024, 2048];

/** What the picture shows, in a line. */
export function caption({ scene, state }: Explorer): string {
  const [turn, height] = sunAngles(scene.sun);
  const where = state.name || `${state.latitude.toFixed(3)}, ${state.longitude.toFixed(3)}`;
  const when = state.sun ? "sun set by hand" : isoText(state.date, state.minutes, state.zone).replace("T", " ");
  return `${where}, ${when}, ${scene.skies.map((sky) => sky.name).join(" | ")}, sun ${turn.toFixed(1)}°, ${height.toFixed(1)}°`;
}

/** The header of the package's files. */
function header(explorer: Explorer): Record<string, Attribute> {
  const { state, scene } = explorer;
  const place = state.sun ? {} : {
    latitude: floatAttribute(state.latitude), longitude: floatAttribute(state.longitude),
    capDate: textAttribute(isoText(state.date, state.minutes, state.zone).slice(0, 16).replaceAll("-", ":").replace("T", " ") + ":00"),
    utcOffset: floatAttribute(-60 * offsetMinutes(state.zone, scene.utc)),
  };
  return {
    chromaticities: chromaticities(TABLES.colour.chromaticities), whiteLuminance: floatAttribute(1), envmap: latlong,
    comments: textAttribute("RGB times 1 is luminance in cd m-2 (Y); texel centres."), ...place,
    "skydome:projection": textAttribute(`Equirectangular(azimuth_left=${TARGETS[state.target].left * DEG}, mirrored=False)`),
    "skydome:model": textAttribute(scene.skies[0].name), "skydome:target": textAttribute(state.target),
    "skydome:caption": textAttribute(caption(explorer)), "skydome:software": textAttribute(`skydome ${TABLES.version} explorer`),
  };
}

/** Linear sRGB of the map in the target's layout, (1, 1, 1) being 1 cd m-2. */
export function pixelsOf(explorer: Explorer, height: number): Float32Array {
  const { scene, numbers, state } = explorer;
  const ground = groundXYZ(scene.skies[0], numbers[0]);
  return mapPixels(explorer.stage.renderer, scene.skies[0], ground, height, TARGETS[state.target].left * DEG);
}

/** The map as an OpenEXR file. */
export function exrOf(explorer: Explorer, height: number): Promise<Uint8Array<ArrayBuffer>> {
  return exrFile(pixelsOf(explorer, height), 2 * height, height, header(explorer));
}

/** The map as a Radiance picture. */
export function hdrOf(explorer: Explorer, height: number): Uint8Array<ArrayBuffer> {
  const primaries = TABLES.colour.chromaticities.map((value) => value.toFixed(4)).join(" ");
  const lines = ["SOFTWARE=skydome explorer", "EXPOSURE=1", `PRIMARIES=${primaries}`, `skydome:target=${explorer.state.target}`,
    `skydome:projection=Equirectangular(azimuth_left=${TARGETS[explorer.state.target].left * DEG}, mirrored=False)`,
    `skydome:caption=${caption(explorer)}`, `skydome:efficacy=${EFFICACY}`];
  return hdrFile(pixelsOf(explorer, height), 2 * height, height, lines);
}

/** The picture as it is shown, with a caption below and in the header. */
export async function pngOf(explorer: Explorer): Promise<Uint8Array<ArrayBuffer>> {
  explorer.drawNow();
  const { canvas } = explorer.stage;
  const bar = Math.round(Math.max(26, canvas.width / 36));
  const made = h("canvas", { width: canvas.width, height: canvas.height + bar });
  const context = made.getContext("2d")!;
  context.drawImage(canvas, 0, 0);
  context.fillStyle = "#0e1116";
  context.fillRect(0, canvas.height, canvas.width, bar);
  context.fillStyle = "#e9ebef";
  context.font = `${Math.round(bar * 0.46)}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  const text = caption(explorer);
  context.fillText(text, bar * 0.5, canvas.height + bar / 2, canvas.width - bar);
  const blob = await new Promise<Blob | null>((done) => made.toBlob(done, "image/png"));
  if (!blob) throw new Error("the browser could not write the picture");
  const light = explorer.numbers.map((each) => `global ${figure(each.global[1])} lx`).join(" | ");
  return withText(blob, "Description", `${text}, ${light}`);
}

function download(bytes: Uint8Array<ArrayBuffer>, name: string, type: string): void {
  const link = h("a", { href: URL.createObjectURL(new Blob([bytes], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** The section of the panel. */
export function takeAway(explorer: Explorer): HTMLElement {
  const copied = (what: string, text: () => string) => (): void => {
    let made: string;
    try {
      made = text();
    } catch (error) {
      return explorer.say(error instanceof Error ? error.message : String(error));
    }
    void navigator.clipboard.writeText(made).then(() => explorer.say(`${what} copied`), () => explorer.say("the browser does not allow copying"));
  };
  const size = h("select", { "aria-label": "Rows of the map" }, ...HEIGHTS.map((rows) => h("option", { value: rows }, `${2 * rows} × ${rows}`)));
  size.value = "512";
  const rows = (): number => Number(size.value);
  const name = (): string => `sky-${explorer.scene.skies[0].name}-${explorer.state.target}`;
  const saved = (work: () => Promise<void> | void) => (): void => {
    void Promise.resolve().then(work).catch((error: unknown) => explorer.say(error instanceof Error ? error.message : String(error)));
  };
  const language = h("select", { "aria-label": "Shading language", class: "small" }, ...LANGUAGES.map((name) => h("option", { value: name }, name.toUpperCase())));
  const numbers = h("button", { type: "button", title: "The numbers that the shader reads, a JSON list of floats", click: saved(() => {
    const { recipe } = explorer.scene.skies[0];
    if (recipe.kind !== "fields" || recipe.layer || recipe.clouds) return explorer.say("clouds have no shader: take their map");
    const text = JSON.stringify(heldNumbers(recipe).map((value) => Number(value.toPrecision(9))));
    download(new TextEncoder().encode(text), "numbers.json", "application/json");
  }) }, "Shader numbers");
  explorer.followed({ element: numbers, follow: ({ skies }) => void (language.hidden = numbers.hidden = skies[0].recipe.kind !== "fields") });
  const button = (text: string, title: string, click: () => void): HTMLElement => h("button", { type: "button", title, click }, text);
  return section("Take away",
    h("div", { class: "buttons" },
      button("Copy Python", "The sky in Python", copied("Python", () => asPython(explorer.scene))),
      button("Copy command", "The command that renders the map", copied("Command", () => asCommand(explorer.scene))),
      button("Copy shader", "Code of this sky: GLSL; the physical sky's in the language beside, which reads its numbers",
        copied("Shader", () => asShader(explorer.scene.skies[0], language.value as ShaderLanguage))), language, numbers),
    h("div", { class: "field" }, h("span", { class: "label" }, "Map"), size),
    h("div", { class: "buttons" },
      button("EXR", "Linear float map, RGB in cd/m²", saved(async () => download(await exrOf(explorer, rows()), `${name()}.exr`, "image/x-exr"))),
      button("HDR", "Radiance picture", saved(() => download(hdrOf(explorer, rows()), `${name()}.hdr`, "image/vnd.radiance"))),
      button("PNG", "The picture with its caption", saved(async () => download(await pngOf(explorer), `${name()}.png`, "image/png")))));
}
