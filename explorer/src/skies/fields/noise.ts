/** Noise of space, periodic, from a hash of the lattice: the package's own numbers, so that a seed means the same clouds. */

const GOLDEN = 0x9e3779b97f4a7c15n;
const FULL = 64;
const LOW_21 = (1n << 21n) - 1n;
/** A period upward that no cloud reaches. */
const ENDLESS = 1 << 20;
/** Brings slopes of components in (-1, 1) to noise of about -1 to 1. */
const GRADIENT_SCALE = 1.2;

/** 64 bits, stirred (Steele et al. 2014, splitmix64). */
function stirred(x: bigint): bigint {
  x = BigInt.asUintN(FULL, (x ^ (x >> 30n)) * 0xbf58476d1ce4e5b9n);
  x = BigInt.asUintN(FULL, (x ^ (x >> 27n)) * 0x94d049bb133111ebn);
  return x ^ (x >> 31n);
}

const wrap = (n: number, period: number): number => ((n % period) + period) % period;

/** Three numbers in [0, 1) of each place of a lattice that repeats after `east` and `north` places. */
export class Lattice {
  readonly numbers: Float64Array;

  /** `levels` of it from `low` upward, which repeat after `up` places. */
  constructor(readonly east: number, readonly north: number, readonly low: number, readonly levels: number, seed: number, up = ENDLESS) {
    this.numbers = new Float64Array(3 * east * north * levels);
    const seeded = BigInt.asUintN(FULL, BigInt(seed) * GOLDEN);
    let at = 0;
    for (let k = 0; k < levels; k++) {
      const high = BigInt(wrap(low + k, up)) << 40n;
      for (let j = 0; j < north; j++) {
        for (let i = 0; i < east; i++) {
          const place = BigInt(i) + (BigInt(j) << 20n) + high;
          const key = stirred(BigInt.asUintN(FULL, stirred(place + 1n) + seeded));
          for (let n = 0n; n < 3n; n++) this.numbers[at++] = Number((key >> (21n * n)) & LOW_21) / 2 ** 21;
        }
      }
    }
  }
}

const faded = (x: number): number => x * x * x * (x * (x * 6 - 15) + 10);

/** Gradient noise (Perlin 1985, 2002) at a place in cells, about -1 to 1. */
export function gradient(lattice: Lattice, px: number, py: number, pz: number): number {
  const { numbers, east, north } = lattice;
  const i = Math.floor(px), j = Math.floor(py), k = Math.floor(pz), x = px - i, y = py - j, z = pz - k;
  const u = faded(x), v = faded(y), w = faded(z);
  const i0 = wrap(i, east), i1 = i0 + 1 === east ? 0 : i0 + 1;
  const j0 = wrap(j, north), j1 = j0 + 1 === north ? 0 : j0 + 1;
  const low = (k - lattice.low) * north;
  const slope = (row: number, column: number, dx: number, dy: number, dz: number): number => {
    const n = 3 * (row * east + column);
    return (2 * numbers[n] - 1) * dx + (2 * numbers[n + 1] - 1) * dy + (2 * numbers[n + 2] - 1) * dz;
  };
  const level = (row0: number, row1: number, dz: number): number =>
    (slope(row0, i0, x, y, dz) * (1 - u) + slope(row0, i1, x - 1, y, dz) * u) * (1 - v) +
    (slope(row1, i0, x, y - 1, dz) * (1 - u) + slope(row1, i1, x - 1, y - 1, dz) * u) * v;
  const below = level(low + j0, low + j1, z);
  return GRADIENT_SCALE * (w > 0 ? below * (1 - w) + level(low + north + j0, low + north + j1, z - 1) * w : below);
}

/** Cells beside, the nearest first. */
const BESIDE = [0, -1, 1];

/** Distance to the nearest of points strewn one in each cell of the lattice (Worley 1996), in cells. */
export function cells(lattice: Lattice, px: number, py: number, pz: number): number {
  const { numbers, east, north, low, levels } = lattice;
  const i = Math.floor(px), j = Math.floor(py), k = Math.floor(pz), x = px - i, y = py - j, z = pz - k;
  /** Square of the way to a cell beside. */
  const away = (step: number, place: number): number => (step === 0 ? 0 : step < 0 ? place * place : (1 - place) * (1 - place));
  let least = 9;
  for (const c of BESIDE) {
    if (away(c, z) > least) continue;
    const level = wrap(k + c - low, levels) * north;
    for (const b of BESIDE) {
      if (away(c, z) + away(b, y) > least) continue;
      const row = (level + wrap(j + b, north)) * east;
      for (const a of BESIDE) {
        if (away(c, z) + away(b, y) + away(a, x) > least) continue;
        const n = 3 * (row + wrap(i + a, east));
        const dx = numbers[n] + a - x, dy = numbers[n + 1] + b - y, dz = numbers[n + 2] + c - z;
        least = Math.min(least, dx * dx + dy * dy + dz * dz);
      }
    }
  }
  return Math.sqrt(least);
}

export type Noise = (lattice: Lattice, x: number, y: number, z: number) => number;

/** As it is. */
export const plain = (noise: number): number => noise;
/** Round bumps with sharp valleys between, of gradient noise. */
export const billows = (noise: number): number => Math.abs(noise) * 2;

/** Octaves of a noise, each half as strong, their weights 1 in all, in a field that repeats after a `period`, m. */
export class Octaves {
  private readonly lattices: Lattice[] = [];
  private readonly scales: [number, number, number][] = [];

  /** `count` octaves from a wavelength, m, downward, for heights up to `highest`, m. */
  constructor(
    private readonly noise: Noise, period: number, wavelength: number, count: number, seed: number, highest = 0,
    stretch: [number, number, number] = [1, 1, 1], private readonly form = plain,
  ) {
    for (let octave = 0; octave < count; octave++) {
      const along = (n: number): number => Math.max(1, Math.round((period / (wavelength * stretch[n])) * 2 ** octave));
      const scale = 2 ** octave / (wavelength * stretch[2]);
      const levels = Math.floor(highest * scale) + 3;
      this.lattices.push(new Lattice(along(0), along(1), -1, levels, seed * 16 + octave));
      this.scales.push([along(0) / period, along(1) / period, scale]);
    }
  }

  at(x: number, y: number, z: number): number {
    let total = 0, weight = 1;
    for (let n = 0; n < this.lattices.length; n++) {
      const scale = this.scales[n];
      total += weight * this.form(this.noise(this.lattices[n], x * scale[0], y * scale[1], z * scale[2]));
      weight /= 2;
    }
    return total / (2 - 2 * weight);
  }
}
