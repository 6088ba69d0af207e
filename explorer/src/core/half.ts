/** Numbers as float16 in base64. */

export interface Half {
  shape: number[];
  f2: string;
}

const held = new Map<string, Float32Array>();

function single(bits: number): number {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const sign = bits & 0x8000 ? -1 : 1;
  return exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

/** The numbers; decoded once. */
export function halves(row: Half): Float32Array {
  const found = held.get(row.f2);
  if (found) return found;
  const bytes = Uint8Array.from(atob(row.f2), (letter) => letter.charCodeAt(0));
  const numbers = Float32Array.from(new Uint16Array(bytes.buffer), single);
  held.set(row.f2, numbers);
  return numbers;
}

/** The first of four neighbours of x among rising nodes, and their weights by Lagrange's cubic; fewer where there are fewer. */
export function cubicAt(nodes: number[], x: number): [number, number[]] {
  const count = Math.min(4, nodes.length);
  const above = nodes.findIndex((node) => node > x);
  const first = Math.min(Math.max((above < 0 ? nodes.length : above) - count / 2, 0), nodes.length - count) | 0;
  const near = nodes.slice(first, first + count);
  const weights = near.map((node, k) => near.reduce((total, other, n) => (n === k ? total : (total * (x - other)) / (node - other)), 1));
  return [first, weights];
}
