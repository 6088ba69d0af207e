/** Light on the horizontal: nodes that crowd at the sun, over the half of the sky that the other mirrors. */

import { TABLES } from "../core/tables";
import { azimuth, direction, elevation, scaled, sum, type Vec3 } from "../core/vector";
import { channel } from "./light";
import { xyzToward } from "./light";
import type { Letters, Points, Sky } from "./sky";

const { near: NEAR, weight: WEIGHT } = TABLES.nodes;

type Visit = (zenith: number, difference: number, solidAngle: number) => void;

/** Call with each node's zenith angle, azimuth from the sun, and solid angle. */
function nodesAbout(sunZenith: number, visit: Visit): void {
  const sun = Math.min(Math.max(sunZenith, 0), Math.PI / 2);
  const parts: [(t: number) => number, number][] = [
    [(t) => sun * (1 - t), sun],
    [(t) => sun + (Math.PI / 2 - sun) * t, Math.PI / 2 - sun],
  ];
  for (const [place, length] of parts) {
    NEAR.forEach((t, i) => {
      const zenith = place(t);
      const ring = length * WEIGHT[i] * Math.sin(zenith) * 2 * Math.PI;
      NEAR.forEach((s, j) => visit(zenith, Math.PI * s, ring * WEIGHT[j]));
    });
  }
}

/** The same without symmetry about the lamp: both halves. */
function bothSides(sunZenith: number, visit: Visit): void {
  nodesAbout(sunZenith, (zenith, difference, solidAngle) => {
    for (const turn of [difference, -difference]) visit(zenith, turn, solidAngle / 2);
  });
}

/** Diffuse light on the horizontal, XYZ, Y in lx. */
export function diffuseXYZ(sky: Sky): Vec3 {
  let total: Vec3 = [0, 0, 0];
  if (!sky.day) return total;
  const lamp = sky.disc?.toward ?? sky.sun;
  const turn = azimuth(lamp);
  const { recipe, points } = sky;
  const around = recipe.kind === "fields" && (recipe.moonlit || recipe.glow || recipe.clouds) ? bothSides : nodesAbout;
  around(Math.PI / 2 - elevation(lamp), (zenith, difference, solidAngle) => {
    const toward = direction(turn + difference, Math.PI / 2 - zenith);
    total = sum(total, scaled(xyzToward(sky, toward), solidAngle * Math.cos(zenith)));
  });
  return points ? sum(total, onLevel(points)) : total;
}

/** Light of points on the horizontal, XYZ, Y in lx. */
function onLevel({ toward, light }: Points): Vec3 {
  let total: Vec3 = [0, 0, 0];
  for (let k = 0; k < light.length; k += 3) total = sum(total, scaled([light[k], light[k + 1], light[k + 2]], toward[k + 2]));
  return total;
}

/** Direct light on the horizontal, XYZ, Y in lx. */
export function directXYZ(sky: Sky): Vec3 {
  return sky.disc && sky.disc.toward[2] > 0 ? scaled(sky.disc.normal, sky.disc.toward[2]) : [0, 0, 0];
}

/** Integral of one channel of the formula times the cosine. */
export function channelIntegral(letters: Letters, sunZenith: number, hosek = false): number {
  return integralOf((up, half, angle) => channel(letters, hosek, up, half, angle), sunZenith);
}

/** Integral over the dome, times the cosine, of what depends on the view's height and its angle to the sun. */
export function integralOf(light: (up: number, half: number, angle: number) => number, sunZenith: number): number {
  let total = 0;
  const sun = Math.min(Math.max(sunZenith, 0), Math.PI / 2);
  nodesAbout(sun, (zenith, difference, solidAngle) => {
    const up = Math.cos(zenith);
    const across = Math.sin(zenith) * Math.sin(sun) * Math.sin(difference / 2) ** 2;
    const half = Math.min(Math.sin((zenith - sun) / 2) ** 2 + across, 1);
    total += solidAngle * up * light(up, half, 2 * Math.asin(Math.sqrt(half)));
  });
  return total;
}
