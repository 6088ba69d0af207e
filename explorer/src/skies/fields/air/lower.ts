/** The air below a field of cloud at one wavelength: what it makes of light from above and below. A second form of `LowerAir`. */

import table from "../../../data/clouds.json";

const [SINES, WEIGHTS] = table.streams;
const COUNT = SINES.length, { grazing: GRAZING, molecular: MOLECULAR } = table;
/** Lights of the lower air: that of thick cloud, even light from above, even light of the ground. */
export const [CLOUD, EVEN, GROUND] = [0, 1, 2];
const LIGHTS = 3;

/** Light that thick cloud lets out toward a sine of elevation, over the mean. */
const escape = (sine: number): number => GRAZING + 1.5 * (1 - GRAZING) * sine;

/** Legendre polynomials of a cosine, `COUNT` of them. */
function polynomials(cosine: number): number[] {
  const found = [1, cosine];
  for (let n = 1; n < COUNT - 1; n++) found.push(((2 * n + 1) * cosine * found[n] - n * found[n - 1]) / (n + 1));
  return found;
}

const ALONG = SINES.map(polynomials);
/** Light that comes into the layer from `SINES`, times pi. */
const COMING = SINES.map((sine) => (sine > 0 ? [escape(sine), 1, 0] : [0, 0, 1]));

/** Solutions (n, LIGHTS) of a system of equations (n, n), both of which are used up. */
function solved(rows: number[][], right: number[][]): number[][] {
  for (let n = 0; n < rows.length; n++) {
    for (let m = 0; m < rows.length; m++) {
      if (m === n) continue;
      const share = rows[m][n] / rows[n][n]; // diagonals lead: light is lost at each turn
      for (let k = n; k < rows.length; k++) rows[m][k] -= share * rows[n][k];
      for (let k = 0; k < LIGHTS; k++) right[m][k] -= share * right[n][k];
    }
  }
  return right.map((row, n) => row.map((value) => value / rows[n][n]));
}

export class LowerAir {
  /** Of each of the three lights of irradiance 1, irradiance at the ground, and upward at the base. */
  readonly down = [0, 0, 0];
  readonly up = [0, 0, 0];
  private readonly strengths: number[];
  /** Light at the ground and in the mean from `SINES`, times pi. */
  private readonly here: number[][];
  private readonly mean: number[][];

  /** Vertical depths of molecules, haze and ozone, the share that the haze scatters, and its lobe's g. */
  constructor([molecules, haze, ozone]: number[], albedo: number, g: number) {
    const depth = Math.max(molecules + haze + ozone, 1e-12);
    this.strengths = SINES.map((_, l) => {
      const molecular = l === 0 ? 1 : l === 2 ? MOLECULAR : 0;
      return ((2 * l + 1) * (molecules * molecular + haze * albedo * g ** l)) / depth;
    });
    const slant = SINES.map((sine) => depth / Math.abs(sine)), kept = slant.map((each) => -Math.expm1(-each) / each);
    const turned = ALONG.map((along) => this.turned(along));
    const once = turned.map((row) => lightsOf((s) => row.reduce((total, each, n) => total + each * kept[n] * COMING[n][s], 0)));
    const source = solved(turned.map((row, m) => row.map((each, n) => Number(m === n) - each * (1 - kept[n]))), once);
    const leaving = source.map((each, n) => lightsOf((s) => COMING[n][s] + (1 - Math.exp(-slant[n])) * (each[s] - COMING[n][s])));
    this.mean = source.map((each, n) => lightsOf((s) => kept[n] * COMING[n][s] + (1 - kept[n]) * each[s]));
    this.here = SINES.map((sine, n) => (sine > 0 ? leaving[n] : COMING[n]));
    leaving.forEach((each, n) => {
      const side = SINES[n] > 0 ? this.down : this.up, level = 2 * WEIGHTS[n] * Math.abs(SINES[n]);
      each.forEach((value, s) => (side[s] += level * value));
    });
  }

  /** What light from `SINES` gives by an optical depth of 1 toward a direction of these polynomials. */
  private turned(toward: number[]): number[] {
    const strong = this.strengths.map((value, l) => value * toward[l]);
    return ALONG.map((along, n) => 0.5 * WEIGHTS[n] * strong.reduce((total, each, l) => total + each * along[l], 0));
  }

  /** What the air sends to the ground from a sine of elevation by the ground and in the mean, of each light, sr-1. */
  private ends(sine: number): [number[], number[]] {
    const turned = this.turned(polynomials(sine));
    const of = (light: number[][]): number[] => lightsOf((s) => turned.reduce((total, each, n) => total + (each * light[n][s]) / Math.PI, 0));
    return [of(this.here), of(this.mean)];
  }

  /** The same where it lets shares `through`, sr-1, (through, lights). */
  toward(sine: number, through: number[]): number[][] {
    const [ground, mean] = this.ends(sine);
    return through.map((left) => {
      const seen = 2 * middle(-Math.log(Math.max(left, 1e-300)));
      return ground.map((near, s) => (1 - left) * (near + seen * (mean[s] - near)));
    });
  }
}

const lightsOf = (value: (s: number) => number): number[] => [value(CLOUD), value(EVEN), value(GROUND)];

/** Where the light comes from that an even layer of a slant depth sends: 1/2 in thin, 0 in thick layers. */
const middle = (depth: number): number => (depth < 1e-3 ? 0.5 - depth / 12 : 1 / depth - Math.exp(-depth) / -Math.expm1(-depth));
