/** The package's tables as `scripts/export_explorer.py` wrote them: long rows are float32 in base64. */

import raw from "../data/tables.json";

export interface Packed {
  shape: number[];
  f4: string;
}

export const TABLES = raw;

const unpackedRows = new Map<string, Float32Array>();

/** The numbers of a packed row; decoded once. */
export function unpacked(row: Packed): Float32Array {
  const found = unpackedRows.get(row.f4);
  if (found) return found;
  const bytes = Uint8Array.from(atob(row.f4), (letter) => letter.charCodeAt(0));
  const numbers = new Float32Array(bytes.buffer);
  unpackedRows.set(row.f4, numbers);
  return numbers;
}
