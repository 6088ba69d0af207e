/** Makes maps of clouds beside the page: coarse at once, finer while nothing new is asked. */

import { direction } from "../../core/vector";
import { Field, Texture } from "./field";
import { Incident, seemingLaw } from "./incident";
import type { FieldKind } from "./kinds";
import { Cells, heldUp } from "./lit";
import { heightAt, type CloudMap } from "./map";
import { Rays, sunShare } from "./march";
import type { Phases } from "./scattering";
import { clearLight, type ClearColours } from "./spectra";

export interface Asked {
  id: number;
  kind: FieldKind;
  cover: number;
  seed: number;
  clear: ClearColours;
  /** By what clouds are made of. */
  phases: Record<string, Phases>;
  /** While the sun is dragged: coarse light and one coarse map alone. */
  moving: boolean;
}

export interface Answer {
  id: number;
  map: CloudMap;
  last: boolean;
}

/** Columns and rows of the maps, one after the other. */
const SIZES = [[128, 40], [256, 80], [512, 160], [1024, 320]];
/** Milliseconds after which the worker looks whether something new is asked. */
const LOOK = 30;

const port = self as unknown as { onmessage: ((event: MessageEvent<Asked>) => void) | null; postMessage(answer: Answer, held: Transferable[]): void };
let wanted: Asked | null = null;
let working = false;

/** What was made last, by what it was made from. */
class Last<T> {
  key = "";
  private value: T | null = null;

  of(key: string, make: () => T): T {
    if (key !== this.key || !this.value) [this.value, this.key] = [make(), key];
    return this.value;
  }
}

const textures = new Last<Texture>(), fields = new Last<Field>(), coarse = new Last<Cells>(), fine = new Last<Cells>(), laws = new Last<Float32Array>();

/** The end of a work with pauses; null where something else is asked meanwhile. */
async function done<T>(asked: Asked, work: Generator<void, T>): Promise<T | null> {
  for (;;) {
    const step = work.next();
    if (step.done) return step.value;
    if (await overtaken(asked)) return null;
  }
}

const pause = (): Promise<void> => new Promise((done) => setTimeout(done));

/** Whether something else is asked by now. */
async function overtaken(asked: Asked): Promise<boolean> {
  await pause();
  return wanted !== asked;
}

async function answer(asked: Asked): Promise<void> {
  const { kind, cover, seed } = asked;
  const texture = textures.of(`${kind} ${seed}`, () => new Texture(kind, seed));
  const key = `${kind} ${seed} ${cover}`;
  const field = fields.of(key, () => new Field(texture, cover));
  if (await overtaken(asked)) return;
  const half = texture.numbers.count / 2;
  if (await drawn(asked, coarse.of(key, () => new Cells(field, half / 2)), SIZES.slice(0, 1), asked.moving)) return;
  if (asked.moving) return;
  await drawn(asked, fine.of(key, () => new Cells(field, half)), SIZES.slice(1), true);
}

/** Send maps of these sizes; true where something else is asked meanwhile. */
async function drawn(asked: Asked, cells: Cells, sizes: number[][], last: boolean): Promise<boolean> {
  if (await overtaken(asked)) return true;
  const { kind, moving } = asked;
  const lit = await done(asked, cells.under(heldUp(asked.clear.sun)));
  if (!lit || (await overtaken(asked))) return true;
  const clear = clearLight(asked.clear, kind), phases = asked.phases[cells.field.numbers.particles];
  // its colours change little with the sun: while that moves, the law of before serves
  const law = laws.of(moving && laws.key.startsWith(kind) ? laws.key : kind + clear.sun.join(), () => seemingLaw(kind, clear, phases));
  const incident = new Incident(lit, kind, clear, law);
  const [rays, sun] = [new Rays(lit), sunShare(lit, asked.clear.sun)];
  for (const [n, [width, height]] of sizes.entries()) {
    const map = await mapOf(asked, incident, rays, sun, width, height);
    if (!map) return true;
    port.postMessage({ id: asked.id, map, last: last && n === sizes.length - 1 }, [map.left.buffer, map.added.buffer]);
  }
  return false;
}

async function mapOf(asked: Asked, incident: Incident, rays: Rays, sun: number, width: number, height: number): Promise<CloudMap | null> {
  const [left, added, six] = [new Float32Array(3 * width * height), new Float32Array(3 * width * height), new Float32Array(6)];
  const level: [number, number, number] = [0, 0, 0];
  let looked = performance.now();
  for (let row = 0, at = 0; row < height; row++) {
    const elevation = heightAt((row + 0.5) / height);
    const [low, high] = [Math.sin(heightAt(row / height)), Math.sin(heightAt((row + 1) / height))];
    const weight = (Math.PI / width) * (high * high - low * low);
    for (let column = 0; column < width; column++, at += 3) {
      const toward = direction((2 * Math.PI * (column + 0.5)) / width, elevation);
      incident.put(rays.march(...toward), ...toward, six, 0);
      for (let c = 0; c < 3; c++) {
        left[at + c] = six[c];
        added[at + c] = six[3 + c];
        level[c] += weight * six[3 + c];
      }
    }
    if (performance.now() - looked > LOOK) {
      if (await overtaken(asked)) return null;
      looked = performance.now();
    }
  }
  return { width, height, left, added, level, sun };
}

port.onmessage = async ({ data }) => {
  wanted = data;
  if (working) return;
  working = true;
  for (let asked: Asked | null = null; asked !== wanted; ) {
    asked = wanted;
    await answer(asked!);
  }
  working = false;
};
