/** OpenEXR files: three float channels in scan lines, packed by ZIP, with the header that the package writes. */

/** A header's values: text, a float, or floats of a named type. */
export type Attribute = { type: string; bytes: Uint8Array };

const encoder = new TextEncoder();
const LINES = 16;

function joined(parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((total, part) => total + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function ints(...values: number[]): Uint8Array {
  return new Uint8Array(new Int32Array(values).buffer);
}

function floats(...values: number[]): Uint8Array {
  return new Uint8Array(new Float32Array(values).buffer);
}

const named = (text: string): Uint8Array => joined([encoder.encode(text), new Uint8Array(1)]);

export const textAttribute = (text: string): Attribute => ({ type: "string", bytes: encoder.encode(text) });
export const floatAttribute = (value: number): Attribute => ({ type: "float", bytes: floats(value) });
export const chromaticities = (values: number[]): Attribute => ({ type: "chromaticities", bytes: floats(...values) });
export const latlong: Attribute = { type: "envmap", bytes: new Uint8Array([0]) };

function header(width: number, height: number, more: Record<string, Attribute>): Uint8Array {
  const channel = (name: string): Uint8Array => joined([named(name), ints(2, 0, 1, 1)]);
  const box: Attribute = { type: "box2i", bytes: ints(0, 0, width - 1, height - 1) };
  const all: Record<string, Attribute> = {
    channels: { type: "chlist", bytes: joined([channel("B"), channel("G"), channel("R"), new Uint8Array(1)]) },
    compression: { type: "compression", bytes: new Uint8Array([3]) },
    dataWindow: box, displayWindow: box,
    lineOrder: { type: "lineOrder", bytes: new Uint8Array([0]) },
    pixelAspectRatio: floatAttribute(1), screenWindowCenter: { type: "v2f", bytes: floats(0, 0) },
    screenWindowWidth: floatAttribute(1), ...more,
  };
  const parts = Object.entries(all).map(([name, { type, bytes }]) => joined([named(name), named(type), ints(bytes.length), bytes]));
  return joined([new Uint8Array([0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0]), ...parts, new Uint8Array(1)]);
}

/** Rows of a block, channel after channel: B, G, R. */
function block(pixels: Float32Array, width: number, first: number, rows: number): Uint8Array {
  const values = new Float32Array(3 * width * rows);
  for (let y = 0; y < rows; y++) {
    for (let c = 0; c < 3; c++) {
      const to = (3 * y + c) * width;
      const from = (first + y) * width * 3 + (2 - c);
      for (let x = 0; x < width; x++) values[to + x] = pixels[from + 3 * x];
    }
  }
  return new Uint8Array(values.buffer);
}

/** OpenEXR's ZIP: bytes at even places first, then differences, then zlib. */
async function packed(raw: Uint8Array): Promise<Uint8Array> {
  const half = Math.ceil(raw.length / 2);
  const sorted = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; k++) sorted[(k & 1 ? half : 0) + (k >> 1)] = raw[k];
  for (let k = raw.length - 1; k > 0; k--) sorted[k] = sorted[k] - sorted[k - 1] + 128;
  const stream = new Blob([sorted]).stream().pipeThrough(new CompressionStream("deflate"));
  const result = new Uint8Array(await new Response(stream).arrayBuffer());
  return result.length < raw.length ? result : raw;
}

/** The file of linear RGB pixels, three numbers each, row by row from the top. */
export async function exrFile(
  pixels: Float32Array, width: number, height: number, more: Record<string, Attribute>,
): Promise<Uint8Array<ArrayBuffer>> {
  const head = header(width, height, more);
  const blocks: Uint8Array[] = [];
  for (let first = 0; first < height; first += LINES) {
    const data = await packed(block(pixels, width, first, Math.min(LINES, height - first)));
    blocks.push(joined([ints(first, data.length), data]));
  }
  const table = new BigUint64Array(blocks.length);
  let at = head.length + table.byteLength;
  blocks.forEach((part, k) => {
    table[k] = BigInt(at);
    at += part.length;
  });
  return joined([head, new Uint8Array(table.buffer), ...blocks]);
}
