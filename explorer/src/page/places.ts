/** Where: search among a thousand cities, coordinates, or a click on a small map. */

import cities from "../data/cities.json";
import land from "../data/land.json";
import { isZone } from "../sun/clock";
import type { Change } from "./controls";
import { h, tell } from "./element";
import type { Scene } from "./scene";
import type { State } from "./state";

type Row = [string, string, number, number, number];
const ROWS = cities.cities as Row[];

/** Letters without accents, for search. */
function plain(text: string): string {
  return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}

const SEARCHED = ROWS.map((row) => plain(`${row[0]}, ${row[1]}`));

/** Cities whose name begins with the words, then those that hold them; the largest first. */
export function citiesLike(text: string, most = 7): Row[] {
  const wanted = plain(text.trim());
  if (!wanted) return [];
  const starts = ROWS.filter((_, k) => SEARCHED[k].startsWith(wanted));
  const holds = ROWS.filter((_, k) => !SEARCHED[k].startsWith(wanted) && SEARCHED[k].includes(wanted));
  return [...starts, ...holds].slice(0, most);
}

function placeOfCity([name, country, latitude, longitude, zone]: Row): Partial<State> {
  return { name: `${name}, ${country}`.slice(0, 60), latitude, longitude, zone: known(cities.zones[zone], longitude), sun: null };
}

function known(zone: string, longitude: number): string {
  if (isZone(zone)) return zone;
  const hours = Math.round(longitude / 15);
  return hours === 0 ? "Etc/GMT" : `Etc/GMT${hours > 0 ? "-" : "+"}${Math.abs(hours)}`;
}

/** The zone of the nearest city, or that of the longitude far from every one. */
export function zoneNear(latitude: number, longitude: number): string {
  let best: Row | null = null;
  let least = 12 ** 2;
  for (const row of ROWS) {
    const turn = ((row[3] - longitude + 540) % 360) - 180;
    const apart = (row[2] - latitude) ** 2 + (turn * Math.cos((latitude * Math.PI) / 180)) ** 2;
    if (apart < least) [best, least] = [row, apart];
  }
  return best ? known(cities.zones[best[4]], longitude) : known("", longitude);
}

export class Places {
  private search = h("input", {
    type: "search", placeholder: "Search a city", role: "combobox", "aria-expanded": "false", "aria-label": "Search a city",
    "aria-controls": "sd-cities", autocomplete: "off", spellcheck: "false",
  });
  private list = h("ul", { id: "sd-cities", role: "listbox", hidden: true });
  private latitude = h("input", { type: "number", min: -90, max: 90, step: "any", "aria-label": "Latitude, degrees north" });
  private longitude = h("input", { type: "number", min: -180, max: 180, step: "any", "aria-label": "Longitude, degrees east" });
  private zone = h("span", { class: "zone-name" });
  private map = h("canvas", { class: "map", width: 640, height: 300, role: "img", "aria-label": "World map: click to choose a place" });
  private back = h("button", { type: "button", class: "link", hidden: true }, "Back to the sun of place and time");
  private chosen = -1;
  readonly element = h("div", { class: "places" },
    h("div", { class: "search" }, this.search, this.list), this.map,
    h("div", { class: "coordinates" }, h("label", {}, "Lat", this.latitude), h("label", {}, "Lon", this.longitude)),
    this.zone, this.back);

  constructor(private change: Change) {
    this.search.addEventListener("input", () => this.offer());
    this.search.addEventListener("keydown", (event) => this.key(event));
    this.search.addEventListener("focus", () => this.search.select());
    this.search.addEventListener("blur", () => setTimeout(() => this.close(), 150));
    for (const input of [this.latitude, this.longitude]) input.addEventListener("change", () => this.typed());
    this.map.addEventListener("click", (event) => {
      const { left, top, width, height } = this.map.getBoundingClientRect();
      const longitude = ((event.clientX - left) / width) * 360 - 180;
      this.go(TOP - ((event.clientY - top) / height) * (TOP - BOTTOM), longitude);
    });
    this.back.addEventListener("click", () => this.change({ sun: null }));
  }

  private go(latitude: number, longitude: number): void {
    const [b, l] = [Number(latitude.toFixed(3)), Number(longitude.toFixed(3))];
    this.change({ latitude: b, longitude: l, zone: zoneNear(b, l), name: "", sun: null });
  }

  private typed(): void {
    const [b, l] = [this.latitude.valueAsNumber, this.longitude.valueAsNumber];
    if (Math.abs(b) <= 90 && Math.abs(l) <= 180) this.go(b, l);
  }

  private offer(): void {
    const found = citiesLike(this.search.value);
    this.chosen = found.length ? 0 : -1;
    this.list.replaceChildren(...found.map((row, k) =>
      h("li", { role: "option", "aria-selected": String(k === 0), pointerdown: () => this.take(row) }, row[0], h("small", {}, row[1]))));
    this.list.hidden = !found.length;
    this.search.setAttribute("aria-expanded", String(found.length > 0));
  }

  private key(event: KeyboardEvent): void {
    const found = citiesLike(this.search.value);
    if (event.key === "Escape") this.close();
    else if (event.key === "Enter" && found[this.chosen]) this.take(found[this.chosen]);
    else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      this.chosen = Math.max(0, Math.min(found.length - 1, this.chosen + (event.key === "ArrowDown" ? 1 : -1)));
      [...this.list.children].forEach((item, k) => item.setAttribute("aria-selected", String(k === this.chosen)));
    }
  }

  private take(row: Row): void {
    this.close();
    this.search.blur();
    this.change(placeOfCity(row));
  }

  private close(): void {
    this.list.hidden = true;
    this.search.setAttribute("aria-expanded", "false");
  }

  follow({ state }: Scene): void {
    if (document.activeElement !== this.search) this.search.value = state.name;
    for (const [input, value] of [[this.latitude, state.latitude], [this.longitude, state.longitude]] as const) {
      if (document.activeElement !== input) input.value = String(Number(value.toFixed(3)));
    }
    tell(this.zone, `Time zone ${state.zone.replaceAll("_", " ")}`);
    this.back.hidden = state.sun === null;
    this.draw(state);
  }

  private drawn = "";

  private draw(state: State): void {
    const style = getComputedStyle(this.map);
    const key = `${state.latitude},${state.longitude},${style.color},${style.accentColor}`;
    if (key === this.drawn) return;
    this.drawn = key;
    const context = this.map.getContext("2d", { willReadFrequently: true })!;
    const { width, height } = this.map;
    context.clearRect(0, 0, width, height);
    context.fillStyle = style.color;
    context.beginPath();
    for (const ring of land.rings) {
      for (let k = 0; k < ring.length; k += 2) {
        const [x, y] = onMap(ring[k + 1] / 10, ring[k] / 10, width, height);
        if (k === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
    }
    context.fill("evenodd");
    const [x, y] = onMap(state.latitude, state.longitude, width, height);
    context.fillStyle = context.strokeStyle = "#f5a742";
    context.beginPath();
    context.arc(x, y, 7, 0, 7);
    context.fill();
    context.lineWidth = 3;
    context.globalAlpha = 0.5;
    context.beginPath();
    context.arc(x, y, 15, 0, 7);
    context.stroke();
    context.globalAlpha = 1;
  }
}

const [TOP, BOTTOM] = [84, -60];

function onMap(latitude: number, longitude: number, width: number, height: number): [number, number] {
  return [((longitude + 180) / 360) * width, ((TOP - latitude) / (TOP - BOTTOM)) * height];
}
