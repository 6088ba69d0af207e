/** The controls of the panel, in the order in which one asks: which sky, where, how it is shown. */

import { TABLES } from "../core/tables";
import { AEROSOLS } from "../skies/physical/airs";
import { KINDS } from "../skies/clouds/optics";
import { FIELD_KINDS } from "../skies/fields/names";
import { MODELS } from "../skies/catalogue";
import type { Own } from "../skies/model";
import { checkbox, section, select, slider, type Change, type Control } from "./controls";
import { h, tell } from "./element";
import { usualEV, type Scene } from "./scene";
import { LETTER_LIMITS, LIMITS, TARGETS, type State } from "./state";

/** Words for a turbidity. */
function haze(turbidity: number): string {
  return turbidity < 2 ? "pure" : turbidity < 2.8 ? "very clear" : turbidity < 4.5 ? "clear" : turbidity < 7 ? "hazy" : "thick haze";
}

function grouped(first: [string, string][] = []): Map<string, [string, string][]> {
  const groups = new Map<string, [string, string][]>(first.length ? [["", first]] : []);
  for (const model of MODELS) groups.set(model.group, [...(groups.get(model.group) ?? []), [model.name, model.label]]);
  return groups;
}

const usesHaze = (scene: Scene): boolean => scene.skies.some((_, k) => modelAt(scene, k)?.turbidity !== null);

function modelAt({ state }: Scene, k: number) {
  return MODELS.find((model) => model.name === (k === 0 ? state.model : state.beside));
}

/** Whether a model that is shown has a parameter of its own. */
const has = (name: Own) => (scene: Scene): boolean => scene.skies.some((_, k) => modelAt(scene, k)?.own?.includes(name));

const LETTERS = ["Horizon darker or brighter", "How steeply toward the horizon", "About the sun", "How wide about the sun", "Opposite the sun"];

/** A haze in the unit asked for. */
function inUnit(unit: State["haze"], turbidity: number): string {
  if (unit === "visibility") return `${visibility(turbidity).toFixed(0)} km`;
  return unit === "depth" ? ((turbidity - 1) * TABLES.rayleigh).toFixed(3) : turbidity.toFixed(1);
}

/** How far one sees, km. */
const visibility = (turbidity: number): number => 1 / (TABLES.seen[0] + TABLES.seen[1] * turbidity);

function hazeUnit(change: Change): Control {
  const made = select("Haze told as", "haze", new Map([["", [["turbidity", "turbidity"], ["visibility", "visibility, km"],
    ["depth", "aerosol's depth, 550 nm"]]]]), change);
  return { element: made.element, follow: (scene) => (made.follow(scene), void (made.element.hidden = !usesHaze(scene))) };
}

function aerosols(change: Change): Control {
  const made = select("Aerosol", "aerosol", new Map([["", AEROSOLS.map((name): [string, string] => [name, name])]]), change);
  return { element: made.element, follow: (scene) => (made.follow(scene), void (made.element.hidden = !has("air")(scene))) };
}

function particles(change: Change): Control {
  const made = select("Cloud of", "particles", new Map([["", Object.keys(KINDS).map((name): [string, string] => [name, name])]]), change);
  return { element: made.element, follow: (scene) => (made.follow(scene), void (made.element.hidden = !has("particles")(scene))) };
}

function clouds(change: Change): Control {
  const kinds = FIELD_KINDS.map((name): [string, string] => [name, name]);
  const made = select("Clouds", "clouds", new Map([["", [["", "– none –"], ...kinds]]]), change);
  return { element: made.element, follow: (scene) => (made.follow(scene), void (made.element.hidden = !has("cover")(scene))) };
}

/** Whether clouds with a shape are asked for, in a sky that has them. */
const isClouded = (scene: Scene): boolean => has("cover")(scene) && scene.state.clouds !== "";

/** Whether a layer of cloud is there, whose depth one asks. */
const isLayered = (scene: Scene): boolean => has("depth")(scene) && (has("particles")(scene) || scene.state.cover > 0);

const isMeasured = (scene: Scene): boolean => scene.skies.some((_, k) => modelAt(scene, k)?.irradiance);

function hazeLimits(scene: Scene): [number, number] {
  return scene.skies.length === 1 ? (scene.model.turbidity ?? [1, 10]) : [1, 10];
}

/** Model, the one beside it, and their air. */
export function skySection(change: Change): { element: HTMLElement; controls: Control[] } {
  const source = h("p", { class: "source" });
  const model = select("Model", "model", grouped(), change);
  const beside = select("Compare with", "beside", grouped([["", "– none –"]]), change,
    (value) => (value ? {} : { show: "photo" }));
  const fixed = (name: string) => (): [number, number] => LIMITS[name];
  const controls: Control[] = [
    model, beside,
    hazeUnit(change),
    slider({ label: "Haze", hint: "Turbidity: scattering of all air over that of molecules", step: 0.05, limits: hazeLimits,
      value: ({ state }) => state.turbidity, text: (value, { state }) => `${inUnit(state.haze, value)} ${haze(value)}`,
      change: (turbidity) => ({ turbidity }), shown: usesHaze }, change),
    aerosols(change),
    slider({ label: "Ozone", hint: "In the whole column of air", step: 5, limits: fixed("ozone"), value: ({ state }) => state.ozone,
      text: (value) => `${value.toFixed(0)} DU`, change: (ozone) => ({ ozone }), shown: has("air") }, change),
    slider({ label: "Ground albedo", hint: "Share of light that the ground sends back", step: 0.01, limits: fixed("albedo"),
      value: ({ state }) => state.albedo, text: (value) => value.toFixed(2), change: (albedo) => ({ albedo }),
      shown: (scene) => scene.skies.some((_, k) => modelAt(scene, k)?.albedo) }, change),
    clouds(change),
    slider({ label: "Cloud cover", hint: "Share of the sky's columns with cloud", step: 0.01, limits: fixed("clouded"),
      value: ({ state }) => state.clouded, text: (value) => value.toFixed(2), change: (clouded) => ({ clouded }), shown: isClouded }, change),
    slider({ label: "Other clouds", hint: "Seed of the clouds' shape", step: 1, limits: () => [0, 99],
      value: ({ state }) => state.seed, text: (value) => `seed ${value.toFixed(0)}`, change: (seed) => ({ seed }), shown: isClouded }, change),
    slider({ label: "Overcast share", hint: "Share of a sky under an even layer of cloud, by day", step: 0.01, limits: fixed("cover"),
      value: ({ state }) => state.cover, text: (value) => value.toFixed(2), change: (cover) => ({ cover }), shown: has("cover") }, change),
    slider({ label: "Cloud depth", hint: "Optical depth of the layer of cloud at 550 nm", step: 0.5, limits: fixed("depth"),
      value: ({ state }) => state.depth, text: (value) => value.toFixed(1), change: (depth) => ({ depth }), shown: isLayered }, change),
    particles(change),
    slider({ label: "Direct normal", hint: "Direct normal irradiance", step: 5, limits: fixed("dni"), value: ({ state }) => state.dni,
      text: (value) => `${value.toFixed(0)} W/m²`, change: (dni) => ({ dni }), shown: isMeasured }, change),
    slider({ label: "Diffuse horizontal", hint: "Diffuse horizontal irradiance", step: 5, limits: fixed("dhi"),
      value: ({ state }) => state.dhi, text: (value) => `${value.toFixed(0)} W/m²`, change: (dhi) => ({ dhi }), shown: isMeasured }, change),
    slider({ label: "Dew point", step: 1, limits: fixed("dew"), value: ({ state }) => state.dew,
      text: (value) => `${value.toFixed(0)} °C`, change: (dew) => ({ dew }), shown: isMeasured }, change),
    ...LETTER_LIMITS.map((limits, k) => slider({ label: `Letter ${"abcde"[k]}`, hint: LETTERS[k], step: 0.01, limits: () => limits,
      value: ({ state }) => state.letters[k], text: (value) => value.toFixed(2),
      change: (value, { state }) => ({ letters: state.letters.map((old, n) => (n === k ? value : old)) }), shown: has("letters") }, change)),
    slider({ label: "Diffuse illuminance", hint: "On the horizontal: how bright the sky is", step: 100, limits: fixed("lux"),
      value: ({ state }) => state.lux, text: (value) => `${value.toFixed(0)} lx`, change: (lux) => ({ lux }), shown: has("lux") }, change),
    slider({ label: "Diffuse share", hint: "Of global irradiance: 1 is overcast", step: 0.01, limits: fixed("share"),
      value: ({ state }) => state.share, text: (value) => value.toFixed(2), change: (share) => ({ share }), shown: has("share") }, change),
    slider({ label: "Clearness index", hint: "Global irradiance over that above the air", step: 0.01, limits: fixed("clearness"),
      value: ({ state }) => state.clearness, text: (value) => value.toFixed(2), change: (clearness) => ({ clearness }),
      shown: has("clearness") }, change),
    slider({ label: "Opaque cloud", hint: "Share of the sky", step: 0.01, limits: fixed("cloud"), value: ({ state }) => state.cloud,
      text: (value) => value.toFixed(2), change: (cloud) => ({ cloud }), shown: has("cloud") }, change),
  ];
  const element = section("Sky", ...controls.slice(0, 2).map((c) => c.element), source, ...controls.slice(2).map((c) => c.element));
  controls.push({ element: source, follow: (scene) => tell(source, scene.skies.map((_, k) => modelAt(scene, k)?.source).join(" | ")) });
  return { element, controls };
}

/** Exposure and what is drawn over the picture. */
export function pictureSection(change: Change): { element: HTMLElement; controls: Control[] } {
  const exposure = slider({ label: "Exposure", hint: "Exposure value at ISO 100; lock it to compare hours", step: 0.05,
    limits: ({ skies }) => [usualEV(skies[0]) - 6, usualEV(skies[0]) + 6].map((v) => Math.round(v * 20) / 20) as [number, number],
    value: ({ state, skies }) => state.ev ?? usualEV(skies[0]), text: (value, { state }) => `EV ${value.toFixed(1)}${state.ev === null ? " auto" : ""}`,
    change: (ev) => ({ ev }) }, change);
  let current = 15;
  const lock = h("button", { type: "button", class: "lock", click: () => change({ ev: lock.ariaPressed === "true" ? null : current }) }, "Lock");
  const locks: Control = {
    element: lock,
    follow: ({ state, skies }) => {
      current = Number((state.ev ?? usualEV(skies[0])).toFixed(2));
      lock.ariaPressed = String(state.ev !== null);
      tell(lock, state.ev === null ? "Lock exposure" : "Unlock exposure");
    },
  };
  const boxes = [checkbox("Sun path of the day", "path", change), checkbox("Moon, and its light at night", "moon", change),
    checkbox("Stars, planets and airglow at night", "stars", change), checkbox("Analemma of the hour", "analemma", change)];
  const targets = new Map([["", Object.entries(TARGETS).map(([name, { note }]): [string, string] => [name, `${name} (${note})`])]]);
  const target = select("Renderer's north", "target", targets, change, (value) => ({ look: (TARGETS[value].left + 180) % 360, view: "panorama" } as Partial<State>));
  return {
    element: section("Picture", exposure.element, h("div", { class: "buttons" }, lock), ...boxes.map((box) => box.element), target.element),
    controls: [exposure, locks, ...boxes, target],
  };
}
