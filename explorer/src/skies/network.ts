/** Neural skies (Satilmis et al. 2017): a network under one sun, what does not change with the view in its biases. */

import { TABLES, unpacked, type Packed } from "../core/tables";
import { elevation, halfSquare, limited, type Vec3 } from "../core/vector";
import type { Network } from "./sky";

interface Stored {
  features: string[];
  layers: { weights: Packed; biases: Packed }[];
  exponential: boolean;
  scale: number;
  bands: number[];
  toXYZ: number[][];
}

export const NETWORKS: Record<string, Stored> = TABLES.networks;

/** Inputs that are the same for every view. */
function inputsOfTheSky(sun: Vec3, turbidity: number, albedo: number): Record<string, number> {
  const height = Math.max(elevation(sun), 0);
  return {
    sqrt_turbidity: Math.sqrt(turbidity),
    turbidity,
    log_turbidity: Math.log(turbidity),
    albedo,
    sun_zenith: Math.PI / 2 - height,
    sqrt_sun_elevation: Math.sqrt(height),
    cbrt_sun_elevation: Math.cbrt(Math.max(height, 1e-9)),
  };
}

/** Rows of weights with the bias last. */
function rowsOf(layer: { weights: Packed; biases: Packed }): number[][] {
  const [rows, columns] = layer.weights.shape;
  const weights = unpacked(layer.weights);
  const biases = unpacked(layer.biases);
  return Array.from({ length: rows }, (_, r) => [...weights.slice(r * columns, (r + 1) * columns), biases[r]]);
}

/** The network under one sun; view_x and view_y (eq. 10) become east and north. */
export function foldedNetwork(name: string, sun: Vec3, turbidity: number, albedo: number): Network {
  const stored = NETWORKS[name];
  const fixed = inputsOfTheSky(sun, limited(turbidity, 1, 10), limited(albedo, 0, 1));
  const level = Math.hypot(sun[0], sun[1]);
  const [east, north] = level > 0 ? [sun[0] / level, sun[1] / level] : [0, 0];
  const inputs: string[] = [];
  const weightsOf: ((row: number[]) => number)[] = [];
  stored.features.forEach((feature, k) => {
    if (feature in fixed) return;
    const y = stored.features.indexOf("view_y");
    inputs.push(feature === "view_x" ? "east" : feature === "view_y" ? "north" : feature);
    if (feature === "view_x") weightsOf.push((row) => -row[k] * east + row[y] * north);
    else if (feature === "view_y") weightsOf.push((row) => -row[stored.features.indexOf("view_x")] * north - row[k] * east);
    else weightsOf.push((row) => row[k]);
  });
  const layers = stored.layers.map(rowsOf);
  layers[0] = layers[0].map((row) => {
    const bias = stored.features.reduce((total, feature, k) => total + (fixed[feature] ?? 0) * row[k], row[row.length - 1]);
    return [...weightsOf.map((weight) => weight(row)), bias];
  });
  const toXYZ = stored.toXYZ.map((row) => row.map((value) => value * stored.scale));
  return { kind: "network", inputs, layers, exponential: stored.exponential, toXYZ };
}

const VIEW: Record<string, (v: Vec3, distance: number) => number> = {
  east: (v) => v[0],
  north: (v) => v[1],
  view_z: (v) => Math.max(v[2], 0),
  distance: (_, distance) => distance,
  sqrt_up: (v) => Math.sqrt(Math.max(v[2], 0)),
  log_up: (v) => Math.log(Math.max(v[2], 0) + 0.02),
  inverse_up: (v) => 1 / (Math.max(v[2], 0) + 0.1),
  sqrt_distance: (_, distance) => Math.sqrt(distance),
  log_distance: (_, distance) => Math.log(distance + 0.05),
  cos_angle: (_, distance) => 1 - distance ** 2 / 2,
};

/** The network's outputs toward a direction, in units of its scale. */
export function networkOutputs(network: Network, sun: Vec3, toward: Vec3): number[] {
  const distance = 2 * Math.sqrt(halfSquare(toward, sun));
  let signal = network.inputs.map((name) => VIEW[name](toward, distance));
  network.layers.forEach((rows, depth) => {
    const sums = rows.map((row) => signal.reduce((total, value, k) => total + value * row[k], row[row.length - 1]));
    const last = depth === network.layers.length - 1;
    signal = last ? sums.map(network.exponential ? (z) => Math.exp(limited(z, -30, 30)) : (z) => (z * z) / 2)
      : sums.map((z) => 1 / (1 + z * z));
  });
  return signal;
}

/** XYZ toward a direction. */
export function networkLight(network: Network, sun: Vec3, toward: Vec3): Vec3 {
  const light = networkOutputs(network, sun, toward);
  return network.toXYZ.map((row) => row.reduce((total, weight, k) => total + weight * light[k], 0)) as unknown as Vec3;
}
