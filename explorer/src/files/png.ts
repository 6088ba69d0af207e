/** PNG files: text put into the header of one that the browser wrote. */

function crc(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let k = 0; k < 8; k++) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  }
  return (value ^ 0xffffffff) >>> 0;
}

/** The same file with a text (iTXt) by that keyword behind its head. */
export async function withText(file: Blob, keyword: string, text: string): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const body = new TextEncoder().encode(`iTXt${keyword}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(body.length + 8);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, body.length - 4);
  chunk.set(body, 4);
  view.setUint32(body.length + 4, crc(body));
  const head = 33;
  const whole = new Uint8Array(bytes.length + chunk.length);
  whole.set(bytes.subarray(0, head));
  whole.set(chunk, head);
  whole.set(bytes.subarray(head), head + chunk.length);
  return whole;
}
