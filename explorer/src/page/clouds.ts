/** The clouds of the page: asks a worker for their map, and puts the newest one into the sky. */

import { KINDS } from "../skies/clouds/optics";
import { clearColours, isOpen, LOWEST_SUN, withClouds } from "../skies/fields/clear";
import type { FieldKind } from "../skies/fields/kinds";
import type { CloudMap } from "../skies/fields/map";
import type { Answer, Asked } from "../skies/fields/worker";
import CloudWorker from "../skies/fields/worker?worker&inline";
import type { Sky } from "../skies/sky";
import { conditionsOf, type Scene } from "./scene";

/** Phase functions of what clouds are made of. */
const PHASES = Object.fromEntries(Object.entries(KINDS).map(([name, { shapes, mixture }]) => [name, { shapes, mixture }]));
const COMING = "clouds: finer ones are being made";
const FAR = `clouds: drawn while the sun is above ${LOWEST_SUN} degrees; the command has them at every hour`;

export class Clouds {
  private worker: Worker | null = null;
  private map: CloudMap | null = null;
  private id = 0;
  private told = "";
  private asked: Asked | null = null;
  /** Whether the finest map is there of all that was asked. */
  settled = true;
  /** Milliseconds from asking to each map, lately. */
  readonly took: number[] = [];
  private begun = 0;

  /** `ready`: a map has come; `failed`: none can. */
  constructor(private ready: () => void, private failed: (text: string) => void) {}

  /** The scene with its clouds, as far as they are known; asks for others where they must change. */
  over(scene: Scene, moving: boolean): Scene {
    const { clouds } = scene.state;
    if (!clouds) this.map = null;
    const open = clouds ? scene.skies.find(isOpen) : undefined;
    if (!open) return clouds && scene.model.name === "physical" ? { ...scene, wanting: [FAR] } : scene;
    this.ask(scene, open, clouds as FieldKind, moving);
    const { map } = this;
    const skies = map ? scene.skies.map((sky) => (isOpen(sky) ? withClouds(sky, map) : sky)) : scene.skies;
    return { ...scene, skies, wanting: this.settled ? [] : [COMING] };
  }

  private ask({ state, sun, distance }: Scene, sky: Sky, kind: FieldKind, moving: boolean): void {
    const { clouded, seed, turbidity, albedo, aerosol, ozone, cover } = state;
    const key = [kind, clouded, seed, sun, distance, turbidity, albedo, aerosol, ozone, cover].join();
    const busy = moving && this.asked?.moving;
    if (busy || (key === this.told && (moving || !this.last.moving))) return;
    this.told = key;
    this.begun = performance.now();
    const clear = clearColours(sky, conditionsOf(state, sun, distance));
    this.last = { moving };
    this.asked = { id: ++this.id, kind, cover: clouded, seed, clear, phases: PHASES, moving };
    this.settled = false;
    this.started().postMessage(this.asked);
  }

  private last: Pick<Asked, "moving"> = { moving: false };

  private started(): Worker {
    if (this.worker) return this.worker;
    this.worker = new CloudWorker();
    this.worker.onerror = () => this.failed("This browser lets the page start no worker, which makes the clouds");
    this.worker.onmessage = ({ data }: MessageEvent<Answer>) => this.take(data);
    return this.worker;
  }

  private take({ id, map, last }: Answer): void {
    if (id !== this.id) return;
    this.map = map;
    this.took.push(performance.now() - this.begun);
    if (this.took.length > 100) this.took.shift();
    if (last) {
      this.asked = null;
      this.settled = true;
    }
    this.ready();
  }
}
