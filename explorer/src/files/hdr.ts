/** Radiance pictures: RGBE, flat, W m-2 sr-1 by 179 lm W-1. */

export const EFFICACY = 179;

/** The file of RGB in cd m-2, three numbers a pixel, with lines for its header. */
export function hdrFile(pixels: Float32Array, width: number, height: number, lines: string[]): Uint8Array<ArrayBuffer> {
  const head = ["#?RADIANCE", ...lines.map((line) => line.replace(/[\r\n]+/g, " ")), "FORMAT=32-bit_rle_rgbe", "", `-Y ${height} +X ${width}`, ""];
  const text = new TextEncoder().encode(head.join("\n"));
  const whole = new Uint8Array(text.length + 4 * width * height);
  whole.set(text);
  for (let k = 0, at = text.length; k < width * height; k++, at += 4) {
    const rgb = [0, 1, 2].map((c) => Math.max(0, pixels[3 * k + c] / EFFICACY));
    const most = Math.max(...rgb);
    if (most < 1e-32) continue;
    const exponent = Math.floor(Math.log2(most)) + 1;
    const scale = 256 / 2 ** exponent;
    rgb.forEach((value, c) => (whole[at + c] = Math.min(255, Math.floor(value * scale))));
    whole[at + 3] = exponent + 128;
  }
  return whole;
}
