/** A weather file's year as a map of hours: drop a file, pick an hour, see that hour's sky. */

import { middleOf, MOST_BYTES, readWeather, type Hour, type Weather } from "../files/epw";
import { VIRIDIS } from "../picture/display";
import { offsetMinutes } from "../sun/clock";
import type { Explorer } from "./app";
import { h, tell } from "./element";
import { zoneNear } from "./places";

type Column = "global" | "direct" | "diffuse";
const COLUMNS: [Column, string][] = [["global", "Global"], ["direct", "Direct normal"], ["diffuse", "Diffuse"]];
const BEFORE = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334];
const MONTHS = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];

/** Column of a day in the map; the 29th of February shares the 28th's. */
const dayOf = ({ month, day }: Hour): number => BEFORE[month - 1] + Math.min(day, month === 2 ? 28 : 31) - 1;

export class Year {
  private title = h("b");
  private told = h("span", { class: "told" });
  private column = h("select", { "aria-label": "What the map shows" }, ...COLUMNS.map(([value, text]) => h("option", { value }, text)));
  private map = h("canvas", { width: 365, height: 24, role: "img", tabindex: 0, "aria-label": "Hours of the year; arrow keys pick an hour" });
  private mark = h("i", { class: "mark" });
  private close = h("button", { type: "button", "aria-label": "Close the year" }, "Close");
  private weather: Weather | null = null;
  private byPlace = new Map<number, Hour>();
  private picked: Hour | null = null;
  private input = h("input", { type: "file", accept: ".epw", hidden: true });
  readonly open = h("button", { type: "button", click: () => this.input.click() }, "Open a weather file (.epw)");
  readonly element = h("div", { class: "year", hidden: true },
    h("div", { class: "year-head" }, this.title, this.told, h("span", { class: "space" }), this.column, this.close),
    h("div", { class: "year-map" }, this.map, this.mark),
    h("div", { class: "scale months" }, ...MONTHS.map((text) => h("span", {}, text))), this.input);

  constructor(private explorer: Explorer) {
    this.column.addEventListener("change", () => this.paint());
    this.close.addEventListener("click", () => this.leave());
    this.map.addEventListener("pointermove", (event) => this.told.replaceChildren(this.words(this.under(event))));
    this.map.addEventListener("pointerleave", () => this.told.replaceChildren(this.words(this.picked)));
    this.map.addEventListener("click", (event) => this.pick(this.under(event)));
    this.map.addEventListener("keydown", (event) => this.key(event));
    this.input.addEventListener("change", () => this.input.files?.[0] && void this.take(this.input.files[0]));
    const { root } = explorer;
    root.addEventListener("dragover", (event) => event.preventDefault());
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
  }

  private async take(file: File): Promise<void> {
    if (file.size > MOST_BYTES) return this.explorer.say(`${file.name.slice(0, 60)} is too large for an .epw file`);
    this.show(await file.text(), file.name);
  }

  /** The file of the same host that the address names. */
  async fetch(path: string): Promise<void> {
    try {
      const answer = await fetch(path, { redirect: "error", credentials: "omit" });
      if (!answer.ok) throw new Error(`${answer.status}`);
      this.show(await answer.text(), path);
    } catch (error) {
      this.explorer.say(`${path.slice(0, 60)} could not be read: ${error instanceof Error ? error.message : ""}`);
    }
  }

  /** The year of a file's text; what is wrong is told with its line. */
  show(text: string, name: string): void {
    try {
      this.weather = readWeather(text);
    } catch (error) {
      return this.explorer.say(`${name.slice(0, 60)}: ${error instanceof Error ? error.message : String(error)}`);
    }
    this.byPlace = new Map(this.weather.hours.map((hour) => [dayOf(hour) * 24 + hour.hour - 1, hour]));
    this.element.hidden = false;
    tell(this.title, this.weather.name || name.slice(0, 60));
    this.paint();
    const { hours } = this.weather;
    this.pick(hours.find((hour) => hour.month === 6 && hour.day === 21 && hour.hour === 15) ?? hours[hours.length >> 1]);
  }

  private leave(): void {
    this.weather = null;
    this.element.hidden = true;
    this.explorer.change({ url: "" });
  }

  private under(event: PointerEvent | MouseEvent): Hour | null {
    const { left, top, width, height } = this.map.getBoundingClientRect();
    const day = Math.floor(((event.clientX - left) / width) * 365);
    const row = Math.floor(((event.clientY - top) / height) * 24);
    return this.byPlace.get(Math.min(364, Math.max(0, day)) * 24 + 23 - Math.min(23, Math.max(0, row))) ?? null;
  }

  private key(event: KeyboardEvent): void {
    const way = { ArrowLeft: -24, ArrowRight: 24, ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (way === undefined || !this.picked) return;
    event.preventDefault();
    event.stopPropagation();
    const place = dayOf(this.picked) * 24 + this.picked.hour - 1 + way;
    this.pick(this.byPlace.get((place + 8760) % 8760) ?? null);
  }

  /** Show an hour's sky: Perez's, of its irradiances, under the sun of its middle. */
  private pick(hour: Hour | null): void {
    if (!hour || !this.weather) return;
    if (Number.isNaN(hour.direct + hour.diffuse)) return this.explorer.say("this hour's irradiance is missing in the file");
    this.picked = hour;
    const { latitude, longitude, name } = this.weather;
    const zone = zoneNear(latitude, longitude);
    const utc = middleOf(this.weather, hour, Number(this.explorer.state.date.slice(0, 4)));
    const local = new Date(utc + offsetMinutes(zone, utc) * 60000);
    const minutes = local.getUTCHours() * 60 + local.getUTCMinutes();
    this.explorer.change({
      latitude, longitude, zone, name, date: local.toISOString().slice(0, 10), minutes, sun: null, model: "perez-all-weather",
      dni: Math.min(hour.direct, 1200), dhi: Math.min(hour.diffuse, 800), dew: hour.dew,
    });
    this.told.replaceChildren(this.words(hour));
    this.mark.style.left = `${((dayOf(hour) + 0.5) / 365) * 100}%`;
    this.mark.style.top = `${((24 - hour.hour + 0.5) / 24) * 100}%`;
  }

  private words(hour: Hour | null): string {
    if (!hour) return "";
    const value = (w: number): string => (Number.isNaN(w) ? "missing" : `${w.toFixed(0)}`);
    return `${hour.day} ${MONTHS[hour.month - 1]}, ${hour.hour - 1}–${hour.hour} h: global ${value(hour.global)}, direct ${value(hour.direct)}, diffuse ${value(hour.diffuse)} W/m²`;
  }

  private paint(): void {
    const column = this.column.value as Column;
    const context = this.map.getContext("2d")!;
    const image = context.createImageData(365, 24);
    const most = Math.max(1, ...[...this.byPlace.values()].map((hour) => hour[column] || 0));
    for (const [place, hour] of this.byPlace) {
      const [day, row] = [Math.floor(place / 24), 23 - (place % 24)];
      const value = hour[column];
      const rgb = Number.isNaN(value) ? [0.5, 0.3, 0.3] : value === 0 ? [0.06, 0.07, 0.1] : viridis(value / most);
      image.data.set([...rgb.map((part) => Math.round(255 * part)), 255], 4 * (row * 365 + day));
    }
    context.putImageData(image, 0, 0);
  }
}

function viridis(x: number): number[] {
  const place = Math.min(Math.max(x, 0), 1) * 8;
  const k = Math.min(Math.floor(place), 7);
  return VIRIDIS[k].map((value, c) => value + (VIRIDIS[k + 1][c] - value) * (place - k));
}
