/** Has a worker make maps of clouds, the newest that was asked for alone. */

import { KINDS } from "../clouds/optics";
import type { Conditions } from "../model";
import type { Sky } from "../sky";
import { clearColours } from "./clear";
import type { FieldKind } from "./kinds";
import type { CloudMap } from "./map";
import type { Answer, Asked } from "./worker";
import CloudWorker from "./worker?worker&inline";

/** Phase functions of what clouds are made of. */
const PHASES = Object.fromEntries(Object.entries(KINDS).map(([name, { shapes, mixture }]) => [name, { shapes, mixture }]));

/** A field of cloud as the page has it. */
export interface Wanted {
  kind: FieldKind;
  cover: number;
  seed: number;
}

export class CloudMaker {
  /** The newest map. */
  map: CloudMap | null = null;
  /** Whether it is the finest of what was asked. */
  settled = true;
  /** Milliseconds from asking to each map, lately. */
  readonly took: number[] = [];
  private worker: Worker | null = null;
  private id = 0;
  private told = "";
  private begun = 0;
  /** Whether what was asked last was asked while something moved, and whether that is not answered yet. */
  private moving = false;
  private busy = false;

  /** `ready`: a map has come; `failed`: none can. */
  constructor(private ready: () => void, private failed: (text: string) => void) {}

  /** Ask for the clouds of a clear sky and its conditions; a coarse map alone while something is `moving`. */
  ask(wanted: Wanted, sky: Sky, c: Conditions, moving: boolean): void {
    const { sun, distance, turbidity, albedo, air, cover } = c;
    const told = JSON.stringify([wanted, sun, distance, turbidity, albedo, air, cover]);
    if ((moving && this.busy) || (told === this.told && (moving || !this.moving))) return;
    this.told = told;
    this.begun = performance.now();
    const asked: Asked = { id: ++this.id, ...wanted, clear: clearColours(sky, c), phases: PHASES, moving };
    [this.moving, this.busy, this.settled] = [moving, moving, false];
    this.started().postMessage(asked);
  }

  /** No clouds. */
  forget(): void {
    if (this.told) this.id++;
    [this.map, this.told, this.moving, this.busy, this.settled] = [null, "", false, false, true];
  }

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
    if (last) [this.busy, this.settled] = [false, true];
    this.ready();
  }
}
