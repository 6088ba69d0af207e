/** What the page shows, as plain values; and each value's way into the address and back. */

import { isZone } from "../sun/clock";
import { AEROSOLS } from "../skies/physical/airs";
import { modelNamed } from "../skies/catalogue";
import { KINDS, type Kind } from "../skies/clouds/optics";
import type { FieldKind } from "../skies/fields/kinds";
import { FIELD_KINDS } from "../skies/fields/names";
import type { Numbers } from "../skies/model";

export interface State extends Numbers {
  model: string;
  /** The model beside it, "" for none. */
  beside: string;
  latitude: number;
  longitude: number;
  zone: string;
  /** Name of the place for people, "" where there is none. */
  name: string;
  date: string;
  /** Minutes after local midnight. */
  minutes: number;
  /** Azimuth and elevation, degrees, of a sun set by hand. */
  sun: [number, number] | null;
  /** Kind of aerosol, and Dobson units of ozone, of the physical sky. */
  aerosol: string;
  ozone: number;
  /** Of what a layer of cloud is. */
  particles: Kind;
  /** The kind of clouds with a shape, "" for none, the share of the sky that they cover, and the seed of their shape. */
  clouds: FieldKind | "";
  clouded: number;
  seed: number;
  /** In what haze is told: turbidity, kilometres that one sees, or the aerosol's optical depth at 550 nm. */
  haze: "turbidity" | "visibility" | "depth";
  view: "dome" | "panorama";
  /** Azimuth in the middle of the panorama, degrees. */
  look: number;
  show: "photo" | "luminance" | "difference";
  /** Exposure value at ISO 100; null by the sky's content. */
  ev: number | null;
  /** log10 of cd m-2 at the ends of the false colours; null by the content. */
  bar: [number, number] | null;
  wipe: number;
  path: boolean;
  /** Whether the moon is shown, and lights the physical sky at night. */
  moon: boolean;
  /** Whether stars, planets and the glow of the night are. */
  stars: boolean;
  analemma: boolean;
  target: string;
  theme: "" | "dark" | "light";
  /** A weather file of the same host. */
  url: string;
}

export const VERSION = 1;

export const USUAL: State = {
  model: "hosek-wilkie", beside: "", latitude: 45.07, longitude: 7.687, zone: "Europe/Rome", name: "Turin, Italy",
  date: "2026-06-21", minutes: 18 * 60 + 30, sun: null, turbidity: 3, albedo: 0.2, dni: 700, dhi: 120, dew: 11,
  letters: [-1, -0.32, 10, -3, 0.45], lux: 12000, share: 0.15, clearness: 0.75, cloud: 0, depth: 10, cover: 0, particles: "water", clouds: "", clouded: 0.4, seed: 0, aerosol: "usual", ozone: 330, haze: "turbidity",
  view: "dome", look: 270, show: "photo", ev: null, bar: null, wipe: 0.5, path: true, moon: true, stars: true, analemma: false,
  target: "native", theme: "", url: "",
};

export const TARGETS: Record<string, { left: number; note: string }> = {
  native: { left: 0, note: "N E S W" },
  blender: { left: 270, note: "W N E S" },
  mitsuba: { left: 0, note: "N E S W" },
  openexr: { left: 0, note: "N E S W" },
  usd: { left: 0, note: "N E S W" },
  three: { left: 270, note: "W N E S" },
  skylibs: { left: 180, note: "S W N E" },
};

export const LIMITS: Record<string, [number, number]> = {
  latitude: [-90, 90], longitude: [-180, 180], turbidity: [1, 10], albedo: [0, 1], dni: [0, 1200], dhi: [0, 800],
  dew: [-30, 40], lux: [100, 60000], share: [0, 1], clearness: [0, 1], cloud: [0, 1], depth: [1, 60], cover: [0, 1], clouded: [0, 1], seed: [0, 999], ozone: [200, 480], look: [0, 360], ev: [-10, 22], wipe: [0, 1],
};

/** Limits of Perez's letters, within which his sky is nowhere below 0. */
export const LETTER_LIMITS: [number, number][] = [[-1, 5], [-2, 0], [0, 30], [-8, 0], [-0.5, 2]];

/** A finite number in its limits, undefined for anything else. */
function within(name: string, text: string): number | undefined {
  const value = text.trim() === "" ? NaN : Number(text);
  const [low, high] = LIMITS[name];
  return value >= low && value <= high ? value : undefined;
}

/** Numbers with commas. */
function pair(text: string): [number, number] | undefined {
  const found = text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
  return found.length === 2 && found.every(Number.isFinite) ? [found[0], found[1]] : undefined;
}

const round = (value: number, digits: number): string => String(Number(value.toFixed(digits)));

interface Entry {
  key: string;
  read(text: string): Partial<State> | undefined;
  write(state: State): string;
}

function choice<K extends keyof State>(name: K, allowed: (text: string) => boolean, key: string = name): Entry {
  return {
    key,
    read: (text) => (allowed(text) ? ({ [name]: text } as unknown as Partial<State>) : undefined),
    write: (state) => String(state[name]),
  };
}

function numeric(name: "turbidity" | "albedo" | "dni" | "dhi" | "dew" | "lux" | "share" | "clearness" | "cloud" | "depth" | "cover" | "clouded" | "seed" | "ozone" | "look" | "wipe", digits = 2): Entry {
  return {
    key: name,
    read: (text) => {
      const value = within(name, text);
      return value === undefined || (name === "seed" && !Number.isInteger(value)) ? undefined : { [name]: value };
    },
    write: (state) => round(state[name], digits),
  };
}

function switched(name: "path" | "moon" | "stars" | "analemma"): Entry {
  return {
    key: name,
    read: (text) => (text === "yes" || text === "no" ? { [name]: text === "yes" } : undefined),
    write: (state) => (state[name] ? "yes" : "no"),
  };
}

const oneOf = (...names: string[]) => (text: string): boolean => names.includes(text);

/** A real date between the years 1 and 9999 written YYYY-MM-DD. */
export function isDate(text: string): boolean {
  if (!/^\d{4}-\d{2}-\d{2}$/.test(text) || text.startsWith("0000")) return false;
  const time = Date.parse(`${text}T00:00Z`);
  return Number.isFinite(time) && new Date(time).toISOString().startsWith(text);
}

/** A path of the same host: no scheme, no host, nothing that leaves the folder's host. */
export function isLocalPath(text: string): boolean {
  return /^(?!\/\/)[A-Za-z0-9_./-]{1,200}$/.test(text) && text.toLowerCase().endsWith(".epw");
}

export const ENTRIES: Entry[] = [
  choice("model", (text) => modelNamed(text) !== undefined),
  choice("beside", (text) => text === "" || modelNamed(text) !== undefined),
  {
    key: "place",
    read: (text) => {
      const found = pair(text);
      const inside = found && Math.abs(found[0]) <= 90 && Math.abs(found[1]) <= 180;
      return inside ? { latitude: found[0], longitude: found[1] } : undefined;
    },
    write: (state) => `${round(state.latitude, 4)},${round(state.longitude, 4)}`,
  },
  choice("zone", (text) => text.length < 60 && isZone(text)),
  choice("name", (text) => text.length <= 60),
  choice("date", isDate),
  {
    key: "time",
    read: (text) => {
      const found = /^([01]\d|2[0-3]):([0-5]\d)$/.exec(text);
      return found ? { minutes: 60 * Number(found[1]) + Number(found[2]) } : undefined;
    },
    write: ({ minutes }) => {
      const whole = Math.min(1439, Math.round(minutes));
      return `${String(Math.floor(whole / 60)).padStart(2, "0")}:${String(whole % 60).padStart(2, "0")}`;
    },
  },
  {
    key: "sun",
    read: (text) => {
      const found = text === "" ? null : pair(text);
      if (found === null) return { sun: null };
      return found && found[0] >= 0 && found[0] <= 360 && Math.abs(found[1]) <= 90 ? { sun: found } : undefined;
    },
    write: ({ sun }) => (sun ? sun.map((value) => round(value, 2)).join() : ""),
  },
  numeric("turbidity"), numeric("albedo"), numeric("dni", 1), numeric("dhi", 1), numeric("dew", 1),
  {
    key: "letters",
    read: (text) => {
      const found = text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
      const inside = found.length === 5 && found.every((value, k) => value >= LETTER_LIMITS[k][0] && value <= LETTER_LIMITS[k][1]);
      return inside ? { letters: found } : undefined;
    },
    write: ({ letters }) => letters.map((value) => round(value, 3)).join(),
  },
  numeric("lux", 0), numeric("share"), numeric("clearness"), numeric("cloud"), numeric("depth", 1), numeric("cover"), choice("particles", oneOf(...Object.keys(KINDS))),
  choice("clouds", oneOf("", ...FIELD_KINDS)), numeric("clouded"), numeric("seed", 0), numeric("ozone", 0), choice("aerosol", oneOf(...AEROSOLS)),
  choice("haze", oneOf("turbidity", "visibility", "depth")),
  choice("view", oneOf("dome", "panorama")), numeric("look", 1),
  choice("show", oneOf("photo", "luminance", "difference")),
  {
    key: "ev",
    read: (text) => {
      const value = text === "auto" ? null : within("ev", text);
      return value === undefined ? undefined : { ev: value };
    },
    write: ({ ev }) => (ev === null ? "auto" : round(ev, 2)),
  },
  {
    key: "bar",
    read: (text) => {
      const found = text === "auto" ? null : pair(text);
      if (found === null) return { bar: null };
      return found && found[0] >= -6 && found[1] <= 10 && found[1] - found[0] >= 0.1 ? { bar: found } : undefined;
    },
    write: ({ bar }) => (bar ? bar.map((value) => round(value, 2)).join() : "auto"),
  },
  numeric("wipe"), switched("path"), switched("moon"), switched("stars"), switched("analemma"),
  choice("target", (text) => Object.hasOwn(TARGETS, text)), choice("theme", oneOf("", "dark", "light")),
  choice("url", (text) => text === "" || isLocalPath(text)),
];
