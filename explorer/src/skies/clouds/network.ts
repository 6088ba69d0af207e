/** Light under a layer of cloud that was scattered more than once: a network's sum of shapes of the dome, as the package has it. */

import table from "../../data/overcast.json";
import { halves } from "../../core/half";
import { DEG, limited } from "../../core/vector";
import { bend, mass, massOfOzone, scaled, WAVES, type Optics } from "./optics";
import { courseOf, type Course } from "./streams";

const [SHAPES, NODES, TERMS] = table.shapes.shape;
export { NODES };

/** A measure of the sun's elevation that is finest at -4 degrees. */
const placeOf = (degrees: number): number => Math.asinh((degrees + 4) / 8);

/** What the network reads at wavelength number w, the sun's elevation by its sine. */
function features(air: Optics, sine: number, w: number, two: Course): number[] {
  const { exp, log, sqrt } = Math;
  const above = (sine + sqrt(sine * sine + 0.01)) / 2;
  const path = 1 / (above + 0.05);
  const [m, n, o, tau] = [air.above[w], air.below[w], air.ozone[w], air.cloud[w]];
  const [a, g, f, { ground }] = [air.albedo[w], air.asymmetry[w], air.peak[w], air];
  const deep = tau * (1 - a * g);
  const fast = sqrt(Math.max(0, 3 * tau * (1 - a) * deep));
  const [depth, curve] = [scaled(air, w), bend(air, w)];
  const [low, steep, high] = [sine + curve, mass(sine), massOfOzone(sine, 0)];
  const { sun, beam, sky, again, typical } = two;
  const degrees = Math.asin(sine) / DEG;
  return [
    m, n, o, a, g, f, ground, table.height / 1e4, table.thickness / 2e3,
    log(tau), log(deep), log(1 + 0.75 * deep), log(m + 0.01), log(n + 0.01),
    fast, log(1 + fast), sqrt(((1 - a) * tau) / deep), sun.back, again, log(1.02 - again),
    ground * n, path * m, exp(-path * m), steep * m, high * o, exp(-steep * m), exp(-high * o),
    exp(-0.3 * depth), exp(-0.3 * path * depth), exp(-depth / low), log(1 + path * deep),
    sun.straight, sun.spread, log(sun.through + table.dark), sky / (beam + sky + table.dark),
    log(beam + sky + table.dark), log(typical), log(low), sqrt(curve / low),
    placeOf(degrees), sine, exp(-(((degrees + 2) / 5) ** 2)), exp(-(((degrees - 3) / 6) ** 2)), path,
  ];
}

/** How much of each shape: Chebyshev polynomials of the sun's place for the first, the network's for the others; the last of the glow. */
function coefficients(air: Optics, sine: number, w: number, two: Course): number[] {
  const [low, high] = table.places;
  const x = limited((2 * placeOf(Math.asin(sine) / DEG) - low - high) / (high - low), -1, 1);
  let found = features(air, sine, w, two);
  table.layers.forEach(({ weights, biases }, number) => {
    const [matrix, [inputs, outputs]] = [halves(weights), weights.shape];
    const next = Float64Array.from(halves(biases));
    for (let i = 0; i < inputs; i++) for (let k = 0; k < outputs; k++) next[k] += found[i] * matrix[i * outputs + k];
    found = Array.from(next, (z) => (number < table.layers.length - 1 ? z / (1 + Math.exp(limited(-z, -60, 60))) : z));
  });
  const [mean, count] = [[1, x], SHAPES + 1 - found.length];
  while (mean.length < count) mean.push(2 * x * mean[mean.length - 1] - mean[mean.length - 2]);
  return [...mean.slice(0, count), ...found];
}

/** Values of the shapes at the nodes and at even azimuths, (shapes, nodes x turns). */
function onTurns(turns: number): Float32Array {
  const shapes = halves(table.shapes);
  const values = new Float32Array(SHAPES * NODES * turns);
  for (let row = 0; row < SHAPES * NODES; row++) {
    for (let t = 0; t < turns; t++) {
      let total = 0;
      for (let m = 0; m < TERMS; m++) total += shapes[row * TERMS + m] * Math.cos((m * Math.PI * t) / (turns - 1));
      values[row * turns + t] = total;
    }
  }
  return values;
}

let shapesOnTurns: Float32Array | null = null;

/** The glow about the sun at the nodes and at even azimuths, (nodes x turns). */
function glowOn(turns: number, sine: number): Float32Array {
  const { width, strength } = table.glow;
  const level = Math.sqrt(Math.max(0, 1 - sine * sine));
  return Float32Array.from({ length: NODES * turns }, (_, n) => {
    const view = Math.cos(Math.acos(table.leastCosine) * (1 - (Math.floor(n / turns) / (NODES - 1)) ** 2));
    const turn = Math.cos((Math.PI * (n % turns)) / (turns - 1));
    return strength * Math.exp((view * sine + Math.sqrt(1 - view * view) * level * turn - 1) / width);
  });
}

/** X, Y and Z of the rest for a sun 1 AU away, each (nodes, turns), one after the other. */
export function restOf(air: Optics, sine: number, turns: number): Float32Array {
  const shapes = (shapesOnTurns ??= onTurns(turns));
  const count = NODES * turns;
  const glow = glowOn(turns, sine);
  const light = new Float32Array(3 * count);
  const log = new Float64Array(count);
  for (let w = 0; w < WAVES; w++) {
    log.fill(0);
    const two = courseOf(air, sine, w);
    coefficients(air, sine, w, two).forEach((amount, s) => {
      const [shape, first] = s < SHAPES ? [shapes, s * count] : [glow, 0];
      for (let n = 0; n < count; n++) log[n] += amount * shape[first + n];
    });
    const colour = table.colours[w];
    for (let n = 0; n < count; n++) {
      const radiance = Math.max(0, Math.exp(log[n]) * two.typical - table.dark);
      for (let c = 0; c < 3; c++) light[c * count + n] += radiance * colour[c];
    }
  }
  return light;
}
