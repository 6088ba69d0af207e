/** The numbers of the sky, and the card of one direction. */

import { DEG, azimuth, elevation, type Vec3 } from "../core/vector";
import { xyzToward } from "../skies/light";
import type { Sky, Spectrum } from "../skies/sky";
import { chromaticity, colourTemperature } from "../skies/temperature";
import { figure, h, tell } from "./element";
import { sunAngles, type Numbers, type Scene } from "./scene";

const ROWS: [keyof Numbers, string, string][] = [
  ["zenith", "Zenith luminance", "cd/m²"], ["diffuse", "Diffuse horizontal", "lx"],
  ["direct", "Direct horizontal", "lx"], ["global", "Global horizontal", "lx"],
];
const WARMTH: [keyof Numbers, string][] = [["diffuse", "Colour of the sky"], ["global", "Colour with sun"]];

/** Kelvin for people; a sky bluer than every black body has none. */
export function kelvin(xyz: Vec3): string {
  const found = colourTemperature(xyz);
  if (Number.isNaN(found)) return "–";
  if (found > 1e5) return "bluer than any black body";
  return `${figure(Math.round(found / 10) * 10, 4)} K`;
}

const degrees = (value: number): string => `${value.toFixed(1)}°`;

/** The table of numbers, of one sky or of two. */
export class Readout {
  private sun = h("p", { class: "sun-place" });
  private moon = h("p", { class: "sun-place" });
  private head = h("thead");
  private body = h("tbody");
  readonly element = h("div", {}, this.sun, this.moon, h("table", { class: "numbers" }, this.head, this.body));
  private note = h("p", { class: "notes" });

  constructor() {
    this.element.append(this.note);
  }

  show(scene: Scene, numbers: Numbers[]): void {
    const [turn, height] = sunAngles(scene.sun);
    tell(this.sun, `Sun ${degrees(turn)} azimuth, ${degrees(height)} elevation`);
    const { moon } = scene;
    this.moon.hidden = !moon || !scene.state.moon;
    if (moon) {
      const [along, high] = sunAngles(moon.toward);
      tell(this.moon, `Moon ${degrees(along)}, ${degrees(high)}, ${(100 * moon.lit).toFixed(0)}\u00a0% lit, ${moon.waxing ? "waxing" : "waning"}`);
    }
    const two = numbers.length > 1;
    this.head.replaceChildren();
    if (two) this.head.append(h("tr", {}, h("th"), ...scene.skies.map((sky) => h("th", { scope: "col" }, sky.name))));
    const name = (label: string): string => (two ? label.replace(/ (luminance|horizontal|of the|with)/, "") : label);
    const rows = ROWS.map(([key, label, unit]) =>
      h("tr", { "data-number": key }, h("th", { scope: "row", title: label }, name(label)),
        ...numbers.map((each) => h("td", { "data-value": each[key][1] }, h("b", {}, figure(each[key][1])), ` ${unit}`))));
    for (const [key, label] of WARMTH) {
      rows.push(h("tr", { "data-number": `${key}-cct` }, h("th", { scope: "row" }, label),
        ...numbers.map((each) => h("td", {}, kelvin(each[key])))));
    }
    this.body.replaceChildren(...rows);
    tell(this.note, [...scene.skies.flatMap((sky) => sky.notes), ...scene.wanting].filter((text, k, all) => all.indexOf(text) === k).join(". "));
  }
}

/** A small card that follows the pointer: where it points, and the light there. */
export class Card {
  private text = h("dl");
  private plot = h("canvas", { class: "spectrum", width: 220, height: 64 });
  private caption = h("figcaption");
  private figure = h("figure", {}, this.plot, this.caption);
  readonly element = h("div", { class: "card", hidden: true, role: "status", "aria-live": "off" }, this.text, this.figure);

  hide(): void {
    this.element.hidden = true;
  }

  show(sky: Sky, named: boolean, toward: Vec3, x: number, y: number, width: number, height: number): void {
    this.element.hidden = false;
    const xyz = xyzToward(sky, toward);
    const [cx, cy] = chromaticity(xyz);
    const rows: [string, string][] = [
      ["toward", `${degrees(azimuth(toward) / DEG)} az, ${degrees(elevation(toward) / DEG)} el`],
      ["luminance", `${figure(xyz[1])} cd/m²`],
      ["CIE x, y", Number.isFinite(cx) ? `${cx.toFixed(4)}, ${cy.toFixed(4)}` : "–"],
      ["colour", kelvin(xyz)],
    ];
    if (named) rows.unshift(["model", sky.name]);
    if (toward[2] < 0) rows.splice(named ? 2 : 1, 3, ["below", "the horizon"]);
    this.text.replaceChildren(...rows.flatMap(([term, value]) => [h("dt", {}, term), h("dd", {}, value)]));
    const spectrum = toward[2] >= 0 && sky.day ? sky.spectrum?.(toward) : null;
    this.figure.hidden = !spectrum;
    if (spectrum) this.draw(spectrum);
    this.place(x, y, width, height);
  }

  private place(x: number, y: number, width: number, height: number): void {
    const { offsetWidth: w, offsetHeight: t } = this.element;
    const left = x + 22 + w > width ? x - w - 22 : x + 22;
    const top = Math.min(Math.max(8, y - t / 2), height - t - 8);
    this.element.style.transform = `translate(${Math.round(Math.max(8, left))}px, ${Math.round(top)}px)`;
  }

  private draw({ wavelengths, radiance }: Spectrum): void {
    const context = this.plot.getContext("2d", { willReadFrequently: true })!;
    const { width, height } = this.plot;
    const [low, high] = [wavelengths[0], wavelengths[wavelengths.length - 1]];
    const most = Math.max(...radiance, 1e-12);
    const place = (k: number): [number, number] =>
      [((wavelengths[k] - low) / (high - low)) * width, height - 2 - (Math.max(radiance[k], 0) / most) * (height - 8)];
    context.clearRect(0, 0, width, height);
    const colours = context.createLinearGradient(0, 0, width, 0);
    for (let k = 0; k <= 20; k++) colours.addColorStop(k / 20, hue(low + ((high - low) * k) / 20));
    context.beginPath();
    context.moveTo(0, height);
    wavelengths.forEach((_, k) => context.lineTo(...place(k)));
    context.lineTo(width, height);
    context.fillStyle = colours;
    context.globalAlpha = 0.8;
    context.fill();
    context.globalAlpha = 1;
    tell(this.caption, `${low}–${high} nm, peak ${most.toPrecision(2)} W m⁻² sr⁻¹ nm⁻¹`);
  }
}

/** About the colour of a wavelength, for decoration. */
function hue(wavelength: number): string {
  const stops: [number, number, number, number][] = [
    [320, 60, 50, 90], [400, 90, 60, 190], [450, 50, 90, 240], [490, 40, 180, 220], [530, 60, 200, 90], [580, 230, 220, 70],
    [610, 245, 150, 50], [650, 230, 60, 50], [720, 130, 30, 40], [790, 80, 20, 30],
  ];
  const k = Math.max(0, stops.findIndex(([w]) => w >= wavelength) - 1);
  const [a, b] = [stops[k], stops[Math.min(k + 1, stops.length - 1)]];
  const share = b[0] === a[0] ? 0 : Math.min(1, Math.max(0, (wavelength - a[0]) / (b[0] - a[0])));
  return `rgb(${[1, 2, 3].map((c) => Math.round(a[c] + (b[c] - a[c]) * share)).join()})`;
}
