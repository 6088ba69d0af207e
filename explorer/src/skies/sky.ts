/** What the page knows of one sky: its light toward any direction, and how a shader is told of it. */

import type { Vec3 } from "../core/vector";
import type { CloudMap } from "./fields/map";

/** Numbers R A B C D E F G H I of one channel (Hosek and Wilkie 2012, eq. 8). */
export type Letters = number[];

export interface Formula {
  kind: "formula";
  /** One row a channel: one, or three. */
  channels: Letters[];
  /** Hosek and Wilkie's gradation has 0.01 added to the cosine. */
  hosek: boolean;
  /** The channels are x, y, Y. */
  chromatic: boolean;
  /** From the channels (X, Y, Z of chromatic ones) to XYZ in cd m-2, rows. */
  toXYZ: number[][];
}

export interface Network {
  kind: "network";
  /** Inputs of the view, by the names of `data/shaders.ts`. */
  inputs: string[];
  /** Rows of weights, the bias last. */
  layers: number[][][];
  exponential: boolean;
  toXYZ: number[][];
}

/** A phase function: constant + square c^2 + the sum over lobes (a, b, g) of (a + b c^2) / (1 + g^2 - 2 g c)^1.5. */
export interface Law {
  constant: number;
  square: number;
  lobes: number[][];
}

export interface Fields {
  kind: "fields";
  /** Whether the clear sky has light at all: none is left under a whole cover. */
  clear: boolean;
  /** (rows, turns, 4, 3): what each of three constituents scatters once, per phase function, and the rest; XYZ, cd m-2. */
  grid: Float32Array;
  /** The sun where it is seen, bent by the air. */
  seen: Vec3;
  leastCosine: number;
  laws: Law[];
  /** Light of the moon in the same air; null by day and without a moon. */
  moonlit: Fields | null;
  /** Light of a layer of cloud, added; null without. */
  layer: Layer | null;
  /** Clouds with a shape, before what lamps and night send; null without. */
  clouds: CloudMap | null;
  /** What glows at night whatever sun and moon do, XYZ on the grid of `night/glow.ts`; null by day. */
  glow: Float32Array | null;
}

/** Light under an even layer of cloud on the grid of `Fields`, its share of the sky in it. */
export interface Layer {
  /** (rows, turns, 4, 3): what is scattered once, per shape of the phase functions, and the rest; XYZ, cd m-2. */
  grid: Float32Array;
  seen: Vec3;
  /** Three shapes, sr-1, at angles even in the root of the angle. */
  phases: Float32Array;
}

export interface Shaped {
  kind: "shaped";
  /** Of the terms of `shaped.ts`. */
  numbers: number[];
  /** cd m-2 a unit of the shape. */
  level: number;
  /** XYZ of its one colour, Y = 1. */
  white: number[];
}

export type Recipe = Formula | Network | Fields | Shaped;

export interface Spectrum {
  wavelengths: number[];
  /** W m-2 sr-1 nm-1 */
  radiance: number[];
}

/** A sky under one sun. */
export interface Sky {
  /** Name in the catalogue. */
  name: string;
  sun: Vec3;
  recipe: Recipe;
  /** Whether it has light at all. */
  day: boolean;
  /** Albedo of its ground. */
  ground: number;
  /** Light on a plane that faces the sun, XYZ in lx; null without a disc. */
  disc: Disc | null;
  spectrum: ((toward: Vec3) => Spectrum) | null;
  /** Stars and planets; null by day. */
  points: Points | null;
  /** What was decided for the user, a line each. */
  notes: string[];
}

/** Points of light: unit vectors, and XYZ on a plane that faces each, lx; three numbers each. */
export interface Points {
  toward: Float32Array;
  light: Float32Array;
}

export interface Disc {
  /** Where it stands: the sun, or at night the moon. */
  toward: Vec3;
  radius: number;
  turbidity: number;
  /** XYZ of the illuminance on a plane that faces it, lx. */
  normal: Vec3;
}
