/** Numbers as `scripts/explorer_digits.py` writes them: differences along an axis as digits, a letter each, times steps. */

export interface Digits {
  shape: number[];
  along: number;
  /** One, or one for each of the first axis. */
  steps: number[];
  planes: string[];
}

const PLACES = new Map(
  Array.from({ length: 92 }, (_, k) => String.fromCharCode(35 + k)).filter((letter) => !"$'<\\`".includes(letter)).map((letter, k) => [letter, k]),
);
const HALF = (PLACES.size - 1) / 2;

const held = new WeakMap<Digits, Float32Array>();

/** The numbers; decoded once. */
export function numbersOf(packed: Digits): Float32Array {
  const found = held.get(packed);
  if (found) return found;
  const { shape, along, steps, planes } = packed;
  const codes = new Int16Array(128);
  for (const [letter, k] of PLACES) codes[letter.charCodeAt(0)] = k - HALF;
  const whole = new Float64Array(shape.reduce((a, b) => a * b));
  planes.forEach((text, n) => {
    const worth = PLACES.size ** n;
    for (let k = 0; k < text.length; k++) whole[k] += worth * codes[text.charCodeAt(k)];
  });
  const stride = shape.slice(along + 1).reduce((a, b) => a * b, 1);
  const [run, own] = [stride * shape[along], whole.length / steps.length];
  for (let k = stride; k < whole.length; k++) if (k % run >= stride) whole[k] += whole[k - stride];
  const numbers = Float32Array.from(whole, (value, k) => value * steps[Math.floor(k / own)]);
  held.set(packed, numbers);
  return numbers;
}
