/** How cloud scatters once: its phase function, and the one that light seems to follow after many small turns, by depth.
 *
 * A second form of the package's `Scattering`: a forward peak g^2 is taken out of the optical depths, and what it turns
 * is put back by Legendre moments.
 */

import table from "../../data/clouds.json";

const { angles: ANGLES, smooth: SMOOTH, moments: MOMENTS, depths: DEPTHS, first: FIRST, step: STEP } = table;

/** Cosines of scattering angles at pi t^2 for even t, and what each counts over the sphere, sr. */
function gridOf(count: number): { cosine: Float64Array; solid: Float64Array } {
  const cosine = Float64Array.from({ length: count }, (_, n) => Math.cos(Math.PI * (n / (count - 1)) ** 2));
  const solid = new Float64Array(count);
  for (let n = 0; n < count - 1; n++) {
    const step = Math.PI * (cosine[n] - cosine[n + 1]);
    solid[n] += step;
    solid[n + 1] += step;
  }
  return { cosine, solid };
}

/** Legendre polynomials at cosines, (MOMENTS, count). */
function polynomials(cosine: Float64Array): Float64Array {
  const count = cosine.length;
  const found = new Float64Array(MOMENTS * count).fill(1, 0, count);
  found.set(cosine, count);
  for (let l = 2; l < MOMENTS; l++) {
    for (let n = 0; n < count; n++) {
      found[l * count + n] = ((2 * l - 1) * cosine[n] * found[(l - 1) * count + n] - (l - 1) * found[(l - 2) * count + n]) / l;
    }
  }
  return found;
}

interface Held {
  whole: ReturnType<typeof gridOf>;
  ofWhole: Float64Array;
  ofSmooth: Float64Array;
}

let held: Held | null = null;

function tables(): Held {
  if (held) return held;
  const whole = gridOf(ANGLES);
  return (held = { whole, ofWhole: polynomials(whole.cosine), ofSmooth: polynomials(gridOf(SMOOTH).cosine) });
}

/** Legendre moments of a table over the angles. */
function momentsOf(values: Float64Array): Float64Array {
  const { whole, ofWhole } = tables();
  const weighted = values.map((value, n) => value * whole.solid[n]);
  return Float64Array.from({ length: MOMENTS }, (_, l) => {
    let total = 0;
    for (let n = 0; n < ANGLES; n++) total += ofWhole[l * ANGLES + n] * weighted[n];
    return total;
  });
}

/** The part of a law that is its forward peak, of a given integral: the law times exp(-(1 - cos) / width). */
function peakOf(law: Float64Array, share: number): Float64Array {
  const { cosine, solid } = tables().whole;
  const within = (log: number): number => {
    const width = Math.exp(log);
    return law.reduce((total, value, n) => total + value * solid[n] * Math.exp((cosine[n] - 1) / width), 0);
  };
  let [low, high] = [Math.log(1e-6), Math.log(1e6)];
  for (let n = 0; n < 30; n++) {
    const middle = (low + high) / 2;
    if (within(middle) < share) low = middle;
    else high = middle;
  }
  return law.map((value, n) => value * Math.exp((cosine[n] - 1) / Math.exp(low)));
}

/** The law that light scattered once seems to follow over the scaled depth, of one channel, (DEPTHS, ANGLES). */
function seeming(law: Float64Array, peak: number): Float64Array {
  const { ofSmooth } = tables();
  const forward = peakOf(law, peak);
  const p = momentsOf(forward).map((value) => value / peak);
  const rest = momentsOf(law.map((value, n) => value - forward[n])).map((value) => value / (1 - peak));
  const found = new Float64Array(DEPTHS * ANGLES);
  for (let depth = 0; depth < DEPTHS; depth++) {
    const scaled = FIRST * Math.expm1(STEP * depth), turns = (peak / (1 - peak)) * scaled, straight = Math.exp(-turns);
    const smooth = new Float64Array(SMOOTH);
    for (let l = 0; l < MOMENTS; l++) {
      const blurred = Math.exp(-turns * (1 - p[l]));
      const more = rest[l] * (blurred - straight) + (blurred - straight - straight * turns * p[l]) / Math.max(scaled, 1e-9);
      const weight = ((2 * l + 1) / (4 * Math.PI)) * more;
      for (let n = 0; n < SMOOTH; n++) smooth[n] += weight * ofSmooth[l * SMOOTH + n];
    }
    for (let n = 0; n < ANGLES; n++) {
      const place = (n * (SMOOTH - 1)) / (ANGLES - 1), k = Math.min(Math.floor(place), SMOOTH - 2);
      const blurred = smooth[k] + (smooth[k + 1] - smooth[k]) * (place - k);
      found[depth * ANGLES + n] = Math.max((law[n] / (1 - peak)) * straight + blurred, 0);
    }
  }
  return found;
}

/** Phase functions as sums of shapes over angles that are even in the root of the angle. */
export interface Phases {
  shapes: number[][];
  /** (shapes, wavelengths) */
  mixture: number[][];
}

/** The same in X, Y and Z of light `weights` (wavelengths, 3), (DEPTHS, ANGLES, 3). */
export function seemingColours({ shapes, mixture }: Phases, weights: number[][], peak: number): Float32Array {
  const { solid } = tables().whole;
  const on = Float64Array.from({ length: ANGLES }, (_, n) => (n * (shapes.length - 1)) / (ANGLES - 1));
  const laws = weights.map((_, w) => {
    const value = on.map((place) => {
      const k = Math.min(Math.floor(place), shapes.length - 2);
      return mixture.reduce((total, row, s) => total + row[w] * (shapes[k][s] + (shapes[k + 1][s] - shapes[k][s]) * (place - k)), 0);
    });
    const whole = value.reduce((total, each, n) => total + each * solid[n], 0);
    return value.map((each) => each / whole);
  });
  const found = new Float32Array(DEPTHS * ANGLES * 3);
  for (let c = 0; c < 3; c++) {
    const total = weights.reduce((sum, row) => sum + row[c], 0);
    const law = new Float64Array(ANGLES);
    laws.forEach((each, w) => each.forEach((value, n) => (law[n] += total > 0 ? (value * weights[w][c]) / total : value / laws.length)));
    seeming(law, peak).forEach((value, n) => (found[3 * n + c] = value));
  }
  return found;
}
