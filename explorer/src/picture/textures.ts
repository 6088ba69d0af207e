/** Tables of three floats a texel on texture units of their own; sent again where their numbers are others. */

/** The first unit: those below hold the light of skies. */
export const FIRST_UNIT = 2;

interface Held {
  texture: WebGLTexture;
  width: number;
  height: number;
  numbers: Float32Array | null;
}

export class FieldTextures {
  private held: Held[] = [];

  constructor(private gl: WebGL2RenderingContext) {}

  /** Put numbers on a unit, counted from `FIRST_UNIT`; null leaves what is there, as every unit must hold something. */
  bind(unit: number, numbers: Float32Array | null, width: number, height: number, smooth = false): void {
    const { gl } = this;
    const known = this.held[unit];
    if (known && (numbers === null || known.numbers === numbers)) return;
    gl.activeTexture(gl.TEXTURE0 + FIRST_UNIT + unit);
    const same = known && known.width === width && known.height === height;
    const held = same ? known : this.made(unit, width, height, smooth);
    held.numbers = numbers;
    if (numbers) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGB, gl.FLOAT, numbers);
  }

  /** `smooth`: linear between texels, around from left to right. */
  private made(unit: number, width: number, height: number, smooth: boolean): Held {
    const { gl } = this;
    if (this.held[unit]) gl.deleteTexture(this.held[unit].texture);
    const texture = gl.createTexture()!;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGB32F, width, height);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, smooth ? gl.LINEAR : gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    return (this.held[unit] = { texture, width, height, numbers: null });
  }
}
