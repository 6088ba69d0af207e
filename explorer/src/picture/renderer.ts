/** Draws skies with WebGL 2: light in float textures first, then the picture; reads light back for files and tests. */

import { TABLES } from "../core/tables";
import type { Vec3 } from "../core/vector";
import { COLUMNS, RINGS } from "../skies/night/glow";
import { ROWS, TURNS } from "../skies/physical/grid";
import type { Fields, Sky } from "../skies/sky";
import { display } from "./display";
import { PointDrawer, POINTS_NAMES, POINTS_SHADERS } from "./points";
import { FieldTextures, FIRST_UNIT } from "./textures";
import { networkBlock, programKey, skyShader, VERTEX } from "./shaders";
import type { View } from "./view";
import { pixelSize } from "./view";

export interface Shown {
  /** 0 photograph, 1 false colour, 2 difference. */
  mode: number;
  exposure: number;
  /** log10 of cd m-2 at the ends of the bar. */
  bar: [number, number];
  stops: number;
  wipe: number;
  paper: Vec3;
  grounds: Vec3[];
}

interface Target {
  texture: WebGLTexture;
  framebuffer: WebGLFramebuffer;
  width: number;
  height: number;
}

export class Renderer {
  readonly gl: WebGL2RenderingContext;
  private programs = new Map<string, WebGLProgram>();
  private uniforms = new Map<WebGLProgram, Map<string, WebGLUniformLocation | null>>();
  private targets: (Target | null)[] = [null, null, null];
  private block: WebGLBuffer | null = null;
  private textures!: FieldTextures;
  private linear = false;
  private pointed: PointDrawer | null = null;

  constructor(readonly canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, depth: false, powerPreference: "low-power" });
    if (!gl) throw new Error("this browser has no WebGL 2, which the explorer needs");
    this.gl = gl;
    this.restart();
  }

  /** Make everything anew, at first and after the context was lost. */
  restart(): void {
    const { gl } = this;
    this.programs.clear();
    this.uniforms.clear();
    this.targets = [null, null, null];
    this.textures = new FieldTextures(gl);
    if (!gl.getExtension("EXT_color_buffer_float") && !gl.isContextLost()) {
      throw new Error("this browser cannot draw into float textures, which the explorer needs");
    }
    this.pointed = gl.getExtension("EXT_float_blend") ? new PointDrawer(gl) : null;
    this.linear = gl.getExtension("OES_texture_float_linear") !== null;
    const corners = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, corners);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    this.block = gl.createBuffer();
  }

  private program(key: string, fragment: () => string, vertex = VERTEX): WebGLProgram {
    const found = this.programs.get(key);
    if (found) return found;
    const { gl } = this;
    const program = gl.createProgram()!;
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment()]] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    for (const [name, place] of Object.entries({ corner: 0, ...POINTS_NAMES })) gl.bindAttribLocation(program, place, name);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      const logs = (gl.getAttachedShaders(program) ?? []).map((shader) => gl.getShaderInfoLog(shader));
      throw new Error(`the shader ${key} does not compile: ${logs.join(" ")}`);
    }
    this.programs.set(key, program);
    return program;
  }

  private at(program: WebGLProgram, name: string): WebGLUniformLocation | null {
    let held = this.uniforms.get(program);
    if (!held) this.uniforms.set(program, (held = new Map()));
    if (!held.has(name)) held.set(name, this.gl.getUniformLocation(program, name));
    return held.get(name)!;
  }

  private target(slot: number, width: number, height: number): Target {
    const { gl } = this;
    const held = this.targets[slot];
    if (held && held.width === width && held.height === height) return held;
    if (held) {
      gl.deleteTexture(held.texture);
      gl.deleteFramebuffer(held.framebuffer);
    }
    const texture = gl.createTexture()!;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
    const smooth = this.linear ? gl.LINEAR : gl.NEAREST;
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, smooth);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    const framebuffer = gl.createFramebuffer()!;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const made = { texture, framebuffer, width, height };
    this.targets[slot] = made;
    return made;
  }

  private useView(program: WebGLProgram, view: View, sun: Vec3): void {
    const { gl } = this;
    gl.useProgram(program);
    gl.uniform1i(this.at(program, "dome"), Number(view.dome));
    gl.uniform4f(this.at(program, "span"), view.left, view.across, view.top, view.down);
    gl.uniform1f(this.at(program, "aspect"), view.aspect);
    gl.uniform3f(this.at(program, "sun"), ...sun);
  }

  /** The sky's XYZ toward every pixel into a float texture; below the horizon 0 where `masked`, else as at it. */
  private light(slot: number, sky: Sky, view: View, width: number, height: number, masked: boolean): Target {
    const { gl } = this;
    const target = this.target(slot, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    gl.viewport(0, 0, width, height);
    const program = this.program(programKey(sky.recipe), () => skyShader(sky.recipe));
    this.useView(program, view, sky.sun);
    gl.uniform1i(this.at(program, "masked"), Number(masked));
    this.tell(program, sky);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    if (sky.points && !masked) this.pointed?.draw(this.program("points", () => POINTS_SHADERS[1], POINTS_SHADERS[0]), sky.points, view, width, height);
    return target;
  }

  private tell(program: WebGLProgram, sky: Sky): void {
    const { gl } = this;
    const { recipe } = sky;
    const dark = sky.day ? 1 : 0;
    if (recipe.kind === "formula") {
      const letters = new Float32Array(30);
      recipe.channels.forEach((row, k) => letters.set(row, 10 * k));
      gl.uniform1fv(this.at(program, "letters"), letters);
      gl.uniform1i(this.at(program, "channels"), recipe.channels.length);
      gl.uniform1i(this.at(program, "chromatic"), Number(recipe.chromatic));
      const matrix = [0, 1, 2].flatMap((c) => recipe.toXYZ.map((row) => dark * (row[c] ?? 0)));
      gl.uniformMatrix3fv(this.at(program, "to_xyz"), false, matrix);
    } else if (recipe.kind === "network") {
      const lit = recipe.toXYZ.map((row) => row.map((value) => dark * value));
      gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.block);
      gl.bufferData(gl.UNIFORM_BUFFER, networkBlock({ ...recipe, toXYZ: lit }), gl.DYNAMIC_DRAW);
      gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, "Weights"), 0);
    } else if (recipe.kind === "shaped") {
      gl.uniform1fv(this.at(program, "n"), recipe.numbers);
      gl.uniform3fv(this.at(program, "white"), recipe.white.map((value) => dark * recipe.level * value));
    } else this.tellFields(program, recipe, dark);
  }

  private tellFields(program: WebGLProgram, fields: Fields, lit: number): void {
    const { gl } = this;
    const { moonlit, layer, clouds } = fields;
    this.textures.bind(0, fields.grid, 4 * TURNS, ROWS);
    this.textures.bind(1, moonlit?.grid ?? null, 4 * TURNS, ROWS);
    this.textures.bind(2, layer?.grid ?? null, 4 * TURNS, ROWS);
    this.textures.bind(3, layer?.phases ?? null, (layer?.phases.length ?? 3) / 3, 1);
    this.textures.bind(4, fields.glow, COLUMNS, RINGS);
    this.textures.bind(5, clouds?.left ?? null, clouds?.width ?? 1, clouds?.height ?? 1, this.linear);
    this.textures.bind(6, clouds?.added ?? null, clouds?.width ?? 1, clouds?.height ?? 1, this.linear);
    ["grid", "moon_grid", "layer_grid", "layer_phases", "glow_grid", "clouds_left", "clouds_added"].forEach((name, k) => gl.uniform1i(this.at(program, name), FIRST_UNIT + k));
    gl.uniform1f(this.at(program, "lit"), lit);
    gl.uniform1i(this.at(program, "clear"), Number(fields.clear));
    gl.uniform1i(this.at(program, "moonlit"), Number(moonlit !== null));
    gl.uniform1i(this.at(program, "layered"), Number(layer !== null));
    gl.uniform1i(this.at(program, "glowing"), Number(fields.glow !== null));
    gl.uniform1i(this.at(program, "clouded"), Number(clouds !== null));
    const [lobe] = (moonlit ?? fields).laws[1].lobes;
    gl.uniform3f(this.at(program, "haze"), lobe[0], lobe[1], lobe[2]);
    gl.uniform3f(this.at(program, "seen"), ...fields.seen);
    gl.uniform3f(this.at(program, "moon_seen"), ...(moonlit ?? fields).seen);
    gl.activeTexture(gl.TEXTURE0);
  }

  /** Draw one sky, or two side by side, on the canvas; their light so many times coarser each way. */
  draw(skies: Sky[], view: View, shown: Shown, coarser = 1): void {
    const { gl } = this;
    const { width, height } = this.canvas;
    const [w, t] = [Math.ceil(width / coarser), Math.ceil(height / coarser)];
    const lit = skies.map((sky, slot) => this.light(slot, sky, view, w, t, false));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    const program = this.program(`display ${shown.mode}`, () => display(shown.mode));
    this.useView(program, view, skies[0].disc?.toward ?? skies[0].sun);
    lit.forEach((target, k) => {
      gl.activeTexture(gl.TEXTURE0 + k);
      gl.bindTexture(gl.TEXTURE_2D, target.texture);
    });
    const normals = skies.map((sky) => sky.disc?.normal ?? ([0, 0, 0] as Vec3));
    gl.uniform1i(this.at(program, "first"), 0);
    gl.uniform1i(this.at(program, "second"), lit.length - 1);
    gl.uniform1i(this.at(program, "two"), Number(lit.length > 1));
    gl.uniform1f(this.at(program, "wipe"), shown.wipe);
    gl.uniform1f(this.at(program, "exposure"), shown.exposure);
    gl.uniform2f(this.at(program, "bar"), ...shown.bar);
    gl.uniform1f(this.at(program, "stops"), shown.stops);
    gl.uniformMatrix3fv(this.at(program, "from_xyz"), true, TABLES.colour.srgbFromXYZ.flat());
    gl.uniform3fv(this.at(program, "grounds"), both(shown.grounds));
    gl.uniform3fv(this.at(program, "suns"), both(normals));
    gl.uniform1f(this.at(program, "radius"), skies[0].disc?.radius ?? 0.00465);
    gl.uniform1f(this.at(program, "pixel"), pixelSize(view, height));
    gl.uniform3f(this.at(program, "paper"), ...shown.paper);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.activeTexture(gl.TEXTURE0);
  }

  /** XYZ and mask (1 sky, 0 below the horizon, -1 outside), four numbers a pixel, row by row from the top. */
  read(sky: Sky, view: View, width: number, height: number): Float32Array {
    const { gl } = this;
    this.light(2, sky, view, width, height, true);
    const flipped = new Float32Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, flipped);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const rows = new Float32Array(flipped.length);
    for (let y = 0; y < height; y++) {
      rows.set(flipped.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
    }
    return rows;
  }
}

function both(values: Vec3[]): number[] {
  return [...values[0], ...(values[1] ?? values[0])];
}
