/** Between nodes: Lagrange's cubics, straight lines, and weights of tables of more than one axis. */

import { limited } from "./vector";

/** The first of four neighbours of x among rising nodes, and their weights by Lagrange's cubic; fewer where there are fewer. */
export function cubicAt(nodes: number[], x: number): [number, number[]] {
  const count = Math.min(4, nodes.length);
  const above = nodes.findIndex((node) => node > x);
  const first = Math.min(Math.max((above < 0 ? nodes.length : above) - count / 2, 0), nodes.length - count) | 0;
  const near = nodes.slice(first, first + count);
  const weights = near.map((node, k) => near.reduce((total, other, n) => (n === k ? total : (total * (x - other)) / (node - other)), 1));
  return [first, weights];
}

/** A weight for each of some rows of a table. */
export type Mixed = [number, number][];

/** Rows by Lagrange's cubic about x, counted from `from`. */
export function cubicRows(nodes: number[], x: number, from = 0): Mixed {
  const [first, weights] = cubicAt(nodes, x);
  return weights.map((weight, k) => [from + first + k, weight]);
}

/** The first two rows by a straight line through their nodes, which may go beyond. */
export function straightRows([low, high]: number[], x: number): Mixed {
  const share = (x - low) / (high - low);
  return [[0, 1 - share], [1, share]];
}

/** Rows of a table of two axes, the second of `count`. */
export function crossed(first: Mixed, second: Mixed, count: number): Mixed {
  return first.flatMap(([a, v]) => second.map(([b, w]): [number, number] => [a * count + b, v * w]));
}

/** Rows about x, the ends held. */
export function heldRows(nodes: number[], x: number): Mixed {
  return cubicRows(nodes, limited(x, nodes[0], nodes[nodes.length - 1]));
}
