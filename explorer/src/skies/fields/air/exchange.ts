/** Light to and fro between a field of cloud, the air below it and the ground, at one wavelength. A second form of `Exchange`. */

import table from "../../../data/clouds.json";
import { CLOUD, EVEN, GROUND, type LowerAir } from "./lower";

const [DIFFUSE, OPEN] = table.slant;

/** What a field makes of diffuse light. */
export interface Shares {
  /** That meets next to no cloud either way; the rest is as under thick cloud. */
  open: number;
  through: number;
  back: number;
}

/** Of columns' scaled depths, straight up, the open share. */
export const openShare = (columns: Float32Array): number =>
  (columns.reduce((total, depth) => total + Math.exp(-depth / DIFFUSE), 0) / columns.length) ** OPEN;

/** Share of light from above that field and ground send back. */
export const seenFromAbove = ({ through, back }: Shares, albedo: number): number => back + (through ** 2 * albedo) / (1 - albedo * back);

/** Irradiances on the horizontal: what the cloud lets through and sends back, light from below at the cloud, what the ground sends up. */
export interface Exchange {
  cloud: number;
  back: number;
  below: number;
  up: number;
}

/** Of what comes through the cloud, sunlight straight on the ground, and what that gives ground and cloud by way of the air. */
export function exchanged({ down, up }: LowerAir, { open, back }: Shares, cloud: number, direct: number, byAir: number, albedo: number): Exchange {
  const mixed = (side: number[]): number => open * side[EVEN] + (1 - open) * side[CLOUD];
  const toCloud = mixed(up) * cloud + byAir, toGround = mixed(down) * cloud + byAir + direct;
  const a = 1 - up[EVEN] * back, b = down[EVEN] * back, c = down[EVEN] * albedo, d = 1 - up[EVEN] * albedo, whole = a * d - b * c;
  const below = (d * toCloud + c * toGround) / whole, ground = (b * toCloud + a * toGround) / whole;
  return { cloud, back: back * below, below, up: albedo * ground };
}

/** What the lower air sends of it where of the three lights it sends `views`. */
export const seenOf = ({ cloud, back, up }: Exchange, open: number, views: number[]): number =>
  views[CLOUD] * (1 - open) * cloud + views[EVEN] * (back + open * cloud) + views[GROUND] * up;
