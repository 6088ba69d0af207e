/** Numbers as float16 in base64. */

export interface Half {
  shape: number[];
  f2: string;
}

const held = new WeakMap<Half, Float32Array>();

function single(bits: number): number {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const sign = bits & 0x8000 ? -1 : 1;
  return exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

/** The numbers; decoded once. */
export function halves(row: Half): Float32Array {
  const found = held.get(row);
  if (found) return found;
  const bytes = Uint8Array.from(atob(row.f2), (letter) => letter.charCodeAt(0));
  const numbers = Float32Array.from(new Uint16Array(bytes.buffer), single);
  held.set(row, numbers);
  return numbers;
}
