/** The explorer: keeps the state, makes its scene, and has every part of the page follow. */

import { VERSION as ADDRESS_VERSION } from "./state";
import { azimuth, elevation, DEG, type Vec3 } from "../core/vector";
import { placeOf, type View } from "../picture/view";
import { MODELS } from "../skies/catalogue";
import { CloudMaker } from "../skies/fields/maker";
import { asCommand, asPython, asShader } from "../files/words";
import { heldNumbers } from "../files/heldshader";
import { analemma, dayPath } from "../sun/path";
import { readAddress, writeAddress } from "./address";
import type { Control } from "./controls";
import { section, segments } from "./controls";
import { h, icon, tell } from "./element";
import { exrOf, takeAway } from "./takeaway";
import { keysList, onKeys } from "./keyboard";
import { Legend, STOPS } from "./legend";
import { pictureSection, skySection } from "./panel";
import { Places } from "./places";
import { Card, Readout } from "./readout";
import { cloudedScene, exposureOf, groundXYZ, numbersOf, sceneOf, usualBar, usualEV, type Numbers, type Scene } from "./scene";
import { Stage, type Lines } from "./stage";
import type { State } from "./state";
import { Timeline } from "./timeline";
import { Year } from "./year";

export interface Choices {
  /** The state at first, as the address has it. */
  query: string;
  /** Told of each state at rest, as the address has it. */
  settled(query: string): void;
}

const SUN = "M12 7a5 5 0 1 0 0 10 5 5 0 0 0 0-10zM12 1v2M12 21v2M1 12h2M21 12h2M4.2 4.2l1.4 1.4M18.4 18.4l1.4 1.4M4.2 19.8l1.4-1.4M18.4 5.6l1.4-1.4";
const HALF = "M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18";
const REST = 140;

export class Explorer {
  state: State;
  scene!: Scene;
  numbers: Numbers[] = [];
  /** Milliseconds of script that the last frames took. */
  readonly took: number[] = [];
  readonly stage: Stage;
  private controls: Control[] = [];
  private card = new Card();
  private readout = new Readout();
  private legend = new Legend((part, dragging) => this.change(part, dragging));
  private timeline: Timeline;
  readonly year: Year;
  readonly clouds = new CloudMaker(() => this.schedule(this.moving), (text) => this.say(text));
  private places = new Places((part) => this.change(part));
  private notice = h("div", { class: "notice", role: "alert", hidden: true });
  private empty = h("div", { class: "empty", hidden: true });
  private lines: Lines = { path: null, analemma: null };
  private linesOf = "";
  private frame = 0;
  private rest = 0;
  private pointer: [Vec3, number, number, boolean] | null = null;

  constructor(readonly root: HTMLElement, private choices: Choices) {
    const read = readAddress(choices.query);
    this.state = read.state;
    const change = (part: Partial<State>, dragging = false): void => this.change(part, dragging);
    this.stage = new Stage(change, (toward, x, y, right) => this.ask(toward, x, y, right), () => this.change({}));
    this.timeline = new Timeline(change, () => this.state);
    this.year = new Year(this);
    this.build();
    this.theme();
    this.stage.start();
    onKeys(this);
    if (read.refused.length) this.say(`Not understood in the address: ${read.refused.join(", ")}`);
    new ResizeObserver(() => this.change({}, true)).observe(this.stage.element);
    this.change({});
    if (this.state.url) void this.year.fetch(this.state.url);
  }

  private build(): void {
    const change = (part: Partial<State>, dragging = false): void => this.change(part, dragging);
    const view = segments("View", "view", [["dome", "Dome"], ["panorama", "Panorama"]], change);
    const show = segments("Show", "show", [["photo", "Photograph"], ["luminance", "False colour"], ["difference", "Difference"]], change,
      (scene, value) => value !== "difference" || scene.skies.length > 1);
    const sky = skySection(change);
    const picture = pictureSection(change);
    const theme = h("button", { type: "button", class: "round", "aria-label": "Dark or light page", title: "Dark or light page", click: () => this.turnTheme() }, icon(HALF));
    this.controls = [view, show, ...sky.controls, ...picture.controls];
    this.stage.element.append(this.card.element, this.legend.element, this.empty, this.notice);
    this.root.classList.add("sd-explorer");
    this.root.replaceChildren(
      h("header", {}, h("h1", {}, icon(SUN), "skydome"), view.element, show.element, h("span", { class: "space" }), theme),
      h("main", {}, this.stage.element, h("div", {}, this.year.element, this.timeline.element)),
      h("aside", { "aria-label": "Sky, place and light" }, sky.element, section("Light", this.readout.element),
        section("Place", this.places.element, h("div", { class: "buttons" }, this.year.open)), picture.element, takeAway(this),
        section("Keys", keysList())),
    );
  }

  /** Have a control follow the scene. */
  followed(control: Control): void {
    this.controls.push(control);
  }

  /** Change the state; `dragging` while a hand moves it. */
  change(part: Partial<State>, dragging = false): void {
    Object.assign(this.state, part);
    if (!this.state.beside && this.state.show === "difference") this.state.show = "photo";
    clearTimeout(this.rest);
    if (dragging) this.rest = window.setTimeout(() => this.schedule(false), Math.max(REST, 5 * this.stage.late));
    this.schedule(dragging);
  }

  private moving = false;

  private schedule(moving: boolean): void {
    this.moving = moving || (this.stage.dragging && this.moving);
    if (!this.frame) this.frame = requestAnimationFrame(() => this.draw());
  }

  /** Draw at full size at once. */
  drawNow(): void {
    this.moving = false;
    this.draw();
  }

  private draw(): void {
    this.frame = 0;
    const begun = performance.now();
    const { moving } = this;
    this.theme();
    this.scene = cloudedScene(sceneOf(this.state), this.clouds, moving);
    const { scene } = this;
    if (!moving || scene.skies.every((sky) => sky.recipe.kind === "formula") || this.numbers.length !== scene.skies.length) {
      this.numbers = scene.skies.map(numbersOf);
    }
    const bar = this.state.bar ?? usualBar(scene.skies);
    this.trace();
    const style = getComputedStyle(this.root);
    const grounds = scene.skies.map((sky, k) => groundXYZ(sky, this.numbers[k]));
    this.stage.draw(scene, {
      mode: { photo: 0, luminance: 1, difference: 2 }[this.state.show], exposure: exposureOf(this.state.ev ?? usualEV(scene.skies[0])),
      bar, stops: STOPS, wipe: this.state.wipe, paper: colourOf(style.getPropertyValue("--paper")), grounds,
    }, this.lines, moving, style.getPropertyValue("--dim"));
    this.follow(bar, moving);
    this.took.push(performance.now() - begun);
    if (this.took.length > 400) this.took.shift();
    if (!moving) this.choices.settled(writeAddress(this.state));
  }

  private follow(bar: [number, number], moving: boolean): void {
    for (const control of this.controls) control.follow(this.scene);
    this.readout.show(this.scene, this.numbers);
    this.legend.follow(this.scene, bar);
    this.timeline.follow(this.scene, !moving);
    this.places.follow(this.scene);
    const dark = this.scene.skies.every((sky) => !sky.day);
    this.empty.hidden = !dark;
    if (dark) tell(this.empty, this.scene.sun[2] > 0 ? "No light: the irradiances are 0" : this.scene.model.lowest < 0 ? "Night without a moon, its stars switched off" : this.scene.model.name === "overcast" && !this.state.sun ? "The sun has set: the command has the night under this cloud" : "The sun has set: this model ends at the horizon");
    if (this.pointer) this.ask(...this.pointer);
  }

  private trace(): void {
    const { state } = this;
    const key = [state.latitude, state.longitude, state.date, state.zone, state.path, state.analemma, state.analemma && Math.round(state.minutes)].join();
    if (key === this.linesOf) return;
    this.linesOf = key;
    this.lines = {
      path: state.path ? dayPath(state, state.date, state.zone) : null,
      analemma: state.analemma ? analemma(state, state.date, state.minutes, state.zone) : null,
    };
  }

  private ask(toward: Vec3 | null, x: number, y: number, right: boolean): void {
    this.pointer = toward ? [toward, x, y, right] : null;
    if (!toward || this.stage.dragging) return this.card.hide();
    const { width, height } = this.stage.element.getBoundingClientRect();
    const sky = this.scene.skies[right ? 1 : 0] ?? this.scene.skies[0];
    this.card.show(sky, this.scene.skies.length > 1, toward, x, y, width, height);
  }

  /** Take the state of another address. */
  go(query: string): void {
    const { state, refused } = readAddress(query);
    if (refused.length) this.say(`Not understood in the address: ${refused.join(", ")}`);
    this.change(state);
  }

  /** A line above the picture, for some seconds. */
  say(text: string): void {
    tell(this.notice, text);
    this.notice.hidden = false;
    setTimeout(() => (this.notice.hidden = true), 6000);
  }

  private theme(): void {
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const theme = this.state.theme || (dark ? "dark" : "light");
    if (this.root.dataset.theme !== theme) this.root.dataset.theme = theme;
  }

  private turnTheme(): void {
    this.change({ theme: this.root.dataset.theme === "dark" ? "light" : "dark" });
  }

  toggleDay(): void {
    this.timeline.toggle();
  }

  /** XYZ and mask of a sky, for tests: four numbers a pixel from the top. */
  read(view: View, width: number, height: number, which = 0): Float32Array {
    return this.stage.renderer.read(this.scene.skies[which], view, width, height);
  }

  /** The sky in the words of others. */
  get words(): { python: string; command: string; shader: string; numbers: number[] } {
    const [{ recipe }] = this.scene.skies;
    const numbers = recipe.kind === "fields" ? heldNumbers(recipe) : [];
    const shader = recipe.kind === "fields" && (recipe.layer || recipe.clouds) ? "" : asShader(this.scene.skies[0]);
    return { python: asPython(this.scene), command: asCommand(this.scene), shader, numbers };
  }

  /** The map as an OpenEXR file. */
  exr(height: number): Promise<Uint8Array<ArrayBuffer>> {
    return exrOf(this, height);
  }

  /** The exposure value in use. */
  get exposure(): number {
    return Number((this.state.ev ?? usualEV(this.scene.skies[0])).toFixed(2));
  }

  /** Where the sun lies in the picture, 0..1 from the left and from the top. */
  get sunPlace(): [number, number] {
    return placeOf(this.stage.view(this.scene), this.scene.sun);
  }

  /** The sun's azimuth and elevation, degrees. */
  get sun(): [number, number] {
    return [azimuth(this.scene.sun) / DEG, elevation(this.scene.sun) / DEG];
  }

  readonly version = ADDRESS_VERSION;
  readonly models = MODELS.map((model) => model.name);
}

/** A colour written #rrggbb as red, green and blue, 0..1. */
function colourOf(text: string): Vec3 {
  const value = parseInt(text.trim().slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
